// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Search/Tree/PackedRTree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace
{
using skd::Box3;
using BoxList = std::vector<Box3>;

struct Scene
{
  int Count;
  double Size; ///< of the largest box, where all are in a unit cube
  double Shift = 0.0;
  double Scale = 1.0;
  bool IsFlat = false;
};

BoxList MakeBoxes(const Scene& scene, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  BoxList boxes(static_cast<std::size_t>(scene.Count));
  for (Box3& box : boxes)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const bool isThin = scene.IsFlat && axis == 1;
      const double low = isThin ? 0.5 : unit(random);
      const double length = isThin ? 0.0 : scene.Size * unit(random);
      box.Min[axis] = scene.Scale * (scene.Shift + low);
      box.Max[axis] = scene.Scale * (scene.Shift + low + length);
    }
  }
  return boxes;
}

/// What overlaps is visited, nothing twice, and nothing that is farther away than `excess`.
void ExpectRight(const BoxList& boxes, const BoxList& asked, double excess)
{
  const skd::PackedRTree tree(boxes);
  for (const Box3& box : asked)
  {
    std::vector<int> visits(boxes.size(), 0);
    tree.ForEachOverlapping(box, [&](std::uint32_t i) { ++visits.at(i); });
    const Box3 around = box.Inflated(excess);
    for (std::size_t i = 0; i < boxes.size(); ++i)
    {
      ASSERT_LE(visits[i], around.Overlaps(boxes[i]) ? 1 : 0) << i;
      ASSERT_GE(visits[i], box.Overlaps(boxes[i]) ? 1 : 0) << i;
    }
  }
}

/// Each pair that overlaps is visited, nothing twice, and none that is farther apart than `excess`.
void ExpectRightPairs(const BoxList& boxes, double excess)
{
  const skd::PackedRTree tree(boxes);
  std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
  skd::PackedRTree::OverlapLists lists;
  for (std::size_t packet = 0; packet < tree.GetNumberOfPackets(); ++packet)
  {
    EXPECT_TRUE(tree.ForEachOverlapWithin(packet, lists,
      [&](std::uint32_t i, const std::vector<std::uint32_t>& others)
      {
        for (const std::uint32_t k : others)
        {
          EXPECT_TRUE(pairs.insert(std::minmax(i, k)).second) << i << " " << k;
          EXPECT_TRUE(boxes[i].Inflated(excess).Overlaps(boxes[k])) << i << " " << k;
        }
        return true;
      }));
  }
  for (std::uint32_t i = 0; i < boxes.size(); ++i)
  {
    for (std::uint32_t k = i + 1; k < boxes.size(); ++k)
    {
      ASSERT_GE(pairs.count({ i, k }), boxes[i].Overlaps(boxes[k]) ? 1u : 0u) << i << " " << k;
    }
    ASSERT_EQ(pairs.count({ i, i }), 0u) << i;
  }
}

void ExpectRight(const Scene& scene)
{
  const BoxList boxes = MakeBoxes(scene, 3);
  const double steps = 4.0 / 16000.0; // of the lattice, and its rounding
  ExpectRight(boxes, MakeBoxes({ 300, 0.3, scene.Shift, scene.Scale, scene.IsFlat }, 5),
    steps * scene.Scale * (1.0 + scene.Size));
  const BoxList few(boxes.begin(), boxes.begin() + std::min<std::ptrdiff_t>(700, scene.Count));
  ExpectRightPairs(few, 2.0 * steps * scene.Scale * (1.0 + scene.Size));
}
}

//------------------------------------------------------------------------------
TEST(PackedRTree, AllThatOverlapAreVisitedOnce)
{
  for (const int count : { 1, 7, 8, 9, 64, 65, 700, 5000 })
  {
    ExpectRight({ count, 0.05 });
    ExpectRight({ count, 0.0 });
    ExpectRight({ count, 1.0 });
  }
}

//------------------------------------------------------------------------------
TEST(PackedRTree, FlatFarTinyAndHugeOnesAreToo)
{
  ExpectRight({ 500, 0.05, 0.0, 1.0, true });
  ExpectRight({ 500, 0.05, 1e6 });
  ExpectRight({ 500, 0.05, -1e12 });
  ExpectRight({ 500, 0.05, 0.0, 1e-300 });
  ExpectRight({ 500, 0.05, 0.0, 1e300 });
}

//------------------------------------------------------------------------------
TEST(PackedRTree, BoxesThatTouchOverlap)
{
  BoxList boxes;
  for (int i = 0; i < 100; ++i)
  {
    boxes.push_back({ { { 0.1 * i, 0.0, 0.0 } }, { { 0.1 * (i + 1), 1.0, 1.0 } } });
  }
  ExpectRight(boxes, boxes, 0.005);
}

//------------------------------------------------------------------------------
TEST(PackedRTree, EqualOnesAreAllVisited)
{
  const Box3 box({ { 1.0, 2.0, 3.0 } }, { { 1.5, 2.0, 3.0 } });
  ExpectRight(BoxList(77, box), { box }, 0.0);
  ExpectRightPairs(BoxList(77, box), 0.0);
  const Box3 point({ { 1.0, 2.0, 3.0 } }, { { 1.0, 2.0, 3.0 } });
  ExpectRight(BoxList(77, point), { box, point }, 0.0);
}

//------------------------------------------------------------------------------
TEST(PackedRTree, WhatIsFarAwayVisitsNone)
{
  const skd::PackedRTree tree(MakeBoxes({ 300, 0.05 }, 3));
  for (const double x : { -1e300, -1e30, -3.0, 3.0, 1e30, 1e300 })
  {
    const Box3 far({ { x, x, x } }, { { x, x, x } });
    tree.ForEachOverlapping(far, [](std::uint32_t) { FAIL(); });
  }
}

//------------------------------------------------------------------------------
TEST(PackedRTree, PairsEndWhenNoMoreAreWanted)
{
  const skd::PackedRTree tree(MakeBoxes({ 100, 1.0 }, 3));
  int visits = 0;
  skd::PackedRTree::OverlapLists lists;
  EXPECT_FALSE(tree.ForEachOverlapWithin(
    0, lists, [&](std::uint32_t, const std::vector<std::uint32_t>&) { return ++visits < 3; }));
  EXPECT_EQ(visits, 3);
}

//------------------------------------------------------------------------------
TEST(PackedRTree, KeysOfARadixSortAscend)
{
  std::mt19937 random(4);
  for (const std::size_t count : { 0, 1, 255, 256, 70000 })
  {
    for (const std::uint32_t most : { 1u, 1000u, 0x3fffffffu })
    {
      std::uniform_int_distribution<std::uint32_t> key(0, most);
      std::vector<std::uint64_t> keys(count);
      for (std::size_t i = 0; i < count; ++i)
      {
        keys[i] = static_cast<std::uint64_t>(key(random)) << 32 | i;
      }
      std::vector<std::uint64_t> sorted = keys;
      std::sort(sorted.begin(), sorted.end());
      skd::SortByHighWord(keys);
      EXPECT_EQ(keys, sorted);
    }
  }
}

//------------------------------------------------------------------------------
TEST(PackedRTree, OfNoneThereIsNone)
{
  const skd::PackedRTree tree{ BoxList() };
  EXPECT_EQ(tree.GetNumberOfPackets(), 0u);
  tree.ForEachOverlapping(
    { { { 0.0, 0.0, 0.0 } }, { { 1.0, 1.0, 1.0 } } }, [](std::uint32_t) { FAIL(); });
}
