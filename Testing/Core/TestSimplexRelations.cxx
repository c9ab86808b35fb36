// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Geometry/Simplices/SimplexCover.h"
#include "Core/Geometry/Simplices/SimplexInteriors.h"
#include "CoreScenes.h"

#include <gtest/gtest.h>

using namespace coretest;

namespace
{

using skd::Box3;
using skd::SimplexSet;
using skd::Vector3;

constexpr double Tolerance = 1e-14;

SimplexSet Make(int dimension, const std::vector<Vector3>& points,
  const std::vector<SimplexSet::Simplex>& simplices)
{
  SimplexSet set;
  set.Clear(dimension);
  for (const Vector3& x : points)
  {
    set.Add(x);
  }
  set.Simplices = simplices;
  set.FindRim();
  return set;
}

Box3 Cube(double low, double high)
{
  return { { { low, low, low } }, { { high, high, high } } };
}

/// A box that is not known to be convex, so that all witnesses are tested.
SimplexSet Plain(const Box3& box)
{
  SimplexSet set = skd::MakeBox(box);
  set.IsConvex = false;
  return set;
}

Box3 HalfBox(Random& random)
{
  Box3 box;
  for (int i = 0; i < 2; ++i)
  {
    Vector3 x;
    for (int axis = 0; axis < 3; ++axis)
    {
      x[axis] = 0.5 * static_cast<double>(random.Below(7));
    }
    box.Add(x);
  }
  return box;
}

SimplexSet RandomSet(Random& random)
{
  const auto point = [&]() { return random.Point<3>(0.0, 1.0); };
  const Vector3 offset = random.Point<3>(-1.0, 1.0);
  const std::vector<Vector3> p = { point() + offset, point() + offset, point() + offset,
    point() + offset };
  switch (random.Below(4))
  {
    case 0:
      return Make(0, { p[0], p[1] }, { { 0, 0, 0 }, { 1, 1, 1 } });
    case 1:
      return Make(1, { p[0], p[1], p[2] }, { { 0, 1, 1 }, { 1, 2, 2 } });
    case 2:
      return Make(2, p, { { 0, 1, 2 }, { 1, 2, 3 } });
    default:
      return Make(3, p, { { 0, 1, 2 }, { 0, 1, 3 }, { 0, 2, 3 }, { 1, 2, 3 } });
  }
}

/// A point of the set: of a solid a mean of its points.
Vector3 PointOf(const SimplexSet& set, Random& random)
{
  Vector3 sum{ { 0, 0, 0 } };
  double total = 0.0;
  const auto& simplex = set.Simplices[random.Below(set.Simplices.size())];
  for (int i = 0; i < (set.Dimension == 3 ? 4 : 3); ++i)
  {
    const double share = random.In(0.0, 1.0);
    const Vector3& x = set.Dimension == 3 ? set.Points[static_cast<std::size_t>(i)]
                                          : set.Points[static_cast<std::size_t>(simplex[i])];
    sum = sum + share * x;
    total += share;
  }
  return (1.0 / total) * sum;
}

/// `test(a, b, distance, random)` for so many pairs of random sets.
template <class Test>
void ForPairsOfSets(int seed, int count, const Test& test)
{
  Random random(seed);
  for (int i = 0; i < count; ++i)
  {
    SCOPED_TRACE(i);
    const SimplexSet a = RandomSet(random);
    const SimplexSet b = RandomSet(random);
    test(a, b, std::sqrt(skd::MinDistance2(a, b)), random);
  }
}

TEST(SimplexSet, DistancesAreThoseOfPointsAsNearAndFarAsPointsCanBe)
{
  const auto test = [](const SimplexSet& a, const SimplexSet& b, double least, Random& random)
  {
    EXPECT_EQ(least, std::sqrt(skd::MinDistance2(b, a)));
    const double most = std::sqrt(skd::MaxDistance2(a, b));
    for (int k = 0; k < 50; ++k)
    {
      const Vector3 x = PointOf(a, random);
      const double toB = std::sqrt(skd::MinDistance2(b, x));
      EXPECT_LE(least, toB + 1e-12);
      const double between = std::sqrt(skd::Distance2(x, PointOf(b, random)));
      EXPECT_GE(most, between - 1e-12);
      EXPECT_LE(toB, between + 1e-12);
    }
  };
  ForPairsOfSets(2, 300, test);
}

/// By alternate projection from a point of one onto the other: slow, and never too near.
double DistanceByProjection(const SimplexSet& a, const SimplexSet& b, Random& random)
{
  double least = std::numeric_limits<double>::infinity();
  for (int start = 0; start < 30; ++start)
  {
    Vector3 x = PointOf(a, random);
    for (int i = 0; i < 300; ++i)
    {
      const auto nearestOn = [](const SimplexSet& set, const Vector3& from)
      {
        skd::TrianglePoint best{ from, 0, 0, std::numeric_limits<double>::infinity() };
        for (const auto& simplex : set.Simplices)
        {
          const auto p = set.Corners(simplex);
          const skd::TrianglePoint next = skd::ClosestPointOnTriangle(p[0], p[1], p[2], from);
          best = next.Dist2 < best.Dist2 ? next : best;
        }
        return skd::Encloses(set, from) ? from : best.Point;
      };
      x = nearestOn(a, nearestOn(b, x));
    }
    least = std::min(least, std::sqrt(skd::MinDistance2(b, x)));
  }
  return least;
}

TEST(SimplexSet, LeastDistancesAreReached)
{
  const auto test = [](const SimplexSet& a, const SimplexSet& b, double least, Random& random)
  {
    const double projected = DistanceByProjection(a, b, random);
    EXPECT_LE(least, projected + 1e-12);
    EXPECT_NEAR(least, projected, 2e-2);
  };
  ForPairsOfSets(3, 60, test);
}

TEST(SimplexSet, BoxesHaveTheDistancesOfBoxes)
{
  Random random(4);
  for (int i = 0; i < 500; ++i)
  {
    const Box3 a = HalfBox(random);
    const Box3 b = HalfBox(random);
    EXPECT_EQ(skd::MinDistance2(skd::MakeBox(a), skd::MakeBox(b)), skd::MinDistance2(a, b));
    EXPECT_EQ(skd::MaxDistance2(skd::MakeBox(a), skd::MakeBox(b)), skd::MaxDistance2(a, b));
  }
}

TEST(SimplexRelations, BoxesCoverWhatTheyContain)
{
  Random random(5);
  for (int i = 0; i < 3000; ++i)
  {
    const Box3 a = HalfBox(random);
    const Box3 b = HalfBox(random);
    EXPECT_EQ(skd::Covers(skd::MakeBox(a), skd::MakeBox(b), Tolerance), a.Contains(b));
    EXPECT_EQ(skd::Covers(Plain(a), Plain(b), Tolerance), a.Contains(b)) << i;
    EXPECT_TRUE(skd::Covers(Plain(a), Plain(a), Tolerance));
  }
}

TEST(SimplexRelations, InteriorsOfBoxesMeetWhereIntervalsDo)
{
  Random random(6);
  for (int i = 0; i < 3000; ++i)
  {
    const Box3 a = HalfBox(random);
    const Box3 b = HalfBox(random);
    bool meet = true;
    for (int axis = 0; axis < 3; ++axis)
    {
      const bool isFlatA = a.Length(axis) == 0.0;
      const bool isFlatB = b.Length(axis) == 0.0;
      const double low = std::max(a.Min[axis], b.Min[axis]);
      const double high = std::min(a.Max[axis], b.Max[axis]);
      const double at = isFlatA ? a.Min[axis] : b.Min[axis];
      const Box3& other = isFlatA ? b : a;
      const bool isStrict = other.Min[axis] < at && at < other.Max[axis];
      meet = meet &&
        (isFlatA && isFlatB      ? low == high
            : isFlatA || isFlatB ? isStrict
                                 : low < high);
    }
    EXPECT_EQ(skd::InteriorsIntersect(skd::MakeBox(a), skd::MakeBox(b), Tolerance), meet) << i;
  }
}

TEST(SimplexRelations, AHollowIsNotCovered)
{
  // A cube with a cavity, and a cube around the cavity.
  SimplexSet whole = Plain(Cube(0, 4));
  const SimplexSet cavity = Plain(Cube(1.5, 2.5));
  const int first = static_cast<int>(whole.Points.size());
  for (const Vector3& x : cavity.Points)
  {
    whole.Add(x);
  }
  for (const auto& simplex : cavity.Simplices)
  {
    whole.AddSimplex(first + simplex[0], first + simplex[1], first + simplex[2]);
  }
  EXPECT_FALSE(skd::Covers(whole, Plain(Cube(1, 3)), Tolerance));
  EXPECT_FALSE(skd::Covers(whole, Plain(Cube(1.75, 2.25)), Tolerance));
  EXPECT_TRUE(skd::Covers(whole, Plain(Cube(0, 1)), Tolerance));
  EXPECT_TRUE(skd::Covers(whole, Plain({ { { 0, 0, 0 } }, { { 4, 4, 1.5 } } }), Tolerance));
  EXPECT_FALSE(skd::Covers(whole, Plain({ { { 0, 0, 0 } }, { { 4, 4, 1.625 } } }), Tolerance));
}

TEST(SimplexRelations, SurfacesCoverAcrossTheirInnerEdgesOnly)
{
  // Two triangles side by side in one plane, and a third that is bent up.
  const SimplexSet whole =
    Make(2, { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 1, 1, 0 } }, { { 2, 0, 1 } } },
      { { 0, 1, 2 }, { 1, 3, 2 }, { 1, 4, 3 } });
  const auto covers = [&](const Vector3& a, const Vector3& b, const Vector3& c) {
    return skd::Covers(whole, Make(2, { a, b, c }, { { 0, 1, 2 } }), Tolerance);
  };
  EXPECT_TRUE(covers({ { 0.25, 0.25, 0 } }, { { 0.75, 0.25, 0 } }, { { 0.75, 0.75, 0 } }));
  EXPECT_FALSE(covers({ { 0.25, 0.25, 0 } }, { { 1.25, 0.25, 0 } }, { { 0.75, 0.75, 0 } }));
  EXPECT_FALSE(covers({ { 0.25, 0.25, 0 } }, { { 0.75, 0.25, 0 } }, { { 1.25, 0.5, 0.25 } }));
  const SimplexSet crease = skd::MakeSegment({ { { 1, 0.25, 0 } }, { { 1, 0.75, 0 } } });
  EXPECT_TRUE(skd::Covers(whole, crease, Tolerance));
  const SimplexSet bridge = skd::MakeSegment({ { { 0.5, 0.5, 0 } }, { { 1.5, 0.25, 0.5 } } });
  EXPECT_FALSE(skd::Covers(whole, bridge, Tolerance));
}

TEST(SimplexRelations, RimsAreWhereSurfacesAndCurvesEnd)
{
  EXPECT_EQ(skd::MakeBox(Cube(0, 1)).Rim.size(), 0u);
  EXPECT_EQ(skd::MakeBox({ { { 0, 0, 0 } }, { { 1, 1, 0 } } }).Rim.size(), 4u);
  EXPECT_EQ(skd::MakeSegment({ { { 0, 0, 0 } }, { { 1, 1, 0 } } }).Rim.size(), 2u);
  EXPECT_EQ(skd::MakeSegment({ { { 1, 1, 0 } }, { { 1, 1, 0 } } }).Dimension, 0);
}

}
