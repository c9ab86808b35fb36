// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/SkdPart.h"

#include "Pipeline/SkdSourceTrees.h"
#include "vtkBoundingBox.h"
#include "vtkCellArray.h"

#include <algorithm>
#include <cmath>

namespace
{
using Triangle = skd::WindingNumber::Triangle;

void LoadTriangle(vtkPolyData* faces, vtkIdType face, vtkIdType ids[3], Triangle& corners)
{
  vtkNew<vtkIdList> points;
  faces->GetPolys()->GetCellAtId(face, points);
  for (int i = 0; i < 3; ++i)
  {
    ids[i] = points->GetId(i);
    faces->GetPoint(ids[i], corners[i].X);
  }
}

skd::Vector3 UnitNormal(const Triangle& t)
{
  const skd::Vector3 across = skd::Cross(t[1] - t[0], t[2] - t[0]);
  const double length = skd::Norm(across);
  return length > 0.0 ? (1.0 / length) * across : skd::Vector3{ { 0.0, 0.0, 0.0 } };
}

double AngleAt(const Triangle& t, int corner)
{
  const skd::Vector3 a = t[(corner + 1) % 3] - t[corner];
  const skd::Vector3 b = t[(corner + 2) % 3] - t[corner];
  return std::atan2(skd::Norm(skd::Cross(a, b)), skd::Dot(a, b));
}

/// Of `yes` among `asked` votes.
SkdSide Counted(int yes, int asked)
{
  const bool isInside = 2 * yes > asked;
  return { isInside, static_cast<double>(isInside ? yes : asked - yes) / asked };
}

/// Calls vote() until one side has more than half of `count`; of an even vote once more.
template <class Vote>
SkdSide Elect(int count, const Vote& vote)
{
  int yes = 0;
  int asked = 0;
  while (asked < count && 2 * yes <= count && 2 * (asked - yes) <= count)
  {
    yes += vote() ? 1 : 0;
    ++asked;
  }
  if (2 * yes == asked)
  {
    yes += vote() ? 1 : 0;
    ++asked;
  }
  return Counted(yes, asked);
}
}

struct SkdPart::Winding
{
  skd::Tree<3> Tree;
  skd::WindingNumber Number;

  Winding(const std::vector<skd::Box3>& boxes, const std::vector<Triangle>& triangles)
    : Tree(skd::MakeTreeInput(boxes, 0.0))
    , Number(this->Tree, triangles)
  {
  }
};

SkdPart::SkdPart(int id, const std::vector<SkdLeaf>& leaves, double epsilon, SkdInsideMethod method)
  : Id(id)
  , Boundary(SkdBoundaryOf(leaves))
  , Faces(SkdMakeLocator(this->Boundary.Faces))
{
  this->Walls = this->Boundary.Walls == this->Boundary.Faces ? this->Faces
                                                             : SkdMakeLocator(this->Boundary.Walls);
  SkdBuildLocator(this->Faces, epsilon, true);
  if (this->Walls != this->Faces)
  {
    SkdBuildLocator(this->Walls, epsilon, true);
  }
  this->Boundary.Faces->GetCellsBounds(this->Bounds);
  const vtkBoundingBox box(this->Bounds);
  this->Diagonal = box.IsValid() ? box.GetDiagonalLength() : 0.0;
  if (method == SkdInsideMethod::WindingNumber)
  {
    this->MakeWinding();
  }
  if (method == SkdInsideMethod::NearestFeature)
  {
    this->MakeNormals();
  }
}

SkdPart::~SkdPart() = default;
SkdPart::SkdPart(SkdPart&&) noexcept = default;
SkdPart& SkdPart::operator=(SkdPart&&) noexcept = default;

// Of the walls: the equal faces of bodies that touch have solid angles that cancel only if they are
// turned against each other.
void SkdPart::MakeWinding()
{
  std::vector<Triangle> triangles(this->Boundary.Walls->GetNumberOfCells());
  std::vector<skd::Box3> boxes(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    vtkIdType ids[3];
    LoadTriangle(this->Boundary.Walls, static_cast<vtkIdType>(i), ids, triangles[i]);
    for (const skd::Vector3& corner : triangles[i])
    {
      boxes[i].Add(corner);
    }
  }
  this->TheWinding = std::make_unique<Winding>(boxes, triangles);
}

// J. A. Baerentzen, H. Aanaes, "Signed distance computation using the angle weighted pseudonormal",
// IEEE Trans. Vis. Comput. Graph. 11 (2005) 243-253.
void SkdPart::MakeNormals()
{
  const vtkIdType faces = this->GetNumberOfFaces();
  this->PointNormals.assign(
    this->Boundary.Faces->GetNumberOfPoints(), skd::Vector3{ { 0.0, 0.0, 0.0 } });
  for (vtkIdType face = 0; face < faces; ++face)
  {
    vtkIdType ids[3];
    Triangle corners;
    LoadTriangle(this->Boundary.Faces, face, ids, corners);
    const skd::Vector3 normal = UnitNormal(corners);
    for (int i = 0; i < 3; ++i)
    {
      this->PointNormals[ids[i]] = this->PointNormals[ids[i]] + AngleAt(corners, i) * normal;
      EdgeNormal& edge = this->EdgeNormals[std::minmax(ids[i], ids[(i + 1) % 3])];
      edge.Sum = edge.Sum + normal;
      ++edge.Faces;
    }
  }
}

