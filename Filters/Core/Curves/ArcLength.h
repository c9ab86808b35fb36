// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Curves_ArcLength_h
#define skd_Curves_ArcLength_h

#include "BezierCurve.h"
#include "Tolerances.h"

namespace skd
{

namespace detail
{

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

/// The arc length of an interval, to about 1e-13 relative.
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
