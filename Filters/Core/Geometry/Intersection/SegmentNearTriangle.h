// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_Intersection_SegmentNearTriangle_h
#define skd_Geometry_Intersection_SegmentNearTriangle_h

#include "../Distance/ClosestPointOnTriangle.h"
#include "SegmentTriangle.h"

namespace skd
{

/// The hit of a segment that misses a triangle, but meets its plane within a tolerance of it.
inline std::optional<TriangleHit> NearMiss(const SegmentView& view, const Vector3& p0,
  const Vector3& p1, const Vector3& p2, double tolerance)
{
  const Segment<3>& segment = view.GetSegment();
  const Vector3 normal = Cross(p1 - p0, p2 - p0);
  const double t = Dot(normal, p0 - segment.A) / Dot(normal, segment.B - segment.A);
  const std::optional<double> accepted = view.Accept(t);
  if (!accepted)
  {
    return std::nullopt;
  }
  const auto nearest = ClosestPointOnTriangle(p0, p1, p2, segment.At(*accepted));
  if (!(nearest.Dist2 <= tolerance * tolerance))
  {
    return std::nullopt;
  }
  return TriangleHit{ *accepted, nearest.R, nearest.S, false, false };
}

/// Intersect(), or else, if the tolerance is above 0, the near miss.
inline std::optional<TriangleHit> IntersectWithin(const SegmentView& view, const Vector3& p0,
  const Vector3& p1, const Vector3& p2, double tolerance)
{
  const std::optional<TriangleHit> hit = Intersect(view, p0, p1, p2);
  return hit || !(tolerance > 0.0) ? hit : NearMiss(view, p0, p1, p2, tolerance);
}

}

#endif
