// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Geometry/Vector.h"

#include <gtest/gtest.h>

#include <limits>

namespace
{

using skd::Vector3;

const Vector3 A{ { 1.0, -2.0, 3.0 } };
const Vector3 B{ { 4.0, 0.5, -6.0 } };

TEST(Vector, AddsAndSubtracts)
{
  EXPECT_TRUE(A + B == (Vector3{ { 5.0, -1.5, -3.0 } }));
  EXPECT_TRUE(A - B == (Vector3{ { -3.0, -2.5, 9.0 } }));
}

TEST(Vector, Scales)
{
  EXPECT_TRUE(2.0 * A == (Vector3{ { 2.0, -4.0, 6.0 } }));
}

TEST(Vector, MeasuresLengthsAndDistances)
{
  EXPECT_EQ(skd::Norm2(A), 14.0);
  EXPECT_EQ(skd::Norm(Vector3{ { 2.0, 3.0, 6.0 } }), 7.0);
  EXPECT_EQ(skd::Distance2(A, B), 9.0 + 6.25 + 81.0);
}

TEST(Vector, CrossIsPerpendicularAndRightHanded)
{
  EXPECT_EQ(skd::Dot(skd::Cross(A, B), A), 0.0);
  EXPECT_EQ(skd::Dot(skd::Cross(A, B), B), 0.0);
  EXPECT_TRUE(
    skd::Cross(Vector3{ { 1, 0, 0 } }, Vector3{ { 0, 1, 0 } }) == (Vector3{ { 0, 0, 1 } }));
}

TEST(Vector, LerpGoesFromTheFirstToTheSecond)
{
  EXPECT_TRUE(skd::Lerp(A, B, 0.0) == A);
  EXPECT_TRUE(skd::Lerp(A, B, 1.0) == B);
  EXPECT_TRUE(skd::Lerp(A, B, 0.5) == (Vector3{ { 2.5, -0.75, -1.5 } }));
}

TEST(Vector, IsOrderedByTheFirstCoordinateThatDiffers)
{
  EXPECT_TRUE((Vector3{ { 1, 2, 3 } } < Vector3{ { 1, 3, 0 } }));
  EXPECT_FALSE((Vector3{ { 1, 3, 0 } } < Vector3{ { 1, 2, 3 } }));
  EXPECT_FALSE((A < A));
}

TEST(Vector, EqualityWithNaNIsFalse)
{
  const Vector3 nan{ { 1.0, std::numeric_limits<double>::quiet_NaN(), 0.0 } };
  EXPECT_FALSE(nan == nan);
}

TEST(Vector, OnlyFiniteCoordinatesAreFinite)
{
  EXPECT_TRUE(skd::IsFinite(A));
  for (const double bad : { std::numeric_limits<double>::infinity(),
         -std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN() })
  {
    EXPECT_FALSE(skd::IsFinite(Vector3{ { 0.0, 0.0, bad } }));
  }
}

}
