// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Search/Tree/Frame.h"
#include "CoreDimensions.h"

using namespace coretest;

namespace
{

constexpr float FloatInfinity = std::numeric_limits<float>::infinity();
constexpr double Largest = std::numeric_limits<double>::max();

/// Numbers of every size, and those where float ends.
std::vector<double> Numbers()
{
  std::vector<double> numbers{ 0.0, 1.0, 1.0 + 1e-9, 1e-46, 1e-40, 1e38, 3.5e38, Largest,
    std::numeric_limits<double>::denorm_min(), std::numeric_limits<float>::max() };
  Random random(1);
  for (int i = 0; i < 2000; ++i)
  {
    numbers.push_back(std::pow(10.0, random.In(-60.0, 60.0)));
  }
  const std::vector<double> positive = numbers;
  for (const double number : positive)
  {
    numbers.push_back(-number);
  }
  return numbers;
}

TEST(FrameRounding, IsOutward)
{
  for (const double number : Numbers())
  {
    EXPECT_LT(static_cast<double>(skd::Frame<1>::RoundDown(number)), number);
    EXPECT_GT(static_cast<double>(skd::Frame<1>::RoundUp(number)), number);
  }
}

/// One step from the nearest, on either side: so it never depends on how a compiler compares.
TEST(FrameRounding, IsOneStepFromTheNearest)
{
  for (const double number : Numbers())
  {
    if (std::abs(number) < std::numeric_limits<float>::max())
    {
      const float nearest = static_cast<float>(number);
      EXPECT_EQ(skd::Frame<1>::RoundDown(number), std::nextafterf(nearest, -FloatInfinity));
      EXPECT_EQ(skd::Frame<1>::RoundUp(number), std::nextafterf(nearest, FloatInfinity));
    }
  }
}

TEST(FrameRounding, IsMonotone)
{
  std::vector<double> numbers = Numbers();
  std::sort(numbers.begin(), numbers.end());
  for (std::size_t i = 1; i < numbers.size(); ++i)
  {
    EXPECT_LE(skd::Frame<1>::RoundDown(numbers[i - 1]), skd::Frame<1>::RoundDown(numbers[i]));
    EXPECT_LE(skd::Frame<1>::RoundUp(numbers[i - 1]), skd::Frame<1>::RoundUp(numbers[i]));
  }
}

TEST(FrameRounding, BeyondFloatIsInfinityOrTheLargest)
{
  EXPECT_EQ(skd::Frame<1>::RoundUp(1e39), FloatInfinity);
  EXPECT_EQ(skd::Frame<1>::RoundDown(1e39), std::numeric_limits<float>::max());
  EXPECT_EQ(skd::Frame<1>::RoundDown(-1e39), -FloatInfinity);
  EXPECT_EQ(skd::Frame<1>::RoundUp(-1e39), std::numeric_limits<float>::lowest());
}

TEST(FrameRounding, OfNaNIsNaN)
{
  EXPECT_TRUE(std::isnan(skd::Frame<1>::RoundDown(std::numeric_limits<double>::quiet_NaN())));
  EXPECT_TRUE(std::isnan(skd::Frame<1>::RoundUp(std::numeric_limits<double>::quiet_NaN())));
}

template <class Type>
class FrameTest : public ::testing::Test
{
};
TYPED_TEST_SUITE(FrameTest, Dimensions, DimensionNames);

/// The unit box, and the one step that rounding goes outward.
const float One = std::nextafterf(1.0f, 2.0f);

TYPED_TEST(FrameTest, PutsTheSetInTheUnitBoxAndFillsHalfOfIt)
{
  constexpr int D = TypeParam::Value;
  for (const Scene<D>& scene : AllScenes<D>(65, true))
  {
    const skd::Box<D> bounds = BoundsOf(scene.Boxes);
    const skd::FloatBox<D> inFrame = skd::Frame<D>::Of(bounds).Outward(bounds);
    float greatest = 0.0f;
    for (int axis = 0; axis < D; ++axis)
    {
      EXPECT_GE(inFrame.Min[axis], -One) << scene.Name;
      EXPECT_LE(inFrame.Max[axis], One) << scene.Name;
      greatest = std::max(greatest, inFrame.Max[axis]);
    }
    const bool isPoint = bounds.Min == bounds.Max;
    EXPECT_TRUE(isPoint || greatest >= 0.49f) << scene.Name;
  }
}

TYPED_TEST(FrameTest, ScalesByAPowerOfTwo)
{
  constexpr int D = TypeParam::Value;
  for (const double size : { 0.0, 5e-324, 1e-310, 1e-200, 0.3, 1.0, 1e9, 1e200, 0.5 * Largest })
  {
    const auto frame = skd::Frame<D>::Of(skd::Box<D>(Filled<D>(-size), Filled<D>(size)));
    int exponent = 0;
    EXPECT_EQ(std::frexp(frame.Scale, &exponent), 0.5) << size;
    EXPECT_TRUE(std::isfinite(frame.Scale)) << size;
  }
}

TYPED_TEST(FrameTest, HoldsTheLargestSetInTheUnitBox)
{
  constexpr int D = TypeParam::Value;
  const skd::Box<D> bounds(Filled<D>(-Largest), Filled<D>(Largest));
  const skd::FloatBox<D> inFrame = skd::Frame<D>::Of(bounds).Outward(bounds);
  EXPECT_GE(inFrame.Min[0], -One);
  EXPECT_LE(inFrame.Max[0], One);
}

TYPED_TEST(FrameTest, OfNothingIsFinite)
{
  constexpr int D = TypeParam::Value;
  const auto frame = skd::Frame<D>::Of(skd::Box<D>());
  EXPECT_TRUE(IsFinite(frame.Centre));
  EXPECT_EQ(frame.Scale, 1.0);
}

/// What touches in the world touches in the frame, though all coordinates are rounded.
TYPED_TEST(FrameTest, KeepsOrder)
{
  constexpr int D = TypeParam::Value;
  Random random(2);
  for (const double offset : { 0.0, 0.1, 1e9, -1e15 })
  {
    const skd::Box<D> bounds(Filled<D>(offset - 3.0), Filled<D>(offset + 11.0));
    const auto frame = skd::Frame<D>::Of(bounds);
    for (int i = 0; i < 2000; ++i)
    {
      const double a = offset + random.In(-30.0, 30.0);
      const double b = std::nextafter(a, i % 2 == 0 ? Largest : a);
      EXPECT_LE(frame.Down(a, D - 1), frame.Up(a, D - 1));
      EXPECT_LE(frame.Down(a, D - 1), frame.Down(b, D - 1));
      EXPECT_LE(frame.Up(a, D - 1), frame.Up(b, D - 1));
    }
  }
}

TYPED_TEST(FrameTest, OutwardIsTight)
{
  constexpr int D = TypeParam::Value;
  for (const Scene<D>& scene : AllScenes<D>(64, true))
  {
    const auto frame = skd::Frame<D>::Of(BoundsOf(scene.Boxes));
    for (const skd::Box<D>& box : scene.Boxes)
    {
      const skd::FloatBox<D> inFrame = frame.Outward(box);
      for (int axis = 0; axis < D; ++axis)
      {
        const double least = (box.Min[axis] - frame.Centre[axis]) * frame.Scale;
        const double greatest = (box.Max[axis] - frame.Centre[axis]) * frame.Scale;
        EXPECT_NEAR(inFrame.Min[axis], least, std::ldexp(1.0, -23)) << scene.Name;
        EXPECT_NEAR(inFrame.Max[axis], greatest, std::ldexp(1.0, -23)) << scene.Name;
      }
    }
  }
}

TYPED_TEST(FrameTest, UpperBound2IsAboveAndNear)
{
  constexpr int D = TypeParam::Value;
  const auto frame = skd::Frame<D>::Of(skd::Box<D>(Filled<D>(5.0), Filled<D>(6.0)));
  for (const double distance2 : { 1e-30, 0.1, 1.0, 12345.678 })
  {
    const double inFrame = distance2 * frame.Scale * frame.Scale;
    EXPECT_GT(frame.UpperBound2(distance2), inFrame);
    EXPECT_LT(frame.UpperBound2(distance2), inFrame * 1.00001);
  }
}

TYPED_TEST(FrameTest, UpperBound2OfSpecialValues)
{
  constexpr int D = TypeParam::Value;
  const auto frame = skd::Frame<D>::Of(skd::Box<D>(Filled<D>(-1e200), Filled<D>(1e200)));
  EXPECT_GE(frame.UpperBound2(0.0), 0.0f);
  EXPECT_LT(frame.UpperBound2(0.0), 1e-40f);
  EXPECT_EQ(frame.UpperBound2(std::numeric_limits<double>::infinity()), FloatInfinity);
  EXPECT_LT(frame.UpperBound2(-1.0), 1e-40f);
  EXPECT_FALSE(frame.UpperBound2(std::numeric_limits<double>::quiet_NaN()) >= 0.0f);
}

}
