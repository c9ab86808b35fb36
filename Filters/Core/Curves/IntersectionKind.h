// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Curves_IntersectionKind_h
#define skd_Curves_IntersectionKind_h

#include "Tolerances.h"

#include <algorithm>
#include <cmath>

namespace skd
{

/// How two things intersect.
enum class IntersectionKind
{
  Crossing,   ///< from one side to the other, or through each other
  Touching,   ///< along each other
  OverlapEnd, ///< a interval that both have in common begins or ends
  Near        ///< within the requested clearance
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

/// From a point where two things are within `maxStep` of each other to one where they are not: in
/// steps that double, the first of which is `step`. gapAt(hit) follows hit.T and returns what is
/// between both; NaN, and this gives false, where nothing can be decided.
template <class Hit, class GapAt>
bool LeaveContact(Hit& hit, double step, double maxStep, const GapAt& gapAt)
{
  const double start = hit.T;
  for (double away = step; std::abs(away) <= 1.0; away *= 2.0)
  {
    hit.T = start + away;
    const double gap = gapAt(hit);
    if (!(gap <= maxStep))
    {
      return gap > maxStep;
    }
  }
  return false;
}

/// How far a contact goes on from a hit, in the parameter of the curve: the larger of the distances
/// at which LeaveContact sees both apart, forwards and backwards. Its steps double, so this is at
/// most twice the length of the contact. Hits that are nearer to each other than this are one, so
/// it is limited: else one long contact would hide all others of the curve.
template <class Hit, class GapAt>
double ContactLength(const Hit& hit, double maxStep, const GapAt& gapAt)
{
  constexpr double longest = 0.125;
  double length = 0.0;
  for (const double step : { -tolerances::SameParameter, tolerances::SameParameter })
  {
    Hit beyond = hit;
    LeaveContact(beyond, step, maxStep, gapAt);
    length = std::max(length, std::abs(beyond.T - hit.T));
  }
  return std::min(length, longest);
}

/// Where a function changes its sign between two parameters, by bisection; the middle if it does
/// not.
template <class Function>
double SignChange(double low, double high, const Function& function)
{
  const double atLow = function(low);
  if (!(atLow * function(high) < 0.0))
  {
    return 0.5 * (low + high);
  }
  for (int iteration = 0; iteration < 60 && high - low > tolerances::SignChange; ++iteration)
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
