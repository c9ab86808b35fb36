// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/SkdCurveJoints.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace skdtree
{
namespace
{
/// Along a direction in which points of a lattice hardly ever are as far.
double KeyOf(const SkdCurveEnd& end)
{
  constexpr skd::Vector3 direction{ { 0.5402, 0.3187, 0.7788 } };
  return skd::Dot(end.X, direction);
}

/// The ends from `first` on that are where it is; the others, by ascending key, stay.
std::vector<SkdCurveEnd> TakeCoincidentEnds(
  std::vector<SkdCurveEnd>& ends, std::vector<char>& isTaken, std::size_t first, double rounding)
{
  std::vector<SkdCurveEnd> place;
  const double last = KeyOf(ends[first]) + 4.0 * rounding;
  for (std::size_t i = first; i < ends.size() && KeyOf(ends[i]) <= last; ++i)
  {
    if (!isTaken[i] && skd::Distance2(ends[i].X, ends[first].X) <= rounding * rounding)
    {
      isTaken[i] = 1;
      place.push_back(ends[i]);
    }
  }
  return place;
}
}

//------------------------------------------------------------------------------
SkdCurveJoints::SkdCurveJoints(
  std::vector<SkdCurveEnd> ends, std::size_t numberOfCurves, double rounding)
  : Joints(2 * numberOfCurves, None)
{
  std::sort(ends.begin(), ends.end(),
    [](const SkdCurveEnd& a, const SkdCurveEnd& b)
    { return std::tuple(KeyOf(a), a.Number) < std::tuple(KeyOf(b), b.Number); });
  std::vector<char> isTaken(ends.size(), 0);
  for (std::size_t first = 0; first < ends.size(); ++first)
  {
    if (!isTaken[first])
    {
      std::vector<SkdCurveEnd> place = TakeCoincidentEnds(ends, isTaken, first, rounding);
      this->Join(place);
    }
  }
}

//------------------------------------------------------------------------------
void SkdCurveJoints::Join(std::vector<SkdCurveEnd>& place)
{
  constexpr std::size_t hub = 64;
  if (place.size() < 2 || place.size() > hub)
  {
    return;
  }
  std::sort(place.begin(), place.end(),
    [](const SkdCurveEnd& a, const SkdCurveEnd& b) { return a.Number < b.Number; });
  std::vector<std::tuple<double, std::size_t, std::size_t>> turns; // -1: straight on
  for (std::size_t i = 0; i < place.size(); ++i)
  {
    for (std::size_t j = i + 1; j < place.size(); ++j)
    {
      const skd::Vector3& a = place[i].Outward;
      const skd::Vector3& b = place[j].Outward;
      turns.emplace_back(skd::Dot(a, b) / (skd::Norm(a) * skd::Norm(b)), i, j);
    }
  }
  const auto isBefore = [](const auto& a, const auto& b) // also where there is no direction
  {
    const double turn = std::isnan(std::get<0>(a)) ? 2.0 : std::get<0>(a);
    const double other = std::isnan(std::get<0>(b)) ? 2.0 : std::get<0>(b);
    return std::tuple(turn, std::get<1>(a), std::get<2>(a)) <
      std::tuple(other, std::get<1>(b), std::get<2>(b));
  };
  std::sort(turns.begin(), turns.end(), isBefore);
  for (const auto& [turn, i, j] : turns)
  {
    std::size_t& one = this->Joints[place[i].Number];
    std::size_t& other = this->Joints[place[j].Number];
    const bool goesOn = place.size() == 2 || turn < 0.0;
    if (goesOn && one == None && other == None)
    {
      one = other = this->Count++;
    }
  }
}
}
