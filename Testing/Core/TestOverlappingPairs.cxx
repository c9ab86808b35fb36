// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Search/Queries/OverlapParts.h"
#include "Core/Search/Queries/OverlappingPairs.h"
#include "Core/Search/Tree/WalkPairs.h"
#include "CoreSupport.h"

using namespace coretest;

namespace
{

template <class Type>
class OverlappingPairsTest : public ::testing::Test
{
};
TYPED_TEST_SUITE(OverlappingPairsTest, Dimensions, DimensionNames);

struct Unmoved
{
  template <class Box>
  Box operator()(const Box& box) const
  {
    return box;
  }
};

/// A turn in the planes of all neighbouring axes, and a shift.
template <int D>
struct Motion
{
  double Angle;
  skd::Vector<D> Shift;

  skd::Vector<D> Rotated(skd::Vector<D> x) const
  {
    for (int axis = 0; axis + 1 < D; ++axis)
    {
      const double a = x[axis];
      const double b = x[axis + 1];
      x[axis] = std::cos(this->Angle) * a - std::sin(this->Angle) * b;
      x[axis + 1] = std::sin(this->Angle) * a + std::cos(this->Angle) * b;
    }
    return x;
  }

  skd::Box<D> operator()(const skd::Box<D>& box) const
  {
    skd::Vector<D> maxDistance = Filled<D>(0.0);
    for (int axis = 0; axis < D; ++axis)
    {
      const skd::Vector<D> edge = this->Rotated(Along<D>(axis, 0.5 * box.Length(axis)));
      for (int i = 0; i < D; ++i)
      {
        maxDistance[i] += std::abs(edge[i]);
      }
    }
    return BoxAround(this->Rotated(box.Centroid()) + this->Shift, maxDistance);
  }
};

/// A pair as one number.
std::uint32_t Pair(std::size_t a, std::size_t b)
{
  return static_cast<std::uint32_t>(a * 10000 + b);
}

template <class First, class Second, class ToFirst>
Ids VisitedPairs(const First& first, const Second& second, const ToFirst& toFirst)
{
  constexpr int D = std::extent_v<decltype(first.GetFrame().Centre.X)>;
  Ids visited;
  auto visitor = [&](std::uint32_t a, std::uint32_t b)
  {
    visited.push_back(Pair(a, b));
    return true;
  };
  skd::OverlappingPairs<D, ToFirst, decltype(visitor)> query(
    first.GetFrame(), second.GetFrame(), toFirst, visitor);
  skd::WalkPairs(first, second, query);
  return visited;
}

/// Pairs that overlap when each box is grown by `margin`, counted from a point near.
template <int D>
Ids Pairs(const Boxes<D>& first, const Boxes<D>& second, const skd::Vector<D>& near, double margin)
{
  Ids pairs;
  for (std::size_t a = 0; a < first.size(); ++a)
  {
    const skd::Box<D> boxA = skd::Box<D>(first[a].Min - near, first[a].Max - near).Inflated(margin);
    for (std::size_t b = 0; b < second.size(); ++b)
    {
      const skd::Box<D> boxB(second[b].Min - near, second[b].Max - near);
      if (boxA.Overlaps(boxB))
      {
        pairs.push_back(Pair(a, b));
      }
    }
  }
  return pairs;
}

template <int D>
Boxes<D> Moved(Boxes<D> boxes, const Motion<D>& motion)
{
  std::transform(boxes.begin(), boxes.end(), boxes.begin(), motion);
  return boxes;
}

/// `test(first, second)` for all kinds of pairs of trees.
template <int D, class Test>
void ForEachKindOfTrees(const Boxes<D>& first, const Boxes<D>& second, Test test)
{
  const auto firstTree = skd::BuildTree<D>(InputOf(first, 8));
  const auto secondTree = skd::BuildTree<D>(InputOf(second, 3));
  test(firstTree, secondTree);
  test(firstTree, skd::BuildLazyTree<D>(InputOf(second, 3)));
  test(skd::BuildLazyTree<D>(InputOf(first, 1)), secondTree);
  test(skd::BuildLazyTree<D>(InputOf(first, 1)), skd::BuildLazyTree<D>(InputOf(second, 8)));
}

template <int D>
void ExpectPairs(const Boxes<D>& first, const Boxes<D>& second)
{
  ForEachKindOfTrees<D>(first, second,
    [&](const auto& firstTree, const auto& secondTree)
    {
      // The way from frame to frame leads through the world, whose coordinates are rounded, too.
      const skd::Vector<D> far = BoundsOf(second).Max;
      const double error = FloatError(secondTree.GetFrame()) +
        FloatError(firstTree.GetFrame(), Norm(far - firstTree.GetFrame().Centre)) +
        std::ldexp(Norm(far), -50);
      const skd::Vector<D> near = firstTree.GetFrame().Centre;
      const double noMargin = 0.0;
      ExpectVisited(VisitedPairs(firstTree, secondTree, Unmoved()),
        Pairs(first, second, Filled<D>(0.0), noMargin), Pairs(first, second, near, error));
      // In single precision, between frames that are at most 16 of the first's half sizes apart.
      const double coarse = error + 64.0 * FLT_EPSILON / firstTree.GetFrame().Scale;
      ExpectVisited(VisitedPairs(firstTree, secondTree, skd::SameWorld()),
        Pairs(first, second, Filled<D>(0.0), noMargin), Pairs(first, second, near, coarse));
      const double margin = 0.01;
      ExpectVisited(VisitedPairs(firstTree, secondTree, skd::SameWorld{ margin }),
        Pairs(first, second, Filled<D>(0.0), 0.999 * margin),
        Pairs(first, second, near, coarse + 1.001 * margin));
    });
}

TYPED_TEST(OverlappingPairsTest, AreThoseWhoseBoxesOverlap)
{
  constexpr int D = TypeParam::Value;
  const std::pair<std::size_t, std::size_t> counts[] = { { 0, 9 }, { 9, 0 }, { 1, 1 }, { 1, 65 },
    { 64, 7 }, { 8, 513 }, { 513, 63 } };
  for (const auto& [n, m] : counts)
  {
    const auto firsts = AllScenes<D>(n, false);
    const auto seconds = AllScenes<D>(m, false);
    for (std::size_t i = 0; i < firsts.size(); ++i)
    {
      SCOPED_TRACE(firsts[i].Name + " and " + seconds[i].Name);
      ExpectPairs(firsts[i].Boxes, seconds[i].Boxes);
    }
  }
}

TYPED_TEST(OverlappingPairsTest, OfUnlikeSetsAreThoseWhoseBoxesOverlap)
{
  constexpr int D = TypeParam::Value;
  Boxes<D> spread = RandomBoxes<D>(64, 5);
  spread.push_back(BoxAround(Filled<D>(1e6), Filled<D>(1.0)));
  for (const Boxes<D>& second :
    { spread, Transformed<D>(RandomBoxes<D>(65, 6), 0.01, 0.2),
      Transformed<D>(RandomBoxes<D>(65, 7), 1000.0, 3.0), SliverBoxes<D>(65), GradedBoxes<D>(65) })
  {
    ExpectPairs(RandomBoxes<D>(513), second);
    ExpectPairs(second, RandomBoxes<D>(513));
  }
}

/// Two frames round differently: boxes that only touch must be found through both.
TYPED_TEST(OverlappingPairsTest, AreTouchingNeighboursInALattice)
{
  constexpr int D = TypeParam::Value;
  const Boxes<D> lattice = Transformed<D>(LatticeBoxes<D>(256), 0.1, 0.7);
  Boxes<D> same(lattice.begin() + 17, lattice.begin() + 170);
  same.push_back(BoxAround(Filled<D>(12345.678), Filled<D>(1.0)));
  ExpectPairs(lattice, same);
  ExpectPairs(same, lattice);
}

/// The second set's frame cannot resolve where its little box ends.
TYPED_TEST(OverlappingPairsTest, TouchThoughOneSetIsHugeAndTheOtherTiny)
{
  constexpr int D = TypeParam::Value;
  for (const double end : { 1e-8, 3e-8, 1e-7, 1e-3 })
  {
    const Boxes<D> tiny{ { Filled<D>(end), Filled<D>(10.0 * end) } };
    const Boxes<D> huge{ { Filled<D>(0.0), Filled<D>(end) }, { Filled<D>(2e9), Filled<D>(2e9) } };
    const auto tinyTree = skd::BuildTree<D>(InputOf(tiny, 8));
    const auto hugeTree = skd::BuildTree<D>(InputOf(huge, 8));
    EXPECT_EQ(VisitedPairs(tinyTree, hugeTree, Unmoved()), Ids{ Pair(0, 0) }) << end;
    EXPECT_EQ(VisitedPairs(hugeTree, tinyTree, Unmoved()), Ids{ Pair(0, 0) }) << end;
    EXPECT_EQ(VisitedPairs(tinyTree, hugeTree, skd::SameWorld()), Ids{ Pair(0, 0) }) << end;
    EXPECT_EQ(VisitedPairs(hugeTree, tinyTree, skd::SameWorld()), Ids{ Pair(0, 0) }) << end;
  }
}

TYPED_TEST(OverlappingPairsTest, AreFoundThroughARigidMotion)
{
  constexpr int D = TypeParam::Value;
  Random random(1);
  for (const double angle : { 0.0, 0.3, 1.5, 3.0 })
  {
    const Motion<D> motion{ angle, random.Point<D>(-0.5, 0.5) };
    const Boxes<D> first = RandomBoxes<D>(513);
    const Boxes<D> second = RandomBoxes<D>(65, 9);
    const Boxes<D> moved = Moved<D>(second, motion);
    ForEachKindOfTrees<D>(first, second,
      [&](const auto& firstTree, const auto& secondTree)
      {
        ExpectVisited(VisitedPairs(firstTree, secondTree, motion),
          Pairs(first, moved, Filled<D>(0.0), -1e-12), Pairs(first, moved, Filled<D>(0.0), 1e-4));
      });
  }
}

/// Boxes are moved in single precision where the trees' frames are much the same, else in double.
TEST(OverlappingPairsOfMovedTest, AreFound)
{
  Random random(4);
  for (const double size : { 1.0, 20.0, 0.004 })
  {
    for (const double away : { 0.0, 1e3, 1e9 })
    {
      for (const double angle : { 0.0, 0.4, 1.6, 3.1 })
      {
        const Motion<3> turn{ angle, Filled<3>(0.0) };
        skd::RigidMotion motion{ {}, random.Point<3>(-0.5, 0.5) + Filled<3>(away) };
        for (int axis = 0; axis < 3; ++axis)
        {
          const skd::Vector<3> column = turn.Rotated(Along<3>(axis, 1.0));
          for (int row = 0; row < 3; ++row)
          {
            motion.Rows[row][axis] = column[row];
          }
        }
        const Boxes<3> first = Transformed<3>(RandomBoxes<3>(513), 1.0, away);
        const Boxes<3> second = Transformed<3>(RandomBoxes<3>(65, 9), size, 0.0);
        const double margin = away > 1e6 ? 1e-5 : 1e-9; // coordinates of 1e9 are rounded
        Boxes<3> moved = second;
        for (skd::Box<3>& box : moved)
        {
          box = motion.Forward(box).Inflated(margin);
        }
        ForEachKindOfTrees<3>(first, second,
          [&](const auto& firstTree, const auto& secondTree)
          {
            ExpectVisited(VisitedPairs(firstTree, secondTree, skd::MovedWorld{ motion, margin }),
              Pairs(first, moved, Filled<3>(away), -1e-12),
              Pairs(first, moved, Filled<3>(away), 1e-4 * std::max(1.0, size)));
          });
      }
    }
  }
}

TYPED_TEST(OverlappingPairsTest, OfSetsApartAreNone)
{
  constexpr int D = TypeParam::Value;
  const auto here = skd::BuildTree<D>(InputOf(RandomBoxes<D>(513), 8));
  const auto there = skd::BuildTree<D>(InputOf(Transformed<D>(RandomBoxes<D>(513), 1.0, 5.0), 8));
  EXPECT_TRUE(VisitedPairs(here, there, Unmoved()).empty());
}

TYPED_TEST(OverlappingPairsTest, EndWhenTheVisitorSaysSo)
{
  constexpr int D = TypeParam::Value;
  const auto tree = skd::BuildTree<D>(InputOf(EqualBoxes<D>(65), 8));
  int visited = 0;
  auto visitor = [&visited](std::uint32_t, std::uint32_t) { return ++visited < 3; };
  const Unmoved unmoved;
  skd::OverlappingPairs<D, Unmoved, decltype(visitor)> query(
    tree.GetFrame(), tree.GetFrame(), unmoved, visitor);
  skd::WalkPairs(tree, tree, query);
  EXPECT_EQ(visited, 3);
}

/// A line against itself: each box meets itself and two others, so work grows as the set does.
TYPED_TEST(OverlappingPairsTest, OpensFewNodesForALineAgainstItself)
{
  constexpr int D = TypeParam::Value;
  const Boxes<D> boxes = LineOfBoxes<D>(4096);
  const auto tree = skd::BuildTree<D>(InputOf(boxes, 8));
  int visited = 0;
  auto visitor = [&visited](std::uint32_t, std::uint32_t) { return ++visited > 0; };
  const Unmoved unmoved;
  skd::OverlappingPairs<D, Unmoved, decltype(visitor)> query(
    tree.GetFrame(), tree.GetFrame(), unmoved, visitor);
  const CountedTree first(tree);
  skd::WalkPairs(first, tree, query);
  EXPECT_EQ(visited, 3 * 4096 - 2);
  EXPECT_LE(first.Opened, 40u * tree.NumberOfNodes());
}

/// A tree against itself, in at least so many parts.
template <int D>
Ids PairsWithin(const skd::Tree<D>& tree, std::size_t enough)
{
  Ids visited;
  const auto visitor = [&](std::uint32_t a, std::uint32_t b)
  {
    visited.push_back(Pair(std::min(a, b), std::max(a, b)));
    return true;
  };
  using Tree = skd::Tree<D>;
  const Unmoved unmoved;
  const skd::OverlapParts<D, Tree, Tree, Unmoved, decltype(visitor)> parts(
    tree, tree, unmoved, enough, visitor, true);
  parts.Visit(0, parts.size(), visitor);
  return visited;
}

TYPED_TEST(OverlappingPairsTest, OfOneTreeAreReachedOnce)
{
  constexpr int D = TypeParam::Value;
  for (const Boxes<D>& boxes :
    { RandomBoxes<D>(513), EqualBoxes<D>(65), LineOfBoxes<D>(300), RandomBoxes<D>(1), Boxes<D>() })
  {
    const auto tree = skd::BuildTree<D>(InputOf(boxes, 8));
    Ids expected;
    for (const std::uint32_t pair : VisitedPairs(tree, tree, Unmoved()))
    {
      if (pair / 10000 < pair % 10000)
      {
        expected.push_back(pair);
      }
    }
    for (const std::size_t parts : { 1, 7, 100, 100000 })
    {
      EXPECT_EQ(Sorted(PairsWithin(tree, parts)), Sorted(expected)) << parts;
    }
  }
}

TYPED_TEST(OverlappingPairsTest, OfTwoTreesAreTheSameInParts)
{
  constexpr int D = TypeParam::Value;
  const auto first = skd::BuildTree<D>(InputOf(RandomBoxes<D>(513), 8));
  const auto second = skd::BuildTree<D>(InputOf(RandomBoxes<D>(65, 9), 3));
  Ids visited;
  const auto visitor = [&](std::uint32_t a, std::uint32_t b)
  {
    visited.push_back(Pair(a, b));
    return true;
  };
  using Tree = skd::Tree<D>;
  const Unmoved unmoved;
  const skd::OverlapParts<D, Tree, Tree, Unmoved, decltype(visitor)> parts(
    first, second, unmoved, 50, visitor, false);
  EXPECT_GE(parts.size(), 50u);
  EXPECT_TRUE(visited.empty());
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    parts.Visit(i, i + 1, visitor);
  }
  EXPECT_EQ(Sorted(visited), Sorted(VisitedPairs(first, second, Unmoved())));
}

}
