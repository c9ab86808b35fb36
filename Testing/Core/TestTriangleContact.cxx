// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Geometry/Intersection/ContactPosition.h"
#include "Core/Geometry/Intersection/NeighbourTriangles.h"
#include "Core/Geometry/Intersection/TriangleContact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace
{

using skd::Vector3;
using Corners = std::array<Vector3, 3>;

std::array<Vector3, 3> EdgesOf(const Corners& t)
{
  return { t[1] - t[0], t[2] - t[1], t[0] - t[2] };
}

bool IsSeparatedAlong(const Vector3& axis, const Corners& a, const Corners& b)
{
  const auto maxDistance = [&](const Corners& t) {
    return std::minmax({ Dot(axis, t[0]), Dot(axis, t[1]), Dot(axis, t[2]) });
  };
  const auto [minA, maxA] = maxDistance(a);
  const auto [minB, maxB] = maxDistance(b);
  return maxA < minB || maxB < minA;
}

/// Whether triangles of small whole coordinates touch: no axis of the finite number that there are
/// separates them. All products are whole numbers below 2^53, so this is exact.
bool Touch(const Corners& a, const Corners& b)
{
  const auto edgesA = EdgesOf(a);
  const auto edgesB = EdgesOf(b);
  const Vector3 normalA = Cross(edgesA[0], edgesA[1]);
  const Vector3 normalB = Cross(edgesB[0], edgesB[1]);
  std::vector<Vector3> axes{ normalA, normalB };
  for (int i = 0; i < 3; ++i)
  {
    axes.push_back(Cross(normalA, edgesA[i]));
    axes.push_back(Cross(normalB, edgesB[i]));
    for (int k = 0; k < 3; ++k)
    {
      axes.push_back(Cross(edgesA[i], edgesB[k]));
    }
  }
  return std::none_of(
    axes.begin(), axes.end(), [&](const Vector3& axis) { return IsSeparatedAlong(axis, a, b); });
}

Vector3 PositionOf(const skd::ContactPoint& point, const Corners& a, const Corners& b)
{
  const auto edge = [](const Corners& t, skd::TriangleFeature part) {
    return skd::Segment<3>{ t[part - 3], t[(part - 2) % 3] };
  };
  if (skd::IsCorner(point.First))
  {
    return a[point.First];
  }
  if (skd::IsCorner(point.Second))
  {
    return b[point.Second];
  }
  if (skd::IsEdge(point.First) && skd::IsEdge(point.Second))
  {
    return skd::CrossingWithEdge(edge(a, point.First), edge(b, point.Second));
  }
  return skd::IsEdge(point.First) ? skd::CrossingWithPlane(edge(a, point.First), b[0], b[1], b[2])
                                  : skd::CrossingWithPlane(edge(b, point.Second), a[0], a[1], a[2]);
}

/// How far x is from the part of a triangle.
double Miss(const Vector3& x, skd::TriangleFeature part, const Corners& t)
{
  const Vector3 normal = Cross(t[1] - t[0], t[2] - t[0]);
  double miss = std::abs(Dot(normal, x - t[0])) / Norm(normal);
  for (int edge = 0; edge < 3; ++edge)
  {
    const Vector3 along = t[(edge + 1) % 3] - t[edge];
    const double inward = Dot(Cross(normal, along), x - t[edge]) / Norm(normal) / Norm(along);
    const bool isOn = part == 3 + edge || part == edge || part == (edge + 1) % 3;
    miss = std::max(miss, isOn ? std::abs(inward) : -inward);
  }
  return miss;
}

/// The part of polygon where `side` is not negative.
std::vector<Vector3> Clip(
  const std::vector<Vector3>& polygon, const Vector3& origin, const Vector3& side)
{
  constexpr double rounding = 1e-10; // far below the least distance of what lies on a lattice
  std::vector<Vector3> clipped;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Vector3& p = polygon[i];
    const Vector3& q = polygon[(i + 1) % polygon.size()];
    const double atP = Dot(side, p - origin) / Norm(side);
    const double atQ = Dot(side, q - origin) / Norm(side);
    if (atP >= -rounding)
    {
      clipped.push_back(p);
    }
    if ((atP < -rounding && atQ > rounding) || (atP > rounding && atQ < -rounding))
    {
      clipped.push_back(skd::Lerp(p, q, atP / (atP - atQ)));
    }
  }
  return clipped;
}

