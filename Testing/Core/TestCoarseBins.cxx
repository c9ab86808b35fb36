// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// Trees whose elements are read when they are needed: coarsely sorted ones are divided as others.
#include "Core/Search/Queries/Nearest.h"
#include "CoreSupport.h"

#include <memory>

using namespace coretest;

namespace
{

template <class Type>
class CoarseBinsTest : public ::testing::Test
{
};
TYPED_TEST_SUITE(CoarseBinsTest, Dimensions, DimensionNames);

/// The elements of some boxes, and how often one of them was read.
template <int D>
struct Source
{
  explicit Source(const Boxes<D>& boxes)
    : Elements(InputOf(boxes, 1).Elements)
  {
  }
  skd::RawVector<skd::Element<D>> Elements;
  std::atomic<std::size_t> NumberOfReads{ 0 };
};

template <int D>
skd::ReadInput<D> ReadInputOf(
  const Boxes<D>& boxes, int capacity, std::size_t few, const std::shared_ptr<Source<D>>& source)
{
  const skd::TreeInput<D> input = InputOf(boxes, capacity);
  const auto read = [source](const std::uint32_t* indices, std::size_t count, skd::Element<D>* to)
  {
    source->NumberOfReads += count;
    std::transform(
      indices, indices + count, to, [&](std::uint32_t index) { return source->Elements[index]; });
  };
  const auto count = static_cast<std::uint32_t>(boxes.size());
  return { input.Frame, input.Bounds, count, read, capacity, skd::SplitRule::Median, few };
}

template <int D>
skd::ReadInput<D> ReadInputOf(const Boxes<D>& boxes, int capacity, std::size_t few)
{
  return ReadInputOf<D>(boxes, capacity, few, std::make_shared<Source<D>>(boxes));
}

template <class Tree, int D>
Ids ElementsOf(const Tree& tree, const skd::Node<D>& leaf)
{
  Ids ids;
  for (std::uint32_t lane = 0; lane < leaf.Count; ++lane)
  {
    ids.push_back(tree.Element(leaf.First + lane));
  }
  return ids;
}

/// The same nodes with the same boxes and elements, but for the order in leaves.
template <int D, class First, class Second>
bool AreSame(const First& first, const Second& second, std::uint32_t a = 0, std::uint32_t b = 0)
{
  const skd::Node<D>& one = first.Open(a);
  const skd::Node<D>& other = second.Open(b);
  if (one.Count != other.Count || one.IsLeaf != other.IsLeaf)
  {
    return false;
  }
  if (one.IsLeaf)
  {
    return Sorted(ElementsOf(first, one)) == Sorted(ElementsOf(second, other));
  }
  bool areSame = true;
  for (int lane = 0; lane < one.Count && areSame; ++lane)
  {
    const auto box = one.Boxes.Get(lane);
    const auto like = other.Boxes.Get(lane);
    areSame = std::equal(box.Min, box.Min + D, like.Min) &&
      std::equal(box.Max, box.Max + D, like.Max) &&
      AreSame<D>(first, second, one.First + static_cast<std::uint32_t>(lane),
        other.First + static_cast<std::uint32_t>(lane));
  }
  return areSame;
}

/// All boxes but a few, the last among them, in a corner a millionth of the whole.
template <int D>
Boxes<D> CrowdedBoxes(std::size_t n)
{
  Boxes<D> boxes = Transformed<D>(RandomBoxes<D>(n), 1e-6, 0.0);
  for (const skd::Box<D>& far : RandomBoxes<D>(10))
  {
    boxes.push_back(far);
  }
  return boxes;
}

/// Where a walk to all elements within a distance comes to.
template <int D, class Tree>
Ids NearTo(const Tree& tree, const skd::Vector<D>& q)
{
  const double limit2 = 0.01 / tree.GetFrame().Scale / tree.GetFrame().Scale;
  return Sorted(Visited(tree, limit2,
    [&](auto& visitor) {
      return skd::Nearest<D, std::decay_t<decltype(visitor)>>(tree.GetFrame(), q, limit2, visitor);
    }));
}

TYPED_TEST(CoarseBinsTest, MakeTheTreeThatIsBuiltWhole)
{
  constexpr int D = TypeParam::Value;
  for (const std::size_t count : { 65, 513, 5000 })
  {
    for (const Scene<D>& scene : AllScenes<D>(count, true))
    {
      const auto tree = skd::BuildTree<D>(InputOf(scene.Boxes, 5));
      for (const std::size_t few : { 0, 6, 100 })
      {
        const auto lazy =
          skd::BuildLazyTree<D>(ReadInputOf(scene.Boxes, 5, few), skd::SerialLoop());
        EXPECT_TRUE(AreSame<D>(tree, lazy)) << scene.Name << ", few " << few;
        const auto whole = skd::BuildTree<D>(ReadInputOf(scene.Boxes, 5, few), skd::SerialLoop());
        EXPECT_TRUE(AreSame<D>(tree, whole)) << scene.Name << ", few " << few;
      }
    }
  }
}

TYPED_TEST(CoarseBinsTest, MakeTheSameTreeHoweverTheLoopsRun)
{
  constexpr int D = TypeParam::Value;
  const Boxes<D> boxes = RandomBoxes<D>(270000);
  const auto source = std::make_shared<Source<D>>(boxes);
  const auto input = ReadInputOf<D>(boxes, 8, 1 << 14, source);
  const auto serial = skd::BuildLazyTree<D>(input, skd::SerialLoop());
  const auto threaded = skd::BuildLazyTree<D>(input, ThreadedLoop());
  EXPECT_TRUE(AreSame<D>(serial, threaded));
  EXPECT_TRUE(AreSame<D>(serial, skd::BuildTree<D>(input, ThreadedLoop())));
}

TYPED_TEST(CoarseBinsTest, TreesByAreaAreThoseOfElementsAtHand)
{
  constexpr int D = TypeParam::Value;
  for (const auto rule : { skd::SplitRule::SurfaceArea, skd::SplitRule::Automatic })
  {
    for (const Scene<D>& scene : AllScenes<D>(5000, false))
    {
      skd::ReadInput<D> input = ReadInputOf(scene.Boxes, 8, 100);
      input.Rule = rule;
      const auto tree = skd::BuildTree<D>(InputOf(scene.Boxes, 8, rule));
      const auto read = skd::BuildTree<D>(input, skd::SerialLoop());
      EXPECT_EQ(tree.Rule(), read.Rule()) << scene.Name;
      EXPECT_TRUE(AreSame<D>(tree, read)) << scene.Name;
    }
  }
}

TYPED_TEST(CoarseBinsTest, LeaveCrowdsToOthers)
{
  constexpr int D = TypeParam::Value;
  const Boxes<D> boxes = CrowdedBoxes<D>(5000);
  const auto lazy = skd::BuildLazyTree<D>(ReadInputOf(boxes, 8, 100), skd::SerialLoop());
  EXPECT_TRUE(AreSame<D>(skd::BuildTree<D>(InputOf(boxes, 8)), lazy));
}

TYPED_TEST(CoarseBinsTest, ReadAgainOnlyWhatQueriesReach)
{
  constexpr int D = TypeParam::Value;
  const Boxes<D> boxes = RandomBoxes<D>(20000);
  const auto source = std::make_shared<Source<D>>(boxes);
  const auto lazy = skd::BuildLazyTree<D>(ReadInputOf<D>(boxes, 8, 200, source), skd::SerialLoop());
  const std::size_t before = source->NumberOfReads;
  EXPECT_LE(before, 2 * boxes.size()); // each once, and a sample
  const skd::Vector<D> corner = lazy.GetBounds().Min;
  EXPECT_EQ(NearTo(lazy, corner), NearTo(skd::BuildTree<D>(InputOf(boxes, 8)), corner));
  EXPECT_LT(source->NumberOfReads - before, (D > 2 ? 3 : 1) * boxes.size());
}

TYPED_TEST(CoarseBinsTest, AnswerManyThreadsAtOnce)
{
  constexpr int D = TypeParam::Value;
  const Boxes<D> boxes = RandomBoxes<D>(5000);
  const auto tree = skd::BuildTree<D>(InputOf(boxes, 4));
  for (int round = 0; round < 5; ++round)
  {
    const auto lazy = skd::BuildLazyTree<D>(ReadInputOf(boxes, 4, 30), skd::SerialLoop());
    std::atomic<int> wrong{ 0 };
    std::vector<std::thread> threads;
    for (int thread = 0; thread < 8; ++thread)
    {
      threads.emplace_back(
        [&, thread]
        {
          Random random(static_cast<std::uint64_t>(thread / 2)); // two have the same queries
          for (int i = 0; i < 10; ++i)
          {
            const skd::Vector<D> q = random.Point<D>(-1.0, 1.0);
            wrong += NearTo(lazy, q) != NearTo(tree, q);
          }
        });
    }
    for (std::thread& thread : threads)
    {
      thread.join();
    }
    EXPECT_EQ(wrong, 0);
  }
}

TYPED_TEST(CoarseBinsTest, OfNothingIsEmpty)
{
  constexpr int D = TypeParam::Value;
  const auto lazy = skd::BuildLazyTree<D>(ReadInputOf(Boxes<D>(), 8, 100), skd::SerialLoop());
  EXPECT_TRUE(lazy.IsEmpty());
  EXPECT_EQ(lazy.NumberOfElements(), 0u);
}

TYPED_TEST(CoarseBinsTest, SlabsFollowTheKeysOfAnAxis)
{
  constexpr int D = TypeParam::Value;
  using Grid = skd::QuantileGrid<D>;
  for (const Boxes<D>& boxes : { RandomBoxes<D>(5000), GradedBoxes<D>(5000) })
  {
    const auto elements = InputOf(boxes, 8).Elements;
    const Grid grid({ elements.begin(), elements.end() });
    for (int axis = 0; axis < D; ++axis)
    {
      auto ordered = elements;
      const auto keyOf = [axis](const skd::Element<D>& element)
      { return skd::SplitAtRank<D>::KeyOf(element, axis); };
      std::sort(ordered.begin(), ordered.end(),
        [&](const auto& a, const auto& b) { return keyOf(a) < keyOf(b); });
      std::vector<int> slabs;
      for (const skd::Element<D>& element : ordered)
      {
        slabs.push_back(Grid::SlabOf(grid.BinOf(element), axis));
      }
      EXPECT_TRUE(std::is_sorted(slabs.begin(), slabs.end()));
      EXPECT_LT(slabs.front(), slabs.back());
    }
  }
}

TYPED_TEST(CoarseBinsTest, SlabsHoldAboutAsManyElementsEach)
{
  constexpr int D = TypeParam::Value;
  using Grid = skd::QuantileGrid<D>;
  const auto elements = InputOf(RandomBoxes<D>(20000), 8).Elements;
  const Grid grid({ elements.begin(), elements.end() });
  for (int axis = 0; axis < D; ++axis)
  {
    std::vector<std::size_t> counts(Grid::NumberOfSlabs);
    for (const skd::Element<D>& element : elements)
    {
      ++counts[static_cast<std::size_t>(Grid::SlabOf(grid.BinOf(element), axis))];
    }
    EXPECT_LT(*std::max_element(counts.begin(), counts.end()), 2 * elements.size() / counts.size());
  }
}

}
