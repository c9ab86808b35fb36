// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// Disjoint sets against labels that are all rewritten at each union.

#include "Core/Geometry/DisjointSets.h"

#include <gtest/gtest.h>

#include <random>

TEST(DisjointSets, AreThoseOfRewrittenLabels)
{
  constexpr std::uint32_t n = 60;
  std::mt19937 random(7);
  skd::DisjointSets<> sets(n - 1);
  sets.Add();
  ASSERT_EQ(sets.Size(), n);
  std::vector<std::uint32_t> labels(n);
  std::iota(labels.begin(), labels.end(), 0u);
  for (int step = 0; step < 50; ++step)
  {
    const std::uint32_t a = random() % n;
    const std::uint32_t b = random() % n;
    const std::uint32_t least = std::min(labels[a], labels[b]);
    const std::uint32_t most = std::max(labels[a], labels[b]);
    EXPECT_EQ(sets.Unite(a, b), least != most);
    std::replace(labels.begin(), labels.end(), most, least);
    for (std::uint32_t i = 0; i < n; ++i)
    {
      ASSERT_EQ(static_cast<const skd::DisjointSets<>&>(sets).Find(i), labels[i]);
    }
    skd::DisjointSets<> copy = sets;
    ASSERT_EQ(copy.Representatives(), labels);
    const std::uint32_t some = random() % n;
    ASSERT_EQ(copy.Find(some), sets.Find(some));
  }
  std::vector<std::uint32_t> numbers;
  std::vector<std::uint32_t> numberOf(n);
  std::uint32_t count = 0;
  for (std::uint32_t i = 0; i < n; ++i)
  {
    numberOf[i] = labels[i] == i ? count++ : numberOf[labels[i]];
    numbers.push_back(numberOf[i]);
  }
  EXPECT_GT(count, 1u);
  EXPECT_EQ(sets.Number(), numbers);
}

TEST(DisjointSets, AreApartOnceAllOfOneAreTakenOut)
{
  skd::DisjointSets<> sets(9);
  for (const std::uint32_t i : { 7u, 3u, 5u })
  {
    sets.Unite(i, 1);
  }
  sets.Unite(2, 8);
  sets.Find(7);
  for (const std::uint32_t i : { 1u, 3u, 5u, 7u })
  {
    sets.TakeOut(i);
  }
  EXPECT_EQ(sets.Representatives(), (std::vector<std::uint32_t>{ 0, 1, 2, 3, 4, 5, 6, 7, 2 }));
}

TEST(DisjointSets, OfNothingAreNone)
{
  skd::DisjointSets<int> sets(0);
  EXPECT_TRUE(sets.Representatives().empty());
  EXPECT_TRUE(sets.Number().empty());
}
