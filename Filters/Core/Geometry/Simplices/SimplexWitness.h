// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_Simplices_SimplexWitness_h
#define skd_Geometry_Simplices_SimplexWitness_h

#include "SimplexDistance.h"
#include "SimplexGroups.h"

#include <algorithm>

namespace skd
{
namespace detail
{

/// Calls visit(t) with the parameters at which a segment comes to something of the set: crosses a
/// triangle, or comes as near as `tolerance` to an edge or a point.
template <class Visit>
void ForEachTransition(
  const Segment<3>& segment, const SimplexGroups& set, double tolerance, Visit visit)
{
  Box3 bounds(segment.A, segment.A);
  bounds.Add(segment.B);
  bounds = bounds.Inflated(tolerance);
  const SegmentView view(segment);
  set.ForEachOverlapping(bounds,
    [&](const Triangle3& corners)
    {
      const auto hit =
        view.IsValid() ? Intersect(view, corners[0], corners[1], corners[2]) : std::nullopt;
      if (hit)
      {
        visit(hit->T);
      }
      for (int i = 0; i < 3; ++i)
      {
        const SegmentPoint<3> corner = ClosestPointOnSegment(segment.A, segment.B, corners[i]);
        if (corner.Dist2 <= tolerance * tolerance)
        {
          visit(corner.R);
        }
        const SegmentPair pair = ClosestPoints(segment, { corners[i], corners[(i + 1) % 3] });
        if (pair.Dist2 <= tolerance * tolerance)
        {
          visit(pair.T);
        }
      }
    });
}

/// Whether x is that near to the simplices: of a solid to its boundary.
inline bool IsNear(const SimplexGroups& set, const Vector3& x, double distance)
{
  const auto mayBe = [&](const Box3& box) { return box.Inflated(distance).Contains(x); };
  return set.Any(mayBe,
    [&](const Triangle3& p)
    {
      return mayBe(BoundsOf(p)) &&
        ClosestPointOnTriangle(p[0], p[1], p[2], x).Dist2 <= distance * distance;
    });
}

inline bool IsWithin(const SimplexGroups& set, const Vector3& x, double distance)
{
  return set.GetSet().Bounds.Inflated(distance).Contains(x) &&
    (IsNear(set, x, distance) || Encloses(set.GetSet(), x));
}

}
}

#endif
