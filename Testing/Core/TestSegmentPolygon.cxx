// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Geometry/Intersection/SegmentPolygon.h"
#include "CoreSolids.h"

#include <gtest/gtest.h>

using namespace coretest;

namespace
{

std::optional<skd::PolygonHit> Hit(const Polygon& polygon, const Vector3& from, const Vector3& to)
{
  return skd::Intersect(
    skd::SegmentView(skd::Segment<3>{ from, to }), polygon.data(), int(polygon.size()));
}

bool IsInNotched(double x, double y)
{
  return x >= 0 && x <= 3 && y >= 0 && y <= 3 && !(x > 1 && x < 2 && y > 1);
}

TEST(SegmentPolygon, HitsWhatIsInsideOfAConcaveOne)
{
  Random random(411);
  for (const double factor : Factors())
  {
    const Polygon polygon = RotatedNotched(factor);
    for (int i = 0; i < 3000; ++i)
    {
      const Vector3 at{ { random.In(-1.0, 4.0), random.In(-1.0, 4.0), 0.0 } };
      Vector3 along = random.Direction<3>();
      along[2] += along[2] < 0.0 ? -0.1 : 0.1;
      const auto hit =
        Hit(polygon, factor * Rotated(at - along), factor * Rotated(at + 2.0 * along));
      ASSERT_EQ(hit.has_value(), IsInNotched(at[0], at[1])) << at[0] << " " << at[1];
      if (hit)
      {
        ASSERT_NEAR(hit->T, 1.0 / 3.0, 1e-13);
        ASSERT_TRUE(hit->Passes && !hit->OnEdge);
      }
    }
  }
}

TEST(SegmentPolygon, EndsBeforeItAndEdgeOnAndAsideAreNoHits)
{
  const Polygon polygon = Notched();
  EXPECT_FALSE(Hit(polygon, { { 0.5, 0.5, 2 } }, { { 0.5, 0.5, 1 } }));
  EXPECT_FALSE(Hit(polygon, { { -1, 0.5, 0 } }, { { 4, 0.5, 0 } }));
  EXPECT_FALSE(Hit(polygon, { { -1, 0, 0 } }, { { 4, 0, 0 } }));
  EXPECT_FALSE(Hit(polygon, { { 5, 5, 1 } }, { { 5, 5, -1 } }));
  EXPECT_FALSE(Hit({ { { 0, 0, 0 } }, { { 1, 0, 0 } } }, { { 0.5, 0, 1 } }, { { 0.5, 0, -1 } }));
}

TEST(SegmentPolygon, AtItsEndsCounts)
{
  const Polygon polygon = Notched();
  ASSERT_TRUE(Hit(polygon, { { 0.5, 0.5, 0 } }, { { 0.7, 0.5, 1 } }));
  EXPECT_EQ(Hit(polygon, { { 0.5, 0.5, 0 } }, { { 0.7, 0.5, 1 } })->T, 0.0);
  EXPECT_EQ(Hit(polygon, { { 0.7, 0.5, 1 } }, { { 0.5, 0.5, 0 } })->T, 1.0);
}

// A polygon and the triangles of the rest of the square around it meet along all its edges.
TEST(SegmentPolygon, OneOfTwoNeighboursPassesAtTheirEdge)
{
  const Polygon polygon = Notched();
  const Polygon notch = { { { 1, 1, 0 } }, { { 2, 1, 0 } }, { { 2, 3, 0 } }, { { 1, 3, 0 } } };
  Random random(412);
  for (int i = 0; i < 1000; ++i)
  {
    const Vector3 target = i % 3 == 0
      ? notch[random.Below(2)]
      : skd::Lerp(notch[i % 2], notch[i % 2 + 1], double(1 + random.Below(7)) / 8.0);
    const Vector3 along{ { double(random.Below(5)) - 2, double(random.Below(5)) - 2, 1 } };
    const auto one = Hit(polygon, target - along, target + along);
    const auto other = Hit(notch, target - along, target + along);
    ASSERT_TRUE(one && other);
    ASSERT_TRUE(one->OnEdge && other->OnEdge);
    ASSERT_EQ(one->T, other->T);
    ASSERT_NE(one->Passes, other->Passes) << "at " << target[0] << " " << target[1];
  }
}

TEST(SegmentPolygon, OfThreePointsIsTheTriangle)
{
  Random random(413);
  for (int i = 0; i < 20000; ++i)
  {
    const auto lattice = [&]()
    {
      return Vector3{ { double(random.Below(4)), double(random.Below(4)),
        double(random.Below(4)) } };
    };
    const Polygon polygon = { lattice(), lattice(), lattice() };
    const skd::SegmentView view(skd::Segment<3>{ lattice(), lattice() });
    if (!view.IsValid())
    {
      continue;
    }
    const auto expected = skd::Intersect(view, polygon[0], polygon[1], polygon[2]);
    const auto hit = skd::Intersect(view, polygon.data(), 3);
    ASSERT_EQ(hit.has_value(), expected.has_value()) << "case " << i;
    if (hit)
    {
      ASSERT_NEAR(hit->T, expected->T, 1e-15);
      ASSERT_EQ(hit->OnEdge, expected->OnEdge);
      ASSERT_EQ(hit->Passes, expected->Passes);
    }
  }
}

}
