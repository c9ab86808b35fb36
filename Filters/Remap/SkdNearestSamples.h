// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// SkdSampleTree::FindNearest, apart so that few files depend on the query that it runs.
#ifndef SkdNearestSamples_h
#define SkdNearestSamples_h

#include "Core/Search/Queries/Nearest.h"
#include "Core/Search/Tree/Walk.h"
#include "Remap/SkdSampleTree.h"

#include <algorithm>
#include <limits>

namespace skdtree
{
template <class Wanted>
void SkdSampleTree::FindNearest(
  const skd::Vector3& x, int most, const Wanted& isWanted, std::vector<Near>& nearest) const
{
  const skd::Vector3 position = this->CoordinatesOf(x);
  const auto wanted = static_cast<std::size_t>(most);
  nearest.clear();
  auto visitor = [&](std::uint32_t i)
  {
    const Near one{ skd::Distance2(this->CoordinatesOf(this->Points[i]), position), i };
    if (isWanted(i) && (nearest.size() < wanted || one < nearest.back()))
    {
      nearest.insert(std::upper_bound(nearest.begin(), nearest.end(), one), one);
      nearest.resize(std::min(nearest.size(), wanted));
    }
    return nearest.size() < wanted ? std::numeric_limits<double>::infinity()
                                   : nearest.back().Distance2;
  };
  if (skd::IsFinite(position) && most > 0)
  {
    skd::Nearest<3, decltype(visitor)> query(
      this->Tree.GetFrame(), position, std::numeric_limits<double>::infinity(), visitor);
    skd::Walk(this->Tree, query);
  }
}

template <class Wanted>
std::int64_t SkdSampleTree::FindNearest(const skd::Vector3& x, const Wanted& isWanted) const
{
  const skd::Vector3 position = this->CoordinatesOf(x);
  double best2 = std::numeric_limits<double>::infinity();
  std::int64_t best = -1;
  auto visitor = [&](std::uint32_t i)
  {
    const double dist2 = skd::Distance2(this->CoordinatesOf(this->Points[i]), position);
    if (isWanted(i) && (dist2 < best2 || (dist2 == best2 && i < best)))
    {
      best2 = dist2;
      best = i;
    }
    return best2;
  };
  if (skd::IsFinite(position))
  {
    skd::Nearest<3, decltype(visitor)> query(this->Tree.GetFrame(), position, best2, visitor);
    skd::Walk(this->Tree, query);
  }
  return best;
}
}

#endif
