// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Refine/SkdOrientedBoundary.h"

#include "Core/Geometry/Distance/ClosestPoint.h"
#include "Core/Geometry/Measures/MeasureInBox.h"
#include "Pipeline/SkdSignedSource.h"
#include "vtkIdList.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <numeric>

namespace
{
/// An edge as one of its triangles has it.
struct TriangleEdge
{
  vtkIdType Low;
  vtkIdType High;
  vtkIdType Triangle;
  bool IsUpward; // from Low to High

  bool IsSameAs(const TriangleEdge& other) const
  {
    return this->Low == other.Low && this->High == other.High;
  }
};

std::vector<TriangleEdge> SortedEdges(vtkPolyData* surface)
{
  std::vector<TriangleEdge> edges;
  vtkNew<vtkIdList> ids;
  for (vtkIdType triangle = 0; triangle < surface->GetNumberOfCells(); ++triangle)
  {
    surface->GetCellPoints(triangle, ids);
    for (int i = 0; i < 3; ++i)
    {
      const vtkIdType a = ids->GetId(i);
      const vtkIdType b = ids->GetId((i + 1) % 3);
      edges.push_back({ std::min(a, b), std::max(a, b), triangle, a < b });
    }
  }
  std::sort(edges.begin(), edges.end(),
    [](const TriangleEdge& a, const TriangleEdge& b)
    { return a.Low != b.Low ? a.Low < b.Low : a.High < b.High; });
  return edges;
}

/// A triangle beside another.
struct Neighbour
{
  vtkIdType Triangle;
  bool IsAlike; // their normals point to the same side
};

/// Over each of a triangle's edges, if there is exactly one.
std::vector<std::vector<Neighbour>> FindNeighbours(vtkPolyData* surface)
{
  std::vector<std::vector<Neighbour>> neighbours(
    static_cast<std::size_t>(surface->GetNumberOfCells()));
  const std::vector<TriangleEdge> edges = SortedEdges(surface);
  for (std::size_t first = 0, last; first < edges.size(); first = last)
  {
    last = first + 1;
    while (last < edges.size() && edges[last].IsSameAs(edges[first]))
    {
      ++last;
    }
    if (last - first == 2)
    {
      const TriangleEdge& a = edges[first];
      const TriangleEdge& b = edges[first + 1];
      const bool isAlike = a.IsUpward != b.IsUpward;
      neighbours[static_cast<std::size_t>(a.Triangle)].push_back({ b.Triangle, isAlike });
      neighbours[static_cast<std::size_t>(b.Triangle)].push_back({ a.Triangle, isAlike });
    }
  }
  return neighbours;
}
}

//------------------------------------------------------------------------------
SkdOrientedBoundary::SkdOrientedBoundary(const SkdSignedSource& boundary, double epsilon)
  : Boundary(boundary)
  , Surface(boundary.GetSurface())
  , Tree(this->Surface,
      [epsilon]
      {
        SkdTreeSettings settings;
        settings.Epsilon = epsilon;
        return settings;
      }())
  , Turned(static_cast<std::size_t>(this->Surface->GetNumberOfCells()), 0)
{
  if (!this->Turned.empty())
  {
    this->Surface->BuildCells();
    this->TurnAlike();
  }
}

std::array<skd::Vector3, 3> SkdOrientedBoundary::GetTriangle(vtkIdType triangle) const
{
  vtkIdType size;
  const vtkIdType* ids;
  this->Surface->GetCellPoints(triangle, size, ids);
  std::array<skd::Vector3, 3> corners;
  for (int i = 0; i < 3; ++i)
  {
    this->Surface->GetPoint(ids[i], corners[static_cast<std::size_t>(i)].X);
  }
  return corners;
}

void SkdOrientedBoundary::TurnAlike()
{
  const std::vector<std::vector<Neighbour>> neighbours = FindNeighbours(this->Surface);
  std::vector<char> isKnown(this->Turned.size(), 0);
  for (std::size_t seed = 0; seed < isKnown.size(); ++seed)
  {
    if (isKnown[seed])
    {
      continue;
    }
    std::vector<vtkIdType> piece{ static_cast<vtkIdType>(seed) };
    isKnown[seed] = 1;
    for (std::size_t i = 0; i < piece.size(); ++i)
    {
      const auto triangle = static_cast<std::size_t>(piece[i]);
      for (const Neighbour& next : neighbours[triangle])
      {
        const auto there = static_cast<std::size_t>(next.Triangle);
        if (!isKnown[there])
        {
          isKnown[there] = 1;
          this->Turned[there] = this->Turned[triangle] != (next.IsAlike ? 0 : 1);
          piece.push_back(next.Triangle);
        }
      }
    }
    if (this->IsInward(piece))
    {
      for (const vtkIdType triangle : piece)
      {
        this->Turned[static_cast<std::size_t>(triangle)] ^= 1;
      }
    }
  }
}

