// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Geometry/Intersection/BoxOverlap.h"
#include "CoreScenes.h"
#include "Support/ClippedWhere.h"

#include <gtest/gtest.h>

#include <array>

using namespace coretest;

namespace
{

using skd::Box3;
using skd::Overlaps;
using skd::Vector3;
using Corners = std::vector<Vector3>;

/// What a box leaves of a convex polygon, an independent method.
Corners Clipped(Corners polygon, const Box3& box)
{
  for (int side = 0; side < 6; ++side)
  {
    const int axis = side / 2;
    const double sign = side % 2 ? -1.0 : 1.0;
    const double limit = side % 2 ? box.Max[axis] : box.Min[axis];
    const auto height = [&](const Vector3& p) { return sign * (p[axis] - limit); };
    polygon = skdtest::ClippedWhere(polygon, height,
      [&](const Vector3& p, const Vector3& q, double t)
      {
        Vector3 crossing = Lerp(p, q, t);
        crossing[axis] = limit;
        return crossing;
      });
  }
  return polygon;
}

Vector3 GridPoint(Random& random, int size)
{
  Vector3 p;
  for (int axis = 0; axis < 3; ++axis)
  {
    p[axis] = static_cast<double>(random.Below(2 * size + 1)) - size;
  }
  return p;
}

Box3 GridBox(Random& random, int size)
{
  const Vector3 a = GridPoint(random, size);
  Box3 box(a, a);
  box.Add(GridPoint(random, size));
  return box;
}

/// Separating axes in whole numbers: exact.
bool MeetsInWholeNumbers(const Box3& box, const std::array<Vector3, 3>& t)
{
  using Whole = std::array<long long, 3>;
  const auto whole = [](const Vector3& v)
  {
    return Whole{ static_cast<long long>(v[0]), static_cast<long long>(v[1]),
      static_cast<long long>(v[2]) };
  };
  const auto minus = [](const Whole& a, const Whole& b) {
    return Whole{ a[0] - b[0], a[1] - b[1], a[2] - b[2] };
  };
  const auto cross = [](const Whole& a, const Whole& b)
  {
    return Whole{ a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
  };
  const auto dot = [](const Whole& a, const Whole& b)
  { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
  const Whole p[3] = { whole(t[0]), whole(t[1]), whole(t[2]) };
  const Whole units[3] = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  std::vector<Whole> axes{ units[0], units[1], units[2],
    cross(minus(p[1], p[0]), minus(p[2], p[0])) };
  for (int i = 0; i < 9; ++i)
  {
    axes.push_back(cross(minus(p[(i + 1) % 3], p[i % 3]), units[i / 3]));
  }
  const Whole sides[2] = { whole(box.Min), whole(box.Max) };
  for (const Whole& axis : axes)
  {
    long long low = 0;
    long long high = 0;
    for (int i = 0; i < 3; ++i)
    {
      low += std::min(axis[i] * sides[0][i], axis[i] * sides[1][i]);
      high += std::max(axis[i] * sides[0][i], axis[i] * sides[1][i]);
    }
    const long long at[3] = { dot(axis, p[0]), dot(axis, p[1]), dot(axis, p[2]) };
    if (std::max({ at[0], at[1], at[2] }) < low || std::min({ at[0], at[1], at[2] }) > high)
    {
      return false;
    }
  }
  return true;
}

TEST(BoxOverlap, OfWholeNumbersIsExact)
{
  Random random(11);
  int met = 0;
  const int rounds = 300000;
  for (int i = 0; i < rounds; ++i)
  {
    const int size = 1 + static_cast<int>(random.Below(12));
    const Box3 box = GridBox(random, size);
    const std::array<Vector3, 3> t{ GridPoint(random, size), GridPoint(random, size),
      GridPoint(random, size) };
    const bool expected = MeetsInWholeNumbers(box, t);
    met += expected;
    ASSERT_EQ(Overlaps(box, t[0], t[1], t[2]), expected) << i;
    const bool ofEdge = MeetsInWholeNumbers(box, { t[0], t[1], t[1] });
    ASSERT_EQ(Overlaps(box, skd::Segment<3>{ t[0], t[1] }), ofEdge) << i;
    ASSERT_EQ(Overlaps(box, t[0], t[1], t[0]), ofEdge) << i;
    ASSERT_EQ(Overlaps(box, t[1], t[1], t[1]), box.Contains(t[1])) << i;
  }
  EXPECT_GT(met, rounds / 10);
  EXPECT_LT(met, rounds - rounds / 10);
}

/// Rounded from whole numbers by a factor and an offset that are no dyadic fractions.
TEST(BoxOverlap, WhatTouchesIsNeverMissedAtAnyScale)
{
  Random random(12);
  for (const double scale : { 1e-300, 1e-150, 1e-30, 0.1, 1.0, 1e30, 1e150, 1e290 })
  {
    for (int i = 0; i < 30000; ++i)
    {
      const int size = 1 + static_cast<int>(random.Below(6));
      const Box3 box = GridBox(random, size);
      const std::array<Vector3, 3> t{ GridPoint(random, size), GridPoint(random, size),
        GridPoint(random, size) };
      const Box3 scaled(scale * box.Min, scale * box.Max);
      ASSERT_EQ(
        Overlaps(scaled, scale * t[0], scale * t[1], scale * t[2]), MeetsInWholeNumbers(box, t))
        << i << " at scale " << scale;
    }
  }
}

TEST(BoxOverlap, AgreesWithClippingOnRandomTriangles)
{
  Random random(13);
  int disagreements = 0;
  int met = 0;
  for (int i = 0; i < 100000; ++i)
  {
    const Vector3 a = random.Point<3>(-1.0, 1.0);
    Box3 box(a, a);
    box.Add(a + random.Point<3>(0.0, std::pow(10.0, random.In(-6.0, 0.0))));
    const double length = std::pow(10.0, random.In(-5.0, 0.5));
    const Vector3 p = box.Centroid() + (length + box.Diagonal()) * random.Point<3>(-0.7, 0.7);
    const Corners t{ p, p + length * random.Point<3>(-1.0, 1.0),
      p + length * random.Point<3>(-1.0, 1.0) };
    const bool found = Overlaps(box, t[0], t[1], t[2]);
    met += found;
    disagreements += found != !Clipped(t, box).empty();
    if (!Clipped(t, box).empty())
    {
      ASSERT_TRUE(found);
    }
  }
  EXPECT_GT(met, 1000);
  EXPECT_EQ(disagreements, 0);
}

/// Of a sheet of triangles across a grid of boxes, each box that the sheet crosses meets one.
TEST(BoxOverlap, ASheetOfSliversLeavesNoBoxOut)
{
  const int n = 40;
  for (int k = 0; k < n; ++k)
  {
    const double low = static_cast<double>(k) / n;
    const double high = static_cast<double>(k + 1) / n;
    const Box3 box({ { low, low, low } }, { { high, high, high } });
    const double a = 1.0 / 3.0;
    // The plane x + y + z = 3 low + a is across the box; its slivers share edges.
    const double sum = 3.0 * low + a / n;
    bool isMet = false;
    for (int i = -60; i < 60; ++i)
    {
      const double y0 = i / 60.0;
      const double y1 = (i + 1) / 60.0;
      const Vector3 p[4] = { { { sum - y0 - 2.0, y0, 2.0 } }, { { sum - y0 + 2.0, y0, -2.0 } },
        { { sum - y1 + 2.0, y1, -2.0 } }, { { sum - y1 - 2.0, y1, 2.0 } } };
      isMet |= Overlaps(box, p[0], p[1], p[2]) || Overlaps(box, p[0], p[2], p[3]);
    }
    EXPECT_TRUE(isMet) << k;
  }
}

TEST(BoxOverlap, AFlatPolygonMeetsWhatItsTrianglesMeet)
{
  Random random(14);
  for (int i = 0; i < 20000; ++i)
  {
    // A concave arrow in a tilted plane of whole numbers.
    const Vector3 u = GridPoint(random, 3);
    const Vector3 v = GridPoint(random, 3);
    const Vector3 o = GridPoint(random, 5);
    const double flat[4][2] = { { 0, 0 }, { 4, 0 }, { 1, 1 }, { 0, 4 } };
    Vector3 p[4];
    for (int k = 0; k < 4; ++k)
    {
      p[k] = o + flat[k][0] * u + flat[k][1] * v;
    }
    const Box3 box = GridBox(random, 8);
    const bool expected = Overlaps(box, p[0], p[1], p[2]) || Overlaps(box, p[0], p[2], p[3]);
    ASSERT_EQ(skd::OverlapsPolygon(box, p, 4), expected) << i;
  }
}

TEST(BoxOverlap, APolygonInTheFaceOfABoxTouchesIt)
{
  for (const double z : { 0.1, 0.3, 1.0 / 3.0, 1e10 / 7.0 })
  {
    const Vector3 p[5] = { { { -9, -9, z } }, { { 9, -9, z } }, { { 11, 0, z } }, { { 9, 9, z } },
      { { -9, 9, z } } };
    EXPECT_TRUE(skd::OverlapsPolygon(Box3({ { 0, 0, z } }, { { 1, 1, z + z } }), p, 5));
    EXPECT_TRUE(skd::OverlapsPolygon(Box3({ { 0, 0, -z } }, { { 1, 1, z } }), p, 5));
    EXPECT_FALSE(skd::OverlapsPolygon(Box3({ { 0, 0, 1.0001 * z } }, { { 1, 1, 9 * z } }), p, 5));
  }
}

TEST(BoxOverlap, AFlatBoxIsABoxToo)
{
  const Box3 sheet({ { 0, 0, 0.5 } }, { { 1, 1, 0.5 } });
  EXPECT_TRUE(Overlaps(sheet, { { 0.2, 0.2, 0 } }, { { 0.3, 0.2, 1 } }, { { 0.2, 0.3, 1 } }));
  EXPECT_TRUE(Overlaps(sheet, { { 1, 1, 0.5 } }, { { 2, 1, 0.5 } }, { { 1, 2, 0.5 } }));
  EXPECT_FALSE(Overlaps(sheet, { { 2, 0, 0 } }, { { 2, 0, 1 } }, { { 0, 2.1, 0.5 } }));
  EXPECT_FALSE(Overlaps(Box3(), { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } }));
}

}
