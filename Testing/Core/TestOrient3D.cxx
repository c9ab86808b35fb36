// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Geometry/Predicates/Orient3D.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>

namespace
{

__extension__ using Whole = __int128; // pedantic compilers want it said

using skd::Vector3;
using Points = std::array<Vector3, 4>;

/// Points of whole coordinates: their volume is exact in 128 bits.
using WholePoint = std::array<std::int64_t, 3>;
using WholePoints = std::array<WholePoint, 4>;

Points AsPoints(const WholePoints& whole)
{
  Points points;
  for (int i = 0; i < 4; ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      points[i][axis] = static_cast<double>(whole[i][axis]);
    }
  }
  return points;
}

int SignOfVolume(const WholePoints& p)
{
  Whole edges[3][3];
  for (int i = 0; i < 3; ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      edges[i][axis] = p[i + 1][axis] - p[0][axis];
    }
  }
  Whole volume = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    volume += edges[2][axis] * (edges[0][u] * edges[1][v] - edges[0][v] * edges[1][u]);
  }
  return (volume > 0) - (volume < 0);
}

int SignOfArea(const WholePoints& p, int axis)
{
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  const Whole area = static_cast<Whole>(p[1][u] - p[0][u]) * (p[2][v] - p[0][v]) -
    static_cast<Whole>(p[1][v] - p[0][v]) * (p[2][u] - p[0][u]);
  return (area > 0) - (area < 0);
}

int Orient(const Points& p)
{
  return skd::Orient3D(p[0], p[1], p[2], p[3]);
}

/// Four points that are nearly, and often exactly, in one plane: whole combinations of two
/// directions, moved by at most one step.
WholePoints NearlyFlat(std::mt19937_64& random, std::int64_t maxDistance, std::int64_t offset)
{
  std::uniform_int_distribution<std::int64_t> direction(-maxDistance, maxDistance);
  std::uniform_int_distribution<std::int64_t> factor(-9, 9);
  std::uniform_int_distribution<std::int64_t> step(-1, 1);
  const WholePoint u = { direction(random), direction(random), direction(random) };
  const WholePoint v = { direction(random), direction(random), direction(random) };
  WholePoints points;
  for (WholePoint& point : points)
  {
    const std::int64_t a = factor(random);
    const std::int64_t b = factor(random);
    for (int axis = 0; axis < 3; ++axis)
    {
      point[axis] = offset + a * u[axis] + b * v[axis];
    }
  }
  points[3][factor(random) > 0 ? 0 : 2] += step(random);
  return points;
}

class Orient3DTest : public ::testing::TestWithParam<std::int64_t>
{
};

TEST_P(Orient3DTest, SignIsExactForPointsNearlyInAPlane)
{
  std::mt19937_64 random(1);
  int flat = 0;
  for (int run = 0; run < 20000; ++run)
  {
    const WholePoints whole = NearlyFlat(random, 1 << 20, GetParam());
    const int expected = SignOfVolume(whole);
    ASSERT_EQ(Orient(AsPoints(whole)), expected) << "run " << run;
    flat += expected == 0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const Points p = AsPoints(whole);
      ASSERT_EQ(skd::Orient2D(p[0], p[1], p[2], axis), SignOfArea(whole, axis)) << "run " << run;
    }
  }
  EXPECT_GT(flat, 1000);
}

TEST_P(Orient3DTest, TwoPointsAreOnASideIfBothAre)
{
  std::mt19937_64 random(4);
  std::array<int, 3> counts{};
  for (int run = 0; run < 20000; ++run)
  {
    const Points p = AsPoints(NearlyFlat(random, run % 2 == 0 ? 1 << 20 : 3, GetParam()));
    const Points q = AsPoints(NearlyFlat(random, run % 2 == 0 ? 1 << 20 : 3, GetParam()));
    const skd::FloatingPlane plane(p[0], p[1], p[2]);
    const int first = plane.SureSideOf(p[3]);
    const int second = plane.SureSideOf(q[0]);
    const int both = first == second ? first : 0;
    ASSERT_EQ(plane.SureSideOfBoth(p[3], q[0]), both) << "run " << run;
    ASSERT_EQ(plane.SureSideOfBoth(q[0], p[3]), both) << "run " << run;
    ++counts[static_cast<std::size_t>(both + 1)];
  }
  EXPECT_GT(counts[1], 100);
}

