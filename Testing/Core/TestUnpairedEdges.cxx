// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Geometry/UnpairedEdges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <utility>
#include <vector>

//------------------------------------------------------------------------------
TEST(UnpairedEdges, EndsAreThoseOfEdgesThatAreNotPassedBothWays)
{
  std::mt19937 random(19);
  for (int i = 0; i < 50; ++i)
  {
    const std::uint32_t n = i % 2 == 0 ? 6 : 40;
    std::uniform_int_distribution<std::uint32_t> point(0, n - 1);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> passed;
    for (int k = 0; k < 300; ++k)
    {
      const auto from = point(random);
      const auto to = (from + 1 + point(random) % (n - 1)) % n;
      passed.insert(passed.end(), { { from, to }, { to, from } });
    }
    passed.resize(passed.size() - static_cast<std::size_t>(i % 3));
    std::shuffle(passed.begin(), passed.end(), random);
    skd::UnpairedEdges edges(n);
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> sums;
    for (const auto& [from, to] : passed)
    {
      edges.Add(from, to);
      sums[std::minmax(from, to)] += from < to ? 1 : -1;
    }
    std::vector<std::uint32_t> expected;
    for (const auto& [edge, sum] : sums)
    {
      if (sum != 0)
      {
        expected.insert(expected.end(), { edge.first, edge.second });
      }
    }
    std::sort(expected.begin(), expected.end());
    expected.erase(std::unique(expected.begin(), expected.end()), expected.end());
    EXPECT_EQ(edges.FindEnds().List(), expected);
  }
}
