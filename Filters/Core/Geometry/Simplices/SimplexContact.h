// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_Simplices_SimplexContact_h
#define skd_Geometry_Simplices_SimplexContact_h

#include "../Intersection/SegmentFacet.h"
#include "../Intersection/TriangleContact.h"
#include "SimplexDistance.h"

namespace skd
{
namespace detail
{

inline bool Crosses(const Triangle3& segment, const Triangle3& triangle)
{
  const Vector3 corners[3] = { triangle[0], triangle[1], triangle[2] };
  return MeetFacet(Segment<3>{ segment[0], segment[1] }, corners).has_value();
}

/// A power of two that makes the larger of two simplices about 1 in size: products of four lengths
/// stay in the range of double then. Nothing is rounded by it.
inline double ScaleOf(const Triangle3& first, const Triangle3& second)
{
  double size = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      size = std::max({ size, std::abs(first[i][axis] - first[0][axis]),
        std::abs(second[i][axis] - first[0][axis]) });
    }
  }
  return size > 0.0 && std::isfinite(size) ? std::ldexp(1.0, -std::ilogb(size)) : 1.0;
}

inline Triangle3 Scaled(Triangle3 simplex, double factor)
{
  for (Vector3& point : simplex)
  {
    point = factor * point;
  }
  return simplex;
}

/// One simplex of a set of that dimension, 3 standing for triangles, too.
struct SetSimplex
{
  Triangle3 Corners;
  int Dimension;
};

inline bool Touch(const SetSimplex& first, const SetSimplex& second, double slack)
{
  if (first.Dimension >= 2 && second.Dimension >= 2)
  {
    if (ProjectedTriangle::FindAxis(first.Corners) >= 0 &&
      ProjectedTriangle::FindAxis(second.Corners) >= 0)
    {
      return FindContact(first.Corners, second.Corners).Count > 0;
    }
  }
  const double scale = ScaleOf(first.Corners, second.Corners);
  const Triangle3 a = Scaled(first.Corners, scale);
  const Triangle3 b = Scaled(second.Corners, scale);
  return (first.Dimension == 1 && second.Dimension >= 2 && Crosses(a, b)) ||
    (second.Dimension == 1 && first.Dimension >= 2 && Crosses(b, a)) ||
    ClosestPoints(a, b).Dist2 <= scale * slack * (scale * slack);
}

}

/// Whether simplices of two sets, of solids their boundaries, have a point in common: exact for
/// triangles that have an area; points, segments and triangles without one count as touching where
/// they come as near as `slack`. O(simplices of a x simplices of b) at worst.
inline bool Touch(const SimplexSet& a, const SimplexSet& b, double slack)
{
  for (const SimplexSet::Simplex& one : a.Simplices)
  {
    const detail::SetSimplex first{ a.Corners(one), a.Dimension };
    const Box3 bounds = detail::BoundsOf(first.Corners).Inflated(slack);
    for (const SimplexSet::Simplex& other : b.Simplices)
    {
      const detail::SetSimplex second{ b.Corners(other), b.Dimension };
      if (bounds.Overlaps(detail::BoundsOf(second.Corners)) && detail::Touch(first, second, slack))
      {
        return true;
      }
    }
  }
  return false;
}

/// Whether two sets have a point in common, be it that one is inside a solid; Touch() says how
/// exactly.
inline bool Meet(const SimplexSet& a, const SimplexSet& b, double slack)
{
  return Touch(a, b, slack) || detail::HasPointWithin(a, b) || detail::HasPointWithin(b, a);
}

}

#endif
