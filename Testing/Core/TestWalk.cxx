// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CoreSupport.h"

#include <type_traits>

using namespace coretest;

namespace
{

/// A query whose keys are the lower ends of the boxes along an axis, from where the tree begins.
template <bool IsOrdered, bool HasManyChildren = false>
struct LowerEnds
{
  static constexpr bool Ordered = IsOrdered;
  static constexpr bool ManyChildren = HasManyChildren;

  template <int W>
  unsigned TestBoxes(const skd::BoxPacket<1, W>& boxes, float* keys) const
  {
    const skd::Lanes<W> ends = boxes.Mins(0) + skd::Lanes<W>(1.0f);
    ends.Store(keys);
    return LessEqual(ends, skd::Lanes<W>(this->TheLimit));
  }
  float Limit() const { return this->TheLimit; }
  bool Visit(std::uint32_t element)
  {
    this->Visited.push_back(element);
    return this->Visited.size() < this->Most;
  }

  float TheLimit = std::numeric_limits<float>::infinity();
  std::size_t Most = std::numeric_limits<std::size_t>::max();
  Ids Visited;
};

/// A row of boxes whose indices are shuffled: IndexAt[place] is the index of the box at a place.
struct ShuffledLine
{
  explicit ShuffledLine(std::size_t count)
    : IndexAt(count)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      this->IndexAt[i] = static_cast<std::uint32_t>(i);
    }
    std::shuffle(this->IndexAt.begin(), this->IndexAt.end(), std::mt19937_64(1));
    Boxes<1> boxes(count);
    for (std::size_t at = 0; at < count; ++at)
    {
      boxes[this->IndexAt[at]] = LineOfBoxes<1>(count)[at];
    }
    this->Tree = skd::BuildTree<1>(InputOf(boxes, 3));
  }

  /// The greatest of the boxes up to that place.
  float KeyOf(double at) const { return this->Tree.GetFrame().Down(at, 0) + 1.0f; }

  Ids IndexAt;
  skd::Tree<1> Tree;
};

/// Whether a query has many children, as std::bool_constant.
template <class Type>
class OrderedWalk : public testing::Test
{
};
using ManyChildren = testing::Types<std::false_type, std::true_type>;
TYPED_TEST_SUITE(OrderedWalk, ManyChildren, );

TYPED_TEST(OrderedWalk, VisitsTheLeastKeyFirst)
{
  const ShuffledLine line(513);
  LowerEnds<true, TypeParam::value> query;
  skd::Walk(line.Tree, query);
  EXPECT_EQ(query.Visited, line.IndexAt);
}

TEST(Walk, VisitsAllWithoutAnOrder)
{
  const ShuffledLine line(513);
  LowerEnds<false> query;
  skd::Walk(line.Tree, query);
  EXPECT_EQ(Sorted(query.Visited), Sorted(line.IndexAt));
}

TYPED_TEST(OrderedWalk, VisitsKeysAtTheLimitAndNoneAbove)
{
  const ShuffledLine line(65);
  LowerEnds<true, TypeParam::value> query;
  query.TheLimit = line.KeyOf(40.0);
  skd::Walk(line.Tree, query);
  EXPECT_EQ(query.Visited, Ids(line.IndexAt.begin(), line.IndexAt.begin() + 41));
}

TYPED_TEST(OrderedWalk, EndsWhenVisitSaysSo)
{
  const ShuffledLine line(65);
  LowerEnds<true, TypeParam::value> query;
  query.Most = 7;
  skd::Walk(line.Tree, query);
  EXPECT_EQ(query.Visited, Ids(line.IndexAt.begin(), line.IndexAt.begin() + 7));
}

TYPED_TEST(OrderedWalk, OfAnEmptyTreeVisitsNothing)
{
  LowerEnds<true, TypeParam::value> query;
  skd::Walk(skd::Tree<1>(), query);
  EXPECT_TRUE(query.Visited.empty());
}

TYPED_TEST(OrderedWalk, WithANaNLimitVisitsNothing)
{
  const ShuffledLine line(65);
  LowerEnds<true, TypeParam::value> query;
  query.TheLimit = std::numeric_limits<float>::quiet_NaN();
  skd::Walk(line.Tree, query);
  EXPECT_TRUE(query.Visited.empty());
}

/// Keeps the boxes of leaves beside the tree, by the numbers of the nodes.
template <bool IsOrdered, bool HasManyChildren = false>
struct KnowsLeaves : LowerEnds<IsOrdered, HasManyChildren>
{
  static constexpr bool SkipsLeaves = true;
  static constexpr bool GivesKeys = true;

  explicit KnowsLeaves(skd::Tree<1>& tree)
  {
    for (std::uint32_t i = 0; i < tree.NumberOfNodes(); ++i)
    {
      const skd::Node<1>& node = tree.Open(i);
      if (node.IsLeaf)
      {
        const std::size_t number = tree.NumberOf(node);
        this->Boxes.resize(std::max(this->Boxes.size(), number + 1));
        this->Boxes[number] = node.Boxes;
      }
      else if (i % 3 != 2) // some are opened
      {
        tree.SetTag(i, 0);
        tree.SetNote(i, tree.LeavesBelow(node));
      }
    }
  }

