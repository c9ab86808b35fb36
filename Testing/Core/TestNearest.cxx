// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Search/Queries/Nearest.h"
#include "CoreSupport.h"

using namespace coretest;

namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

template <class Type>
class NearestTest : public ::testing::Test
{
};
TYPED_TEST_SUITE(NearestTest, Dimensions, DimensionNames);

template <int D>
std::vector<double> AllDistances2(const Boxes<D>& boxes, const skd::Vector<D>& q)
{
  std::vector<double> distances2;
  for (const skd::Box<D>& box : boxes)
  {
    distances2.push_back(skd::MinDistance2(q, box));
  }
  return distances2;
}

/// The least distances that a walk finds when a box is its own exact shape, in order.
template <int D, class Tree>
std::vector<double> LeastDistances2(const Tree& tree, const Boxes<D>& boxes,
  const skd::Vector<D>& q, std::size_t count, double limit2 = Infinity)
{
  std::vector<double> best(count, limit2);
  auto visitor = [&](std::uint32_t element)
  {
    const double distance2 = skd::MinDistance2(q, boxes[element]);
    if (distance2 < best.back())
    {
      best.back() = distance2;
      std::sort(best.begin(), best.end());
    }
    return best.back();
  };
  skd::Nearest<D, decltype(visitor)> query(tree.GetFrame(), q, limit2, visitor);
  skd::Walk(tree, query);
  return best;
}

/// What a search within a constant distance reaches.
template <int D, class Tree>
Ids VisitedWithin(const Tree& tree, const skd::Vector<D>& q, double limit2)
{
  return Visited(tree, limit2,
    [&](auto& visitor) {
      return skd::Nearest<D, std::decay_t<decltype(visitor)>>(tree.GetFrame(), q, limit2, visitor);
    });
}

TYPED_TEST(NearestTest, FindsTheLeastDistance)
{
  ForEachTree<TypeParam::Value>(false,
    [](const auto& scene, const auto& tree)
    {
      for (const auto& q : QueryPoints(scene.Boxes))
      {
        const auto all = AllDistances2(scene.Boxes, q);
        const double least = all.empty() ? Infinity : *std::min_element(all.begin(), all.end());
        EXPECT_EQ(LeastDistances2(tree, scene.Boxes, q, 1)[0], least);
      }
    });
}

TYPED_TEST(NearestTest, FindsTheKLeastDistances)
{
  ForEachTree<TypeParam::Value>(false,
    [](const auto& scene, const auto& tree)
    {
      for (const auto& q : QueryPoints(scene.Boxes))
      {
        auto all = AllDistances2(scene.Boxes, q);
        all.resize(std::max<std::size_t>(all.size(), 9), Infinity);
        std::sort(all.begin(), all.end());
        all.resize(9);
        EXPECT_EQ(LeastDistances2(tree, scene.Boxes, q, 9), all);
      }
    });
}

TYPED_TEST(NearestTest, ReachesAllWithinARadiusAndNoneFarther)
{
  ForEachTree<TypeParam::Value>(false,
    [](const auto& scene, const auto& tree)
    {
      const double size = 1.0 / tree.GetFrame().Scale;
      for (const auto& q : QueryPoints(scene.Boxes))
      {
        const double far = Norm(q - tree.GetFrame().Centre);
        for (const double radius : { 0.01 * size, 0.5 * size, far })
        {
          const double most = radius + 2.0 * FloatError(tree.GetFrame(), far);
          const auto within = [&](double limit)
          {
            return Select(scene.Boxes,
              [&](const auto& box) { return skd::MinDistance2(q, box) <= limit * limit; });
          };
          ExpectVisited(VisitedWithin(tree, q, radius * radius), within(radius), within(most));
        }
      }
    });
}

TYPED_TEST(NearestTest, ReachesThoseAtExactlyTheLimit)
{
  ForEachTree<TypeParam::Value>(false,
    [](const auto& scene, const auto& tree)
    {
      Random random(3);
      for (const auto& q : QueryPoints(scene.Boxes))
      {
        if (!scene.Boxes.empty())
        {
          const auto& some = scene.Boxes[random.Below(scene.Boxes.size())];
          const double limit2 = skd::MinDistance2(q, some);
          const auto isWithin = [&](const auto& box)
          { return skd::MinDistance2(q, box) <= limit2; };
          const Ids all = Select(scene.Boxes, [](const auto&) { return true; });
          ExpectVisited(VisitedWithin(tree, q, limit2), Select(scene.Boxes, isWithin), all);
        }
      }
    });
}

TYPED_TEST(NearestTest, ReachesAllBoxesThatMeetInAPointAtDistanceZero)
{
  constexpr int D = TypeParam::Value;
  const Boxes<D> boxes = LatticeBoxes<D>(729);
  const auto tree = skd::BuildTree<D>(InputOf(boxes, 4));
  const skd::Vector<D> corner = Filled<D>(1.0);
  EXPECT_EQ(Sorted(VisitedWithin(tree, corner, 0.0)),
    Select(boxes, [&](const auto& box) { return box.Contains(corner); }));
}

