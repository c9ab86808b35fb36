// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Curves_CurveSpans_h
#define skd_Curves_CurveSpans_h

#include "../Geometry/Distance/ClosestPointOnSegment.h"
#include "BezierCurve.h"
#include "Tolerances.h"

namespace skd
{

/// The greatest distance of a curve from the segment between its ends, or more: that of its control
/// points. The curve lies in the "safety cylinder" of this radius (section 6.1).
inline double ChordDeviation(const BezierCurve& curve)
{
  double deviation2 = 0.0;
  for (int i = 1; i < curve.Degree; ++i)
  {
    const Vector3 point = curve.Control(i);
    deviation2 =
      std::max(deviation2, ClosestPointOnSegment(curve.Start(), curve.End(), point).Dist2);
  }
  return std::sqrt(deviation2);
}

/// Whether a step from control point to control point leaves the chord by more than 22.5 degrees.
inline bool BendsMuch(const BezierCurve& curve)
{
  constexpr double cosine = 0.9238795325112867;
  const Vector3 chord = curve.End() - curve.Start();
  for (int i = 0; i < curve.Degree; ++i)
  {
    const Vector3 step = curve.Control(i + 1) - curve.Control(i);
    if (!(Dot(step, chord) >= cosine * Norm(step) * Norm(chord)))
    {
      return true;
    }
  }
  return false;
}

namespace detail
{

template <class IsFine, class Visit>
void VisitSpansOf(
  const BezierCurve& curve, const Interval& range, const IsFine& isFine, int depth, Visit& visit)
{
  constexpr int depthLimit = 12;
  if (curve.IsLine() || depth == depthLimit || isFine(curve))
  {
    visit(curve, range);
    return;
  }
  const double middle = 0.5 * (range.Min + range.Max);
  VisitSpansOf(curve.Restricted(0.0, 0.5), { range.Min, middle }, isFine, depth + 1, visit);
  VisitSpansOf(curve.Restricted(0.5, 1.0), { middle, range.Max }, isFine, depth + 1, visit);
}

}

/// Cuts a curve so that no part is farther than `delta` from its chord, or cut 12 times over:
/// visit(part, range of t) from the start to the end.
template <class Visit>
void VisitSpans(const BezierCurve& curve, double delta, Visit visit)
{
  const auto isFine = [&](const BezierCurve& part) { return ChordDeviation(part) <= delta; };
  detail::VisitSpansOf(curve, { 0.0, 1.0 }, isFine, 0, visit);
}

/// The same, and no part turns from its chord by more than 22.5 degrees: neither it nor two that
/// follow each other can meet themselves.
template <class Visit>
void VisitStraightSpans(const BezierCurve& curve, double delta, Visit visit)
{
  const auto isFine = [&](const BezierCurve& part)
  { return ChordDeviation(part) <= delta && !BendsMuch(part); };
  detail::VisitSpansOf(curve, { 0.0, 1.0 }, isFine, 0, visit);
}

}

#endif
