// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Geometry/Polygons/EarClipping.h"
#include "CoreScenes.h"

#include <gtest/gtest.h>

#include <array>

using namespace coretest;

namespace
{

using skd::Vector3;
using Polygon = std::vector<Vector3>;

double DoubleArea(const Vector3& a, const Vector3& b, const Vector3& c)
{
  return skd::Norm(skd::Cross(b - a, c - a));
}

std::vector<std::array<int, 3>> Cut(const Polygon& polygon)
{
  std::vector<std::array<int, 3>> triangles;
  skd::EarClipping<Polygon> ears(polygon, static_cast<int>(polygon.size()));
  ears.ForEachTriangle([&](int a, int b, int c) { triangles.push_back({ a, b, c }); });
  return triangles;
}

/// A star around the origin: simple, and as a rule concave.
Polygon Star(Random& random, int size)
{
  Polygon polygon;
  for (int i = 0; i < size; ++i)
  {
    const double angle = 6.283185307179586 * (i + random.In(0.0, 0.9)) / size;
    const double radius = random.In(0.1, 1.0);
    polygon.push_back(Vector3{ { radius * std::cos(angle), radius * std::sin(angle), 0.25 } });
  }
  return polygon;
}

Vector3 Rotated(const Vector3& x)
{
  return { { x[2] + 0.3 * x[0], x[0] - 0.2 * x[1], x[1] } };
}

TEST(EarClipping, TrianglesHaveTheAreaOfThePolygonHoweverItIsTurned)
{
  Random random(1);
  for (int i = 0; i < 200; ++i)
  {
    Polygon polygon = Star(random, 3 + static_cast<int>(random.Below(12)));
    if (i % 2)
    {
      std::reverse(polygon.begin(), polygon.end());
    }
    if (i % 3)
    {
      std::transform(polygon.begin(), polygon.end(), polygon.begin(), Rotated);
    }
    double area = 0.0;
    for (const auto& triangle : Cut(polygon))
    {
      area += DoubleArea(polygon[triangle[0]], polygon[triangle[1]], polygon[triangle[2]]);
    }
    const skd::PolygonPlane plane(polygon, static_cast<int>(polygon.size()));
    EXPECT_NEAR(area, skd::Norm(plane.Normal), 1e-12);
    EXPECT_EQ(Cut(polygon).size(), polygon.size() - 2);
  }
}

TEST(EarClipping, CornersOnEdgesAndRepeatedCornersAreNoObstacle)
{
  const Polygon onEdges = { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 2, 0, 0 } }, { { 2, 2, 0 } },
    { { 1, 2, 0 } }, { { 0, 2, 0 } }, { { 0, 1, 0 } } };
  double area = 0.0;
  for (const auto& t : Cut(onEdges))
  {
    area += DoubleArea(onEdges[t[0]], onEdges[t[1]], onEdges[t[2]]);
  }
  EXPECT_EQ(area, 8.0);
  const Polygon repeated = { { { 0, 0, 0 } }, { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 1, 1, 0 } },
    { { 1, 1, 0 } } };
  EXPECT_EQ(Cut(repeated).size(), 3u);
}

TEST(EarClipping, PolygonsWithoutAreaOrThatCrossThemselvesAreCutSomehow)
{
  const Vector3 x{ { 1, 2, 3 } };
  EXPECT_EQ(Cut({ x, x, x, x }).size(), 2u);
  EXPECT_EQ(Cut({ x, x }).size(), 0u);
  EXPECT_EQ(Cut({ { { 0, 0, 0 } }, { { 1, 1, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } } }).size(), 2u);
}

}