/// What triangles have in common, by clipping one by the planes of the other: measured by rounding.
std::vector<Vector3> ClipWhole(const Corners& a, const Corners& b)
{
  const Vector3 normal = Cross(b[1] - b[0], b[2] - b[0]);
  std::vector<Vector3> rest(a.begin(), a.end());
  rest = Clip(rest, b[0], normal);
  rest = Clip(rest, b[0], -1.0 * normal);
  for (int edge = 0; edge < 3; ++edge)
  {
    rest = Clip(rest, b[edge], Cross(normal, b[(edge + 1) % 3] - b[edge]));
  }
  return rest;
}

double LengthOf(const std::vector<Vector3>& points)
{
  double length = 0.0;
  for (const Vector3& p : points)
  {
    for (const Vector3& q : points)
    {
      length = std::max(length, Norm(p - q));
    }
  }
  return length;
}

double AreaOf(const std::vector<Vector3>& polygon)
{
  Vector3 area{ { 0.0, 0.0, 0.0 } };
  for (std::size_t i = 2; i < polygon.size(); ++i)
  {
    area = area + 0.5 * Cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
  }
  return Norm(area);
}

Corners RandomTriangle(std::mt19937& random, int maxDistance, bool isFlat)
{
  std::uniform_int_distribution<int> coordinate(0, maxDistance);
  Corners t;
  do
  {
    for (Vector3& x : t)
    {
      const double z = coordinate(random);
      x = { { double(coordinate(random)), double(coordinate(random)), isFlat ? 1.0 : z } };
    }
  } while (Norm2(Cross(t[1] - t[0], t[2] - t[0])) == 0.0);
  return t;
}

void ExpectRightContact(const Corners& a, const Corners& b)
{
  const skd::TriangleContact contact = skd::FindContact(a, b);
  ASSERT_EQ(contact.Count > 0, Touch(a, b));
  std::vector<Vector3> points;
  for (int i = 0; i < contact.Count; ++i)
  {
    points.push_back(PositionOf(contact.Points[i], a, b));
    ASSERT_LT(Miss(points.back(), contact.Points[i].First, a), 1e-13);
    ASSERT_LT(Miss(points.back(), contact.Points[i].Second, b), 1e-13);
    for (int k = 0; k < i; ++k)
    {
      ASSERT_GT(Norm(points[i] - points[k]), 1e-6) << "one point twice";
    }
  }
  const std::vector<Vector3> expected = ClipWhole(a, b);
  ASSERT_NEAR(LengthOf(points), LengthOf(expected), 1e-9);
  ASSERT_NEAR(AreaOf(points), AreaOf(expected), 1e-9);
  if (!contact.IsFlat)
  {
    ASSERT_LE(contact.Count, 2);
  }
}

void ExpectSameTheOtherWay(const Corners& a, const Corners& b)
{
  const skd::TriangleContact there = skd::FindContact(a, b);
  const skd::TriangleContact back = skd::FindContact(b, a);
  ASSERT_EQ(there.Count, back.Count);
  ASSERT_EQ(there.IsFlat, back.IsFlat);
  for (int i = 0; i < there.Count; ++i)
  {
    const auto isSame = [&](const skd::ContactPoint& point)
    { return point.First == there.Points[i].Second && point.Second == there.Points[i].First; };
    ASSERT_TRUE(std::any_of(back.Points.begin(), back.Points.begin() + back.Count, isSame));
  }
}

class TriangleContactTest : public ::testing::TestWithParam<std::tuple<int, bool>>
{
};

// Coordinates of few values: most pairs are touching, sharing corners, crossing in edges or flat.
TEST_P(TriangleContactTest, IsThatOfBruteForce)
{
  const auto [maxDistance, isFlat] = GetParam();
  std::mt19937 random(7);
  for (int run = 0; run < 20000; ++run)
  {
    const Corners a = RandomTriangle(random, maxDistance, isFlat);
    const Corners b = RandomTriangle(random, maxDistance, isFlat);
    SCOPED_TRACE("run " + std::to_string(run));
    ASSERT_NO_FATAL_FAILURE(ExpectRightContact(a, b));
    ASSERT_NO_FATAL_FAILURE(ExpectSameTheOtherWay(a, b));
  }
}