/// Asks on both sides of the largest triangle's middle, from near to nearer.
bool SkdOrientedBoundary::IsInward(const std::vector<vtkIdType>& piece) const
{
  double largest2 = -1.0;
  skd::Vector3 middle{};
  skd::Vector3 normal{};
  for (const vtkIdType triangle : piece)
  {
    const auto p = this->GetTriangle(triangle);
    skd::Vector3 across = skd::Cross(p[1] - p[0], p[2] - p[0]);
    across = (this->Turned[static_cast<std::size_t>(triangle)] ? -1.0 : 1.0) * across;
    if (skd::Norm2(across) > largest2)
    {
      largest2 = skd::Norm2(across);
      middle = p[0] + (1.0 / 3.0) * ((p[1] - p[0]) + (p[2] - p[0]));
      normal = across;
    }
  }
  const double size = std::sqrt(std::sqrt(largest2));
  for (double step = 1e-3; step > 1e-13; step *= 1e-2)
  {
    const skd::Vector3 aside = (step / size) * normal;
    const bool isAbove = this->Boundary.IsInside((middle + aside).X);
    const bool isBelow = this->Boundary.IsInside((middle - aside).X);
    if (isAbove != isBelow)
    {
      return isAbove;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
/// Finds a corner of the box that is not on a triangle, or is farthest from them; false if even
/// that is within rounding of one.
bool SkdOrientedBoundary::PutCornerAway(
  const skd::Box3& box, vtkIdList* triangles, unsigned& corner) const
{
  const double enough = 1e-6 * box.Diagonal();
  double farthest2 = -1.0;
  for (unsigned i = 0; i < 8 && farthest2 <= enough * enough; ++i)
  {
    const skd::Vector3 at{ { i & 1u ? box.Max[0] : box.Min[0], i & 2u ? box.Max[1] : box.Min[1],
      i & 4u ? box.Max[2] : box.Min[2] } };
    double nearest2 = std::numeric_limits<double>::max();
    for (vtkIdType k = 0; k < triangles->GetNumberOfIds(); ++k)
    {
      const auto p = this->GetTriangle(triangles->GetId(k));
      nearest2 = std::min(nearest2, skd::ClosestPointOnTriangle(p[0], p[1], p[2], at).Dist2);
    }
    if (nearest2 > farthest2)
    {
      farthest2 = nearest2;
      corner = i;
    }
  }
  return farthest2 > 0.0;
}

double SkdOrientedBoundary::GetFraction(const skd::Box3& box) const
{
  thread_local vtkNew<vtkIdList> triangles;
  this->Tree.FindSafetyBoxesWithin(box, triangles);
  unsigned corner = 0;
  if (triangles->GetNumberOfIds() == 0 || !this->PutCornerAway(box, triangles, corner))
  {
    return this->Boundary.IsInside(box.Centroid().X) ? 1.0 : 0.0;
  }
  skd::MeasureInBox measure(box, corner);
  for (vtkIdType k = 0; k < triangles->GetNumberOfIds(); ++k)
  {
    const vtkIdType triangle = triangles->GetId(k);
    const auto p = this->GetTriangle(triangle);
    const bool isTurned = this->Turned[static_cast<std::size_t>(triangle)] != 0;
    measure.Add(p[0], isTurned ? p[2] : p[1], isTurned ? p[1] : p[2]);
  }
  const skd::Vector3 at{ { corner & 1u ? box.Max[0] : box.Min[0],
    corner & 2u ? box.Max[1] : box.Min[1], corner & 4u ? box.Max[2] : box.Min[2] } };
  double whole = 1.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    whole *= box.Length(axis) > 0.0 ? box.Length(axis) : 1.0;
  }
  return std::clamp(measure.Measure(this->Boundary.IsInside(at.X)) / whole, 0.0, 1.0);
}
