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

/// Gauss's quadrature of the speed, seven points.
inline double GaussLength(const BezierCurve& curve, double from, double to)
{
  static constexpr double parameters[4] = { 0.0, 0.4058451513773971669, 0.7415311855993944398,
    0.9491079123427585245 };
  static constexpr double weights[4] = { 0.4179591836734693878, 0.3818300505051189449,
    0.2797053914892766679, 0.1294849661688696933 };
  const double middle = 0.5 * (from + to);
  const double half = 0.5 * (to - from);
  double sum = weights[0] * Norm(curve.At(middle).D1);
  for (int i = 1; i < 4; ++i)
  {
    sum += weights[i] *
      (Norm(curve.At(middle - half * parameters[i]).D1) +
        Norm(curve.At(middle + half * parameters[i]).D1));
  }
  return half * sum;
}

inline double LengthByHalves(
  const BezierCurve& curve, double from, double to, double whole, int depth)
{
  const double middle = 0.5 * (from + to);
  const double low = GaussLength(curve, from, middle);
  const double high = GaussLength(curve, middle, to);
  if (depth == 0 || std::abs(low + high - whole) <= tolerances::ArcLength * whole)
  {
    return low + high;
  }
  return LengthByHalves(curve, from, middle, low, depth - 1) +
    LengthByHalves(curve, middle, to, high, depth - 1);
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

/// The arc length of a interval, to about 1e-13 relative.
inline double ArcLength(const BezierCurve& curve, double from, double to)
{
  if (curve.IsLine())
  {
    return (to - from) * std::sqrt(Distance2(curve.Start(), curve.End()));
  }
  return detail::LengthByHalves(curve, from, to, detail::GaussLength(curve, from, to), 8);
}

}

#endif
