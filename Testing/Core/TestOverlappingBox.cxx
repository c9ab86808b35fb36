// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Search/Queries/OverlappingBox.h"
#include "CoreSupport.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace
{

template <class Value>
class OverlappingBoxTest : public ::testing::Test
{
protected:
  static constexpr int D = Value::value;
  using Box = skd::Box<D>;
  static constexpr double Epsilon = 1e-3;

  std::mt19937_64 Engine{ 41 };

  double Between(double min, double max)
  {
    return std::uniform_real_distribution<double>(min, max)(this->Engine);
  }

  Box RandomBox(double size)
  {
    Box box;
    for (int axis = 0; axis < D; ++axis)
    {
      box.Min[axis] = this->Between(-1.0, 1.0);
      box.Max[axis] = box.Min[axis] + this->Between(0.0, size);
    }
    return box;
  }

  std::vector<Box> RandomBoxes(int count, double size)
  {
    std::vector<Box> boxes;
    for (int i = 0; i < count; ++i)
    {
      boxes.push_back(this->RandomBox(i % 5 == 0 ? 0.0 : size));
    }
    return boxes;
  }

  /// What a walk reports, each once; `doubtful` counts what it was not sure of.
  template <class Tree>
  std::set<std::uint32_t> Report(
    const Tree& tree, const std::vector<Box>& boxes, const Box& query, int& doubtful)
  {
    std::set<std::uint32_t> found;
    doubtful = 0;
    auto visitor = [&](std::uint32_t element)
    {
      ++doubtful;
      if (boxes[element].Overlaps(query))
      {
        EXPECT_TRUE(found.insert(element).second);
      }
      return true;
    };
    auto sure = [&](std::uint32_t element)
    {
      EXPECT_TRUE(boxes[element].Overlaps(query)) << element;
      EXPECT_TRUE(found.insert(element).second);
      return true;
    };
    skd::OverlappingBox<D, decltype(visitor), decltype(sure)> overlapping(
      tree.GetFrame(), query, 2.0 * Epsilon, visitor, sure);
    skd::Walk(tree, overlapping);
    return found;
  }

  static std::set<std::uint32_t> BruteForce(const std::vector<Box>& boxes, const Box& query)
  {
    std::set<std::uint32_t> found;
    for (std::uint32_t i = 0; i < boxes.size(); ++i)
    {
      if (boxes[i].Overlaps(query))
      {
        found.insert(i);
      }
    }
    return found;
  }
};

using Dimensions = ::testing::Types<std::integral_constant<int, 1>, std::integral_constant<int, 2>,
  std::integral_constant<int, 3>, std::integral_constant<int, 4>>;
TYPED_TEST_SUITE(OverlappingBoxTest, Dimensions);

TYPED_TEST(OverlappingBoxTest, ReportsWhatOverlapsEachOnce)
{
  constexpr int D = TypeParam::value;
  for (const int count : { 0, 1, 8, 9, 100, 3000 })
  {
    const auto boxes = this->RandomBoxes(count, 0.1);
    const auto tree = skd::BuildTree<D>(skd::MakeTreeInput<D>(boxes, this->Epsilon));
    const auto lazy = skd::BuildLazyTree<D>(skd::MakeTreeInput<D>(boxes, this->Epsilon));
    for (const double size : { 0.0, 0.01, 0.3, 2.0, 4.0 })
    {
      for (int i = 0; i < 20; ++i)
      {
        const auto query = this->RandomBox(size);
        const auto expected = this->BruteForce(boxes, query);
        int doubtful = 0;
        ASSERT_EQ(this->Report(tree, boxes, query, doubtful), expected);
        ASSERT_EQ(this->Report(lazy, boxes, query, doubtful), expected);
      }
    }
  }
}

// Boxes that touch the query box, or miss it by less than a float resolves.
TYPED_TEST(OverlappingBoxTest, IsExactAtTheFacesOfTheBox)
{
  constexpr int D = TypeParam::value;
  const auto boxes = this->RandomBoxes(500, 0.1);
  const auto tree = skd::BuildTree<D>(skd::MakeTreeInput<D>(boxes, this->Epsilon));
  for (const auto& box : boxes)
  {
    auto query = this->RandomBox(0.5);
    const int axis = static_cast<int>(this->Engine() % D);
    for (const double gap : { 0.0, 1e-15, -1e-15, 1e-8, -1e-8, 1e-3, 2e-3 })
    {
      query.Min[axis] = box.Max[axis] + gap;
      query.Max[axis] = query.Min[axis] + 0.3;
      int doubtful = 0;
      ASSERT_EQ(this->Report(tree, boxes, query, doubtful), this->BruteForce(boxes, query));
    }
  }
}

TYPED_TEST(OverlappingBoxTest, OnlyALayerIsInDoubt)
{
  constexpr int D = TypeParam::value;
  const auto boxes = this->RandomBoxes(3000, 0.1);
  const auto tree = skd::BuildTree<D>(skd::MakeTreeInput<D>(boxes, this->Epsilon));
  const double infinity = std::numeric_limits<double>::infinity();
  skd::Box<D> query;
  for (int axis = 0; axis < D; ++axis)
  {
    query.Min[axis] = -infinity;
    query.Max[axis] = infinity;
  }
  int doubtful = 0;
  EXPECT_EQ(this->Report(tree, boxes, query, doubtful).size(), boxes.size());
  EXPECT_EQ(doubtful, 0);
  query = this->RandomBox(1.0);
  const std::size_t found = this->Report(tree, boxes, query, doubtful).size();
  EXPECT_LE(doubtful, static_cast<int>(found) / 4 + 40);
}

TYPED_TEST(OverlappingBoxTest, EndsWhenRequested)
{
  constexpr int D = TypeParam::value;
  const auto boxes = this->RandomBoxes(1000, 0.1);
  const auto tree = skd::BuildTree<D>(skd::MakeTreeInput<D>(boxes, this->Epsilon));
  int visits = 0;
  auto few = [&](std::uint32_t) { return ++visits < 5; };
  skd::Box<D> all;
  all.Add(tree.GetBounds());
  skd::OverlappingBox<D, decltype(few), decltype(few)> query(
    tree.GetFrame(), all, 2.0 * this->Epsilon, few, few);
  skd::Walk(tree, query);
  EXPECT_EQ(visits, 5);
}

}
