// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Geometry/Segment.h"
#include "CoreDimensions.h"

using namespace coretest;

namespace
{

template <class Type>
class ClipTest : public ::testing::Test
{
public:
  static constexpr int D = Type::Value;
  const skd::Box<D> Unit{ Filled<D>(0.0), Filled<D>(1.0) };
};
TYPED_TEST_SUITE(ClipTest, Dimensions, DimensionNames);

TYPED_TEST(ClipTest, AgreesWithSampling)
{
  constexpr int D = TypeParam::Value;
  Random random(1);
  for (int i = 0; i < 500; ++i)
  {
    const skd::Segment<D> segment{ random.Point<D>(-0.5, 1.5), random.Point<D>(-0.5, 1.5) };
    const std::optional<skd::Interval> inside = skd::Clip(segment, this->Unit);
    for (double t = 0.0; t <= 1.0; t += 1.0 / 64.0)
    {
      const bool isExpected = inside && inside->Min <= t && t <= inside->Max;
      EXPECT_EQ(this->Unit.Contains(segment.At(t)), isExpected) << "segment " << i << " at " << t;
    }
  }
}

TYPED_TEST(ClipTest, OfASegmentInsideIsAllOfIt)
{
  constexpr int D = TypeParam::Value;
  const auto inside = skd::Clip(skd::Segment<D>{ Filled<D>(0.25), Filled<D>(0.75) }, this->Unit);
  ASSERT_TRUE(inside);
  EXPECT_EQ(inside->Min, 0.0);
  EXPECT_EQ(inside->Max, 1.0);
}

TYPED_TEST(ClipTest, OfADiagonalIsTheMiddleThird)
{
  constexpr int D = TypeParam::Value;
  const auto inside = skd::Clip(skd::Segment<D>{ Filled<D>(-1.0), Filled<D>(2.0) }, this->Unit);
  ASSERT_TRUE(inside);
  EXPECT_DOUBLE_EQ(inside->Min, 1.0 / 3.0);
  EXPECT_DOUBLE_EQ(inside->Max, 2.0 / 3.0);
}

TYPED_TEST(ClipTest, OfAnEndOnAFaceIsThatEnd)
{
  constexpr int D = TypeParam::Value;
  Random random(2);
  for (int axis = 0; axis < D; ++axis)
  {
    skd::Segment<D> segment{ random.Point<D>(0.0, 1.0), random.Point<D>(0.0, 1.0) };
    segment.A[axis] = -random.In(0.1, 3.0);
    segment.B[axis] = 0.0;
    const auto inside = skd::Clip(segment, this->Unit);
    ASSERT_TRUE(inside) << "axis " << axis;
    EXPECT_EQ(inside->Min, 1.0);
    EXPECT_EQ(inside->Max, 1.0);
  }
}

TYPED_TEST(ClipTest, BesideTheBoxIsNothing)
{
  constexpr int D = TypeParam::Value;
  for (int axis = 0; axis < D; ++axis)
  {
    const skd::Vector<D> step = Along<D>(axis, std::nextafter(1.0, 2.0));
    const skd::Segment<D> segment{ step, step + Along<D>((axis + 1) % D, 0.5) };
    EXPECT_FALSE(skd::Clip(segment, this->Unit)) << "axis " << axis;
  }
}

TYPED_TEST(ClipTest, AlongAFaceIsInside)
{
  constexpr int D = TypeParam::Value;
  for (int axis = 0; axis < D; ++axis)
  {
    skd::Segment<D> segment{ Filled<D>(1.0), Filled<D>(1.0) };
    segment.A[axis] = -3.0;
    const auto inside = skd::Clip(segment, this->Unit);
    ASSERT_TRUE(inside) << "axis " << axis;
    EXPECT_EQ(inside->Min, 0.75);
    EXPECT_EQ(inside->Max, 1.0);
  }
}

TYPED_TEST(ClipTest, OfAPointIsAllOrNothing)
{
  constexpr int D = TypeParam::Value;
  const auto at = [this](double x) {
    return skd::Clip(skd::Segment<D>{ Filled<D>(x), Filled<D>(x) }, this->Unit);
  };
  ASSERT_TRUE(at(1.0));
  EXPECT_EQ(at(1.0)->Min, 0.0);
  EXPECT_EQ(at(1.0)->Max, 1.0);
  EXPECT_FALSE(at(std::nextafter(1.0, 2.0)));
}

TYPED_TEST(ClipTest, ReversedIsTheSameInterval)
{
  constexpr int D = TypeParam::Value;
  Random random(3);
  for (int i = 0; i < 200; ++i)
  {
    const skd::Segment<D> there{ random.Point<D>(-1.0, 2.0), random.Point<D>(-1.0, 2.0) };
    const skd::Segment<D> back{ there.B, there.A };
    const auto inside = skd::Clip(there, this->Unit);
    const auto reversed = skd::Clip(back, this->Unit);
    ASSERT_EQ(inside.has_value(), reversed.has_value());
    if (inside)
    {
      EXPECT_NEAR(inside->Min, 1.0 - reversed->Max, 1e-12);
      EXPECT_NEAR(inside->Max, 1.0 - reversed->Min, 1e-12);
    }
  }
}

TYPED_TEST(ClipTest, WithAnEmptyBoxIsNothing)
{
  constexpr int D = TypeParam::Value;
  const skd::Segment<D> segment{ Filled<D>(-1.0), Filled<D>(2.0) };
  EXPECT_FALSE(skd::Clip(segment, skd::Box<D>()));
}

TYPED_TEST(ClipTest, WithNaNAnywhereIsNothing)
{
  constexpr int D = TypeParam::Value;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const skd::Segment<D> good{ Filled<D>(-1.0), Filled<D>(2.0) };
  for (int axis = 0; axis < D; ++axis)
  {
    skd::Segment<D> bad = good;
    bad.A[axis] = nan;
    EXPECT_FALSE(skd::Clip(bad, this->Unit));
    bad = good;
    bad.B[axis] = nan;
    EXPECT_FALSE(skd::Clip(bad, this->Unit));
    skd::Box<D> box = this->Unit;
    box.Min[axis] = nan;
    EXPECT_FALSE(skd::Clip(good, box));
    box = this->Unit;
    box.Max[axis] = nan;
    EXPECT_FALSE(skd::Clip(good, box));
  }
}

/// A larger box never loses a segment: trees clip to the bounds of all before anything else.
TYPED_TEST(ClipTest, OfALargerBoxIsNoLess)
{
  constexpr int D = TypeParam::Value;
  Random random(4);
  for (int i = 0; i < 2000; ++i)
  {
    const skd::Vector<D> corner = random.Corner(this->Unit);
    const skd::Vector<D> away = random.Direction<D>();
    const skd::Segment<D> grazing{ corner - away, corner + random.In(0.0, 9.0) * away };
    const auto small = skd::Clip(grazing, this->Unit);
    const auto large = skd::Clip(grazing, this->Unit.Inflated(random.In(0.0, 1e-15)));
    if (small)
    {
      ASSERT_TRUE(large);
      EXPECT_LE(large->Min, small->Min);
      EXPECT_GE(large->Max, small->Max);
    }
  }
}

}