TEST_P(Orient3DTest, SignTurnsWithTheOrderOfThePoints)
{
  std::mt19937_64 random(2);
  for (int run = 0; run < 2000; ++run)
  {
    Points p = AsPoints(NearlyFlat(random, 1 << 20, GetParam()));
    const int sign = Orient(p);
    for (int i = 0; i < 3; ++i)
    {
      std::swap(p[i], p[i + 1]);
      ASSERT_EQ(Orient(p), i % 2 ? sign : -sign);
    }
  }
}

TEST_P(Orient3DTest, ScaleDoesNotMatter)
{
  std::mt19937_64 random(3);
  for (int run = 0; run < 2000; ++run)
  {
    const WholePoints whole = NearlyFlat(random, 1 << 16, GetParam());
    for (const int exponent : { -240, -60, 60, 240 })
    {
      Points p = AsPoints(whole);
      for (Vector3& x : p)
      {
        x = std::ldexp(1.0, exponent) * x;
      }
      ASSERT_EQ(Orient(p), SignOfVolume(whole)) << "scale 2^" << exponent;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
  Offsets, Orient3DTest, ::testing::Values(0, 1000003, (std::int64_t(1) << 50) + 12345));

// 12 + 12 ulps of 24: the points of Kettner et al., "Classroom Examples of Robustness Problems".
TEST(Orient2DTest, IsExactOnTheDiagonal)
{
  const double ulp = std::ldexp(1.0, -53);
  const Vector3 b{ { 12.0, 12.0, 0.0 } };
  const Vector3 c{ { 24.0, 24.0, 0.0 } };
  const Vector3 above{ { 12.0, 12.0, 1.0 } };
  for (int i = 0; i < 256; ++i)
  {
    for (int j = 0; j < 256; ++j)
    {
      const Vector3 a{ { 0.5 + i * ulp, 0.5 + j * ulp, 0.0 } };
      ASSERT_EQ(skd::Orient2D(a, b, c, 2), (i < j) - (i > j)) << i << " " << j;
      ASSERT_EQ(skd::Orient3D(a, b, c, above), (i < j) - (i > j)) << i << " " << j;
      ASSERT_EQ(skd::Orient3D(b, c, above, a), (i > j) - (i < j)) << i << " " << j;
    }
  }
}

TEST(Orient3DTest, ValueIsThatOfTheVolume)
{
  const Vector3 o{ { 1e6, 1e6, 1e6 } };
  const Vector3 x{ { 1e6 + 1.0, 1e6, 1e6 } };
  const Vector3 y{ { 1e6, 1e6 + 1.0, 1e6 } };
  const Vector3 z{ { 1e6 + 0.25, 1e6 + 0.25, 1e6 + std::ldexp(1.0, -30) } };
  EXPECT_EQ(skd::AccuratePlane(o, x, y).VolumeTo(z), std::ldexp(1.0, -30));
  EXPECT_EQ(skd::AreaOf(o, x, y, 2), 1.0);
}

TEST(Orient3DTest, EqualPointsAreInOnePlane)
{
  const Vector3 a{ { 0.1, 0.2, 0.3 } };
  const Vector3 b{ { 0.7, 0.11, 0.13 } };
  const Vector3 c{ { 0.9, 0.17, 0.19 } };
  for (const Vector3& d : { a, b, c })
  {
    EXPECT_EQ(skd::Orient3D(a, b, c, d), 0);
    EXPECT_EQ(skd::AccuratePlane(a, b, c).VolumeTo(d), 0.0);
  }
}

TEST(Orient3DTest, NothingIsKnownOfNan)
{
  const Vector3 a{ { 0.0, 0.0, 0.0 } };
  const Vector3 b{ { 1.0, 0.0, 0.0 } };
  const Vector3 c{ { 0.0, 1.0, 0.0 } };
  const Vector3 nan{ { 0.0, std::nan(""), 1.0 } };
  EXPECT_EQ(skd::Orient3D(a, b, c, nan), 0);
  EXPECT_EQ(skd::Orient2D(a, b, nan, 2), 0);
}

}
