// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// EdgeTable against a map of all edges.

#include "Core/Geometry/EdgeTable.h"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <random>
#include <tuple>

namespace
{

/// A triangle, its side and whether it has the edge forward.
using Use = std::tuple<std::uint32_t, int, bool>;

template <class Index>
using Edges = std::map<std::pair<Index, Index>, std::vector<Use>>;

const auto InTurn = [](std::size_t n, const auto& body)
{
  for (std::size_t i = 0; i < n; ++i)
  {
    body(i);
  }
};

template <class Index>
void ExpectTable(const std::vector<std::array<Index, 3>>& triangles, std::size_t numberOfPoints)
{
  Edges<Index> expected;
  for (std::uint32_t triangle = 0; triangle < triangles.size(); ++triangle)
  {
    for (int i = 0; i < 3; ++i)
    {
      const Index a = triangles[triangle][static_cast<std::size_t>(i)];
      const Index b = triangles[triangle][static_cast<std::size_t>((i + 1) % 3)];
      expected[{ std::min(a, b), std::max(a, b) }].push_back({ triangle, i, a < b });
    }
  }
  Edges<Index> found;
  std::vector<std::pair<Index, Index>> order;
  skd::EdgeTable<Index>(triangles, numberOfPoints, InTurn)
    .ForEach(
      [&](Index low, const skd::EdgeUse<Index>* first, const skd::EdgeUse<Index>* last)
      {
        order.emplace_back(low, first->High);
        for (; first != last; ++first)
        {
          found[{ low, first->High }].push_back({ first->Triangle, first->Side, first->IsForward });
        }
      });
  EXPECT_EQ(found, expected);
  EXPECT_TRUE(std::is_sorted(order.begin(), order.end()));
  EXPECT_EQ(order.size(), expected.size());
}

template <class Index>
void ExpectRandomTables()
{
  std::mt19937 random(5);
  for (const unsigned points : { 1u, 2u, 3u, 5u, 40u, 1000u })
  {
    for (const std::size_t count : { 0u, 1u, 2u, 100u, 3000u })
    {
      std::vector<std::array<Index, 3>> triangles(count);
      for (std::array<Index, 3>& corners : triangles)
      {
        for (Index& corner : corners)
        {
          corner = static_cast<Index>(random() % points);
        }
      }
      ExpectTable(triangles, points);
    }
  }
}

}

TEST(EdgeTable, HasEachUseOfEachEdgeInOrder)
{
  ExpectRandomTables<std::uint32_t>();
  ExpectRandomTables<long long>();
}

TEST(EdgeTable, IsEmptyWithoutTriangles)
{
  skd::EdgeTable<>().ForEach([](std::uint32_t, const auto*, const auto*) { ADD_FAILURE(); });
}
