// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Geometry/Simplices/SimplexContact.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace
{

using skd::SimplexSet;
using skd::Vector3;

/// Points of a set of one simplex of small integers, dense enough to find any common point of two.
std::set<Vector3> PointsOf(const SimplexSet& set, int n)
{
  const auto corners = set.Corners(set.Simplices[0]);
  std::set<Vector3> points;
  for (int i = 0; i <= n; ++i)
  {
    for (int k = 0; k <= n - i; ++k)
    {
      points.insert((double(n - i - k) / n) * corners[0] + (double(i) / n) * corners[1] +
        (double(k) / n) * corners[2]);
    }
  }
  return points;
}

SimplexSet RandomSimplex(std::mt19937& random, int dimension)
{
  SimplexSet set;
  set.Clear(dimension);
  for (int i = 0; i <= dimension; ++i)
  {
    const auto number = [&random] { return double(random() % 4); };
    const double x = number();
    const double y = number();
    set.Add({ { x, y, number() } });
  }
  set.AddSimplex(0, std::min(1, dimension), dimension);
  return set;
}

SimplexSet Scaled(const SimplexSet& set, double factor)
{
  SimplexSet scaled;
  scaled.Clear(set.Dimension);
  for (const Vector3& point : set.Points)
  {
    scaled.Add(factor * point);
  }
  scaled.Simplices = set.Simplices;
  return scaled;
}

TEST(SimplexContact, TouchesWhereTheLeastDistanceIsNought)
{
  std::mt19937 random(13);
  int touching = 0;
  for (int i = 0; i < 4000; ++i)
  {
    const SimplexSet a = RandomSimplex(random, i % 3);
    const SimplexSet b = RandomSimplex(random, i / 3 % 3);
    const bool touch = skd::Touch(a, b, 1e-12);
    EXPECT_EQ(touch, skd::Touch(b, a, 1e-12));
    // Samples of the one against the whole of the other: near 0 at a touch, else bounded below.
    double least2 = 1e9;
    for (const Vector3& x : PointsOf(a, 60))
    {
      least2 = std::min(least2, skd::SimplexDistance2(b, x));
    }
    EXPECT_TRUE(!touch || least2 < 0.1 * 0.1) << i;
    EXPECT_TRUE(touch || least2 > 1e-10) << i;
    touching += touch;
  }
  EXPECT_TRUE(touching > 400 && touching < 3600) << touching;
}

TEST(SimplexContact, IsTheSameAtAnyScale)
{
  std::mt19937 random(17);
  for (int i = 0; i < 500; ++i)
  {
    const SimplexSet a = RandomSimplex(random, i % 3);
    const SimplexSet b = RandomSimplex(random, i / 3 % 3);
    const bool touch = skd::Touch(a, b, 1e-12);
    for (const int exponent : { -200, 200 })
    {
      const double scale = std::ldexp(1.0, exponent);
      EXPECT_EQ(skd::Touch(Scaled(a, scale), Scaled(b, scale), 1e-12 * scale), touch) << i;
    }
  }
}

/// Solids meet what is within them, and what they are within, though no boundaries touch.
TEST(SimplexContact, SolidsMeetWhatTheyEnclose)
{
  const SimplexSet large = skd::MakeBox(skd::Box3({ { 0, 0, 0 } }, { { 4, 4, 4 } }));
  const SimplexSet small = skd::MakeBox(skd::Box3({ { 1, 1, 1 } }, { { 2, 2, 2 } }));
  const SimplexSet beside = skd::MakeBox(skd::Box3({ { 4, 1, 1 } }, { { 5, 2, 2 } }));
  const SimplexSet off = skd::MakeBox(skd::Box3({ { 4.5, 1, 1 } }, { { 5, 2, 2 } }));
  EXPECT_FALSE(skd::Touch(large, small, 0.0));
  EXPECT_TRUE(skd::Meet(large, small, 0.0));
  EXPECT_TRUE(skd::Meet(small, large, 0.0));
  EXPECT_TRUE(skd::Meet(large, beside, 0.0));
  EXPECT_FALSE(skd::Meet(large, off, 0.0));
}

}
