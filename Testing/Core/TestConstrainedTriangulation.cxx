// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Geometry/Polygons/ConstrainedTriangulation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <random>
#include <set>
#include <vector>

namespace
{

/// Points of whole coordinates: all signs are exact.
using Point = std::array<long long, 2>;
using Edge = std::pair<int, int>;

long long AreaOf(const Point& a, const Point& b, const Point& c)
{
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// By the circle through a, b, c.
bool IsInCircle(const Point& a, const Point& b, const Point& c, const Point& d)
{
  const auto row = [&](const Point& p)
  {
    const double x = static_cast<double>(p[0] - d[0]);
    const double y = static_cast<double>(p[1] - d[1]);
    return std::array<double, 3>{ x, y, x * x + y * y };
  };
  const auto r = row(a);
  const auto s = row(b);
  const auto t = row(c);
  return r[0] * (s[1] * t[2] - s[2] * t[1]) - r[1] * (s[0] * t[2] - s[2] * t[0]) +
    r[2] * (s[0] * t[1] - s[1] * t[0]) >
    0.0;
}

auto MakeTriangulation(const std::vector<Point>& points)
{
  const auto orient = [&points](int a, int b, int c)
  {
    const long long area = AreaOf(points[a], points[b], points[c]);
    return (area > 0) - (area < 0);
  };
  const auto isBetter = [&points](int a, int b, int c, int d)
  { return IsInCircle(points[a], points[b], points[c], points[d]); };
  return skd::ConstrainedTriangulation<decltype(orient), decltype(isBetter)>(
    static_cast<int>(points.size()), orient, isBetter);
}

template <class Triangulation>
std::set<Edge> CheckAndGetEdges(const Triangulation& made, const std::vector<Point>& points)
{
  std::set<Edge> edges;
  long long area = 0;
  for (const skd::FlipMesh::Triangle& triangle : made.GetTriangles())
  {
    const std::array<int, 3>& t = triangle.Corners;
    const long long part = AreaOf(points[t[0]], points[t[1]], points[t[2]]);
    EXPECT_GT(part, 0);
    area += part;
    for (int i = 0; i < 3; ++i)
    {
      EXPECT_TRUE(edges.emplace(t[i], t[(i + 1) % 3]).second) << "an edge used twice one way";
    }
  }
  EXPECT_EQ(area, AreaOf(points[0], points[1], points[2]));
  return edges;
}

bool HasEdge(const std::set<Edge>& edges, int a, int b)
{
  return edges.count({ a, b }) + edges.count({ b, a }) > 0;
}

std::vector<Point> BigTriangle(long long size)
{
  return { { 0, 0 }, { size, 0 }, { 0, size } };
}

TEST(ConstrainedTriangulation, OfNothingIsTheTriangle)
{
  const auto points = BigTriangle(1);
  EXPECT_EQ(MakeTriangulation(points).GetTriangles().size(), 1u);
}

TEST(ConstrainedTriangulation, BorderPointsComeInTurn)
{
  auto points = BigTriangle(12);
  for (const Point& p : { Point{ 3, 0 }, { 6, 0 }, { 9, 3 }, { 0, 4 } })
  {
    points.push_back(p);
  }
  auto made = MakeTriangulation(points);
  made.AddOnBorder(3, 0, 1);
  made.AddOnBorder(4, 3, 1);
  made.AddOnBorder(5, 1, 2);
  made.AddOnBorder(6, 2, 0);
  made.Constrain(3, 5);
  made.Constrain(6, 3);
  const auto edges = CheckAndGetEdges(made, points);
  EXPECT_EQ(made.GetTriangles().size(), 5u);
  EXPECT_TRUE(HasEdge(edges, 3, 5) && HasEdge(edges, 6, 3));
}

TEST(ConstrainedTriangulation, APointThatIsThereIsReported)
{
  auto points = BigTriangle(12);
  points.push_back({ 3, 3 });
  points.push_back({ 3, 3 });
  points.push_back({ 12, 0 });
  auto made = MakeTriangulation(points);
  EXPECT_EQ(made.Add(3), 3);
  EXPECT_EQ(made.Add(4), 3);
  EXPECT_EQ(made.Add(5), 1);
}

TEST(ConstrainedTriangulation, ASegmentThroughPointsGoesFromOneToTheNext)
{
  auto points = BigTriangle(40);
  for (int i = 1; i < 8; ++i)
  {
    points.push_back({ 2 * i, 3 * i });
    points.push_back({ 3 * i, 2 * i });
  }
  auto made = MakeTriangulation(points);
  for (int i = 3; i < static_cast<int>(points.size()); ++i)
  {
    EXPECT_EQ(made.Add(i), i);
  }
  made.Constrain(15, 0);
  made.Constrain(4, 14);
  const auto edges = CheckAndGetEdges(made, points);
  for (int i = 3; i + 2 < 16; i += 2)
  {
    EXPECT_TRUE(HasEdge(edges, i, i + 2));
    EXPECT_TRUE(HasEdge(edges, std::min(i + 1, 14), std::min(i + 3, 16)));
  }
}

/// Segments of a random set that do not cross the ones before.
std::vector<Edge> RandomSegments(const std::vector<Point>& points, int tries, std::mt19937& random)
{
  std::vector<Edge> segments;
  const auto side = [&](const Edge& e, int p)
  {
    const long long area = AreaOf(points[e.first], points[e.second], points[p]);
    return (area > 0) - (area < 0);
  };
  const auto crosses = [&](const Edge& e, const Edge& f)
  { return side(e, f.first) * side(e, f.second) < 0 && side(f, e.first) * side(f, e.second) < 0; };
  std::uniform_int_distribution<int> any(0, static_cast<int>(points.size()) - 1);
  for (int i = 0; i < tries; ++i)
  {
    const Edge next(any(random), any(random));
    if (next.first != next.second &&
      std::none_of(
        segments.begin(), segments.end(), [&](const Edge& old) { return crosses(old, next); }))
    {
      segments.push_back(next);
    }
  }
  return segments;
}

// On few whole coordinates: points on edges, on segments, segments over segments.
TEST(ConstrainedTriangulation, RandomSegmentsAreThere)
{
  for (int seed = 0; seed < 300; ++seed)
  {
    std::mt19937 random(seed);
    const int maxDistance = 6 + seed % 30;
    auto points = BigTriangle(maxDistance);
    std::set<Point> known(points.begin(), points.end());
    for (int x = 0; x < 4 + seed % 60; ++x)
    {
      std::uniform_int_distribution<int> any(1, maxDistance - 2);
      const Point p{ any(random), any(random) };
      if (p[0] + p[1] < maxDistance && known.insert(p).second)
      {
        points.push_back(p);
      }
    }
    auto made = MakeTriangulation(points);
    for (int i = 3; i < static_cast<int>(points.size()); ++i)
    {
      ASSERT_EQ(made.Add(i), i);
    }
    const auto segments = RandomSegments(points, 40, random);
    for (const Edge& segment : segments)
    {
      made.Constrain(segment.first, segment.second);
    }
    const auto edges = CheckAndGetEdges(made, points);
    for (const Edge& segment : segments)
    {
      const auto isOn = [&](int p)
      {
        const Point& a = points[segment.first];
        const Point& b = points[segment.second];
        const auto within = [&](int k)
        { return std::min(a[k], b[k]) <= points[p][k] && points[p][k] <= std::max(a[k], b[k]); };
        return AreaOf(a, b, points[p]) == 0 && within(0) && within(1);
      };
      std::vector<int> on;
      for (int p = 0; p < static_cast<int>(points.size()); ++p)
      {
        if (isOn(p))
        {
          on.push_back(p);
        }
      }
      std::sort(on.begin(), on.end(), [&](int p, int q) { return points[p] < points[q]; });
      for (std::size_t i = 1; i < on.size(); ++i)
      {
        EXPECT_TRUE(HasEdge(edges, on[i - 1], on[i])) << "seed " << seed;
      }
    }
  }
}

TEST(ConstrainedTriangulation, WithoutSegmentsItIsDelaunay)
{
  std::mt19937 random(5);
  std::uniform_int_distribution<int> any(1, 4999);
  auto points = BigTriangle(10000);
  for (int i = 0; i < 500; ++i)
  {
    points.push_back({ any(random), any(random) });
  }
  auto made = MakeTriangulation(points);
  for (int i = 3; i < static_cast<int>(points.size()); ++i)
  {
    made.Add(i);
  }
  for (const skd::FlipMesh::Triangle& triangle : made.GetTriangles())
  {
    const std::array<int, 3>& t = triangle.Corners;
    for (const Point& p : points)
    {
      EXPECT_FALSE(IsInCircle(points[t[0]], points[t[1]], points[t[2]], p));
    }
  }
}

/// How often signs are asked for to make an edge across a fan, whose edges can only be flipped one
/// after the other, the one that is crossed last at first.
long CountSigns(int crossed)
{
  auto points = BigTriangle(1000000);
  for (int i = 1; i <= crossed; ++i)
  {
    points.push_back({ 1000 * i, 0 });
  }
  points.push_back({ 1000 * crossed + 500, 1 });
  long count = 0;
  const auto orient = [&points, &count](int a, int b, int c)
  {
    ++count;
    const long long area = AreaOf(points[a], points[b], points[c]);
    return (area > 0) - (area < 0);
  };
  const auto isBetter = [](int, int, int, int) { return false; };
  skd::ConstrainedTriangulation<decltype(orient), decltype(isBetter)> made(
    static_cast<int>(points.size()), orient, isBetter);
  for (int i = 0; i < crossed; ++i)
  {
    made.AddOnBorder(3 + i, i == 0 ? 0 : 2 + i, 1);
  }
  made.Add(3 + crossed);
  count = 0;
  made.Constrain(0, 3 + crossed);
  EXPECT_TRUE(HasEdge(CheckAndGetEdges(made, points), 0, 3 + crossed));
  return count;
}

TEST(ConstrainedTriangulation, AnEdgeCostsWhatItCrosses)
{
  EXPECT_LT(CountSigns(800), 3 * CountSigns(400));
}

}
