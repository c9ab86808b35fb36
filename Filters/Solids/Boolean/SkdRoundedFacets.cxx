// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Boolean/SkdRoundedFacets.h"

#include "Bodies/SkdWeld.h"
#include "Solids/Surfaces/SkdPointFilter.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <numeric>

namespace skdtree
{
namespace
{
using Corners = SkdTriangleSet::Corners;

/// A facet of the boundary by its corners, ascending, and which way it faces as seen with these.
struct Laid
{
  Corners Ascending;
  std::uint32_t Facet;
  int Sign;

  bool operator<(const Laid& other) const
  {
    return this->Ascending != other.Ascending ? this->Ascending < other.Ascending
                                              : this->Facet < other.Facet;
  }
};

bool HasEqualCorners(const Corners& corners)
{
  return corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0];
}

/// 1 if the corners are ascending but for where they begin, else -1.
int OrientationOf(const Corners& corners)
{
  return (corners[0] < corners[1]) + (corners[1] < corners[2]) + (corners[2] < corners[0]) == 2
    ? 1
    : -1;
}

/// The facets of the boundary with a point that several have become.
std::vector<Laid> ListLaid(const SkdRoundedFacets& rounded, const std::vector<bool>& isShared)
{
  std::vector<Laid> laid;
  for (std::uint32_t facet = 0; facet < rounded.Signs.size(); ++facet)
  {
    const Corners& corners = rounded.Facets.Corners[facet];
    if (rounded.Signs[facet] != 0 &&
      (isShared[corners[0]] || isShared[corners[1]] || isShared[corners[2]]))
    {
      laid.push_back({ corners, facet, rounded.Signs[facet] * OrientationOf(corners) });
      std::sort(laid.back().Ascending.begin(), laid.back().Ascending.end());
    }
  }
  std::sort(laid.begin(), laid.end());
  return laid;
}

/// Of facets that are laid on each other as many stay as face one way more often than the other.
void TakeOut(const Laid* first, const Laid* last, bool keepsOne, SkdFacetSigns& signs)
{
  int sum = 0;
  std::for_each(first, last, [&sum](const Laid& laid) { sum += laid.Sign; });
  int left = keepsOne ? 1 : std::abs(sum);
  for (const Laid* laid = first; laid != last; ++laid)
  {
    const bool stays = left > 0 && (keepsOne || (laid->Sign > 0) == (sum > 0));
    left -= stays;
    signs[laid->Facet] = stays ? signs[laid->Facet] : static_cast<signed char>(0);
  }
}

/// A point to 48 bits of its largest coordinate (16 units in the last place), so that those that
/// differ by rounding are equal, as a rule: where faces lie in one plane but for rounding, their
/// edges cross each other in many such points. With 50 bits too many stay apart.
skd::Vector3 Coarse(const skd::Vector3& x)
{
  constexpr int bits = 48;
  const double largest = std::max({ std::abs(x[0]), std::abs(x[1]), std::abs(x[2]) });
  std::uint64_t exponent;
  std::memcpy(&exponent, &largest, sizeof(exponent));
  exponent &= 0x7ff0000000000000u;
  double power; // of two, not above the largest
  std::memcpy(&power, &exponent, sizeof(power));
  // Added and subtracted, this number leaves multiples of power / 2^bits.
  const double shift = 1.5 * power * static_cast<double>(1 << (52 - bits));
  if (!std::isfinite(shift))
  {
    return x; // beyond 1e306
  }
  skd::Vector3 coarse;
  for (int axis = 0; axis < 3; ++axis)
  {
    coarse[axis] = (x[axis] + shift) - shift;
  }
  return coarse;
}
}

std::vector<std::uint32_t> SkdFindEqualPoints(
  const SkdPlacement& placement, const SkdFacets& facets)
{
  const SkdMovedTriangles& set = placement.First;
  const double unscaled = 1.0 / placement.Scale;
  const auto given = static_cast<std::uint32_t>(set.GetPoints().size());
  const auto end = given + static_cast<std::uint32_t>(facets.NewPoints.size());
  const auto coarseAt = [&](std::uint32_t point)
  { return Coarse(unscaled * facets.GetPosition(set, point)); };
  SkdPointFilter filter(facets.NewPoints.size());
  for (std::uint32_t point = given; point < end; ++point)
  {
    filter.Add(coarseAt(point));
  }
  SkdWeld weld(facets.NewPoints.size());
  std::vector<std::uint32_t> firsts; // of each position
  std::vector<std::uint32_t> lowest;
  for (std::uint32_t point = given == end ? end : 0; point < end; ++point)
  {
    const skd::Vector3 x = coarseAt(point);
    if (point < given && !filter.MayHave(x))
    {
      continue;
    }
    const auto welded = static_cast<std::size_t>(weld.GetId(x.X));
    if (welded == firsts.size())
    {
      firsts.push_back(point);
      continue;
    }
    if (point < given)
    {
      continue; // given points that are different stay so
    }
    if (lowest.empty())
    {
      lowest.resize(end);
      std::iota(lowest.begin(), lowest.end(), 0u);
    }
    lowest[point] = firsts[welded];
  }
  return lowest;
}

SkdRoundedFacets SkdMakeRounded(const SkdFacets& facets, const SkdFacetSigns& signs)
{
  SkdRoundedFacets rounded;
  rounded.Facets.Corners = facets.Corners;
  rounded.Facets.Parents = facets.Parents;
  rounded.Facets.NewPoints = facets.NewPoints;
  rounded.Signs = signs;
  return rounded;
}

SkdRoundedFacets SkdUniteEqualPoints(
  SkdRoundedFacets rounded, const std::vector<std::uint32_t>& lowest, bool keepsOne)
{
  const SkdFacetSigns signs = rounded.Signs;
  std::vector<bool> isShared(lowest.size(), false);
  for (std::uint32_t point = 0; point < lowest.size(); ++point)
  {
    isShared[lowest[point]] = isShared[lowest[point]] || lowest[point] != point;
  }
  for (std::uint32_t facet = 0; facet < signs.size(); ++facet)
  {
    Corners& corners = rounded.Facets.Corners[facet];
    std::transform(corners.begin(), corners.end(), corners.begin(),
      [&](std::uint32_t corner) { return lowest[corner]; });
    rounded.Signs[facet] = HasEqualCorners(corners) ? static_cast<signed char>(0) : signs[facet];
  }
  const std::vector<Laid> laid = ListLaid(rounded, isShared);
  for (const Laid *first = laid.data(), *end = first + laid.size(); first != end;)
  {
    const Laid* last = std::find_if(
      first, end, [&](const Laid& other) { return other.Ascending != first->Ascending; });
    TakeOut(first, last, keepsOne, rounded.Signs);
    first = last;
  }
  for (std::uint32_t facet = 0; facet < signs.size(); ++facet)
  {
    rounded.NumberFolded += signs[facet] != rounded.Signs[facet];
  }
  return rounded;
}
}
