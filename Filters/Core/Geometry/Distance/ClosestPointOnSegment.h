// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The nearest point of a segment, with its parameter.
///
/// Any finite input gives a finite answer, zero lengths included. Distances are good to a few units
/// in the last place of the coordinates relative to x, so a large common offset costs no more than
/// its own rounding. Lengths may range over 1e-150 to 1e150. The nearest point comes out the same,
/// to the last bit, whichever way the segment is named: elements that share an edge tie. A NaN
/// gives Dist2 = NaN.
#ifndef skd_Geometry_Distance_ClosestPointOnSegment_h
#define skd_Geometry_Distance_ClosestPointOnSegment_h

#include "../Vector.h"

namespace skd
{

/// Point = a + R (b - a).
template <int D>
struct SegmentPoint
{
  Vector<D> Point;
  double R;
  double Dist2;
};

/// Everything about the nearest point of the segment with a < b.
template <int D>
SegmentPoint<D> ClosestPointOnOrderedSegment(
  const Vector<D>& a, const Vector<D>& b, const Vector<D>& x)
{
  const Vector<D> along = b - a;
  const Vector<D> toA = a - x;
  const double t = -Dot(toA, along) / Norm2(along);
  if (!(t > 0.0)) // also 0 / 0
  {
    return { a, 0.0, Norm2(toA) };
  }
  if (t >= 1.0)
  {
    return { b, 1.0, Distance2(b, x) };
  }
  return { a + t * along, t, Norm2(toA + t * along) };
}

template <int D>
SegmentPoint<D> ClosestPointOnSegment(const Vector<D>& a, const Vector<D>& b, const Vector<D>& x)
{
  const bool isSwapped = b < a;
  SegmentPoint<D> nearest = ClosestPointOnOrderedSegment(isSwapped ? b : a, isSwapped ? a : b, x);
  nearest.R = isSwapped ? 1.0 - nearest.R : nearest.R;
  return nearest;
}

}

#endif