  bool Knows(const skd::Node<1>& node) const { return node.Tag == 0; }
  unsigned TestElements(const skd::Node<1>& leaf, float* keys)
  {
    ++this->Opened;
    return this->TestBoxes(leaf.Boxes, keys);
  }
  unsigned TestKnown(std::uint32_t number, std::uint32_t count, float* keys)
  {
    ++this->Known;
    return this->TestBoxes(this->Boxes[number], keys) & skd::LowBits(count);
  }
  void FetchKnown(std::uint32_t number) const { EXPECT_LT(number, this->Boxes.size()); }
  void FetchData(std::uint32_t) const {}

  std::vector<skd::BoxPacket<1, 8>> Boxes;
  int Opened = 0;
  int Known = 0;
};

TYPED_TEST(OrderedWalk, OfKnownLeavesVisitsTheSame)
{
  ShuffledLine line(513);
  KnowsLeaves<true, TypeParam::value> inOrder(line.Tree);
  inOrder.TheLimit = line.KeyOf(300.0);
  skd::Walk(line.Tree, inOrder);
  EXPECT_EQ(inOrder.Visited, Ids(line.IndexAt.begin(), line.IndexAt.begin() + 301));
  EXPECT_GT(inOrder.Opened, 0);
  EXPECT_GT(inOrder.Known, inOrder.Opened);
}

TEST(Walk, OfKnownLeavesVisitsAllWithoutAnOrder)
{
  ShuffledLine line(513);
  KnowsLeaves<false> inAnyOrder(line.Tree);
  skd::Walk(line.Tree, inAnyOrder);
  EXPECT_EQ(Sorted(inAnyOrder.Visited), Sorted(line.IndexAt));
}

TYPED_TEST(OrderedWalk, OfKnownLeavesEndsWhenVisitSaysSo)
{
  ShuffledLine line(65);
  KnowsLeaves<true, TypeParam::value> query(line.Tree);
  query.Most = 7;
  skd::Walk(line.Tree, query);
  EXPECT_EQ(query.Visited, Ids(line.IndexAt.begin(), line.IndexAt.begin() + 7));
}

/// Says of every lane that it is wanted, of those too that hold nothing.
struct WantsAll : LowerEnds<false>
{
  template <int W>
  unsigned TestBoxes(const skd::BoxPacket<1, W>&, float*) const
  {
    return ~0u;
  }
};

TEST(Walk, NeverVisitsLanesThatHoldNothing)
{
  const ShuffledLine line(65);
  WantsAll query;
  skd::Walk(line.Tree, query);
  EXPECT_EQ(Sorted(query.Visited), Sorted(line.IndexAt));
}

/// A limit that falls while the walk goes on: what was pushed before it fell is left alone.
template <bool HasManyChildren>
struct EndsAfter : LowerEnds<true, HasManyChildren>
{
  bool Visit(std::uint32_t element)
  {
    this->Visited.push_back(element);
    this->TheLimit = this->Fallen;
    return true;
  }

  float Fallen = 0.0f;
};

TYPED_TEST(OrderedWalk, LeavesAloneWhatAFallenLimitExcludes)
{
  const ShuffledLine line(513);
  EndsAfter<TypeParam::value> query;
  query.Fallen = line.KeyOf(5.0);
  skd::Walk(line.Tree, query);
  EXPECT_EQ(query.Visited, Ids(line.IndexAt.begin(), line.IndexAt.begin() + 6));
}

/// As deep as the largest number of elements makes a tree, and every node full. Nodes are numbered
/// by their level alone.
class DeepestTree
{
public:
  static constexpr std::uint32_t Levels = 11;

  DeepestTree()
  {
    for (std::uint32_t level = 0; level <= Levels; ++level)
    {
      skd::Node<1>& node = this->Nodes[level];
      node.Boxes.Clear();
      node.SetCount(8);
      node.IsLeaf = level == Levels;
      for (int lane = 0; lane < 8; ++lane)
      {
        node.Boxes.Set(lane, { { 0.0f }, { 1.0f } });
      }
    }
  }

  bool IsEmpty() const { return false; }
  const skd::Node<1>& Open(std::uint32_t node) const
  {
    this->Deepest = std::max(this->Deepest, node / 8);
    skd::Node<1>& opened = this->Nodes[std::min(node / 8, Levels)];
    opened.First = 8 * (node / 8 + 1);
    return opened;
  }
  void Fetch(std::uint32_t) const {}
  std::uint32_t Element(std::uint32_t position) const { return position; }

  mutable std::uint32_t Deepest = 0;

private:
  mutable skd::Node<1> Nodes[Levels + 1];
};

TEST(Walk, HasRoomForTheDeepestTree)
{
  const DeepestTree tree;
  for (const std::size_t most : { 1u, 8u, 1000u })
  {
    LowerEnds<true> query;
    query.Most = most;
    skd::Walk(tree, query);
    EXPECT_EQ(query.Visited.size(), most);
    EXPECT_EQ(tree.Deepest, DeepestTree::Levels);
  }
}

}
