// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/Search/SkdCellTree.h"

#include "Cells/Search/SkdVisitCandidates.h"
#include "Core/Geometry/Polygons/PolygonPlane.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace skdtree
{
namespace
{
constexpr double HalfTurn = 3.14159265358979323846;

/// The unit normals of a bent surface, and how far they turn from their mean.
class NormalDeviation
{
public:
  explicit NormalDeviation(std::vector<skd::Vector3>& memory)
    : Normals(memory)
  {
    memory.clear();
  }

  void Add(const skd::Vector3& normal)
  {
    this->Normals.push_back(normal);
    this->Sum = this->Sum + normal;
  }

  /// The largest angle to the mean; half a turn where there is no mean.
  double Angle() const
  {
    const double length = skd::Norm(this->Sum);
    if (!(length > 0.0))
    {
      return HalfTurn;
    }
    double least = length;
    for (const skd::Vector3& normal : this->Normals)
    {
      least = std::min(least, skd::Dot(normal, this->Sum));
    }
    return std::acos(std::max(least / length, -1.0));
  }

private:
  std::vector<skd::Vector3>& Normals;
  skd::Vector3 Sum{ { 0.0, 0.0, 0.0 } };
};

/// Calls visit(unit normal), except for polygons so thin that rounding may have changed the normal.
template <class Visit>
void VisitNormal(const skd::Vector3* points, int size, double sign, Visit visit)
{
  const skd::PolygonPlane plane(points, size);
  if (!plane.IsUncertain)
  {
    visit((sign / skd::Norm(plane.Normal)) * plane.Normal);
  }
}

template <class Visit>
void VisitStripNormals(const SkdPolyCell& strip, Visit visit)
{
  for (int i = 0; i + 2 < strip.Size; ++i)
  {
    VisitNormal(strip.Points + i, 3, i % 2 ? -1.0 : 1.0, visit);
  }
}

bool IsFlatSurface(SkdShape shape)
{
  return shape == SkdShape::Triangle || shape == SkdShape::Quad || shape == SkdShape::Pixel ||
    shape == SkdShape::Polygon || shape == SkdShape::Strip;
}

template <class Visit>
void VisitNormals(const SkdCellStore& store, std::uint32_t cell, Visit visit)
{
  const SkdPolyCell points = store.GatherPoly(cell);
  if (points.Shape == SkdShape::Strip)
  {
    VisitStripNormals(points, visit);
    return;
  }
  if (points.Shape == SkdShape::Pixel)
  {
    const skd::Vector3 quad[4] = { points.Points[0], points.Points[1], points.Points[3],
      points.Points[2] };
    VisitNormal(quad, 4, 1.0, visit);
    return;
  }
  VisitNormal(points.Points, points.Size, 1.0, visit);
}
}

//------------------------------------------------------------------------------
template <class Test>
double SkdCellTree::NormalDeviationOf(
  const SkdCandidateRange& above, const skd::Box3& box, const Test& isMet) const
{
  thread_local std::vector<skd::Vector3> memory; // called for every box of a grid
  NormalDeviation deviation(memory);
  bool isSurface = true;
  this->VisitCandidates(above, box,
    [&](std::uint32_t cell)
    {
      if (!isSurface || !isMet(cell))
      {
        return;
      }
      isSurface = IsFlatSurface(this->Store.ShapeOf(cell));
      if (isSurface)
      {
        VisitNormals(this->Store, cell, [&](const skd::Vector3& normal) { deviation.Add(normal); });
      }
    });
  return isSurface ? deviation.Angle() : HalfTurn;
}

double SkdCellTree::FindNormalDeviation(
  const SkdCandidateRange& above, const skd::Box3& box, SkdOverlapTest test) const
{
  return this->NormalDeviationOf(
    above, box, [&](std::uint32_t cell) { return this->IsMet(cell, box, test); });
}

double SkdCellTree::FindNormalDeviation(
  const skd::Box3& box, const std::function<bool(std::uint32_t)>& isMet) const
{
  const skd::CandidateLanes all = skd::AllCandidates().front();
  return this->NormalDeviationOf({ &all, &all + 1 }, box, isMet);
}
}