bool SkdPart::BoundsHold(const double x[3]) const
{
  return x[0] >= this->Bounds[0] && x[0] <= this->Bounds[1] && x[1] >= this->Bounds[2] &&
    x[1] <= this->Bounds[3] && x[2] >= this->Bounds[4] && x[2] <= this->Bounds[5];
}

SkdSide SkdPart::AskSide(const double x[3], const SkdInsideRules& rules, std::uint64_t point) const
{
  if (!this->BoundsHold(x))
  {
    return SkdSide();
  }
  switch (rules.Method)
  {
    case SkdInsideMethod::AxisRays:
      return this->VoteAlongAxes(x);
    case SkdInsideMethod::RandomRays:
      return this->VoteAtRandom(x, rules, point);
    case SkdInsideMethod::WindingNumber:
      return this->AskWinding(x);
    default:
      return this->AskNearest(x);
  }
}

bool SkdPart::IsOdd(const double x[3], const SkdWayOut& way) const
{
  const double end[3] = { x[0] + way[0], x[1] + way[1], x[2] + way[2] };
  return this->Walls->CountCrossings(x, end) % 2 == 1;
}

SkdSide SkdPart::VoteAlongAxes(const double x[3]) const
{
  const std::array<SkdWayOut, 7> ways = SkdWaysOutAlongAxes(this->Bounds, x);
  const int count = this->Boundary.OpenEdges == 0 ? 1 : 6;
  auto way = ways.begin();
  return Elect(count, [&]() { return this->IsOdd(x, *way++); });
}

SkdSide SkdPart::VoteAtRandom(
  const double x[3], const SkdInsideRules& rules, std::uint64_t point) const
{
  SkdRandomWaysOut ways(this->Bounds, rules.Seed, point);
  const int count = this->Boundary.OpenEdges == 0 ? 1 : rules.NumberOfRays;
  return Elect(count, [&]() { return this->IsOdd(x, ways.Next()); });
}

double SkdPart::GetWindingNumber(const double x[3]) const
{
  return this->TheWinding ? this->TheWinding->Number.At({ { x[0], x[1], x[2] } }) : 0.0;
}

SkdSide SkdPart::AskWinding(const double x[3]) const
{
  const double beyond = std::abs(this->GetWindingNumber(x)) - 0.5;
  return { beyond >= 0.0, 0.5 + std::min(0.5, std::abs(beyond)) };
}

// The normal of the face, edge or corner that a point of a face is on.
skd::Vector3 SkdPart::NormalAt(vtkIdType face, const double pcoords[3], bool& isOpen) const
{
  vtkIdType ids[3];
  Triangle corners;
  LoadTriangle(this->Boundary.Faces, face, ids, corners);
  const double weights[3] = { 1.0 - pcoords[0] - pcoords[1], pcoords[0], pcoords[1] };
  constexpr double none = 1e-12;
  isOpen = false;
  for (int i = 0; i < 3; ++i)
  {
    if (weights[(i + 1) % 3] <= none && weights[(i + 2) % 3] <= none)
    {
      return this->PointNormals[ids[i]];
    }
  }
  for (int i = 0; i < 3; ++i)
  {
    if (weights[i] <= none)
    {
      const auto edge = this->EdgeNormals.find(std::minmax(ids[(i + 1) % 3], ids[(i + 2) % 3]));
      isOpen = edge->second.Faces % 2 == 1;
      return edge->second.Sum;
    }
  }
  return UnitNormal(corners);
}

SkdSide SkdPart::AskNearest(const double x[3]) const
{
  double asked[3] = { x[0], x[1], x[2] };
  double nearest[3], pcoords[3], dist2;
  vtkIdType face;
  int subId;
  this->Faces->FindClosestPoint(asked, nearest, face, subId, dist2);
  if (face < 0 || !this->Faces->EvaluateCell(face, x, nearest, subId, pcoords, dist2, nullptr))
  {
    return SkdSide();
  }
  bool isOpen;
  const skd::Vector3 normal = this->NormalAt(face, pcoords, isOpen);
  const skd::Vector3 away{ { x[0] - nearest[0], x[1] - nearest[1], x[2] - nearest[2] } };
  return { skd::Dot(away, normal) <= 0.0, isOpen ? 0.5 : 1.0 };
}

bool SkdPart::IsNear(const double x[3], double distance) const
{
  double asked[3] = { x[0], x[1], x[2] };
  double nearest[3], dist2;
  vtkIdType face;
  int subId;
  return this->Faces->FindClosestPointWithinRadius(
           asked, distance, nearest, nullptr, face, subId, dist2) != 0;
}
