// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// The hull of random points, many of them in planes and on lines: closed, convex, around all.

#include "Core/Geometry/Polygons/ConvexHull.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>

namespace
{
using namespace skd;

std::vector<Vector3> LatticePoints(std::mt19937& random, int count, int size, double scale)
{
  std::vector<Vector3> points;
  for (int i = 0; i < count; ++i)
  {
    Vector3 x;
    for (double& c : x.X)
    {
      c = scale * static_cast<double>(random() % static_cast<unsigned>(size));
    }
    points.push_back(x);
  }
  return points;
}

/// Each edge is of two triangles, once in each direction, and no point is before any triangle.
void ExpectHull(const std::vector<Vector3>& points, const ConvexHull& hull, double scale)
{
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  std::set<std::uint32_t> corners;
  for (const auto& t : hull.Triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      ++edges[{ t[k], t[(k + 1) % 3] }];
      corners.insert(t[k]);
    }
    const auto at = [&](std::uint32_t i) { return (1.0 / scale) * points[i]; };
    for (std::uint32_t i = 0; i < points.size(); ++i)
    {
      ASSERT_LE(Orient3D(at(t[0]), at(t[1]), at(t[2]), at(i)), 0);
    }
  }
  for (const auto& [edge, count] : edges)
  {
    ASSERT_EQ(count, 1);
    ASSERT_EQ(edges.count({ edge.second, edge.first }), 1u);
  }
  ASSERT_EQ(hull.Triangles.size(), 2 * corners.size() - 4); // Euler
}

TEST(ConvexHull, OfRandomPointsIsClosedAndConvex)
{
  std::mt19937 random(3);
  int solid = 0;
  for (int i = 0; i < 2000; ++i)
  {
    const double scale = std::ldexp(1.0, (i % 7 - 3) * 150);
    const auto points = LatticePoints(random, 4 + i % 24, 2 + i % 5, scale);
    const ConvexHull hull = ConvexHullOf(points.data(), points.size());
    if (hull.Dimension == 3)
    {
      ++solid;
      ExpectHull(points, hull, scale);
    }
  }
  EXPECT_GT(solid, 1800);
}

TEST(ConvexHull, OfACubeWithPointsOnIt)
{
  std::vector<Vector3> points;
  for (int i = 0; i < 27; ++i)
  {
    points.push_back({ { 0.5 * (i % 3), 0.5 * (i / 3 % 3), 0.5 * (i / 9) } });
  }
  const ConvexHull hull = ConvexHullOf(points.data(), points.size());
  ASSERT_EQ(hull.Dimension, 3);
  ExpectHull(points, hull, 1.0);
  double volume = 0.0;
  for (const auto& t : hull.Triangles)
  {
    volume += Dot(points[t[0]], Cross(points[t[1]], points[t[2]])) / 6.0;
  }
  EXPECT_DOUBLE_EQ(volume, 1.0);
}

TEST(ConvexHull, OfFlatPointsIsTheirOutline)
{
  std::mt19937 random(5);
  for (int i = 0; i < 300; ++i)
  {
    auto points = LatticePoints(random, 12, 4, 1.0);
    for (Vector3& x : points)
    {
      x = i % 3 == 0 ? Vector3{ { x[0], x[1], 3.0 } }
        : i % 3 == 1 ? Vector3{ { 2.0, x[0], x[1] } }
                     : Vector3{ { x[0], x[0] + x[1], x[1] } };
    }
    const ConvexHull hull = ConvexHullOf(points.data(), points.size());
    ASSERT_EQ(hull.Dimension, 2);
    const auto& o = hull.Outline;
    ASSERT_GE(o.size(), 3u);
    const int axis = i % 3 == 1 ? 0 : 2;
    for (std::size_t k = 0; k < o.size(); ++k)
    {
      const Vector3& a = points[o[k]];
      const Vector3& b = points[o[(k + 1) % o.size()]];
      EXPECT_NE(Orient2D(a, b, points[o[(k + 2) % o.size()]], axis), 0);
      int least = 0;
      int most = 0;
      for (const Vector3& x : points)
      {
        least = std::min(least, Orient2D(a, b, x, axis));
        most = std::max(most, Orient2D(a, b, x, axis));
      }
      EXPECT_TRUE(least == 0 || most == 0);
    }
  }
}

TEST(ConvexHull, OfLinesAndPoints)
{
  const std::vector<Vector3> line{ { { 1, 1, 1 } }, { { 3, 3, 3 } }, { { 2, 2, 2 } },
    { { 0, 0, 0 } }, { { 3, 3, 3 } } };
  ConvexHull hull = ConvexHullOf(line.data(), line.size());
  EXPECT_EQ(hull.Dimension, 1);
  EXPECT_EQ(hull.Outline, (std::vector<std::uint32_t>{ 3, 4 }));
  const std::vector<Vector3> same(4, Vector3{ { 1, 2, 3 } });
  EXPECT_EQ(ConvexHullOf(same.data(), same.size()).Dimension, 0);
  EXPECT_EQ(ConvexHullOf(same.data(), 0).Dimension, -1);
}
}
