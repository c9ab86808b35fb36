// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Predicates_Sign_h
#define skd_Predicates_Sign_h

#include <cmath>

namespace skd
{

/// The exact sign of a b - c d: -1, 0 or 1, as long as no product under- or overflows.
/// Rounding is monotone, so products that round to different numbers are already in order; equal
/// ones are compared by their rounding errors. NaN gives 0. Must be compiled without
/// contraction of a b - c d into a fused operation (-ffp-contract=off).
inline int SignOfDifference(double a, double b, double c, double d)
{
  const double left = a * b;
  const double right = c * d;
  if (left != right)
  {
    return left > right ? 1 : (left < right ? -1 : 0);
  }
  const double leftRest = std::fma(a, b, -left);
  const double rightRest = std::fma(c, d, -right);
  return leftRest > rightRest ? 1 : (leftRest < rightRest ? -1 : 0);
}

/// a b - c d to about one unit in the last place.
inline double Difference(double a, double b, double c, double d)
{
  const double left = a * b;
  const double right = c * d;
  return (left - right) + (std::fma(a, b, -left) - std::fma(c, d, -right));
}

}

#endif
