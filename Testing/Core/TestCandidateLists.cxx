// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Search/Queries/CandidateLists.h"
#include "Core/Search/Queries/WithinBox.h"
#include "CoreSupport.h"

#include <stdexcept>

using namespace coretest;

namespace
{

template <class Type>
class CandidateListsTest : public ::testing::Test
{
};
TYPED_TEST_SUITE(CandidateListsTest, Dimensions, DimensionNames);

using List = std::vector<skd::CandidateLanes>;

template <int D>
skd::Box<D> Part(const skd::Box<D>& box, unsigned child)
{
  skd::Box<D> part = box;
  const skd::Vector<D> middle = box.Centroid();
  for (int axis = 0; axis < D; ++axis)
  {
    (child >> axis & 1u ? part.Min : part.Max)[axis] = middle[axis];
  }
  return part;
}

/// A family of boxes, each searched in full, and followed into a few of its parts.
template <int D, class Tree>
class Family
{
public:
  Family(const Tree& tree, const Boxes<D>& boxes)
    : TheTree(tree)
    , TheBoxes(boxes)
  {
  }

  void Follow(const skd::Box<D>& box, const List& above, int levels)
  {
    List list;
    const bool isMet = skd::NarrowCandidates(
      this->TheTree, above.data(), above.data() + above.size(), box,
      [&](std::uint32_t element) { return this->TheBoxes[element].Overlaps(box); }, list);
    const Ids expected =
      Select(this->TheBoxes, [&](const skd::Box<D>& other) { return other.Overlaps(box); });
    ASSERT_EQ(isMet, !expected.empty());
    ASSERT_EQ(isMet, !list.empty());
    Ids visited;
    skd::VisitCandidates(this->TheTree, list.data(), list.data() + list.size(), box,
      [&](std::uint32_t element) { visited.push_back(element); });
    const Ids got = Sorted(visited);
    ASSERT_TRUE(std::adjacent_find(got.begin(), got.end()) == got.end());
    ASSERT_TRUE(std::includes(got.begin(), got.end(), expected.begin(), expected.end()));
    for (int i = 0; levels > 0 && i < 4; ++i)
    {
      const auto child = static_cast<unsigned>(this->Rand.Below(std::size_t(1) << D));
      this->Follow(Part(box, child), list, levels - 1);
    }
  }

private:
  const Tree& TheTree;
  const Boxes<D>& TheBoxes;
  Random Rand{ 5 };
};

TYPED_TEST(CandidateListsTest, EachBoxOfAFamilyHasAllThatMeetsIt)
{
  ForEachTree<TypeParam::Value>(true,
    [](const auto& scene, const auto& tree)
    {
      constexpr int D = TypeParam::Value;
      Family<D, std::decay_t<decltype(tree)>> family(tree, scene.Boxes);
      const int levels = scene.Boxes.size() > 1000 ? 3 : 4;
      family.Follow(Around(scene.Boxes), skd::AllCandidates(), levels);
    });
}

TYPED_TEST(CandidateListsTest, WhatFailsTheTestIsNoCandidate)
{
  constexpr int D = TypeParam::Value;
  const Boxes<D> boxes = RandomBoxes<D>(513);
  const auto tree = skd::BuildTree<D>(InputOf(boxes, 8));
  // The tree cannot exclude a thin box from what its node holds: cut across a box of the set.
  skd::Box<D> thin = tree.GetBounds();
  thin.Min = thin.Max = boxes[17].Centroid();
  const List all = skd::AllCandidates();
  List list;
  int requested = 0;
  EXPECT_FALSE(skd::NarrowCandidates(
    tree, all.data(), all.data() + all.size(), thin,
    [&](std::uint32_t)
    {
      ++requested;
      return false;
    },
    list));
  EXPECT_GE(requested, 1);
  EXPECT_TRUE(list.empty());
}

TYPED_TEST(CandidateListsTest, ABoxAroundAllAsksNothingAndOpensOneNode)
{
  constexpr int D = TypeParam::Value;
  const Boxes<D> boxes = RandomBoxes<D>(5000);
  const auto tree = skd::BuildTree<D>(InputOf(boxes, 8));
  const CountedTree counted(tree);
  const List all = skd::AllCandidates();
  List list;
  EXPECT_TRUE(skd::NarrowCandidates(
    counted, all.data(), all.data() + all.size(), tree.GetBounds().Inflated(1.0),
    [](std::uint32_t) -> bool { throw std::logic_error("asked"); }, list));
  EXPECT_EQ(counted.Opened, 1u);
  EXPECT_EQ(list.size(), 1u);
}

TYPED_TEST(CandidateListsTest, AFamilyCostsLessThanSearchesFromTheRoot)
{
  constexpr int D = TypeParam::Value;
  const Boxes<D> boxes = LatticeBoxes<D>(4096);
  const auto tree = skd::BuildTree<D>(InputOf(boxes, 8));
  const CountedTree counted(tree);
  const CountedTree searched(tree);
  skd::Box<D> box = tree.GetBounds();
  List list = skd::AllCandidates();
  for (int level = 0; level < 12; ++level)
  {
    List next;
    const auto meets = [&](std::uint32_t element) { return boxes[element].Overlaps(box); };
    EXPECT_TRUE(
      skd::NarrowCandidates(counted, list.data(), list.data() + list.size(), box, meets, next));
    auto visitor = [](std::uint32_t) { return true; };
    skd::WithinBox<D, decltype(visitor)> query(tree.GetFrame(), box, visitor);
    skd::Walk(searched, query);
    list.swap(next);
    box = Part(box, static_cast<unsigned>(level % 2 ? 0 : (1 << D) - 1));
  }
  EXPECT_LT(2 * counted.Opened, searched.Opened);
}

TYPED_TEST(CandidateListsTest, AnEmptyTreeOrListOrBoxMeetsNothing)
{
  constexpr int D = TypeParam::Value;
  const auto empty = skd::BuildTree<D>(InputOf(Boxes<D>{}, 8));
  const auto tree = skd::BuildTree<D>(InputOf(RandomBoxes<D>(100), 8));
  const List all = skd::AllCandidates();
  List list;
  const auto yes = [](std::uint32_t) { return true; };
  EXPECT_FALSE(
    skd::NarrowCandidates(empty, all.data(), all.data() + 1, tree.GetBounds(), yes, list));
  EXPECT_FALSE(skd::NarrowCandidates(tree, all.data(), all.data(), tree.GetBounds(), yes, list));
  EXPECT_FALSE(skd::NarrowCandidates(tree, all.data(), all.data() + 1, skd::Box<D>(), yes, list));
  skd::Box<D> nowhere = tree.GetBounds();
  nowhere.Max[0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(skd::NarrowCandidates(tree, all.data(), all.data() + 1, nowhere, yes, list));
  EXPECT_TRUE(list.empty());
}

}
