// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CoreSupport.h"

using namespace coretest;

namespace
{

template <class Type>
class TreeTest : public ::testing::Test
{
};
TYPED_TEST_SUITE(TreeTest, Dimensions, DimensionNames);

/// `test(boxes, tree, capacity)` for all capacities of small sets, and of larger ones in turn, by
/// both rules.
template <int D, class Test>
void ForEachCapacity(Test test)
{
  int turn = 0;
  for (const std::size_t count : Counts())
  {
    for (const Scene<D>& scene : AllScenes<D>(count, true))
    {
      const int only = 1 + turn++ % 8;
      for (int capacity = 1; capacity <= 8; ++capacity)
      {
        if (count <= 65 || capacity == only)
        {
          SCOPED_TRACE(scene.Name + ", capacity " + std::to_string(capacity));
          test(scene.Boxes, skd::BuildTree<D>(InputOf(scene.Boxes, capacity)), capacity);
          SCOPED_TRACE("by area");
          test(scene.Boxes,
            skd::BuildTree<D>(InputOf(scene.Boxes, capacity, skd::SplitRule::SurfaceArea)),
            capacity);
        }
      }
      if (::testing::Test::HasFailure())
      {
        return;
      }
    }
  }
}

/// `visit(node index, level)` from the root down, brothers in order.
template <class Tree, class Visitor>
void ForEachNode(const Tree& tree, Visitor visit, std::uint32_t node = 0, int level = 0)
{
  if (tree.IsEmpty())
  {
    return;
  }
  visit(node, level);
  const auto& opened = tree.Open(node);
  for (int lane = 0; lane < opened.Count && !opened.IsLeaf; ++lane)
  {
    ForEachNode(tree, visit, opened.First + static_cast<std::uint32_t>(lane), level + 1);
  }
}

/// What is below a node in order, wherever its nodes are stored: boxes' bits and elements.
template <class Tree>
std::vector<double> ContentOf(const Tree& tree)
{
  std::vector<double> content;
  ForEachNode(tree,
    [&](std::uint32_t index, int level)
    {
      const auto& node = tree.Open(index);
      content.insert(content.end(), { double(level), double(node.Count), double(node.IsLeaf) });
      for (int lane = 0; lane < node.Count; ++lane)
      {
        const auto box = node.Boxes.Get(lane);
        content.insert(content.end(), std::begin(box.Min), std::end(box.Min));
        content.insert(content.end(), std::begin(box.Max), std::end(box.Max));
        if (node.IsLeaf)
        {
          content.push_back(tree.Element(node.First + static_cast<std::uint32_t>(lane)));
        }
      }
    });
  return content;
}

template <int D>
skd::FloatBox<D> UnionOf(const skd::Node<D>& node)
{
  skd::FloatBox<D> all = node.Boxes.Get(0);
  for (int lane = 1; lane < node.Count; ++lane)
  {
    skd::Enclose(all, node.Boxes.Get(lane));
  }
  return all;
}

template <int D>
bool AreEqual(const skd::FloatBox<D>& a, const skd::FloatBox<D>& b)
{
  return std::equal(a.Min, a.Min + D, b.Min) && std::equal(a.Max, a.Max + D, b.Max);
}

TYPED_TEST(TreeTest, OfNothingIsEmpty)
{
  constexpr int D = TypeParam::Value;
  const auto tree = skd::BuildTree<D>(InputOf(Boxes<D>(), 8));
  EXPECT_TRUE(tree.IsEmpty());
  EXPECT_TRUE(tree.GetBounds().IsEmpty());
  EXPECT_EQ(tree.NumberOfNodes(), 0u);
  EXPECT_EQ(tree.NumberOfElements(), 0u);
  EXPECT_TRUE(skd::Tree<D>().IsEmpty());
}

TYPED_TEST(TreeTest, HoldsEachElementOnceWithItsBox)
{
  ForEachCapacity<TypeParam::Value>(
    [](const auto& boxes, const auto& tree, int)
    {
      Ids found;
      ForEachNode(tree,
        [&](std::uint32_t index, int)
        {
          const auto& node = tree.Open(index);
          for (int lane = 0; lane < node.Count && node.IsLeaf; ++lane)
          {
            found.push_back(tree.Element(node.First + static_cast<std::uint32_t>(lane)));
            EXPECT_TRUE(
              AreEqual(node.Boxes.Get(lane), tree.GetFrame().Outward(boxes[found.back()])));
          }
        });
      EXPECT_EQ(Sorted(found), Select(boxes, [](const auto&) { return true; }));
    });
}

TYPED_TEST(TreeTest, BoxesOfInnerNodesAreTheUnionsOfTheirChildren)
{
  ForEachCapacity<TypeParam::Value>(
    [](const auto&, const auto& tree, int)
    {
      ForEachNode(tree,
        [&](std::uint32_t index, int)
        {
          const auto& node = tree.Open(index);
          for (int lane = 0; lane < node.Count && !node.IsLeaf; ++lane)
          {
            const auto& child = tree.Open(node.First + static_cast<std::uint32_t>(lane));
            EXPECT_TRUE(AreEqual(node.Boxes.Get(lane), UnionOf(child)));
          }
        });
    });
}

TYPED_TEST(TreeTest, LanesWithoutAChildAreEmpty)
{
  ForEachCapacity<TypeParam::Value>(
    [](const auto&, const auto& tree, int)
    {
      ForEachNode(tree,
        [&](std::uint32_t index, int)
        {
          const auto& node = tree.Open(index);
          for (int lane = node.Count; lane < 8; ++lane)
          {
            EXPECT_EQ(node.Boxes.Min[0][lane], std::numeric_limits<float>::max());
            EXPECT_EQ(node.Boxes.Max[0][lane], std::numeric_limits<float>::lowest());
          }
        });
    });
}

TYPED_TEST(TreeTest, FillsAllLeavesButOne)
{
  ForEachCapacity<TypeParam::Value>(
    [](const auto&, const auto& tree, int capacity)
    {
      int partlyFull = 0;
      ForEachNode(tree,
        [&](std::uint32_t index, int)
        {
          const auto& node = tree.Open(index);
          EXPECT_GE(node.Count, 1);
          EXPECT_LE(node.Count, node.IsLeaf ? capacity : 8);
          partlyFull += node.IsLeaf && node.Count < capacity;
        });
      EXPECT_LE(partlyFull, 1);
    });
}

TYPED_TEST(TreeTest, IsAsLowAsEightChildrenANodeCanMakeItOrOneHigherByArea)
{
  ForEachCapacity<TypeParam::Value>(
    [](const auto& boxes, const auto& tree, int capacity)
    {
      int height = 0;
      ForEachNode(tree, [&](std::uint32_t, int level) { height = std::max(height, level); });
      std::size_t maxDistance = static_cast<std::size_t>(capacity);
      int least = 0;
      for (; maxDistance < boxes.size(); maxDistance *= 8)
      {
        ++least;
      }
      const bool isByArea = tree.Rule() == skd::SplitRule::SurfaceArea;
      EXPECT_GE(height, least);
      EXPECT_LE(height, isByArea && least > 0 ? least + 1 : least);
      EXPECT_EQ(tree.Depth(), boxes.empty() ? 0 : height + 1);
    });
}

TYPED_TEST(TreeTest, StoresAsManyNodesAsItHas)
{
  ForEachCapacity<TypeParam::Value>(
    [](const auto& boxes, const auto& tree, int)
    {
      std::vector<int> visited(tree.NumberOfNodes(), 0);
      ForEachNode(tree, [&](std::uint32_t index, int) { ++visited.at(index); });
      EXPECT_EQ(std::count(visited.begin(), visited.end(), 1), std::ptrdiff_t(visited.size()));
      EXPECT_EQ(tree.NumberOfElements(), boxes.size());
      EXPECT_GE(tree.MemorySize(),
        visited.size() * sizeof(skd::Node<TypeParam::Value>) +
          boxes.size() * sizeof(std::uint32_t));
    });
}

TYPED_TEST(TreeTest, IsTheSameWhateverLoopBuildsIt)
{
  constexpr int D = TypeParam::Value;
  for (const Scene<D>& scene : AllScenes<D>(5000, true))
  {
    const auto serial = ContentOf(skd::BuildTree<D>(InputOf(scene.Boxes, 3)));
    EXPECT_EQ(serial, ContentOf(skd::BuildTree<D>(InputOf(scene.Boxes, 3), ReversedLoop())));
    EXPECT_EQ(serial, ContentOf(skd::BuildTree<D>(InputOf(scene.Boxes, 3), ThreadedLoop())));

    const auto byArea = [&](auto loop)
    { return skd::BuildTree<D>(InputOf(scene.Boxes, 3, skd::SplitRule::SurfaceArea), loop); };
    const auto serialByArea = ContentOf(byArea(skd::SerialLoop()));
    EXPECT_EQ(serialByArea, ContentOf(byArea(ReversedLoop())));
    EXPECT_EQ(serialByArea, ContentOf(byArea(ThreadedLoop())));
  }
}

TYPED_TEST(TreeTest, BuiltOnQueryIsTheSame)
{
  constexpr int D = TypeParam::Value;
  for (const std::size_t count : Counts())
  {
    for (const Scene<D>& scene : AllScenes<D>(count, true))
    {
      EXPECT_EQ(ContentOf(skd::BuildTree<D>(InputOf(scene.Boxes, 5))),
        ContentOf(skd::BuildLazyTree<D>(InputOf(scene.Boxes, 5))))
        << scene.Name;
    }
  }
}

TYPED_TEST(TreeTest, KeepsWhatItsOwnerNotesInANode)
{
  constexpr int D = TypeParam::Value;
  struct Note
  {
    float Place[4];
    std::uint32_t Count;
  };
  auto tree = skd::BuildTree<D>(InputOf(RandomBoxes<D>(65), 8));
  const auto before = ContentOf(tree);
  for (std::uint32_t node = 0; node < tree.NumberOfNodes(); ++node)
  {
    tree.SetTag(node, 3 * node);
    tree.SetNote(node, Note{ { 1.0f, 2.0f, 3.0f, float(node) }, node });
  }
  for (std::uint32_t node = 0; node < tree.NumberOfNodes(); ++node)
  {
    const auto note = tree.Open(node).template Read<Note>();
    EXPECT_EQ(tree.Open(node).Tag, 3 * node);
    EXPECT_EQ(note.Place[0], 1.0f);
    EXPECT_EQ(note.Place[3], float(node));
    EXPECT_EQ(note.Count, node);
  }
  EXPECT_EQ(ContentOf(tree), before);
}

TYPED_TEST(TreeTest, NumbersOfLeavesTellTheirElements)
{
  constexpr int D = TypeParam::Value;
  for (const std::size_t count : Counts())
  {
    for (const int capacity : { 1, 3, 8 })
    {
      for (const skd::SplitRule rule : { skd::SplitRule::Median, skd::SplitRule::SurfaceArea })
      {
        const auto tree = skd::BuildTree<D>(InputOf(RandomBoxes<D>(count), capacity, rule));
        for (std::uint32_t i = 0; i < tree.NumberOfNodes(); ++i)
        {
          const skd::Node<D>& node = tree.Open(i);
          if (node.IsLeaf)
          {
            const skd::ElementRange elements = tree.LeafAt(tree.NumberOf(node));
            ASSERT_EQ(elements.First, node.First);
            ASSERT_EQ(elements.Count, node.Count);
            continue;
          }
          const skd::KnownLeaves known = tree.LeavesBelow(node);
          for (int lane = 0; lane < 8; ++lane)
          {
            const bool isChild = lane < node.Count;
            const auto& child = tree.Open(node.First + (isChild ? lane : 0));
            const bool isKnown = known.IsKnown(lane);
            ASSERT_EQ(isKnown, isChild && child.IsLeaf);
            ASSERT_TRUE(!isKnown || known.NumberOf(lane) == tree.NumberOf(child));
          }
        }
      }
    }
  }
}

TYPED_TEST(TreeTest, LeavesWithoutInnerBrothersLieBehindAllInnerNodes)
{
  ForEachCapacity<TypeParam::Value>(
    [](const auto&, const auto& tree, int)
    {
      std::uint32_t lastInner = 0;
      std::uint32_t firstBehind = static_cast<std::uint32_t>(tree.NumberOfNodes());
      ForEachNode(tree,
        [&](std::uint32_t index, int)
        {
          const auto& node = tree.Open(index);
          if (node.IsLeaf)
          {
            return;
          }
          lastInner = std::max(lastInner, index);
          bool areLeaves = true;
          for (std::uint32_t lane = 0; lane < node.Count; ++lane)
          {
            areLeaves = areLeaves && tree.Open(node.First + lane).IsLeaf;
          }
          firstBehind = areLeaves ? std::min(firstBehind, node.First) : firstBehind;
        });
      EXPECT_TRUE(tree.NumberOfNodes() < 2 || lastInner < firstBehind);
    });
}

TYPED_TEST(TreeTest, SafetyBoxesAreInflatedByTwoEpsilon)
{
  constexpr int D = TypeParam::Value;
  const Boxes<D> boxes = RandomBoxes<D>(65);
  const skd::TreeInput<D> input = skd::MakeTreeInput(boxes, 0.25);
  const skd::Box<D> bounds = BoundsOf(boxes);
  EXPECT_TRUE(input.Bounds.Min == bounds.Min - Filled<D>(0.5));
  EXPECT_TRUE(input.Bounds.Max == bounds.Max + Filled<D>(0.5));
  for (const skd::Element<D>& element : input.Elements)
  {
    EXPECT_TRUE(AreEqual(element.Box, input.Frame.Outward(boxes[element.Index].Inflated(0.5))));
  }
}

/// The boxes of the elements below a lane of a node.
template <int D>
void CollectBelow(const skd::Tree<D>& tree, const skd::Node<D>& node, int lane,
  std::vector<skd::FloatBox<D>>& boxes)
{
  if (node.IsLeaf)
  {
    boxes.push_back(node.Boxes.Get(lane));
    return;
  }
  const skd::Node<D>& child = tree.Open(node.First + static_cast<std::uint32_t>(lane));
  for (int i = 0; i < child.Count; ++i)
  {
    CollectBelow(tree, child, i, boxes);
  }
}

template <int D>
std::vector<skd::FloatBox<D>> Below(
  const skd::Tree<D>& tree, const skd::Node<D>& node, int firstLane, int lastLane)
{
  std::vector<skd::FloatBox<D>> boxes;
  for (int lane = firstLane; lane < lastLane; ++lane)
  {
    CollectBelow(tree, node, lane, boxes);
  }
  return boxes;
}

/// Twice the least (sign = 1) or minus twice the greatest (sign = -1) centroid along an axis.
template <int D>
float LeastCentroid(const std::vector<skd::FloatBox<D>>& boxes, int axis, float sign)
{
  float least = std::numeric_limits<float>::infinity();
  for (const skd::FloatBox<D>& box : boxes)
  {
    least = std::min(least, sign * (box.Min[axis] + box.Max[axis]));
  }
  return least;
}

template <int D>
int LongestAxis(const std::vector<skd::FloatBox<D>>& boxes)
{
  int longest = 0;
  float length = 0.0f;
  for (int axis = 0; axis < D; ++axis)
  {
    float least = std::numeric_limits<float>::max();
    float greatest = std::numeric_limits<float>::lowest();
    for (const skd::FloatBox<D>& box : boxes)
    {
      least = std::min(least, box.Min[axis]);
      greatest = std::max(greatest, box.Max[axis]);
    }
    longest = greatest - least > length ? axis : longest;
    length = std::max(length, greatest - least);
  }
  return longest;
}

/// The lanes of a node come of halving, and halving again: at each the median divides.
template <int D>
void ExpectMedians(const skd::Tree<D>& tree, const skd::Node<D>& node, int first, int last)
{
  if (last - first < 2)
  {
    return;
  }
  const int middle = first + (last - first + 1) / 2;
  const int axis = LongestAxis(Below(tree, node, first, last));
  EXPECT_LE(-LeastCentroid(Below(tree, node, first, middle), axis, -1.0f),
    LeastCentroid(Below(tree, node, middle, last), axis, 1.0f));
  ExpectMedians(tree, node, first, middle);
  ExpectMedians(tree, node, middle, last);
}

TYPED_TEST(TreeTest, MediansAlongTheLongestAxesDivideTheCentroids)
{
  constexpr int D = TypeParam::Value;
  for (const Scene<D>& scene : AllScenes<D>(513, true))
  {
    SCOPED_TRACE(scene.Name);
    const auto tree = skd::BuildTree<D>(InputOf(scene.Boxes, 3));
    ForEachNode(tree,
      [&](std::uint32_t index, int)
      {
        const skd::Node<D>& node = tree.Open(index);
        ExpectMedians(tree, node, 0, node.IsLeaf ? 0 : node.Count);
      });
  }
}

/// Of equal boxes in a row the leaves are runs of neighbours.
TYPED_TEST(TreeTest, SplitsALineIntoRuns)
{
  constexpr int D = TypeParam::Value;
  const auto tree = skd::BuildTree<D>(InputOf(LineOfBoxes<D>(5000), 8));
  std::uint32_t next = 0;
  ForEachNode(tree,
    [&](std::uint32_t index, int)
    {
      const auto& node = tree.Open(index);
      if (node.IsLeaf)
      {
        Ids run;
        for (int lane = 0; lane < node.Count; ++lane)
        {
          run.push_back(tree.Element(node.First + static_cast<std::uint32_t>(lane)));
        }
        EXPECT_EQ(Sorted(run).front(), next);
        EXPECT_EQ(Sorted(run).back(), next + run.size() - 1);
        next += static_cast<std::uint32_t>(run.size());
      }
    });
  EXPECT_EQ(next, 5000u);
}

}
