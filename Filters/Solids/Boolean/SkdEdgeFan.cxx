// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Boolean/SkdEdgeFan.h"

#include "Core/Geometry/Predicates/Orient3D.h"

#include <algorithm>

namespace skdtree
{
void SkdEdgeFan::Sort(std::uint32_t low, std::vector<SkdEdgeUse>& uses) const
{
  struct SortedUse
  {
    SkdEdgeUse Use;
    int Half; // 0: less than half a turn from the first, 1: half a turn, 2: more
  };
  std::vector<SortedUse> sorted;
  for (std::size_t i = 1; i < uses.size(); ++i)
  {
    sorted.push_back({ uses[i], 1 - this->OrientationOf(low, uses[0], uses[i]) });
  }
  std::sort(sorted.begin(), sorted.end(),
    [&](const SortedUse& a, const SortedUse& b)
    {
      if (a.Half != b.Half)
      {
        return a.Half < b.Half;
      }
      const int order = this->OrientationOf(low, a.Use, b.Use);
      return order != 0 ? order > 0 : a.Use.Triangle < b.Use.Triangle;
    });
  for (std::size_t i = 1; i < uses.size(); ++i)
  {
    uses[i] = sorted[i - 1].Use;
  }
}

/// 1 if the shortest turn from one facet to another is counterclockwise, 0 if they are in a plane.
int SkdEdgeFan::OrientationOf(std::uint32_t low, const SkdEdgeUse& from, const SkdEdgeUse& to) const
{
  const int side = this->SideOf(low, to, this->Facets.Parents[from.Triangle]);
  return from.IsForward ? side : -side;
}

/// On which side of the plane of a triangle a facet is that meets it in an edge: 1 in front, -1
/// behind, 0 in it. A corner of the facet's triangle that is not in the plane has an exact side,
/// and is on the facet's side of the edge or on the other one.
int SkdEdgeFan::SideOf(std::uint32_t low, const SkdEdgeUse& use, std::uint32_t plane) const
{
  const std::uint32_t triangle = this->Facets.Parents[use.Triangle];
  const std::array<skd::Vector3, 3> x = this->Set.GetCornerPoints(triangle);
  const std::array<skd::Vector3, 3> p = this->Set.GetCornerPoints(plane);
  const int axis = this->Set.Get(triangle).Axis;
  const int facing = skd::Orient2D(x[0], x[1], x[2], axis);
  for (const skd::Vector3& corner : x)
  {
    const int above = skd::Orient3D(p[0], p[1], p[2], corner);
    if (above != 0)
    {
      const int left = this->SideOfLine(low, use.High, corner, axis);
      return above * (use.IsForward ? left : -left) * facing;
    }
  }
  return 0;
}

int SkdEdgeFan::SideOfLine(std::uint32_t a, std::uint32_t b, const skd::Vector3& x, int axis) const
{
  const int sign = skd::FilteredOrient2D(this->Facets.GetPosition(this->Set, a),
    this->Facets.GetPosition(this->Set, b), x, axis, this->Points.GetError());
  return sign != 0
    ? sign
    : skd::ExactArea(this->ExactOf(a), this->ExactOf(b), skd::ExactPoint(x), axis).Sign();
}

skd::ExactPoint SkdEdgeFan::ExactOf(std::uint32_t point) const
{
  const auto& given = this->Set.GetPoints();
  return point < given.size() ? skd::ExactPoint(given[point])
                              : this->Points.GetExact(this->Ids[point - given.size()]);
}
}
