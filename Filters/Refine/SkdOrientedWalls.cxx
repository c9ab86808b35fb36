// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Refine/SkdOrientedWalls.h"

#include "Core/Geometry/Distance/ClosestPoint.h"
#include "Core/Geometry/Measures/MeasureInBox.h"
#include "Pipeline/SkdSignedSource.h"
#include "vtkIdList.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <numeric>

namespace
{
/// An edge as one of its walls has it.
struct WallEdge
{
  vtkIdType Low;
  vtkIdType High;
  vtkIdType Wall;
  bool IsUpward; // from Low to High

  bool IsSameAs(const WallEdge& other) const
  {
    return this->Low == other.Low && this->High == other.High;
  }
};

std::vector<WallEdge> SortedEdges(vtkPolyData* walls)
{
  std::vector<WallEdge> edges;
  vtkNew<vtkIdList> ids;
  for (vtkIdType wall = 0; wall < walls->GetNumberOfCells(); ++wall)
  {
    walls->GetCellPoints(wall, ids);
    for (int i = 0; i < 3; ++i)
    {
      const vtkIdType a = ids->GetId(i);
      const vtkIdType b = ids->GetId((i + 1) % 3);
      edges.push_back({ std::min(a, b), std::max(a, b), wall, a < b });
    }
  }
  std::sort(edges.begin(), edges.end(),
    [](const WallEdge& a, const WallEdge& b)
    { return a.Low != b.Low ? a.Low < b.Low : a.High < b.High; });
  return edges;
}

/// A wall beside another.
struct Neighbour
{
  vtkIdType Wall;
  bool IsAlike; // their normals point to the same side
};

/// Over each of a wall's edges, if there is exactly one.
std::vector<std::vector<Neighbour>> FindNeighbours(vtkPolyData* walls)
{
  std::vector<std::vector<Neighbour>> neighbours(
    static_cast<std::size_t>(walls->GetNumberOfCells()));
  const std::vector<WallEdge> edges = SortedEdges(walls);
  for (std::size_t first = 0, last; first < edges.size(); first = last)
  {
    last = first + 1;
    while (last < edges.size() && edges[last].IsSameAs(edges[first]))
    {
      ++last;
    }
    if (last - first == 2)
    {
      const WallEdge& a = edges[first];
      const WallEdge& b = edges[first + 1];
      const bool isAlike = a.IsUpward != b.IsUpward;
      neighbours[static_cast<std::size_t>(a.Wall)].push_back({ b.Wall, isAlike });
      neighbours[static_cast<std::size_t>(b.Wall)].push_back({ a.Wall, isAlike });
    }
  }
  return neighbours;
}
}

//------------------------------------------------------------------------------
SkdOrientedWalls::SkdOrientedWalls(const SkdSignedSource& boundary, double epsilon)
  : Boundary(boundary)
  , Walls(boundary.GetWalls())
  , Tree(this->Walls,
      [epsilon]
      {
        SkdTreeSettings settings;
        settings.Epsilon = epsilon;
        return settings;
      }())
  , Turned(static_cast<std::size_t>(this->Walls->GetNumberOfCells()), 0)
{
  if (!this->Turned.empty())
  {
    this->Walls->BuildCells();
    this->TurnAlike();
  }
}

std::array<skd::Vector3, 3> SkdOrientedWalls::GetWall(vtkIdType wall) const
{
  vtkIdType size;
  const vtkIdType* ids;
  this->Walls->GetCellPoints(wall, size, ids);
  std::array<skd::Vector3, 3> corners;
  for (int i = 0; i < 3; ++i)
  {
    this->Walls->GetPoint(ids[i], corners[static_cast<std::size_t>(i)].X);
  }
  return corners;
}

void SkdOrientedWalls::TurnAlike()
{
  const std::vector<std::vector<Neighbour>> neighbours = FindNeighbours(this->Walls);
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
      const auto wall = static_cast<std::size_t>(piece[i]);
      for (const Neighbour& next : neighbours[wall])
      {
        const auto there = static_cast<std::size_t>(next.Wall);
        if (!isKnown[there])
        {
          isKnown[there] = 1;
          this->Turned[there] = this->Turned[wall] != (next.IsAlike ? 0 : 1);
          piece.push_back(next.Wall);
        }
      }
    }
    if (this->IsInward(piece))
    {
      for (const vtkIdType wall : piece)
      {
        this->Turned[static_cast<std::size_t>(wall)] ^= 1;
      }
    }
  }
}

/// Asks on both sides of the largest wall's middle, from near to nearer.
bool SkdOrientedWalls::IsInward(const std::vector<vtkIdType>& piece) const
{
  double largest2 = -1.0;
  skd::Vector3 middle{};
  skd::Vector3 normal{};
  for (const vtkIdType wall : piece)
  {
    const auto p = this->GetWall(wall);
    skd::Vector3 across = skd::Cross(p[1] - p[0], p[2] - p[0]);
    across = (this->Turned[static_cast<std::size_t>(wall)] ? -1.0 : 1.0) * across;
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
/// Finds a corner of the box that is not on a wall, or is farthest from them; false if even that is
/// within rounding of one.
bool SkdOrientedWalls::PutCornerAway(const skd::Box3& box, vtkIdList* walls, unsigned& corner) const
{
  const double enough = 1e-6 * box.Diagonal();
  double farthest2 = -1.0;
  for (unsigned i = 0; i < 8 && farthest2 <= enough * enough; ++i)
  {
    const skd::Vector3 at{ { i & 1u ? box.Max[0] : box.Min[0], i & 2u ? box.Max[1] : box.Min[1],
      i & 4u ? box.Max[2] : box.Min[2] } };
    double nearest2 = std::numeric_limits<double>::max();
    for (vtkIdType k = 0; k < walls->GetNumberOfIds(); ++k)
    {
      const auto p = this->GetWall(walls->GetId(k));
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

double SkdOrientedWalls::GetFraction(const skd::Box3& box) const
{
  thread_local vtkNew<vtkIdList> walls;
  this->Tree.FindSafetyBoxesWithin(box, walls);
  unsigned corner = 0;
  if (walls->GetNumberOfIds() == 0 || !this->PutCornerAway(box, walls, corner))
  {
    return this->Boundary.IsInside(box.Centroid().X) ? 1.0 : 0.0;
  }
  skd::MeasureInBox measure(box, corner);
  for (vtkIdType k = 0; k < walls->GetNumberOfIds(); ++k)
  {
    const vtkIdType wall = walls->GetId(k);
    const auto p = this->GetWall(wall);
    const bool isTurned = this->Turned[static_cast<std::size_t>(wall)] != 0;
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
