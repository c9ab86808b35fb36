// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Queries_OverlapParts_h
#define skd_Queries_OverlapParts_h

#include "../Tree/WalkPairs.h"
#include "OverlappingPairs.h"

#include <cstddef>
#include <limits>
#include <type_traits>
#include <vector>

namespace skd
{

/// The search for overlapping pairs of two trees in parts that may be searched in parallel. What is
/// in a part depends on the trees alone, not on the number of threads. See OverlappingPairs for the
/// arguments.
template <int D, class FirstTree, class SecondTree, class ToFirst, class Visitor>
class OverlapParts
{
public:
  /// At least `enough` parts, or as many as there can be. Of one tree twice, each pair is visited
  /// once and no element with itself if `isWithinOne`. The arguments must outlive this.
  OverlapParts(const FirstTree& first, const SecondTree& second, const ToFirst& toFirst,
    std::size_t enough, Visitor visitor, bool isWithinOne,
    double excess = std::numeric_limits<double>::infinity())
    : First(first)
    , Second(second)
    , Map(toFirst)
    , IsWithinOne(isWithinOne)
    , Excess(excess)
  {
    this->InWalk(visitor, [&](Walk& walk) { this->Starts = walk.Split(enough); });
  }

  std::size_t size() const { return this->Starts.size(); }
  /// Where the walk of a part begins.
  const TreePair<D>& StartOf(std::size_t part) const { return this->Starts[part]; }

  /// Visits the pairs of the parts from one to before another. Thread-safe.
  void Visit(std::size_t begin, std::size_t end, Visitor visitor) const
  {
    this->InWalk(visitor,
      [&](Walk& walk)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          walk.RunFrom(this->Starts[i]);
        }
      });
  }

private:
  using Query = OverlappingPairs<D, ToFirst, Visitor>;
  using Walk = PairWalk<FirstTree, SecondTree, Query>;

  template <class Body>
  void InWalk(Visitor& visitor, const Body& body) const
  {
    Query query(this->First.GetFrame(), this->Second.GetFrame(), this->Map, visitor, this->Excess);
    if constexpr (std::is_same_v<FirstTree, SecondTree>)
    {
      if (this->IsWithinOne)
      {
        Walk walk(this->First, query);
        body(walk);
        return;
      }
    }
    Walk walk(this->First, this->Second, query);
    body(walk);
  }

  const FirstTree& First;
  const SecondTree& Second;
  const ToFirst& Map;
  const bool IsWithinOne;
  const double Excess;
  std::vector<TreePair<D>> Starts;
};

}

#endif
