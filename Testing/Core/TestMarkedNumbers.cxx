// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Geometry/MarkedNumbers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

namespace
{

TEST(MarkedNumbers, AreListedAscendingAndOnce)
{
  std::mt19937 random(5);
  for (const std::uint32_t n : { 1u, 63u, 64u, 65u, 1000u })
  {
    skd::MarkedNumbers marked(n);
    std::set<std::uint32_t> expected;
    for (std::uint32_t i = 0; i < n / 3 + 1; ++i)
    {
      const auto number = static_cast<std::uint32_t>(random() % n);
      marked.Mark(number);
      expected.insert(number);
    }
    marked.Mark(n - 1);
    expected.insert(n - 1);
    EXPECT_EQ(marked.List(), std::vector<std::uint32_t>(expected.begin(), expected.end()));
    for (std::uint32_t number = 0; number < n; ++number)
    {
      EXPECT_EQ(marked.IsMarked(number), expected.count(number) == 1) << number;
      EXPECT_EQ(marked.FindNext(number, n), *expected.lower_bound(number)) << number;
      const std::uint32_t end = number + (n - number) / 2;
      EXPECT_EQ(marked.FindNext(number, end), std::min(end, *expected.lower_bound(number)));
    }
    marked.Clear();
    EXPECT_TRUE(marked.List().empty());
    EXPECT_EQ(marked.FindNext(0, n), n);
  }
}

}
