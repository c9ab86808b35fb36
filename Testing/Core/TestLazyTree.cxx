// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Search/Queries/AlongSegment.h"
#include "Core/Search/Queries/Nearest.h"
#include "Core/Search/Queries/WithinBox.h"
#include "CoreSupport.h"

using namespace coretest;

namespace
{

template <class Type>
class LazyTreeTest : public ::testing::Test
{
};
TYPED_TEST_SUITE(LazyTreeTest, Dimensions, DimensionNames);

constexpr int NumberOfThreads = 8;

/// Runs `body(thread)` on many threads that set off at the same moment.
template <class Body>
void OnManyThreads(Body body)
{
  std::atomic<int> waiting{ NumberOfThreads };
  std::vector<std::thread> threads;
  for (int thread = 0; thread < NumberOfThreads; ++thread)
  {
    threads.emplace_back(
      [&waiting, &body, thread]
      {
        --waiting;
        while (waiting > 0)
        {
          std::this_thread::yield();
        }
        body(thread);
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
}

/// The elements within a distance in the order in which they are reached: the walk itself.
template <int D, class Tree>
Ids NearestWalk(const Tree& tree, const skd::Vector<D>& q)
{
  const double limit2 = 0.1 / tree.GetFrame().Scale / tree.GetFrame().Scale;
  return Visited(tree, limit2,
    [&](auto& visitor) {
      return skd::Nearest<D, std::decay_t<decltype(visitor)>>(tree.GetFrame(), q, limit2, visitor);
    });
}

template <int D, class Tree>
Ids SegmentWalk(const Tree& tree, const skd::Vector<D>& a, const skd::Vector<D>& b)
{
  return Visited(tree, 1.0,
    [&](auto& visitor)
    {
      return skd::AlongSegment<D, std::decay_t<decltype(visitor)>>(
        tree.GetFrame(), skd::Segment<D>{ a, b }, 0.0, visitor);
    });
}

template <int D, class Tree>
Ids BoxWalk(const Tree& tree, const skd::Vector<D>& corner)
{
  const skd::Box<D> box(corner, corner + Filled<D>(0.25));
  return Visited(tree, true,
    [&](auto& visitor)
    { return skd::WithinBox<D, std::decay_t<decltype(visitor)>>(tree.GetFrame(), box, visitor); });
}

/// All that a thread does: queries of every kind, one after the other.
template <int D, class Tree>
std::vector<Ids> AllWalks(const Tree& tree, int thread)
{
  Random random(static_cast<std::uint64_t>(thread));
  std::vector<Ids> walks;
  for (int i = 0; i < 10; ++i)
  {
    const skd::Vector<D> a = random.Point<D>(-1.0, 1.0);
    const skd::Vector<D> b = random.Point<D>(-1.0, 1.0);
    walks.push_back(NearestWalk(tree, a));
    walks.push_back(SegmentWalk(tree, a, b));
    walks.push_back(BoxWalk(tree, b));
  }
  return walks;
}

TYPED_TEST(LazyTreeTest, WalksAsATreeThatIsBuiltWhole)
{
  constexpr int D = TypeParam::Value;
  for (const std::size_t count : Counts())
  {
    for (const Scene<D>& scene : AllScenes<D>(count, false))
    {
      const auto tree = skd::BuildTree<D>(InputOf(scene.Boxes, 4));
      const auto lazy = skd::BuildLazyTree<D>(InputOf(scene.Boxes, 4));
      for (const skd::Vector<D>& q : QueryPoints(scene.Boxes))
      {
        EXPECT_EQ(NearestWalk(lazy, q), NearestWalk(tree, q)) << scene.Name;
      }
    }
  }
}

TYPED_TEST(LazyTreeTest, AnswersManyThreadsAtOnceAsATreeDoes)
{
  constexpr int D = TypeParam::Value;
  for (const Boxes<D>& boxes : { RandomBoxes<D>(5000), NestedBoxes<D>(513), LatticeBoxes<D>(4096) })
  {
    const auto tree = skd::BuildTree<D>(InputOf(boxes, 4));
    for (int round = 0; round < 5; ++round)
    {
      const auto lazy = skd::BuildLazyTree<D>(InputOf(boxes, 4));
      std::vector<std::vector<Ids>> answers(NumberOfThreads);
      OnManyThreads([&](int thread) { answers[thread] = AllWalks<D>(lazy, thread); });
      for (int thread = 0; thread < NumberOfThreads; ++thread)
      {
        EXPECT_EQ(answers[thread], AllWalks<D>(tree, thread));
      }
    }
  }
}

/// All threads run the same query on a tree not yet begun: they meet at every node.
TYPED_TEST(LazyTreeTest, IsSplitOnceThoughAllThreadsWantTheSameNode)
{
  constexpr int D = TypeParam::Value;
  const Boxes<D> boxes = RandomBoxes<D>(5000);
  const std::vector<Ids> expected = AllWalks<D>(skd::BuildTree<D>(InputOf(boxes, 1)), 0);
  for (int round = 0; round < 5; ++round)
  {
    const auto lazy = skd::BuildLazyTree<D>(InputOf(boxes, 1));
    std::vector<std::vector<Ids>> answers(NumberOfThreads);
    OnManyThreads([&](int thread) { answers[thread] = AllWalks<D>(lazy, 0); });
    EXPECT_EQ(std::count(answers.begin(), answers.end(), expected), NumberOfThreads);
  }
}

template <int D>
std::size_t NumberOfMoved(const skd::LazyTree<D>& tree)
{
  std::size_t moved = 0;
  for (std::uint32_t position = 0; position < tree.NumberOfElements(); ++position)
  {
    moved += tree.Element(position) != position;
  }
  return moved;
}

TYPED_TEST(LazyTreeTest, SortsNothingBeforeTheFirstQuery)
{
  constexpr int D = TypeParam::Value;
  EXPECT_EQ(NumberOfMoved(skd::BuildLazyTree<D>(InputOf(RandomBoxes<D>(5000), 8))), 0u);
}

TYPED_TEST(LazyTreeTest, SortsNothingForQueriesThatMiss)
{
  constexpr int D = TypeParam::Value;
  const auto lazy = skd::BuildLazyTree<D>(InputOf(RandomBoxes<D>(5000), 8));
  EXPECT_TRUE(SegmentWalk(lazy, Filled<D>(10.0), Filled<D>(11.0)).empty());
  EXPECT_EQ(NumberOfMoved(lazy), 0u);
}

/// A line in order, the last first: splitting brings the small centroids to the front. Asked about
/// one end, the tree leaves what lies at the other as its first split put it.
TYPED_TEST(LazyTreeTest, SortsOnlyWhatQueriesReach)
{
  constexpr int D = TypeParam::Value;
  Boxes<D> boxes = LineOfBoxes<D>(4096);
  std::shuffle(boxes.begin(), boxes.end(), std::mt19937_64(1));
  const auto whole = skd::BuildTree<D>(InputOf(boxes, 8));
  const auto lazy = skd::BuildLazyTree<D>(InputOf(boxes, 8));
  BoxWalk(lazy, Along<D>(0, 0.5));
  const auto sortedAlike = [&](std::uint32_t first, std::uint32_t last)
  {
    std::size_t alike = 0;
    for (std::uint32_t position = first; position < last; ++position)
    {
      alike += lazy.Element(position) == whole.Element(position);
    }
    return alike;
  };
  EXPECT_EQ(sortedAlike(0, 8), 8u);
  EXPECT_LT(sortedAlike(2048, 4096), 200u);
}

TYPED_TEST(LazyTreeTest, OfNothingIsEmpty)
{
  constexpr int D = TypeParam::Value;
  const auto lazy = skd::BuildLazyTree<D>(InputOf(Boxes<D>(), 8));
  EXPECT_TRUE(lazy.IsEmpty());
  EXPECT_EQ(lazy.NumberOfElements(), 0u);
  EXPECT_EQ(lazy.NumberOfNodes(), 0u);
  EXPECT_EQ(lazy.MemorySize(), 0u);
  EXPECT_TRUE(lazy.GetBounds().IsEmpty());
}

TYPED_TEST(LazyTreeTest, HasTheFrameBoundsAndSizesOfATree)
{
  constexpr int D = TypeParam::Value;
  const Boxes<D> boxes = RandomBoxes<D>(513);
  const auto tree = skd::BuildTree<D>(InputOf(boxes, 4));
  const auto lazy = skd::BuildLazyTree<D>(InputOf(boxes, 4));
  EXPECT_EQ(lazy.NumberOfElements(), tree.NumberOfElements());
  EXPECT_EQ(lazy.NumberOfNodes(), tree.NumberOfNodes());
  EXPECT_GE(lazy.MemorySize(), tree.NumberOfNodes() * sizeof(skd::Node<D>));
  EXPECT_TRUE(lazy.GetFrame().Centre == tree.GetFrame().Centre);
  EXPECT_EQ(lazy.GetFrame().Scale, tree.GetFrame().Scale);
  EXPECT_TRUE(lazy.GetBounds().Min == tree.GetBounds().Min);
  EXPECT_TRUE(lazy.GetBounds().Max == tree.GetBounds().Max);
}

}
