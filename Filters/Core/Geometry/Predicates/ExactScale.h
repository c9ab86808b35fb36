// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Predicates_ExactScale_h
#define skd_Predicates_ExactScale_h

#include "../Vector.h"

#include <algorithm>
#include <cmath>

namespace skd
{

/// Exact signs are exact for coordinates that are 0 or at least this, relative to the largest one:
/// then no product of three, nor any digit of it, is out of range.
constexpr double LeastExactCoordinate = 1e-80;

/// A power of two that keeps products of three coordinates in range, given the largest magnitude of
/// one: at this scale exact signs are exact.
inline double ExactScale(double extent)
{
  constexpr double least = 1e-20;
  constexpr double largest = 1e80;
  int exponent = 0;
  std::frexp(extent, &exponent);
  const bool isInRange = extent == 0.0 || (extent >= least && extent <= largest);
  return isInRange ? 1.0 : std::ldexp(1.0, -std::clamp(exponent, -1000, 1000));
}

/// Takes coordinates of a point that are smaller than `least` as 0. Returns whether there are any.
inline bool TakeTinyAsZero(Vector3& x, double least)
{
  bool isTaken = false;
  for (double& coordinate : x.X)
  {
    const bool isTiny = coordinate != 0.0 && std::abs(coordinate) < least;
    coordinate = isTiny ? 0.0 : coordinate;
    isTaken = isTaken || isTiny;
  }
  return isTaken;
}
}

#endif