/// Squares near 0 have few digits in single precision: that must not lose anything either.
TYPED_TEST(NearestTest, ReachesThoseAtTheLimitWhereSquaresAreDenormal)
{
  constexpr int D = TypeParam::Value;
  Random random(4);
  for (int i = 0; i < 200; ++i)
  {
    const skd::Vector<D> near = random.In(0.1, 4.0) * Filled<D>(2.65e-23);
    Boxes<D> boxes{ { Filled<D>(-0.9), Filled<D>(-0.9) }, { Filled<D>(0.9), Filled<D>(0.9) },
      { near, near } };
    const auto tree = skd::BuildTree<D>(InputOf(boxes, 8));
    const Ids visited = VisitedWithin(tree, Filled<D>(0.0), skd::Norm2(near));
    EXPECT_EQ(std::count(visited.begin(), visited.end(), 2u), 1) << near[0];
  }
}

TYPED_TEST(NearestTest, KnowingADistanceChangesNoAnswerAndOpensNoMore)
{
  constexpr int D = TypeParam::Value;
  const Boxes<D> boxes = RandomBoxes<D>(5000);
  const auto tree = skd::BuildTree<D>(InputOf(boxes, 8));
  for (const skd::Vector<D>& q : QueryPoints(boxes))
  {
    const CountedTree ignorant(tree);
    const double least2 = LeastDistances2(ignorant, boxes, q, 1)[0];
    const double known2 = 1.01 * least2 + 1e-6;
    const CountedTree knowing(tree);
    EXPECT_EQ(LeastDistances2(knowing, boxes, q, 1, known2)[0], least2);
    EXPECT_LE(knowing.Opened, ignorant.Opened);
  }
}

TYPED_TEST(NearestTest, ReachesNothingWithinANegativeOrNaNDistance)
{
  constexpr int D = TypeParam::Value;
  const Boxes<D> boxes = RandomBoxes<D>(513);
  const auto tree = skd::BuildTree<D>(InputOf(boxes, 8));
  for (const double bad : { -1e-6, -Infinity, NaN })
  {
    EXPECT_TRUE(VisitedWithin(tree, boxes[7].Centroid(), bad).empty()) << bad;
  }
}

/// Callers refuse such points; should one come, the walk ends and meets no element twice.
TYPED_TEST(NearestTest, EndsForPointsThatAreNotFinite)
{
  ForEachTree<TypeParam::Value>(false,
    [](const auto& scene, const auto& tree)
    {
      constexpr int D = TypeParam::Value;
      const Ids all = Select(scene.Boxes, [](const auto&) { return true; });
      for (const double bad : { NaN, Infinity, -Infinity })
      {
        skd::Vector<D> q = Filled<D>(0.0);
        q[D - 1] = bad;
        ExpectVisited(VisitedWithin(tree, q, 1.0), {}, all);
        ExpectVisited(VisitedWithin(tree, q, Infinity), {}, all);
      }
    });
}

TYPED_TEST(NearestTest, FarPointsFindTheLeastDistance)
{
  constexpr int D = TypeParam::Value;
  const Boxes<D> boxes = RandomBoxes<D>(513);
  const auto tree = skd::BuildTree<D>(InputOf(boxes, 8));
  Random random(5);
  for (const double far : { 1e3, 1e6, 1e9, 1e15, 1e30, 1e100 })
  {
    const skd::Vector<D> q = far * random.Direction<D>();
    const auto all = AllDistances2(boxes, q);
    EXPECT_EQ(LeastDistances2(tree, boxes, q, 1)[0], *std::min_element(all.begin(), all.end()));
  }
}

/// Nodes opened a query, on average over points in the set.
template <int D>
double AverageOpened(std::size_t count)
{
  const Boxes<D> boxes = RandomBoxes<D>(count);
  const auto tree = skd::BuildTree<D>(InputOf(boxes, 8));
  const CountedTree counted(tree);
  Random random(6);
  constexpr int queries = 200;
  for (int i = 0; i < queries; ++i)
  {
    LeastDistances2(counted, boxes, random.Point<D>(-1.0, 1.0), 1);
  }
  return static_cast<double>(counted.Opened) / queries;
}

/// O(log N): eight times the elements are a level more, and a few more nodes to open.
TYPED_TEST(NearestTest, OpensAFewNodesALevel)
{
  constexpr int D = TypeParam::Value;
  double opened = AverageOpened<D>(64);
  for (const std::size_t count : { 512u, 4096u, 32768u })
  {
    const double openedOfMore = AverageOpened<D>(count);
    EXPECT_LE(openedOfMore, opened + 1.5 * D) << count << " elements";
    opened = openedOfMore;
  }
}

}
