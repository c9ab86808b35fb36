// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// Nearest points of segments and triangles. Patches have a file of their own.
#include "GeometryReference.h"

#include <gtest/gtest.h>

namespace
{

using coretest::Dice;
using skd::ClosestPointOnSegment;
using skd::ClosestPointOnTriangle;
using skd::TrianglePoint;
using skd::Vector3;

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

/// Whether the parameters are those of a point of the triangle, and of the one returned.
void ExpectConsistent(
  const Vector3* p, const Vector3& x, const TrianglePoint& found, double tolerance)
{
  EXPECT_GE(found.R, 0.0);
  EXPECT_GE(found.S, 0.0);
  EXPECT_GE(1.0 - found.R - found.S, 0.0);
  const Vector3 point = (1.0 - found.R - found.S) * p[0] + found.R * p[1] + found.S * p[2];
  EXPECT_LE(skd::Norm(point - found.Point), tolerance);
  EXPECT_NEAR(skd::Norm(found.Point - x), std::sqrt(found.Dist2), tolerance);
}

template <int D>
void CompareSegmentsWithSamples(unsigned seed)
{
  Dice dice(seed);
  for (int i = 0; i < 300; ++i)
  {
    skd::Vector<D> a;
    skd::Vector<D> b;
    skd::Vector<D> x;
    for (int axis = 0; axis < D; ++axis)
    {
      a[axis] = dice.Between(-1.0, 1.0);
      b[axis] = dice.Between(-1.0, 1.0);
      x[axis] = dice.Between(-2.0, 2.0);
    }
    const skd::SegmentPoint<D> found = ClosestPointOnSegment(a, b, x);
    EXPECT_LE(skd::Distance2(found.Point, skd::Lerp(a, b, found.R)), 1e-30);
    EXPECT_NEAR(skd::Distance2(found.Point, x), found.Dist2, 1e-14);
    for (int sample = 0; sample <= 200; ++sample)
    {
      EXPECT_LE(found.Dist2, skd::Distance2(skd::Lerp(a, b, sample / 200.0), x) + 1e-15);
    }
  }
}

TEST(ClosestPointOnSegment, IsNearerThanAnySampleInAnyDimension)
{
  CompareSegmentsWithSamples<1>(1);
  CompareSegmentsWithSamples<2>(2);
  CompareSegmentsWithSamples<3>(3);
  CompareSegmentsWithSamples<4>(4);
}

TEST(ClosestPointOnSegment, EndsAreExact)
{
  const Vector3 a{ { 0.1, 0.2, 0.3 } };
  const Vector3 b{ { 0.7, -0.4, 1e9 } };
  const auto before = ClosestPointOnSegment(a, b, Vector3{ { 0.1, 0.2, -5.0 } });
  EXPECT_EQ(before.Point, a);
  EXPECT_EQ(before.R, 0.0);
  const auto after = ClosestPointOnSegment(a, b, Vector3{ { 0.1, 0.2, 2e9 } });
  EXPECT_EQ(after.Point, b);
  EXPECT_EQ(after.R, 1.0);
  EXPECT_EQ(ClosestPointOnSegment(a, b, a).Dist2, 0.0);
  EXPECT_EQ(ClosestPointOnSegment(a, b, b).Dist2, 0.0);
}

TEST(ClosestPointOnSegment, OfNoLengthIsAPoint)
{
  const Vector3 a{ { 1.0, 2.0, 3.0 } };
  const auto found = ClosestPointOnSegment(a, a, Vector3{ { 1.0, 2.0, 5.0 } });
  EXPECT_EQ(found.Point, a);
  EXPECT_EQ(found.Dist2, 4.0);
  EXPECT_TRUE(found.R == 0.0 || found.R == 1.0);
}

TEST(ClosestPointOnSegment, IsTheSameFromBothEndsToTheLastBit)
{
  Dice dice(5);
  for (int i = 0; i < 1000; ++i)
  {
    const Vector3 a = dice.Point(1.0);
    const Vector3 b = dice.Point(1.0);
    const Vector3 x = dice.Point(2.0);
    const auto forth = ClosestPointOnSegment(a, b, x);
    const auto back = ClosestPointOnSegment(b, a, x);
    EXPECT_EQ(forth.Point, back.Point);
    EXPECT_EQ(forth.Dist2, back.Dist2);
    EXPECT_NEAR(forth.R, 1.0 - back.R, 1e-15);
  }
}

TEST(ClosestPointOnSegment, WorksAtAllScales)
{
  for (const double scale : { 1e-150, 1e-100, 1e-20, 1.0, 1e20, 1e100, 1e150 })
  {
    const Vector3 a{ { 0.0, 0.0, 0.0 } };
    const Vector3 b{ { 4.0 * scale, 0.0, 0.0 } };
    const auto found = ClosestPointOnSegment(a, b, Vector3{ { scale, 2.0 * scale, 0.0 } });
    EXPECT_DOUBLE_EQ(found.R, 0.25) << scale;
    EXPECT_NEAR(std::sqrt(found.Dist2) / scale, 2.0, 1e-8) << scale; // subnormal at the lower end
  }
}

TEST(ClosestPointOnTriangle, AgreesWithSampling)
{
  Dice dice(6);
  for (int i = 0; i < 300; ++i)
  {
    const Vector3 p[3] = { dice.Point(1.0), dice.Point(1.0), dice.Point(1.0) };
    const Vector3 x = dice.Point(1.5);
    const TrianglePoint found = ClosestPointOnTriangle(p[0], p[1], p[2], x);
    EXPECT_NEAR(std::sqrt(found.Dist2), coretest::TriangleDistance(p, x), 4e-15);
    ExpectConsistent(p, x, found, 4e-15);
  }
}

TEST(ClosestPointOnTriangle, ReturnsCornersExactly)
{
  const Vector3 p[3] = { { { 0.1, 0.2, 0.3 } }, { { 1.1, 0.3, 0.2 } }, { { 0.3, 1.7, 0.4 } } };
  const Vector3 middle = (1.0 / 3.0) * (p[0] + p[1] + p[2]);
  for (const Vector3& corner : p)
  {
    const Vector3 beyond = middle + 5.0 * (corner - middle);
    EXPECT_EQ(ClosestPointOnTriangle(p[0], p[1], p[2], beyond).Point, corner);
    EXPECT_LE(ClosestPointOnTriangle(p[0], p[1], p[2], corner).Dist2, 1e-32);
  }
}

TEST(ClosestPointOnTriangle, NeighboursTieOnTheirEdgeToTheLastBit)
{
  Dice dice(7);
  int ties = 0;
  for (int i = 0; i < 1000; ++i)
  {
    const Vector3 a = dice.Point(1.0);
    const Vector3 b = dice.Point(1.0);
    const Vector3 x = dice.Point(2.0);
    const TrianglePoint left = ClosestPointOnTriangle(a, b, dice.Point(1.0), x);
    const TrianglePoint right = ClosestPointOnTriangle(dice.Point(1.0), b, a, x);
    if (left.S == 0.0 && right.R + right.S == 1.0 && right.R > 0.0 && right.S > 0.0)
    {
      EXPECT_EQ(left.Point, right.Point);
      EXPECT_EQ(left.Dist2, right.Dist2);
      ++ties;
    }
  }
  EXPECT_GT(ties, 50);
}

TEST(ClosestPointOnTriangle, WithoutAreaIsItsEdges)
{
  Dice dice(8);
  for (int i = 0; i < 300; ++i)
  {
    Vector3 p[3] = { dice.Point(1.0), dice.Point(1.0), dice.Point(1.0) };
    p[i % 3] = i % 2 == 0 ? p[(i + 1) % 3] : skd::Lerp(p[(i + 1) % 3], p[(i + 2) % 3], 0.5);
    const Vector3 x = dice.Point(2.0);
    const TrianglePoint found = ClosestPointOnTriangle(p[0], p[1], p[2], x);
    const double edges = std::min({ ClosestPointOnSegment(p[0], p[1], x).Dist2,
      ClosestPointOnSegment(p[1], p[2], x).Dist2, ClosestPointOnSegment(p[2], p[0], x).Dist2 });
    EXPECT_NEAR(std::sqrt(found.Dist2), std::sqrt(edges), 1e-15);
    ExpectConsistent(p, x, found, 1e-15);
  }
  const Vector3 point{ { 3.0, 4.0, 0.0 } };
  EXPECT_EQ(ClosestPointOnTriangle(point, point, point, { { 0.0, 0.0, 0.0 } }).Dist2, 25.0);
}

// However thin, a triangle is at no distance from a point that was computed on it.
TEST(ClosestPointOnTriangle, NeedlesAndCapsKeepTheirInterior)
{
  Dice dice(9);
  for (int i = 0; i < 20000; ++i)
  {
    Vector3 p[3] = { dice.Point(1.0), dice.Point(1.0), dice.Point(1.0) };
    const double thickness = std::pow(10.0, -dice.Between(0.0, 17.0));
    const double share = i % 2 == 0 ? 0.0 : dice.Between(-1.0, 2.0);
    p[2] = skd::Lerp(p[0], p[1], share) + thickness * dice.Point(1.0);
    std::swap(p[0], p[dice.Below(3)]);
    const Vector3 position = coretest::MoveIntoDomain<skd::Wedge>(dice);
    const Vector3 x = p[0] + position[0] * (p[1] - p[0]) + position[1] * (p[2] - p[0]);
    const TrianglePoint found = ClosestPointOnTriangle(p[0], p[1], p[2], x);
    EXPECT_LE(std::sqrt(found.Dist2), 4e-15) << thickness;
    ExpectConsistent(p, x, found, 4e-15);
  }
}

TEST(ClosestPointOnTriangle, ALargeCommonOffsetCostsNothingMore)
{
  Dice dice(10);
  for (int i = 0; i < 200; ++i)
  {
    const double offset = std::pow(10.0, dice.Between(6.0, 9.0));
    const Vector3 origin{ { offset, -offset, 0.5 * offset } };
    const Vector3 p[3] = { origin + dice.Point(1.0), origin + dice.Point(1.0),
      origin + dice.Point(1.0) };
    const Vector3 x = origin + dice.Point(1.5);
    const TrianglePoint found = ClosestPointOnTriangle(p[0], p[1], p[2], x);
    EXPECT_NEAR(std::sqrt(found.Dist2), coretest::TriangleDistance(p, x), 4e-15);
  }
}

TEST(ClosestPointOnTriangle, WorksAtAllScales)
{
  Dice dice(11);
  for (const double scale : { 1e-70, 1e-40, 1e-10, 1e10, 1e40, 1e70 })
  {
    const Vector3 p[3] = { dice.Point(1.0), dice.Point(1.0), dice.Point(1.0) };
    const Vector3 x = dice.Point(1.5);
    const TrianglePoint plain = ClosestPointOnTriangle(p[0], p[1], p[2], x);
    const TrianglePoint scaled =
      ClosestPointOnTriangle(scale * p[0], scale * p[1], scale * p[2], scale * x);
    EXPECT_NEAR(std::sqrt(scaled.Dist2) / scale, std::sqrt(plain.Dist2), 1e-14) << scale;
    EXPECT_NEAR(scaled.R, plain.R, 1e-13) << scale;
    EXPECT_NEAR(scaled.S, plain.S, 1e-13) << scale;
  }
}

TEST(ClosestPointOnTriangle, NaNGivesNoDistance)
{
  const Vector3 a{ { 0.0, 0.0, 0.0 } };
  const Vector3 b{ { 1.0, 0.0, 0.0 } };
  const Vector3 c{ { 0.0, 1.0, 0.0 } };
  EXPECT_FALSE(ClosestPointOnSegment(a, b, Vector3{ { NaN, 0.0, 0.0 } }).Dist2 < 1e300);
  EXPECT_FALSE(ClosestPointOnTriangle(a, b, c, Vector3{ { 0.0, NaN, 0.0 } }).Dist2 < 1e300);
}

}
