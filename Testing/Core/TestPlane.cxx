// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Geometry/Plane.h"
#include "CoreDimensions.h"

using namespace coretest;

namespace
{

template <class Type>
class PlaneTest : public ::testing::Test
{
public:
  static constexpr int D = Type::Value;
  const skd::Box<D> Unit{ Filled<D>(0.0), Filled<D>(1.0) };
};
TYPED_TEST_SUITE(PlaneTest, Dimensions, DimensionNames);

/// The least distance of the box's corners to the plane, 0 when there are some on both sides.
template <int D>
double DistanceOfCorners(const skd::Plane<D>& plane, const skd::Box<D>& box)
{
  double least = std::numeric_limits<double>::max();
  double greatest = std::numeric_limits<double>::lowest();
  for (unsigned int corner = 0; corner < (1u << D); ++corner)
  {
    skd::Vector<D> x;
    for (int axis = 0; axis < D; ++axis)
    {
      x[axis] = (corner >> axis) & 1u ? box.Max[axis] : box.Min[axis];
    }
    const double height = Dot(plane.Normal, x - plane.Origin);
    least = std::min(least, height);
    greatest = std::max(greatest, height);
  }
  return std::max({ 0.0, least, -greatest });
}

TYPED_TEST(PlaneTest, OverlapsWhenTheCornersComeWithinTheTolerance)
{
  constexpr int D = TypeParam::Value;
  Random random(1);
  for (int i = 0; i < 1000; ++i)
  {
    const skd::Plane<D> plane{ random.Point<D>(-2.0, 3.0), random.Direction<D>() };
    const double distance = DistanceOfCorners(plane, this->Unit);
    EXPECT_TRUE(Overlaps(plane, this->Unit, distance + 1e-12));
    EXPECT_TRUE(distance == 0.0 || !Overlaps(plane, this->Unit, distance - 1e-12));
  }
}

TYPED_TEST(PlaneTest, OverlapsABoxThatItTouches)
{
  constexpr int D = TypeParam::Value;
  for (int axis = 0; axis < D; ++axis)
  {
    skd::Plane<D> plane{ Filled<D>(7.0), Along<D>(axis, 1.0) };
    plane.Origin[axis] = 1.0;
    EXPECT_TRUE(Overlaps(plane, this->Unit, 0.0));
    plane.Origin[axis] = std::nextafter(1.0, 2.0);
    EXPECT_FALSE(Overlaps(plane, this->Unit, 0.0));
  }
}

TYPED_TEST(PlaneTest, TurnedRoundOverlapsTheSame)
{
  constexpr int D = TypeParam::Value;
  Random random(2);
  for (int i = 0; i < 100; ++i)
  {
    const skd::Plane<D> plane{ random.Point<D>(-2.0, 3.0), random.Direction<D>() };
    const skd::Plane<D> rotated{ plane.Origin, -1.0 * plane.Normal };
    EXPECT_EQ(Overlaps(plane, this->Unit, 0.1), Overlaps(rotated, this->Unit, 0.1));
  }
}

TYPED_TEST(PlaneTest, WithNaNOverlapsNothing)
{
  constexpr int D = TypeParam::Value;
  skd::Plane<D> plane{ Filled<D>(0.5), Along<D>(0, 1.0) };
  plane.Origin[0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(Overlaps(plane, this->Unit, 0.0));
}

}
