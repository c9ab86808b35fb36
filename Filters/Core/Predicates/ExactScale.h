// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Predicates_ExactScale_h
#define skd_Predicates_ExactScale_h

#include <algorithm>
#include <cmath>

namespace skd
{

/// A power of two that keeps products of three coordinates in range, given the largest magnitude of
/// one: at this scale exact signs are exact.
inline double ExactScale(double reach)
{
  constexpr double least = 1e-20;
  constexpr double largest = 1e80;
  int exponent = 0;
  std::frexp(reach, &exponent);
  const bool isInRange = reach == 0.0 || (reach >= least && reach <= largest);
  return isInRange ? 1.0 : std::ldexp(1.0, -std::clamp(exponent, -1000, 1000));
}
}

#endif
