// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// Rows against a vector of vectors.

#include "Core/Geometry/Rows.h"

#include <gtest/gtest.h>

#include <random>
#include <utility>

namespace
{

using Lists = std::vector<std::vector<std::uint32_t>>;

template <class Offset>
Lists ListsOf(const skd::Rows<std::uint32_t, Offset>& rows)
{
  Lists lists;
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    const auto row = rows[i];
    lists.emplace_back(row.begin(), row.end());
    EXPECT_EQ(lists.back().size(), row.size());
    for (std::size_t k = 0; k < row.size(); ++k)
    {
      EXPECT_EQ(row[k], lists.back()[k]);
    }
  }
  return lists;
}

struct Scattered
{
  std::size_t NumberOfRows;
  std::vector<std::pair<std::size_t, std::uint32_t>> Items; // each with its row

  template <class Add>
  void operator()(const Add& add) const
  {
    for (const auto& [row, item] : this->Items)
    {
      add(row, item);
    }
  }

  Lists InLists() const
  {
    Lists lists(this->NumberOfRows);
    (*this)([&](std::size_t row, std::uint32_t item) { lists[row].push_back(item); });
    return lists;
  }
};

std::vector<Scattered> AllScattered()
{
  std::mt19937 random(11);
  std::vector<Scattered> all{ { 0, {} }, { 3, {} } };
  for (const std::size_t rows : { 1u, 2u, 50u })
  {
    for (const std::size_t items : { 1u, 30u, 400u })
    {
      all.push_back({ rows, {} });
      for (std::size_t i = 0; i < items; ++i)
      {
        all.back().Items.emplace_back(random() % rows, random() % 60);
      }
    }
  }
  return all;
}

const auto InTurn = [](std::size_t n, const auto& body)
{
  for (std::size_t i = 0; i < n; ++i)
  {
    body(i);
  }
};

template <class Offset>
class RowsTest : public ::testing::Test
{
};
using Offsets = ::testing::Types<std::size_t, std::uint32_t>;
TYPED_TEST_SUITE(RowsTest, Offsets);

TYPED_TEST(RowsTest, KeepTheOrderOfScatteredItems)
{
  for (const Scattered& scattered : AllScattered())
  {
    const skd::Rows<std::uint32_t, TypeParam> rows(scattered.NumberOfRows, scattered);
    EXPECT_EQ(ListsOf(rows), scattered.InLists());
    EXPECT_EQ(rows.GetItems().size(), scattered.Items.size());
    EXPECT_EQ(rows.GetOffsets().size(), scattered.NumberOfRows + 1);
  }
}

TYPED_TEST(RowsTest, AreAddedAtTheEnd)
{
  for (const Scattered& scattered : AllScattered())
  {
    Lists lists = scattered.InLists();
    skd::Rows<std::uint32_t, TypeParam> rows;
    EXPECT_EQ(rows.size(), 0u);
    for (const std::vector<std::uint32_t>& list : lists)
    {
      rows.Add(list.begin(), list.end());
    }
    rows.AddEmpty(2);
    lists.resize(lists.size() + 2);
    EXPECT_EQ(ListsOf(rows), lists);
  }
}

TYPED_TEST(RowsTest, AreSortedEach)
{
  for (const Scattered& scattered : AllScattered())
  {
    skd::Rows<std::uint32_t, TypeParam> rows(scattered.NumberOfRows, scattered);
    rows.SortEach(InTurn);
    Lists lists = scattered.InLists();
    for (std::vector<std::uint32_t>& list : lists)
    {
      std::sort(list.begin(), list.end());
    }
    EXPECT_EQ(ListsOf(rows), lists);
  }
}

TYPED_TEST(RowsTest, OfTheInverseAreTheRowsThatHaveAnItem)
{
  for (const Scattered& scattered : AllScattered())
  {
    const skd::Rows<std::uint32_t, TypeParam> rows(scattered.NumberOfRows, scattered);
    Lists expected(60);
    const Lists lists = scattered.InLists();
    for (std::uint32_t row = 0; row < lists.size(); ++row)
    {
      for (const std::uint32_t item : lists[row])
      {
        expected[item].push_back(row);
      }
    }
    EXPECT_EQ(ListsOf(rows.Inverse(60)), expected);
  }
}

}
