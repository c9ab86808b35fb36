// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Search/Tree/PaperTree.h"
#include "CoreAnswers.h"
#include "CoreDimensions.h"

using namespace coretest;

namespace
{

template <class Type>
class PaperTreeTest : public ::testing::Test
{
};
TYPED_TEST_SUITE(PaperTreeTest, Dimensions, DimensionNames);

template <int D, class Test>
void ForEachPaperTree(Test test)
{
  for (const std::size_t count : Counts())
  {
    for (const Scene<D>& scene : AllScenes<D>(count, true))
    {
      SCOPED_TRACE(scene.Name);
      test(scene.Boxes, skd::BuildPaperTree(scene.Boxes));
      if (::testing::Test::HasFailure())
      {
        return;
      }
    }
  }
}

/// The elements of the leaves below each node.
template <int D>
std::vector<Ids> ElementsBelow(const skd::PaperTree<D>& tree)
{
  std::vector<Ids> below(tree.L.size());
  for (std::size_t node = tree.L.size(); node-- > 0;)
  {
    if (tree.IsLeaf(node))
    {
      below[node] = { static_cast<std::uint32_t>(-tree.L[node]) };
      continue;
    }
    const auto child = static_cast<std::size_t>(tree.L[node]);
    below[node] = below[child];
    below[node].insert(below[node].end(), below[child + 1].begin(), below[child + 1].end());
  }
  return below;
}

int CeilingOfLog2(std::size_t count)
{
  int log2 = 0;
  while ((std::size_t(1) << log2) < count)
  {
    ++log2;
  }
  return log2;
}

TYPED_TEST(PaperTreeTest, HasTwiceAsManyNodesAsElementsLessOne)
{
  ForEachPaperTree<TypeParam::Value>(
    [](const auto& boxes, const auto& tree)
    {
      const std::size_t expected = boxes.empty() ? 0 : 2 * boxes.size() - 1;
      EXPECT_EQ(tree.S.size(), expected);
      EXPECT_EQ(tree.L.size(), expected);
      EXPECT_EQ(tree.Level.size(), expected);
    });
}

TYPED_TEST(PaperTreeTest, IsAsDeepAsLog2OfTheNumberOfElements)
{
  ForEachPaperTree<TypeParam::Value>(
    [](const auto& boxes, const auto& tree)
    {
      const int depth = boxes.empty() ? 0 : *std::max_element(tree.Level.begin(), tree.Level.end());
      EXPECT_EQ(depth, CeilingOfLog2(boxes.size()));
    });
}

TYPED_TEST(PaperTreeTest, LevelsCountFromTheRoot)
{
  ForEachPaperTree<TypeParam::Value>(
    [](const auto&, const auto& tree)
    {
      for (std::size_t node = 0; node < tree.L.size(); ++node)
      {
        if (!tree.IsLeaf(node))
        {
          EXPECT_EQ(tree.Level[tree.L[node]], tree.Level[node] + 1);
          EXPECT_EQ(tree.Level[tree.L[node] + 1], tree.Level[node] + 1);
        }
      }
      EXPECT_TRUE(tree.L.empty() || tree.Level[0] == 0);
    });
}

TYPED_TEST(PaperTreeTest, EachNodeButTheRootHasOneParentThatComesBefore)
{
  ForEachPaperTree<TypeParam::Value>(
    [](const auto&, const auto& tree)
    {
      std::vector<int> parents(tree.L.size(), 0);
      for (std::size_t node = 0; node < tree.L.size(); ++node)
      {
        if (!tree.IsLeaf(node))
        {
          ASSERT_GT(static_cast<std::size_t>(tree.L[node]), node);
          ASSERT_LT(static_cast<std::size_t>(tree.L[node]) + 1, tree.L.size());
          ++parents[tree.L[node]];
          ++parents[tree.L[node] + 1];
        }
      }
      EXPECT_TRUE(parents.empty() || parents[0] == 0);
      EXPECT_EQ(std::count(parents.begin(), parents.end(), 1),
        std::max<std::ptrdiff_t>(0, static_cast<std::ptrdiff_t>(parents.size()) - 1));
    });
}

TYPED_TEST(PaperTreeTest, EachElementIsInOneLeaf)
{
  ForEachPaperTree<TypeParam::Value>(
    [](const auto& boxes, const auto& tree)
    {
      const Ids all = Select(boxes, [](const auto&) { return true; });
      EXPECT_EQ(boxes.empty() ? Ids{} : Sorted(ElementsBelow(tree)[0]), all);
    });
}

TYPED_TEST(PaperTreeTest, BoxesAreTheUnionsOfTheElementsBelow)
{
  ForEachPaperTree<TypeParam::Value>(
    [](const auto& boxes, const auto& tree)
    {
      const std::vector<Ids> below = ElementsBelow(tree);
      for (std::size_t node = 0; node < below.size(); ++node)
      {
        skd::Box<TypeParam::Value> box;
        for (const std::uint32_t element : below[node])
        {
          box.Add(boxes[element]);
        }
        EXPECT_TRUE(tree.S[node].Min == box.Min && tree.S[node].Max == box.Max) << node;
      }
    });
}

TYPED_TEST(PaperTreeTest, TheFirstChildHasTheHalfRoundedUp)
{
  ForEachPaperTree<TypeParam::Value>(
    [](const auto&, const auto& tree)
    {
      const std::vector<Ids> below = ElementsBelow(tree);
      for (std::size_t node = 0; node < below.size(); ++node)
      {
        if (!tree.IsLeaf(node))
        {
          EXPECT_EQ(below[tree.L[node]].size(), (below[node].size() + 1) / 2);
          EXPECT_EQ(below[tree.L[node] + 1].size(), below[node].size() / 2);
        }
      }
    });
}

TYPED_TEST(PaperTreeTest, TheMedianAlongTheLongestAxisDividesTheCentroids)
{
  ForEachPaperTree<TypeParam::Value>(
    [](const auto& boxes, const auto& tree)
    {
      const std::vector<Ids> below = ElementsBelow(tree);
      for (std::size_t node = 0; node < below.size(); ++node)
      {
        if (tree.IsLeaf(node))
        {
          continue;
        }
        const int axis = tree.S[node].LongestAxis();
        double leftGreatest = std::numeric_limits<double>::lowest();
        for (const std::uint32_t element : below[tree.L[node]])
        {
          leftGreatest = std::max(leftGreatest, boxes[element].Centroid()[axis]);
        }
        for (const std::uint32_t element : below[tree.L[node] + 1])
        {
          EXPECT_LE(leftGreatest, boxes[element].Centroid()[axis]) << "node " << node;
        }
      }
    });
}

TYPED_TEST(PaperTreeTest, OfOneElementIsALeafThatIsTheRoot)
{
  const auto tree = skd::BuildPaperTree(RandomBoxes<TypeParam::Value>(1));
  ASSERT_EQ(tree.L.size(), 1u);
  EXPECT_TRUE(tree.IsLeaf(0));
  EXPECT_EQ(tree.L[0], 0);
}

}
