// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_Intersection_CrossingDirection_h
#define skd_Geometry_Intersection_CrossingDirection_h

#include "SegmentTriangle.h"

namespace skd
{

/// Which way a segment passes through a triangle that it hits: 1 along the normal of p0 p1 p2, out
/// of what the triangle bounds, -1 against it, 0 where it does not pass (see TriangleHit::Passes).
/// By the signs that decide the hit, so sums over a closed surface whose triangles are oriented
/// alike are exact: the winding number around the segment's start, if it ends outside.
inline int CrossingDirection(
  const SegmentView& view, const Vector3& p0, const Vector3& p1, const Vector3& p2)
{
  const Sheared a = view.See(p0);
  const Sheared b = view.See(p1);
  const Sheared c = view.See(p2);
  const int u = detail::SideOf(b, c).MovedSign;
  const int v = detail::SideOf(c, a).MovedSign;
  const int w = detail::SideOf(a, b).MovedSign;
  const Segment<3>& segment = view.GetSegment();
  const int z = view.GetShear().Z;
  return u != v || v != w ? 0 : (segment.B[z] > segment.A[z] ? u : -u);
}

}

#endif
