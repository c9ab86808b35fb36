// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/SkdCellTree.h"

#include "Core/Geometry/PlanarPolygon.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
constexpr double HalfTurn = 3.14159265358979323846;

/// The unit normals of a bent surface, seen twice: once for their mean, once for what is farthest
/// from it.
class Bend
{
public:
  void Add(const skd::Vector3& normal) { this->Sum = this->Sum + normal; }
  void AddWhatIsNoSurface() { this->IsSurface = false; }

  void Compare(const skd::Vector3& normal)
  {
    this->LeastCosine = std::min(this->LeastCosine, skd::Dot(normal, this->Sum));
  }

  bool HasMean() const { return this->IsSurface && skd::Norm(this->Sum) > 0.0; }
  double Angle() const
  {
    return std::acos(std::clamp(this->LeastCosine / skd::Norm(this->Sum), -1.0, 1.0));
  }

private:
  skd::Vector3 Sum{ { 0.0, 0.0, 0.0 } };
  double LeastCosine = std::numeric_limits<double>::infinity();
  bool IsSurface = true;
};

/// Calls visit(unit normal); not for a polygon so thin that rounding may have turned it.
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
double SkdCellTree::FindBend(
  const SkdListedRange& above, const skd::Box3& box, SkdOverlapTest test) const
{
  Bend bend;
  const auto forMet = [&](const auto& body)
  {
    this->VisitListed(above, box,
      [&](std::uint32_t cell)
      {
        if (this->IsMet(cell, box, test))
        {
          body(cell);
        }
      });
  };
  forMet(
    [&](std::uint32_t cell)
    {
      if (!IsFlatSurface(this->Store.ShapeOf(cell)))
      {
        bend.AddWhatIsNoSurface();
        return;
      }
      VisitNormals(this->Store, cell, [&](const skd::Vector3& normal) { bend.Add(normal); });
    });
  if (!bend.HasMean())
  {
    return HalfTurn;
  }
  forMet([&](std::uint32_t cell)
    { VisitNormals(this->Store, cell, [&](const skd::Vector3& n) { bend.Compare(n); }); });
  return bend.Angle();
}