INSTANTIATE_TEST_SUITE_P(Lattices, TriangleContactTest,
  ::testing::Combine(::testing::Values(1, 2, 3, 5, 40), ::testing::Bool()));

TEST(TriangleContact, KnownSharedCornersChangeNothing)
{
  std::mt19937 random(8);
  for (int run = 0; run < 20000; ++run)
  {
    const Corners a = RandomTriangle(random, 3, run % 2 == 0);
    const Corners b = RandomTriangle(random, 3, run % 2 == 0);
    skd::SharedCorners shared = skd::NoSharedCorners;
    for (std::int8_t i = 0; i < 3; ++i)
    {
      const auto at = std::find(b.begin(), b.end(), a[i]);
      shared[i] = static_cast<std::int8_t>(at == b.end() ? -1 : at - b.begin());
    }
    const skd::TriangleContact plain = skd::FindContact(a, b);
    const skd::TriangleContact told = skd::FindContact(a, b, shared);
    ASSERT_EQ(plain.Count, told.Count) << "run " << run;
    for (int i = 0; i < plain.Count; ++i)
    {
      ASSERT_EQ(plain.Points[i].First, told.Points[i].First);
      ASSERT_EQ(plain.Points[i].Second, told.Points[i].Second);
    }
  }
}

// What the fast test of neighbours is sure of is so. Of those of one plane on either side of their
// edge it is sure.
TEST(TriangleContact, WhatNeighboursSurelyHaveInCommonIsAllThatTheyHave)
{
  std::mt19937 random(10);
  std::uniform_int_distribution<int> corner(0, 2);
  int sure = 0;
  for (int run = 0; run < 40000; ++run)
  {
    const int size = run % 3 == 0 ? 2 : 9;
    const Corners a = RandomTriangle(random, size, run % 2 == 0);
    Corners b = RandomTriangle(random, size, run % 2 == 0);
    b[corner(random)] = a[corner(random)];
    b[corner(random)] = a[corner(random)];
    unsigned masks[2] = { 0, 0 };
    for (unsigned i = 0; i < 3; ++i)
    {
      masks[0] |= static_cast<unsigned>(std::count(b.begin(), b.end(), a[i]) > 0) << i;
      masks[1] |= static_cast<unsigned>(std::count(a.begin(), a.end(), b[i]) > 0) << i;
    }
    const skd::CornerPointers atA = { &a[0], &a[1], &a[2] };
    const skd::CornerPointers atB = { &b[0], &b[1], &b[2] };
    if (skd::HaveOnlyCornersInCommon(atA, masks[0], atB, masks[1]))
    {
      ++sure;
      const int shared = static_cast<int>(std::count_if(a.begin(), a.end(),
        [&b](const Vector3& x) { return std::count(b.begin(), b.end(), x) > 0; }));
      ASSERT_LE(skd::FindContact(a, b).Count, shared) << "run " << run;
    }
  }
  EXPECT_GT(sure, 10000);
  for (const double z : { 0.0, 0.3, -1e9 })
  {
    const Vector3 x[4] = { { { 0.1, 0.0, z } }, { { 1.0, 0.2, z } }, { { 0.3, 0.9, z } },
      { { 0.4, -0.8, z } } };
    EXPECT_TRUE(
      skd::HaveOnlyCornersInCommon({ &x[0], &x[1], &x[2] }, 3u, { &x[3], &x[1], &x[0] }, 6u));
    EXPECT_FALSE(
      skd::HaveOnlyCornersInCommon({ &x[0], &x[1], &x[2] }, 3u, { &x[2], &x[1], &x[0] }, 6u));
  }
}

