// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Search/Queries/Nearest.h"
#include "CoreSupport.h"

using namespace coretest;

namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

template <class Type>
class NearestCandidatesTest : public ::testing::Test
{
};
TYPED_TEST_SUITE(NearestCandidatesTest, Dimensions, DimensionNames);

/// Algorithm 5.1 with its last step: elements reached early that turned out too far are dropped.
template <int D, class Tree>
Ids Candidates(
  const Tree& tree, const Boxes<D>& boxes, const skd::Vector<D>& q, double limit2 = Infinity)
{
  Ids visited;
  auto visitor = [&](std::uint32_t element) { visited.push_back(element); };
  skd::NearestCandidates<D, decltype(visitor)> query(tree.GetFrame(), q, limit2, visitor);
  skd::Walk(tree, query);
  const double scale = tree.GetFrame().Scale;
  const auto isTooFar = [&](std::uint32_t element)
  { return skd::MinDistance2(q, boxes[element]) * scale * scale > query.Limit(); };
  visited.erase(std::remove_if(visited.begin(), visited.end(), isTooFar), visited.end());
  return Sorted(visited);
}

/// The least of the boxes' greatest distances: the nearest element cannot be farther.
template <int D>
double Pessimistic2(const Boxes<D>& boxes, const skd::Vector<D>& q)
{
  double known2 = Infinity;
  for (const skd::Box<D>& box : boxes)
  {
    known2 = std::min(known2, skd::MaxDistance2(q, box));
  }
  return known2;
}

template <int D>
Ids Within(const Boxes<D>& boxes, const skd::Vector<D>& q, double distance2)
{
  return Select(
    boxes, [&](const skd::Box<D>& box) { return skd::MinDistance2(q, box) <= distance2; });
}

TYPED_TEST(NearestCandidatesTest, AreThoseNotFartherThanThePessimisticDistance)
{
  ForEachTree<TypeParam::Value>(false,
    [](const auto& scene, const auto& tree)
    {
      const auto& boxes = scene.Boxes;
      for (const auto& q : QueryPoints(boxes))
      {
        const double known2 = Pessimistic2(boxes, q);
        const double far = Norm(q - tree.GetFrame().Centre);
        const double most = std::sqrt(known2) + 2.0 * FloatError(tree.GetFrame(), far);
        ExpectVisited(
          Candidates(tree, boxes, q), Within(boxes, q, known2), Within(boxes, q, most * most));
      }
    });
}

TYPED_TEST(NearestCandidatesTest, HoldTheNearestOfPointsInTheBoxes)
{
  ForEachTree<TypeParam::Value>(false,
    [](const auto& scene, const auto& tree)
    {
      Random random(1);
      for (const auto& q : QueryPoints(scene.Boxes))
      {
        std::uint32_t nearest = 0;
        double least2 = Infinity;
        for (std::uint32_t i = 0; i < scene.Boxes.size(); ++i)
        {
          const double distance2 = skd::Distance2(q, random.Point(scene.Boxes[i]));
          nearest = distance2 < least2 ? i : nearest;
          least2 = std::min(least2, distance2);
        }
        const Ids candidates = Candidates(tree, scene.Boxes, q);
        EXPECT_TRUE(
          scene.Boxes.empty() || std::binary_search(candidates.begin(), candidates.end(), nearest));
      }
    });
}

TYPED_TEST(NearestCandidatesTest, AreNoMoreWithAReferencePoint)
{
  ForEachTree<TypeParam::Value>(false,
    [](const auto& scene, const auto& tree)
    {
      const auto& boxes = scene.Boxes;
      for (const auto& q : QueryPoints(boxes))
      {
        // Half way between the least and the pessimistic distance: as if of a point of an element.
        double known2 = Pessimistic2(boxes, q);
        for (const auto& box : boxes)
        {
          known2 = std::min(known2, skd::MinDistance2(q, box) + 0.5 * known2);
        }
        const double far = Norm(q - tree.GetFrame().Centre);
        const double most = std::sqrt(known2) + 2.0 * FloatError(tree.GetFrame(), far);
        ExpectVisited(Candidates(tree, boxes, q, known2), Within(boxes, q, known2),
          Within(boxes, q, most * most));
      }
    });
}

TYPED_TEST(NearestCandidatesTest, OfPointsAreTheNearestOnly)
{
  constexpr int D = TypeParam::Value;
  const Boxes<D> points = PointBoxes<D>(5000);
  const auto tree = skd::BuildTree<D>(InputOf(points, 8));
  for (const skd::Vector<D>& q : QueryPoints(RandomBoxes<D>(64)))
  {
    const double far = Norm(q - tree.GetFrame().Centre);
    const double most = std::sqrt(Pessimistic2(points, q)) + 2.0 * FloatError(tree.GetFrame(), far);
    EXPECT_LE(Candidates(tree, points, q).size(), Within(points, q, most * most).size());
    EXPECT_GE(Candidates(tree, points, q).size(), 1u);
  }
}

TYPED_TEST(NearestCandidatesTest, EndsForPointsThatAreNotFinite)
{
  constexpr int D = TypeParam::Value;
  const Boxes<D> boxes = RandomBoxes<D>(513);
  const auto tree = skd::BuildTree<D>(InputOf(boxes, 8));
  for (const double bad : { std::numeric_limits<double>::quiet_NaN(), Infinity, -Infinity })
  {
    EXPECT_LE(Candidates(tree, boxes, Filled<D>(bad)).size(), boxes.size());
  }
}

}
