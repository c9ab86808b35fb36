// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Search/Queries/AlongSegment.h"
#include "CoreSupport.h"

using namespace coretest;

namespace
{

template <class Type>
class AlongSegmentTest : public ::testing::Test
{
};
TYPED_TEST_SUITE(AlongSegmentTest, Dimensions, DimensionNames);

template <int D, class Tree>
Ids AllAlong(const Tree& tree, const skd::Segment<D>& segment, double margin = 0.0)
{
  return Visited(tree, 1.0,
    [&](auto& visitor)
    {
      return skd::AlongSegment<D, std::decay_t<decltype(visitor)>>(
        tree.GetFrame(), segment, margin, visitor);
    });
}

/// The least parameter at which the segment enters a box, as a search for the first hit finds it.
template <int D, class Tree>
double FirstAlong(const Tree& tree, const Boxes<D>& boxes, const skd::Segment<D>& segment)
{
  double first = 2.0;
  auto visitor = [&](std::uint32_t element)
  {
    const auto inside = skd::Clip(segment, boxes[element]);
    first = inside ? std::min(first, inside->Min) : first;
    return std::min(first, 1.0);
  };
  skd::AlongSegment<D, decltype(visitor)> query(tree.GetFrame(), segment, 0.0, visitor);
  skd::Walk(tree, query);
  return first;
}

template <int D>
Ids Crossed(const Boxes<D>& boxes, const skd::Segment<D>& segment, double margin = 0.0)
{
  return Select(boxes,
    [&](const skd::Box<D>& box) { return skd::Clip(segment, box.Inflated(margin)).has_value(); });
}

/// Those crossed within a distance along each axis, counted from a point near.
template <int D>
Ids CrossedWithin(const Boxes<D>& boxes, const skd::Segment<D>& segment, const skd::Vector<D>& near,
  double distance)
{
  const skd::Segment<D> moved{ segment.A - near, segment.B - near };
  return Select(boxes,
    [&](const skd::Box<D>& box)
    {
      const skd::Box<D> larger = skd::Box<D>(box.Min - near, box.Max - near).Inflated(distance);
      return skd::Clip(moved, larger).has_value();
    });
}

/// All that a segment crosses, in both directions, and nothing beside it; and the first of them.
template <int D, class Tree>
void ExpectCrossed(const Tree& tree, const Boxes<D>& boxes, const skd::Segment<D>& segment)
{
  const skd::Frame<D>& frame = tree.GetFrame();
  for (const auto& directed : { segment, skd::Segment<D>{ segment.B, segment.A } })
  {
    ExpectVisited(AllAlong(tree, directed), Crossed(boxes, directed),
      CrossedWithin(boxes, directed, frame.Centre, 1e-4 / frame.Scale));
    double first = 2.0;
    for (const skd::Box<D>& box : boxes)
    {
      const auto inside = skd::Clip(directed, box);
      first = inside ? std::min(first, inside->Min) : first;
    }
    EXPECT_EQ(FirstAlong(tree, boxes, directed), first);
  }
}

/// `test(scene, tree, point)` for points in boxes and at corners of them.
template <int D, class Test>
void ForEachPointOfBoxes(Test test)
{
  ForEachTree<D>(true,
    [&](const auto& scene, const auto& tree)
    {
      Random random(1);
      for (std::size_t i = 0; i < std::min<std::size_t>(scene.Boxes.size(), 4); ++i)
      {
        const auto& box = scene.Boxes[random.Below(scene.Boxes.size())];
        test(scene.Boxes, tree, random.Point(box));
        test(scene.Boxes, tree, random.Corner(box));
      }
    });
}

/// The same for segments from there: `move(segment, unit)` moves A away, in units of the tree's
/// size.
template <int D, class Move>
void ExpectCrossedFromPoints(const Move& move)
{
  ForEachPointOfBoxes<D>(
    [&](const auto& boxes, const auto& tree, const auto& point)
    {
      skd::Segment<D> segment{ point, point };
      move(segment, 1.0 / tree.GetFrame().Scale);
      ExpectCrossed(tree, boxes, segment);
    });
}

TYPED_TEST(AlongSegmentTest, ReachesWhatARandomSegmentCrosses)
{
  ForEachTree<TypeParam::Value>(true,
    [](const auto& scene, const auto& tree)
    {
      constexpr int D = TypeParam::Value;
      Random random(2);
      const auto around = Around(scene.Boxes);
      for (int i = 0; i < 5; ++i)
      {
        ExpectCrossed(
          tree, scene.Boxes, skd::Segment<D>{ random.Point(around), random.Point(around) });
      }
    });
}

TYPED_TEST(AlongSegmentTest, ReachesWhatASegmentThroughABoxCrosses)
{
  Random random(3);
  ForEachPointOfBoxes<TypeParam::Value>(
    [&](const auto& boxes, const auto& tree, const auto& point)
    {
      constexpr int D = TypeParam::Value;
      const auto step = (0.4 / tree.GetFrame().Scale) * random.Direction<D>();
      ExpectCrossed(tree, boxes, skd::Segment<D>{ point - step, point + step });
    });
}

TYPED_TEST(AlongSegmentTest, ReachesWhatASegmentAlongAnAxisCrosses)
{
  Random random(4);
  constexpr int D = TypeParam::Value;
  ExpectCrossedFromPoints<D>([&](skd::Segment<D>& segment, double unit)
    { segment.A[static_cast<int>(random.Below(D))] -= 2.0 * unit; });
}

TYPED_TEST(AlongSegmentTest, ReachesWhatASegmentInACoordinatePlaneCrosses)
{
  Random random(5);
  ForEachPointOfBoxes<TypeParam::Value>(
    [&](const auto& boxes, const auto& tree, const auto& point)
    {
      constexpr int D = TypeParam::Value;
      auto step = (1.0 / tree.GetFrame().Scale) * random.Direction<D>();
      step[static_cast<int>(random.Below(D))] = 0.0;
      ExpectCrossed(tree, boxes, skd::Segment<D>{ point - step, point + step });
    });
}

/// Nearly along an axis: sideways by a few units in the last place only.
TYPED_TEST(AlongSegmentTest, ReachesWhatASegmentAlmostAlongAnAxisCrosses)
{
  Random random(6);
  constexpr int D = TypeParam::Value;
  ExpectCrossedFromPoints<D>(
    [&](skd::Segment<D>& segment, double unit)
    {
      for (int axis = 0; axis < D; ++axis)
      {
        segment.A[axis] = std::nextafter(segment.B[axis], random.In(-1.0, 1.0) * 1e300);
      }
      const int along = static_cast<int>(random.Below(D));
      segment.A[along] = segment.B[along] - 2.0 * unit;
    });
}

TYPED_TEST(AlongSegmentTest, ReachesBoxesOnWhoseFacesItEnds)
{
  Random random(7);
  ForEachTree<TypeParam::Value>(true,
    [&](const auto& scene, const auto& tree)
    {
      constexpr int D = TypeParam::Value;
      for (std::size_t i = 0; i < std::min<std::size_t>(scene.Boxes.size(), 6); ++i)
      {
        const int axis = static_cast<int>(i % D);
        skd::Segment<D> segment{ random.Point(scene.Boxes[i]), random.Point(scene.Boxes[i]) };
        segment.A[axis] = scene.Boxes[i].Max[axis] + 1.0 / tree.GetFrame().Scale;
        segment.B[axis] = scene.Boxes[i].Max[axis];
        const Ids crossed = AllAlong(tree, segment);
        EXPECT_EQ(std::count(crossed.begin(), crossed.end(), i), 1);
        ExpectCrossed(tree, scene.Boxes, segment);
      }
    });
}

TYPED_TEST(AlongSegmentTest, ReachesWhatHoldsASegmentWithoutLength)
{
  ForEachPointOfBoxes<TypeParam::Value>(
    [](const auto& boxes, const auto& tree, const auto& point) {
      ExpectCrossed(tree, boxes, skd::Segment<TypeParam::Value>{ point, point });
    });
}

/// Far ends: what is crossed near the set does not depend on where the segment began.
TYPED_TEST(AlongSegmentTest, ReachesBoxesBetweenFarEnds)
{
  Random random(8);
  ForEachTree<TypeParam::Value>(false,
    [&](const auto& scene, const auto& tree)
    {
      constexpr int D = TypeParam::Value;
      for (std::size_t i = 0; i < std::min<std::size_t>(scene.Boxes.size(), 4); ++i)
      {
        const auto middle = scene.Boxes[i].Centroid();
        for (const double far : { 3.0, 3.999, 4.001, 1e3, 1e6, 1e9 })
        {
          const auto step = (far / tree.GetFrame().Scale) * random.Direction<D>();
          const skd::Segment<D> segment{ middle - step, middle + step };
          ExpectVisited(AllAlong(tree, segment), Crossed(scene.Boxes, segment),
            CrossedWithin(
              scene.Boxes, segment, tree.GetFrame().Centre, 1e-4 / tree.GetFrame().Scale));
        }
      }
    });
}

/// A flat set is crossed in a point of each segment, however it lies and whatever its size.
TYPED_TEST(AlongSegmentTest, FindsAFlatSetFromAfar)
{
  constexpr int D = TypeParam::Value;
  const Boxes<D> square{ skd::Box<D>(
    Along<D>(D - 1, 0.3), Filled<D>(1.0) + Along<D>(D - 1, -0.7)) };
  const auto tree = skd::BuildTree<D>(InputOf(square, 8));
  Random random(9);
  for (double far = 1.0; far < 1e13; far *= 10.0)
  {
    for (int i = 0; i < 100; ++i)
    {
      const skd::Vector<D> middle = random.Point<D>(0.2, 0.8);
      skd::Vector<D> step = far * random.Point<D>(-0.2, 0.2);
      step[D - 1] = far;
      skd::Segment<D> segment{ middle - step, middle + step };
      EXPECT_EQ(AllAlong(tree, segment).size(), 1u) << "length " << far;
    }
  }
}

TYPED_TEST(AlongSegmentTest, MarginWidensEveryBox)
{
  ForEachTree<TypeParam::Value>(true,
    [](const auto& scene, const auto& tree)
    {
      constexpr int D = TypeParam::Value;
      Random random(10);
      const double size = 1.0 / tree.GetFrame().Scale;
      const auto around = Around(scene.Boxes);
      for (const double margin : { 0.01 * size, size })
      {
        const skd::Segment<D> segment{ random.Point(around), random.Point(around) };
        ExpectVisited(AllAlong(tree, segment, margin), Crossed(scene.Boxes, segment, margin),
          CrossedWithin(scene.Boxes, segment, tree.GetFrame().Centre, margin + 1e-4 * size));
      }
    });
}

TYPED_TEST(AlongSegmentTest, MissesTheTreeWithoutOpeningIt)
{
  constexpr int D = TypeParam::Value;
  const auto tree = skd::BuildTree<D>(InputOf(RandomBoxes<D>(513), 8));
  const skd::Segment<D> beside{ Filled<D>(10.0), Filled<D>(11.0) };
  const CountedTree counted(tree);
  EXPECT_EQ(FirstAlong(counted, RandomBoxes<D>(513), beside), 2.0);
  EXPECT_EQ(counted.Opened, 0u);
}

TYPED_TEST(AlongSegmentTest, OpensAPathOfNodesToTheFirstHit)
{
  constexpr int D = TypeParam::Value;
  const Boxes<D> boxes = LineOfBoxes<D>(32768);
  const auto tree = skd::BuildTree<D>(InputOf(boxes, 8));
  const CountedTree counted(tree);
  const skd::Segment<D> along{ Along<D>(0, -5.0), Along<D>(0, 40000.0) };
  const double first = FirstAlong(counted, boxes, along);
  EXPECT_DOUBLE_EQ(first, 5.0 / 40005.0);
  EXPECT_LE(counted.Opened, 6u) << "five levels, and a neighbour within rounding";
}

/// A kernel's parameter may be rounded down, even to before the set's bounds: equal hits still
/// come.
TYPED_TEST(AlongSegmentTest, ReachesAllThatShareTheFirstHit)
{
  constexpr int D = TypeParam::Value;
  const auto tree = skd::BuildTree<D>(InputOf(EqualBoxes<D>(65), 8));
  for (const double far : { 1.0, 1e6, 1e9 })
  {
    const skd::Segment<D> segment{ Filled<D>(-far), Filled<D>(far) };
    const double first = skd::Clip(segment, EqualBoxes<D>(1)[0])->Min;
    const double early = std::nextafter(std::nextafter(first, 0.0), 0.0);
    const Ids visited = Visited(tree, early,
      [&](auto& visitor)
      {
        return skd::AlongSegment<D, std::decay_t<decltype(visitor)>>(
          tree.GetFrame(), segment, 0.0, visitor);
      });
    EXPECT_EQ(visited.size(), 65u) << far;
  }
}

TYPED_TEST(AlongSegmentTest, ReachesNothingWithNaN)
{
  constexpr int D = TypeParam::Value;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto tree = skd::BuildTree<D>(InputOf(RandomBoxes<D>(513), 8));
  const skd::Vector<D> bad = Along<D>(D - 1, nan);
  const skd::Vector<D> good = Filled<D>(0.0);
  EXPECT_TRUE(AllAlong(tree, skd::Segment<D>{ bad, good }).empty());
  EXPECT_TRUE(AllAlong(tree, skd::Segment<D>{ good, bad }).empty());
  EXPECT_TRUE(AllAlong(tree, skd::Segment<D>{ good, Filled<D>(1.0) }, nan).empty());
}

}