// Triangles of a fan in one plane, tilted or not, are surely apart but for its centre, unless they
// overlap.
TEST(TriangleContact, TrianglesOfAFanSurelyHaveTheirCentreInCommonOnly)
{
  constexpr int count = 9;
  for (const Vector3& normal : { Vector3{ { 0, 0, 1 } }, { { 1, 2, -3 } }, { { -5, 0.1, 0 } } })
  {
    const Vector3 u = Cross(normal, { { 0.3, 0.7, 0.2 } });
    const Vector3 v = Cross(normal, u);
    const Vector3 centre{ { 0.1, -7.0, 1e3 } };
    std::vector<Vector3> rim;
    for (int i = 0; i < count; ++i)
    {
      const double angle = 6.283185307179586 * i / count;
      rim.push_back(centre + std::cos(angle) * u + (std::sin(angle) / Norm(normal)) * v);
    }
    const auto areSure = [&](int i, int sizeOfFirst, int k, int sizeOfSecond)
    {
      return skd::HaveOnlyCornersInCommon({ &centre, &rim[i], &rim[(i + sizeOfFirst) % count] }, 1u,
        { &rim[k], &rim[(k + sizeOfSecond) % count], &centre }, 4u);
    };
    for (int between = 2; between + 1 < count; ++between)
    {
      EXPECT_TRUE(areSure(between, 1, 0, 1)) << between;
    }
    if (normal[2] == 1.0) // others are not in one plane to the last bit
    {
      EXPECT_FALSE(areSure(0, 4, 1, 2)); // inside
      EXPECT_FALSE(areSure(0, 3, 2, 2)); // crosses
    }
  }
}

// One unit in the last place decides, far from the origin, too.
TEST(TriangleContact, OneUlpDecides)
{
  for (const double z : { 0.0, 1.0, 1e9, -1e15 })
  {
    const Corners floor = { { { { -3.0, -3.0, z } }, { { 9.0, -3.0, z } }, { { -3.0, 9.0, z } } } };
    const auto standing = [&](double tip)
    {
      return Corners{ { { { 0.3, 0.1, tip } }, { { 0.7, 0.1, z + 7.0 } },
        { { 0.3, 0.9, z + 5.0 } } } };
    };
    const double above = std::nextafter(z, 1e300);
    const double below = std::nextafter(z, -1e300);
    const auto count = [&](double tip) { return skd::FindContact(floor, standing(tip)).Count; };
    EXPECT_EQ(count(above), 0);
    EXPECT_EQ(count(z), 1);
    EXPECT_EQ(count(below), 2);
  }
}

// Triangles that are cut through by others, off all corners and edges: the short way.
TEST(TriangleContact, IsThatOfBruteForceOffAllLattices)
{
  std::mt19937 random(9);
  std::uniform_real_distribution<double> coordinate(0.0, 1.0);
  const auto next = [&]
  {
    Corners corners;
    for (Vector3& x : corners)
    {
      x = { { coordinate(random), coordinate(random), coordinate(random) } };
    }
    return corners;
  };
  for (int run = 0; run < 50000; ++run)
  {
    const Corners a = next();
    const Corners b = next();
    SCOPED_TRACE("run " + std::to_string(run));
    ASSERT_EQ(skd::FindContact(a, b).Count > 0, Touch(a, b));
    ASSERT_NO_FATAL_FAILURE(ExpectSameTheOtherWay(a, b));
  }
}

TEST(TriangleContact, TrianglesOnALineTouchNothing)
{
  const Vector3 a{ { 0.0, 0.0, -1.0 } };
  const Vector3 b{ { 0.0, 0.0, 1.0 } };
  const Corners line = { { a, b, 0.5 * b } };
  const Corners floor = { { { { -1.0, -1.0, 0.0 } }, { { 3.0, -1.0, 0.0 } },
    { { -1.0, 3.0, 0.0 } } } };
  const Corners along = { { a, b, { { 1.0, 0.0, 0.0 } } } };
  for (const Corners& other : { floor, along, line })
  {
    EXPECT_EQ(skd::FindContact(line, other).Count, 0);
    EXPECT_EQ(skd::FindContact(other, line).Count, 0);
  }
}

TEST(TriangleContact, TrianglesOnALineHaveNoAxis)
{
  const Vector3 a{ { 0.1, 0.2, 0.3 } };
  const Vector3 b{ { 0.2, 0.4, 0.6 } };
  EXPECT_EQ(skd::ProjectedTriangle({ a, b, a }).Axis, -1);
  EXPECT_EQ(skd::ProjectedTriangle({ a, a, a }).Axis, -1);
  EXPECT_EQ(skd::ProjectedTriangle({ a, 4.0 * a, 2.0 * a }).Axis, -1);
  EXPECT_NE(skd::ProjectedTriangle({ a, 3.0 * a, b }).Axis, -1) << "3 * 0.1 is rounded";
}

}
