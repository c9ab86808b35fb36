// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// What two segments have in common, against whole numbers.

#include "Core/Geometry/Intersection/SegmentContact.h"

#include <gtest/gtest.h>

#include <random>

namespace
{

using namespace skd;

SegmentContact MeetIn(double scale, const Vector3 (&p)[4])
{
  return Meet(Segment<3>{ scale * p[0], scale * p[1] }, Segment<3>{ scale * p[2], scale * p[3] });
}

/// The same of points on a small lattice, by whole numbers: 0 nothing, 1 a point, 2 a interval.
int CountEnds(const Vector3 (&p)[4])
{
  const Vector3 u = p[1] - p[0];
  const Vector3 v = p[3] - p[2];
  const Vector3 between = p[2] - p[0];
  const Vector3 normal = Cross(u, v);
  if (Norm2(normal) > 0.0)
  {
    const double t = Dot(Cross(between, v), normal); // over the square of the normal
    const double s = Dot(Cross(between, u), normal);
    const double all = Norm2(normal);
    return Dot(between, normal) == 0.0 && t >= 0.0 && t <= all && s >= 0.0 && s <= all;
  }
  if (Norm2(Cross(between, u)) > 0.0)
  {
    return 0;
  }
  const double at[2] = { Dot(between, u), Dot(p[3] - p[0], u) };
  const double begin = std::max(0.0, std::min(at[0], at[1]));
  const double end = std::min(Norm2(u), std::max(at[0], at[1]));
  return begin < end ? 2 : (begin == end ? 1 : 0);
}

}

TEST(SegmentContact, AgreesWithWholeNumbers)
{
  std::mt19937 engine(3);
  int counts[3] = {};
  for (int round = 0; round < 100000; ++round)
  {
    Vector3 p[4];
    for (Vector3& x : p)
    {
      x = { { double(engine() % 4), double(engine() % 4), double(engine() % (1 + round % 3)) } };
    }
    if (p[0] == p[1] || p[2] == p[3])
    {
      continue;
    }
    const int expected = CountEnds(p);
    ++counts[expected];
    for (const double scale : { 1.0, 0x1p-430, 0x1p430 })
    {
      const SegmentContact contact = MeetIn(scale, p);
      ASSERT_EQ(static_cast<int>(contact.Kind), expected) << round;
      for (const SegmentContact::Position& position : { contact.Begin, contact.End })
      {
        const Vector3 gap = Lerp(p[0], p[1], position.T) - Lerp(p[2], p[3], position.S);
        ASSERT_LE(expected > 0 ? Norm(gap) : 0.0, 1e-15 * 8) << round;
      }
      ASSERT_LE(contact.Begin.T, contact.End.T);
    }
  }
  EXPECT_GT(counts[1], 10000);
  EXPECT_GT(counts[2], 500);
}

TEST(SegmentContact, EndsAreReported)
{
  const Vector3 corner{ { 23, 26, 0 } }; // on the line of the others
  const Vector3 a{ { 376, -316, 0 } };
  const Vector3 c{ { 2494, -2382, 0 } };
  const Vector3 d{ { -1389, 1402, 0 } };
  ASSERT_EQ(Orient2D(c, d, corner, 2), 0);
  const SegmentContact contact = Meet(Segment<3>{ a, corner }, Segment<3>{ c, d });
  EXPECT_EQ(contact.Kind, SegmentContact::Point);
  EXPECT_EQ(contact.Begin.T, 1.0);
  EXPECT_NEAR(contact.Begin.S, (2494.0 - 23.0) / (2494.0 + 1389.0), 1e-16);
  EXPECT_EQ(Meet(Segment<3>{ c, d }, Segment<3>{ corner, a }).Begin.S, 0.0);
}
