// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// Closed polylines pass through closed meshes an even number of times, whatever they meet.

#include "Core/Geometry/Intersection/SegmentFacet.h"

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <vector>

namespace
{

using skd::Vector3;
using Triangle = std::array<Vector3, 3>;

/// A cube of n^3 cells of size 1 about the origin: all coordinates are whole.
std::vector<Triangle> CubeFaces(int n, const Vector3& origin)
{
  std::vector<Triangle> triangles;
  const auto corner = [&](int axis, int side, int i, int j)
  {
    Vector3 point;
    point[axis] = side * n;
    point[(axis + 1) % 3] = i;
    point[(axis + 2) % 3] = j;
    return origin + point;
  };
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int face = 0; face < 2 * n * n; ++face)
    {
      const int side = face % 2;
      const int i = (face / 2) % n;
      const int j = face / 2 / n;
      const Vector3 a = corner(axis, side, i, j);
      const Vector3 b = corner(axis, side, i + side, j + 1 - side);
      const Vector3 c = corner(axis, side, i + 1, j + 1);
      const Vector3 d = corner(axis, side, i + 1 - side, j + side);
      triangles.push_back({ a, b, c });
      triangles.push_back({ a, c, d });
    }
  }
  return triangles;
}

struct Passes
{
  int Number = 0; ///< with or against the normal
  int Sum = 0;    ///< with less against
};

Passes PassesOf(const std::vector<Triangle>& mesh, const Vector3& from, const Vector3& to)
{
  Passes passes;
  for (const Triangle& triangle : mesh)
  {
    const Vector3 points[3] = { triangle[0], triangle[1], triangle[2] };
    if (const auto hit = skd::MeetFacet({ from, to }, points))
    {
      passes.Number += hit->Passes != 0;
      passes.Sum += hit->Passes;
    }
  }
  return passes;
}

class Whole
{
public:
  explicit Whole(int range)
    : Range(-range, range)
  {
  }
  Vector3 Point()
  {
    return { { 1.0 * this->Range(this->Engine), 1.0 * this->Range(this->Engine),
      1.0 * this->Range(this->Engine) } };
  }

private:
  std::mt19937 Engine{ 7 };
  std::uniform_int_distribution<int> Range;
};

}

TEST(SegmentFacet, HitsTheInside)
{
  const Vector3 points[3] = { { { 0, 0, 0 } }, { { 4, 0, 0 } }, { { 0, 4, 0 } } };
  const auto hit = skd::MeetFacet({ { { 1, 2, -1 } }, { { 1, 2, 3 } } }, points);
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->T, 0.25);
  EXPECT_EQ(hit->R, 0.25);
  EXPECT_EQ(hit->S, 0.5);
  EXPECT_FALSE(hit->OnBoundary);
  EXPECT_EQ(hit->Passes, 1);
  EXPECT_EQ(skd::MeetFacet({ { { 1, 2, 3 } }, { { 1, 2, -1 } } }, points)->Passes, -1);
  EXPECT_FALSE(skd::MeetFacet({ { { 3, 2, -1 } }, { { 3, 2, 3 } } }, points));
  EXPECT_FALSE(skd::MeetFacet({ { { 1, 2, 3 } }, { { 1, 2, 1 } } }, points));
}

TEST(SegmentFacet, NeighboursReportAnEqualParameter)
{
  const Vector3 one[3] = { { { 0, 0, 0 } }, { { 3, 0, 1 } }, { { 1, 3, 7 } } };
  const Vector3 other[3] = { { { 1, 3, 7 } }, { { 3, 0, 1 } }, { { 9, 9, 2 } } };
  const Vector3 onEdge{ { 2, 1.5, 4 } };
  const skd::Segment<3> segment{ { { 1, 0.5, -3 } }, { { 3, 2.5, 11 } } };
  ASSERT_EQ(segment.At(0.5), onEdge);
  const auto first = skd::MeetFacet(segment, one);
  const auto second = skd::MeetFacet(segment, other);
  ASSERT_TRUE(first && second);
  EXPECT_TRUE(first->OnBoundary && second->OnBoundary);
  EXPECT_EQ(first->T, second->T);
}

