// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Search/Queries/WithinBox.h"
#include "CoreSupport.h"

using namespace coretest;

namespace
{

template <class Type>
class WithinBoxTest : public ::testing::Test
{
};
TYPED_TEST_SUITE(WithinBoxTest, Dimensions, DimensionNames);

template <int D, class Tree>
Ids VisitedIn(const Tree& tree, const skd::Box<D>& box)
{
  return Visited(tree, true,
    [&](auto& visitor)
    { return skd::WithinBox<D, std::decay_t<decltype(visitor)>>(tree.GetFrame(), box, visitor); });
}

template <int D>
Ids Overlapping(const Boxes<D>& boxes, const skd::Box<D>& query)
{
  return Select(boxes, [&](const skd::Box<D>& box) { return box.Overlaps(query); });
}

/// Those within a distance along each axis, counted from a point near: no digits are lost there.
template <int D>
Ids OverlappingWithin(
  const Boxes<D>& boxes, const skd::Box<D>& query, const skd::Vector<D>& near, double distance)
{
  const skd::Box<D> larger = skd::Box<D>(query.Min - near, query.Max - near).Inflated(distance);
  return Select(boxes,
    [&](const skd::Box<D>& box)
    { return skd::Box<D>(box.Min - near, box.Max - near).Overlaps(larger); });
}

template <int D, class Tree>
void ExpectOverlapping(const Tree& tree, const Boxes<D>& boxes, const skd::Box<D>& query)
{
  const skd::Frame<D>& frame = tree.GetFrame();
  double extent = 0.0;
  for (int axis = 0; axis < D; ++axis)
  {
    extent = std::max({ extent, std::abs(query.Min[axis] - frame.Centre[axis]),
      std::abs(query.Max[axis] - frame.Centre[axis]) });
  }
  ExpectVisited(VisitedIn(tree, query), Overlapping(boxes, query),
    OverlappingWithin(boxes, query, frame.Centre, FloatError(frame, extent)));
}

TYPED_TEST(WithinBoxTest, ReachesWhatOverlapsARandomBox)
{
  ForEachTree<TypeParam::Value>(true,
    [](const auto& scene, const auto& tree)
    {
      Random random(1);
      const auto around = Around(scene.Boxes);
      for (int i = 0; i < 10; ++i)
      {
        auto query = around;
        query.Min = query.Max = random.Point(around);
        query.Add(random.Point(around));
        ExpectOverlapping(tree, scene.Boxes, query);
      }
    });
}

TYPED_TEST(WithinBoxTest, ReachesWhatHoldsAPoint)
{
  ForEachTree<TypeParam::Value>(true,
    [](const auto& scene, const auto& tree)
    {
      constexpr int D = TypeParam::Value;
      for (const auto& point : QueryPoints(scene.Boxes))
      {
        ExpectOverlapping(tree, scene.Boxes, skd::Box<D>(point, point));
      }
    });
}

TYPED_TEST(WithinBoxTest, ReachesTheSameAboutAPointOfTheFrame)
{
  ForEachTree<TypeParam::Value>(true,
    [](const auto& scene, const auto& tree)
    {
      constexpr int D = TypeParam::Value;
      std::vector<skd::Vector<D>> points = QueryPoints(scene.Boxes);
      points.push_back(Filled<D>(1e300));
      points.push_back(Filled<D>(-1e300));
      for (const auto& point : points)
      {
        const Ids visited = Visited(tree, true,
          [&](auto& visitor)
          {
            return skd::WithinBox<D, std::decay_t<decltype(visitor)>>(
              tree.GetFrame().Local(point), visitor, skd::NoLeafFilter());
          });
        EXPECT_EQ(visited, VisitedIn(tree, skd::Box<D>(point, point)));
      }
    });
}

TYPED_TEST(WithinBoxTest, ReachesWhatTouchesInAFace)
{
  ForEachTree<TypeParam::Value>(true,
    [](const auto& scene, const auto& tree)
    {
      constexpr int D = TypeParam::Value;
      for (std::size_t i = 0; i < std::min<std::size_t>(scene.Boxes.size(), 10); ++i)
      {
        const int axis = static_cast<int>(i % D);
        skd::Box<D> above = scene.Boxes[i];
        above.Min[axis] = scene.Boxes[i].Max[axis];
        above.Max[axis] += scene.Boxes[i].Length(axis);
        ExpectOverlapping(tree, scene.Boxes, above);
        skd::Box<D> below = scene.Boxes[i];
        below.Max[axis] = scene.Boxes[i].Min[axis];
        below.Min[axis] -= scene.Boxes[i].Length(axis);
        ExpectOverlapping(tree, scene.Boxes, below);
      }
    });
}

TYPED_TEST(WithinBoxTest, OfALatticeReachesTheNeighboursOnly)
{
  constexpr int D = TypeParam::Value;
  const Boxes<D> boxes = LatticeBoxes<D>(4096);
  const auto tree = skd::BuildTree<D>(InputOf(boxes, 8));
  for (std::size_t i = 0; i < boxes.size(); i += 97)
  {
    EXPECT_EQ(Sorted(VisitedIn(tree, boxes[i])), Overlapping(boxes, boxes[i]));
  }
}

TYPED_TEST(WithinBoxTest, ReachesAllInTheBounds)
{
  ForEachTree<TypeParam::Value>(true,
    [](const auto& scene, const auto& tree)
    {
      const Ids all = Select(scene.Boxes, [](const auto&) { return true; });
      ExpectVisited(VisitedIn(tree, tree.GetBounds()), all, all);
    });
}

TYPED_TEST(WithinBoxTest, ReachesNothingInAnEmptyBox)
{
  ForEachTree<TypeParam::Value>(true,
    [](const auto&, const auto& tree)
    { EXPECT_TRUE(VisitedIn(tree, skd::Box<TypeParam::Value>()).empty()); });
}

TYPED_TEST(WithinBoxTest, ReachesNothingBesideTheBounds)
{
  constexpr int D = TypeParam::Value;
  const Boxes<D> boxes = RandomBoxes<D>(513);
  const auto tree = skd::BuildTree<D>(InputOf(boxes, 8));
  for (int axis = 0; axis < D; ++axis)
  {
    skd::Box<D> beside = tree.GetBounds();
    beside.Min[axis] = beside.Max[axis] + 1e-5;
    beside.Max[axis] = 1e300;
    const CountedTree counted(tree);
    auto visitor = [](std::uint32_t) { return true; };
    skd::WithinBox<D, decltype(visitor)> query(tree.GetFrame(), beside, visitor);
    skd::Walk(counted, query);
    EXPECT_EQ(counted.Opened, 1u);
  }
}

TYPED_TEST(WithinBoxTest, ReachesNothingWithNaN)
{
  constexpr int D = TypeParam::Value;
  const Boxes<D> boxes = RandomBoxes<D>(513);
  const auto tree = skd::BuildTree<D>(InputOf(boxes, 8));
  skd::Box<D> query = tree.GetBounds();
  query.Min[D - 1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(VisitedIn(tree, query).empty());
  query.Min[D - 1] = 0.0;
  query.Max[0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(VisitedIn(tree, query).empty());
}

TYPED_TEST(WithinBoxTest, ReachesAllInABoxWithoutEnds)
{
  constexpr int D = TypeParam::Value;
  const double infinity = std::numeric_limits<double>::infinity();
  const auto tree = skd::BuildTree<D>(InputOf(RandomBoxes<D>(513), 8));
  EXPECT_EQ(VisitedIn(tree, skd::Box<D>(Filled<D>(-infinity), Filled<D>(infinity))).size(), 513u);
}

TYPED_TEST(WithinBoxTest, EndsWhenTheVisitorSaysSo)
{
  constexpr int D = TypeParam::Value;
  const auto tree = skd::BuildTree<D>(InputOf(RandomBoxes<D>(513), 8));
  int visited = 0;
  auto visitor = [&visited](std::uint32_t) { return ++visited < 3; };
  skd::WithinBox<D, decltype(visitor)> query(tree.GetFrame(), tree.GetBounds(), visitor);
  skd::Walk(tree, query);
  EXPECT_EQ(visited, 3);
}

}
