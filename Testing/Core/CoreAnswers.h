// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The elements that brute force finds, and what is expected of those that a query reached.
#ifndef coretest_CoreAnswers_h
#define coretest_CoreAnswers_h

#include "CoreScenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <vector>

namespace coretest
{

using Ids = std::vector<std::uint32_t>;

/// The elements of a scene for which `isWanted(box)`.
template <int D, class Predicate>
Ids Select(const Boxes<D>& boxes, Predicate isWanted)
{
  Ids ids;
  for (std::size_t i = 0; i < boxes.size(); ++i)
  {
    if (isWanted(boxes[i]))
    {
      ids.push_back(static_cast<std::uint32_t>(i));
    }
  }
  return ids;
}

inline Ids Sorted(Ids ids)
{
  std::sort(ids.begin(), ids.end());
  return ids;
}

/// Each once at most, every one of `must`, and none that is not in `may`.
inline void ExpectVisited(const Ids& visited, const Ids& must, const Ids& may)
{
  const Ids got = Sorted(visited);
  EXPECT_TRUE(std::adjacent_find(got.begin(), got.end()) == got.end()) << "reached twice";
  Ids missed;
  std::set_difference(must.begin(), must.end(), got.begin(), got.end(), std::back_inserter(missed));
  EXPECT_TRUE(missed.empty()) << missed.size() << " of " << must.size()
                              << " missed, one of them: " << missed.front();
  Ids needless;
  std::set_difference(got.begin(), got.end(), may.begin(), may.end(), std::back_inserter(needless));
  EXPECT_TRUE(needless.empty()) << needless.size() << " of " << got.size()
                                << " reached needlessly, one of them: " << needless.front();
}

}

#endif
