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
  std::vector<SkdCurveEnd> group;
  const double last = KeyOf(ends[first]) + 4.0 * rounding;
  for (std::size_t i = first; i < ends.size() && KeyOf(ends[i]) <= last; ++i)
  {
    if (!isTaken[i] && skd::Distance2(ends[i].X, ends[first].X) <= rounding * rounding)
    {
      isTaken[i] = 1;
      group.push_back(ends[i]);
    }
  }
  return group;
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
      std::vector<SkdCurveEnd> group = TakeCoincidentEnds(ends, isTaken, first, rounding);
      this->Join(group);
    }
  }
}

//------------------------------------------------------------------------------
void SkdCurveJoints::Join(std::vector<SkdCurveEnd>& group)
{
  constexpr std::size_t hub = 64;
  if (group.size() < 2 || group.size() > hub)
  {
    return;
  }
  std::sort(group.begin(), group.end(),
    [](const SkdCurveEnd& a, const SkdCurveEnd& b) { return a.Number < b.Number; });
  std::vector<std::tuple<double, std::size_t, std::size_t>> cosines; // -1: straight on
  for (std::size_t i = 0; i < group.size(); ++i)
  {
    for (std::size_t j = i + 1; j < group.size(); ++j)
    {
      const skd::Vector3& a = group[i].Outward;
      const skd::Vector3& b = group[j].Outward;
      cosines.emplace_back(skd::Dot(a, b) / (skd::Norm(a) * skd::Norm(b)), i, j);
    }
  }
  const auto isBefore = [](const auto& a, const auto& b) // also where there is no direction
  {
    const double cosine = std::isnan(std::get<0>(a)) ? 2.0 : std::get<0>(a);
    const double other = std::isnan(std::get<0>(b)) ? 2.0 : std::get<0>(b);
    return std::tuple(cosine, std::get<1>(a), std::get<2>(a)) <
      std::tuple(other, std::get<1>(b), std::get<2>(b));
  };
  std::sort(cosines.begin(), cosines.end(), isBefore);
  for (const auto& [cosine, i, j] : cosines)
  {
    std::size_t& one = this->Joints[group[i].Number];
    std::size_t& other = this->Joints[group[j].Number];
    const bool goesOn = group.size() == 2 || cosine < 0.0;
    if (goesOn && one == None && other == None)
    {
      one = other = this->Count++;
    }
  }
}
}
