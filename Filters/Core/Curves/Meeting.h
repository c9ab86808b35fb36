// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Curves_Meeting_h
#define skd_Curves_Meeting_h

#include <algorithm>
#include <cmath>

namespace skd
{

/// How two things meet.
enum class MeetingKind
{
  Crossing,   ///< from one side to the other, or through each other
  Touching,   ///< along each other
  OverlapEnd, ///< a stretch that both have in common begins or ends
  Near        ///< at a distance that was asked for
};

/// Puts a parameter onto the end of [0, 1] that it is near; false when it is farther beyond.
inline bool SnapToEnds(double& value, double slack)
{
  const double inside = std::clamp(value, 0.0, 1.0);
  if (!(std::abs(value - inside) <= slack))
  {
    return false;
  }
  value = inside <= slack ? 0.0 : (inside >= 1.0 - slack ? 1.0 : inside);
  return true;
}

/// Where a function changes its sign between two places, by bisection; the middle if it does not.
template <class Function>
double SignChange(double low, double high, const Function& function)
{
  const double atLow = function(low);
  if (!(atLow * function(high) < 0.0))
  {
    return 0.5 * (low + high);
  }
  for (int iteration = 0; iteration < 60 && high - low > 1e-16; ++iteration)
  {
    const double middle = 0.5 * (low + high);
    const double atMiddle = function(middle);
    if (atMiddle == 0.0)
    {
      return middle;
    }
    (atMiddle * atLow > 0.0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}

#endif