TEST(SegmentFacet, ClosedPolylinesPassAnEvenNumberOfTimes)
{
  const auto mesh = CubeFaces(2, { { -1, -1, -1 } });
  Whole whole(2); // vertices, edges and faces of the mesh are met all the time
  for (int round = 0; round < 4000; ++round)
  {
    const Vector3 points[4] = { whole.Point(), whole.Point(), whole.Point(), whole.Point() };
    Passes passes;
    for (int i = 0; i < 4; ++i)
    {
      const Passes more = PassesOf(mesh, points[i], points[(i + 1) % 4]);
      passes.Number += more.Number;
      passes.Sum += more.Sum;
    }
    ASSERT_EQ(passes.Number % 2, 0) << "round " << round;
    ASSERT_EQ(passes.Sum, 0) << "round " << round;
  }
}

TEST(SegmentFacet, ClosedPolylinesPassAnEvenNumberOfTimesFarAway)
{
  // Coordinates whose differences are not exact: vertices move, but equal ones stay equal.
  const Vector3 far{ { 1e7 / 3.0, -1e8 / 7.0, 1e6 / 9.0 } };
  auto mesh = CubeFaces(2, { { -1, -1, -1 } });
  for (Triangle& triangle : mesh)
  {
    for (Vector3& point : triangle)
    {
      point = far + 1e-3 * point;
    }
  }
  Whole whole(2);
  for (int round = 0; round < 5000; ++round)
  {
    const Vector3 points[3] = { far + 1e-3 * whole.Point(), far + 1e-3 * whole.Point(),
      far + 1e-3 * whole.Point() };
    int number = 0;
    for (int i = 0; i < 3; ++i)
    {
      number += PassesOf(mesh, points[i], points[(i + 1) % 3]).Number;
    }
    ASSERT_EQ(number % 2, 0) << "round " << round;
  }
}

TEST(SegmentFacet, ALineIntoTheMiddlePassesOnceWhateverItMeets)
{
  const auto mesh = CubeFaces(4, { { -2, -2, -2 } });
  Whole whole(5);
  for (int round = 0; round < 4000; ++round)
  {
    const Vector3 from = whole.Point();
    const double farthest = std::max({ std::abs(from[0]), std::abs(from[1]), std::abs(from[2]) });
    if (farthest > 2.0)
    {
      const Passes passes = PassesOf(mesh, from, { { 0, 0, 0 } });
      ASSERT_EQ(passes.Number, 1) << "round " << round;
      ASSERT_EQ(passes.Sum, -1) << "round " << round;
    }
  }
}

TEST(SegmentFacet, WithoutAreaLengthOrNumbersNothingIsHit)
{
  const Vector3 line[3] = { { { 0, 0, 0 } }, { { 1, 1, 0 } }, { { 2, 2, 0 } } };
  EXPECT_FALSE(skd::MeetFacet({ { { 1, 1, -1 } }, { { 1, 1, 1 } } }, line));
  const Vector3 points[3] = { { { 0, 0, 0 } }, { { 4, 0, 0 } }, { { 0, 4, 0 } } };
  EXPECT_FALSE(skd::MeetFacet({ { { 1, 1, 0 } }, { { 1, 1, 0 } } }, points));
  EXPECT_FALSE(skd::MeetFacet({ { { -1, 1, 0 } }, { { 3, 1, 0 } } }, points)); // edge-on
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(skd::MeetFacet({ { { nan, 1, -1 } }, { { 1, 1, 1 } } }, points));
  const Vector3 holed[3] = { { { 0, nan, 0 } }, { { 4, 0, 0 } }, { { 0, 4, 0 } } };
  EXPECT_FALSE(skd::MeetFacet({ { { 1, 1, -1 } }, { { 1, 1, 1 } } }, holed));
}
