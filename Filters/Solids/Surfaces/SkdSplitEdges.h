// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdSplitEdges_h
#define SkdSplitEdges_h

#include "Solids/Surfaces/SkdSplitSegments.h"

#include <algorithm>
#include <numeric>

namespace skdtree
{
/// The points on the edges of a side, found by the ends of an edge.
class SkdSplitEdges
{
public:
  struct Row
  {
    const SkdSplitEdgePoint* First;
    const SkdSplitEdgePoint* Last;
  };

  explicit SkdSplitEdges(const SkdSplitSegments::Side& side)
    : Points(side.EdgePoints.data())
    , Begin(side.Set->GetPoints().size() + 1, 0)
  {
    for (const SkdSplitEdgePoint& point : side.EdgePoints)
    {
      ++this->Begin[point.From + std::size_t(1)];
    }
    std::partial_sum(this->Begin.begin(), this->Begin.end(), this->Begin.begin());
  }

  /// Whether an edge whose lower corner is this one has points.
  bool AreAtLower(std::uint32_t corner) const
  {
    return this->Begin[corner] != this->Begin[corner + std::size_t(1)];
  }

  /// Of the edge between two corners, along it from the lower one.
  Row Find(std::uint32_t a, std::uint32_t b) const
  {
    const std::uint32_t low = std::min(a, b);
    const std::uint32_t high = std::max(a, b);
    const SkdSplitEdgePoint* const begin = this->Points + this->Begin[low];
    const SkdSplitEdgePoint* const end = this->Points + this->Begin[low + std::size_t(1)];
    const auto [first, last] = std::equal_range(begin, end, SkdSplitEdgePoint{ low, high, 0 },
      [](const SkdSplitEdgePoint& x, const SkdSplitEdgePoint& y) { return x.To < y.To; });
    return { first, last };
  }

private:
  const SkdSplitEdgePoint* Points;
  std::vector<std::uint32_t> Begin; // of each lower corner
};
}

#endif
