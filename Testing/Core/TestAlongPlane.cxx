// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Search/Queries/WithinSlabs.h"
#include "CoreSupport.h"

using namespace coretest;

namespace
{

template <class Type>
class AlongPlaneTest : public ::testing::Test
{
};
TYPED_TEST_SUITE(AlongPlaneTest, Dimensions, DimensionNames);

template <int D, class Tree>
Ids VisitedAlong(const Tree& tree, const skd::Plane<D>& plane, double tolerance)
{
  return Visited(tree, true,
    [&](auto& visitor)
    {
      return skd::AlongPlane<D, std::decay_t<decltype(visitor)>>(
        tree.GetFrame(), plane, tolerance, visitor);
    });
}

template <int D>
Ids Within(const Boxes<D>& boxes, const skd::Plane<D>& plane, double tolerance)
{
  return Select(
    boxes, [&](const skd::Box<D>& box) { return skd::Overlaps(plane, box, tolerance); });
}

/// All within the tolerance, and none farther than single precision errs.
template <int D, class Tree>
void ExpectWithin(
  const Tree& tree, const Boxes<D>& boxes, const skd::Plane<D>& plane, double tolerance)
{
  const double size = 1.0 / tree.GetFrame().Scale;
  const skd::Vector<D> offset = plane.Origin - tree.GetFrame().Centre;
  const double maxDistance = size + std::abs(Dot(plane.Normal, offset));
  const double largest = *std::max_element(offset.X, offset.X + D);
  const double error = 2e-5 * maxDistance + 1e-14 * largest;
  ExpectVisited(VisitedAlong(tree, plane, tolerance), Within(boxes, plane, tolerance),
    Within(boxes, plane, tolerance + error));
}

TYPED_TEST(AlongPlaneTest, ReachesWhatARandomPlaneCuts)
{
  ForEachTree<TypeParam::Value>(true,
    [](const auto& scene, const auto& tree)
    {
      constexpr int D = TypeParam::Value;
      Random random(1);
      for (const auto& point : QueryPoints(scene.Boxes))
      {
        const skd::Plane<D> plane{ point, random.Direction<D>() };
        ExpectWithin(tree, scene.Boxes, plane, 0.0);
        ExpectWithin(tree, scene.Boxes, plane, 0.1 / tree.GetFrame().Scale);
      }
    });
}

TYPED_TEST(AlongPlaneTest, ReachesWhatAPlaneAcrossAnAxisTouches)
{
  ForEachTree<TypeParam::Value>(true,
    [](const auto& scene, const auto& tree)
    {
      constexpr int D = TypeParam::Value;
      for (std::size_t i = 0; i < std::min<std::size_t>(scene.Boxes.size(), 8); ++i)
      {
        const int axis = static_cast<int>(i % D);
        const skd::Vector<D> up = Along<D>(axis, 1.0);
        ExpectWithin(tree, scene.Boxes, skd::Plane<D>{ scene.Boxes[i].Max, up }, 0.0);
        ExpectWithin(tree, scene.Boxes, skd::Plane<D>{ scene.Boxes[i].Min, -1.0 * up }, 0.0);
      }
    });
}

TYPED_TEST(AlongPlaneTest, OriginMayLieFarAwayInThePlane)
{
  constexpr int D = TypeParam::Value;
  const Boxes<D> boxes = RandomBoxes<D>(513);
  const auto tree = skd::BuildTree<D>(InputOf(boxes, 8));
  Random random(2);
  for (const double far : { 1e3, 1e6, 1e9, 1e12 })
  {
    for (int i = 0; i < 50; ++i)
    {
      const skd::Vector<D> normal = random.Direction<D>();
      const skd::Vector<D> side = random.Direction<D>();
      const skd::Vector<D> inPlane = side - Dot(side, normal) * normal;
      const skd::Plane<D> plane{ random.Corner(boxes[i]) + far * inPlane, normal };
      const Ids all = Select(boxes, [](const auto&) { return true; });
      ExpectVisited(VisitedAlong(tree, plane, 0.0), Within(boxes, plane, 0.0), all);
    }
  }
}

TYPED_TEST(AlongPlaneTest, ReachesNothingBeyondTheTolerance)
{
  constexpr int D = TypeParam::Value;
  const auto tree = skd::BuildTree<D>(InputOf(EqualBoxes<D>(65), 8)); // [-0.25, 0.75]
  const skd::Plane<D> above{ Filled<D>(1.0), Along<D>(D - 1, 1.0) };
  EXPECT_EQ(VisitedAlong(tree, above, 0.25).size(), 65u);
  EXPECT_TRUE(VisitedAlong(tree, above, 0.2499).empty());
}

TYPED_TEST(AlongPlaneTest, ReachesAllOfAFlatSetInThePlane)
{
  constexpr int D = TypeParam::Value;
  const Boxes<D> boxes = FlatBoxes<D>(513);
  const auto tree = skd::BuildTree<D>(InputOf(boxes, 8));
  const skd::Plane<D> plane{ Along<D>(D - 1, 0.3), Along<D>(D - 1, 1.0) };
  EXPECT_EQ(VisitedAlong(tree, plane, 0.0).size(), 513u);
}

TYPED_TEST(AlongPlaneTest, ReachesNothingWithNaN)
{
  constexpr int D = TypeParam::Value;
  const auto tree = skd::BuildTree<D>(InputOf(RandomBoxes<D>(513), 8));
  const skd::Vector<D> bad = Filled<D>(std::numeric_limits<double>::quiet_NaN());
  const skd::Vector<D> up = Along<D>(0, 1.0);
  EXPECT_TRUE(VisitedAlong(tree, skd::Plane<D>{ bad, up }, 0.0).empty());
  EXPECT_TRUE(VisitedAlong(tree, skd::Plane<D>{ up, bad }, 0.0).empty());
  EXPECT_TRUE(VisitedAlong(tree, skd::Plane<D>{ up, up }, bad[0]).empty());
}

TYPED_TEST(AlongPlaneTest, EndsWhenTheVisitorSaysSo)
{
  constexpr int D = TypeParam::Value;
  const auto tree = skd::BuildTree<D>(InputOf(EqualBoxes<D>(65), 8));
  int visited = 0;
  auto visitor = [&visited](std::uint32_t) { return ++visited < 3; };
  const skd::Plane<D> plane{ Filled<D>(0.25), Along<D>(0, 1.0) };
  skd::AlongPlane<D, decltype(visitor)> query(tree.GetFrame(), plane, 0.0, visitor);
  skd::Walk(tree, query);
  EXPECT_EQ(visited, 3);
}

}
