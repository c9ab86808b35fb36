// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_Distance_ClosestSegments_h
#define skd_Geometry_Distance_ClosestSegments_h

#include "../Segment.h"
#include "ClosestPointOnSegment.h"

#include <algorithm>

namespace skd
{

/// The points where two segments come nearest: at T on the first, at R on the second.
struct SegmentPair
{
  double T;
  double R;
  double Dist2;
};

namespace detail
{

inline void KeepNearer(SegmentPair& nearest, const SegmentPair& other)
{
  if (other.Dist2 < nearest.Dist2)
  {
    nearest = other;
  }
}

/// Nearest with one end of either segment.
inline SegmentPair ClosestAtEnds(const Segment<3>& first, const Segment<3>& second)
{
  const SegmentPoint<3> fromA = ClosestPointOnSegment(second.A, second.B, first.A);
  const SegmentPoint<3> fromB = ClosestPointOnSegment(second.A, second.B, first.B);
  const SegmentPoint<3> toA = ClosestPointOnSegment(first.A, first.B, second.A);
  const SegmentPoint<3> toB = ClosestPointOnSegment(first.A, first.B, second.B);
  SegmentPair nearest{ 0.0, fromA.R, fromA.Dist2 };
  KeepNearer(nearest, { toA.R, 0.0, toA.Dist2 });
  KeepNearer(nearest, { toB.R, 1.0, toB.Dist2 });
  KeepNearer(nearest, { 1.0, fromB.R, fromB.Dist2 });
  return nearest;
}

}

/// Any finite segments: parallel, crossing, of no length. Of several nearest pairs one is given.
inline SegmentPair ClosestPoints(const Segment<3>& first, const Segment<3>& second)
{
  SegmentPair nearest = detail::ClosestAtEnds(first, second);
  const Vector3 u = first.B - first.A;
  const Vector3 v = second.B - second.A;
  const Vector3 normal = Cross(u, v);
  const double normal2 = Norm2(normal);
  const Vector3 between = second.A - first.A;
  const double t = Dot(Cross(between, v), normal) / normal2;
  const double r = Dot(Cross(between, u), normal) / normal2;
  if (t >= 0.0 && t <= 1.0 && r >= 0.0 && r <= 1.0) // false for parallel ones: 0 / 0
  {
    detail::KeepNearer(nearest, { t, r, Distance2(first.At(t), second.At(r)) });
  }
  return nearest;
}

/// The interval of the first segment that is within a distance of the second, no less of it: their
/// nearest points must be.
inline Interval IntervalWithin(const Segment<3>& first, const Segment<3>& second, double distance)
{
  const double nearest = ClosestPoints(first, second).T;
  const auto isWithin = [&](double t)
  { return ClosestPointOnSegment(second.A, second.B, first.At(t)).Dist2 <= distance * distance; };
  const auto findEnd = [&](double end)
  {
    double inside = nearest; // distances from a straight line to a segment are convex
    for (int halving = 0; halving < 60 && !isWithin(end); ++halving)
    {
      const double middle = 0.5 * (inside + end);
      if (middle == inside || middle == end)
      {
        break;
      }
      (isWithin(middle) ? inside : end) = middle;
    }
    return end;
  };
  return { findEnd(0.0), findEnd(1.0) };
}

}

#endif
