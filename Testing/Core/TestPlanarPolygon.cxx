// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Geometry/Polygons/PlanarPolygon.h"
#include "CoreSolids.h"

#include <gtest/gtest.h>

using namespace coretest;

namespace
{

TEST(PlanarPolygon, NearestPointOfAConcaveOneIsThatOfItsParts)
{
  Random random(401);
  for (const double factor : Factors())
  {
    const Polygon polygon = RotatedNotched(factor);
    for (int i = 0; i < 2000; ++i)
    {
      const Vector3 x = random.Point<3>(-2.0, 5.0);
      const auto found =
        skd::ClosestPointOnPolygon(polygon.data(), int(polygon.size()), factor * Rotated(x));
      const double expected = std::sqrt(LeastDistance2(PartsOfNotched(0.0), x));
      ASSERT_NEAR(std::sqrt(found.Dist2) / factor, expected, 1e-14) << "query " << i;
      ASSERT_NEAR(Norm(found.Point - factor * Rotated(x)) / factor, expected, 1e-14);
    }
  }
}

TEST(PlanarPolygon, FootIsInnerOnlyInside)
{
  const Polygon polygon = Notched();
  const auto isInner = [&](double x, double y)
  {
    return skd::ClosestPointOnPolygon(polygon.data(), int(polygon.size()), Vector3{ { x, y, 0.7 } })
      .IsInner;
  };
  EXPECT_TRUE(isInner(0.5, 2.5));
  EXPECT_TRUE(isInner(1.5, 0.5));
  EXPECT_FALSE(isInner(1.5, 2.0));
  EXPECT_FALSE(isInner(-0.5, 1.0));
}

TEST(PlanarPolygon, OneOfNoAreaIsItsEdges)
{
  const Vector3 a{ { 1, 2, 3 } };
  const Vector3 b{ { 4, 1, 5 } };
  const std::vector<Polygon> thin = { { a }, { a, a, a }, { a, b }, { a, b, a, b },
    { a, skd::Lerp(a, b, 0.3), b, skd::Lerp(a, b, 0.7) } };
  Random random(402);
  for (const Polygon& polygon : thin)
  {
    const Vector3 end = std::find(polygon.begin(), polygon.end(), b) == polygon.end() ? a : b;
    for (int i = 0; i < 500; ++i)
    {
      const Vector3 x = random.Point<3>(-2.0, 7.0);
      const auto found = skd::ClosestPointOnPolygon(polygon.data(), int(polygon.size()), x);
      const auto expected = skd::ClosestPointOnSegment(a, end, x);
      ASSERT_NEAR(std::sqrt(found.Dist2), std::sqrt(expected.Dist2), 1e-14);
    }
  }
}

TEST(PlanarPolygon, MeanIsTheSameTheOtherWayAround)
{
  Random random(403);
  for (int size = 1; size < 12; ++size)
  {
    Polygon polygon;
    for (int i = 0; i < size; ++i)
    {
      polygon.push_back(random.Point<3>(-1.0, 1e3));
    }
    const Vector3 mean = skd::MeanOfPoints(polygon.data(), size);
    std::reverse(polygon.begin() + 1, polygon.end());
    EXPECT_TRUE(mean == skd::MeanOfPoints(polygon.data(), size));
  }
}

TEST(PlanarPolygon, WeightsGiveThePoint)
{
  Random random(404);
  for (const double factor : Factors())
  {
    const Polygon polygon = RotatedNotched(factor);
    std::vector<double> weights(polygon.size());
    for (int i = 0; i < 1000; ++i)
    {
      const skd::Box3 part = PartsOfNotched(0.0)[random.Below(3)];
      const Vector3 x = factor * Rotated(random.Point(part));
      ASSERT_TRUE(skd::MeanValueWeights(polygon.data(), int(polygon.size()), x, weights.data()));
      ASSERT_NEAR(std::accumulate(weights.begin(), weights.end(), 0.0), 1.0, 1e-13);
      ASSERT_LE(Norm(Mean(weights, polygon) - x), 1e-13 * factor);
    }
  }
}

TEST(PlanarPolygon, WeightsOfAConvexOneAreNotNegative)
{
  Random random(405);
  const Polygon polygon = Regular(7);
  std::vector<double> weights(polygon.size());
  for (int i = 0; i < 1000; ++i)
  {
    const double angle = random.In(0.0, 6.28);
    const double radius = random.In(0.0, 0.9);
    const Vector3 x{ { radius * std::cos(angle), radius * std::sin(angle), 0.0 } };
    ASSERT_TRUE(skd::MeanValueWeights(polygon.data(), int(polygon.size()), x, weights.data()));
    ASSERT_GE(*std::min_element(weights.begin(), weights.end()), 0.0);
  }
}

TEST(PlanarPolygon, WeightsCloseToAnEdgeAreThoseOfTheEdge)
{
  const Polygon polygon = Notched();
  std::vector<double> weights(polygon.size());
  for (double height = 0.1; height > 1e-15; height *= 0.1)
  {
    const Vector3 x{ { 0.75, height, 0.0 } };
    ASSERT_TRUE(skd::MeanValueWeights(polygon.data(), int(polygon.size()), x, weights.data()));
    ASSERT_LE(Norm(Mean(weights, polygon) - x), 1e-14);
    ASSERT_NEAR(weights[0], 0.75, 3.0 * height + 1e-14);
    ASSERT_NEAR(weights[1], 0.25, 3.0 * height + 1e-14);
  }
}

TEST(PlanarPolygon, HasNoWeightsWithoutArea)
{
  const Polygon polygon = { { { 0, 0, 0 } }, { { 1, 1, 1 } }, { { 2, 2, 2 } } };
  std::vector<double> weights(3);
  const Vector3 x{ { 0.5, 0.5, 0.5 } };
  EXPECT_FALSE(skd::MeanValueWeights(polygon.data(), 3, x, weights.data()));
}

}
