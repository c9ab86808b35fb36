// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Search/Tree/AxisLanes.h"
#include "Core/Search/Tree/ShortLanes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace
{

using skd::Lanes;

constexpr int W = 8;
constexpr float NaN = std::numeric_limits<float>::quiet_NaN();
constexpr float Infinity = std::numeric_limits<float>::infinity();
const float A[W] = { 1.0f, -2.0f, 0.0f, 3.5f, NaN, 1.0f, Infinity, 1e-45f };
const float B[W] = { 2.0f, -3.0f, 0.0f, 3.5f, 1.0f, NaN, 1.0f, 1e-45f };

/// Lane by lane the same as `expected(a, b)`, NaN being the same as NaN.
template <class Function>
void ExpectEach(const Lanes<W>& lanes, Function expected)
{
  float got[W];
  lanes.Store(got);
  for (int i = 0; i < W; ++i)
  {
    const float wanted = expected(A[i], B[i]);
    EXPECT_TRUE(got[i] == wanted || (std::isnan(got[i]) && std::isnan(wanted))) << "lane " << i;
  }
}

const Lanes<W> LanesA = Lanes<W>::Load(A);
const Lanes<W> LanesB = Lanes<W>::Load(B);

TEST(Lanes, HoldWhatWasLoaded)
{
  ExpectEach(LanesA, [](float a, float) { return a; });
}

TEST(Lanes, OfOneValueAreAllTheSame)
{
  for (const float value : { 0.0f, 2.5f, -Infinity, NaN })
  {
    ExpectEach(Lanes<W>(value), [value](float, float) { return value; });
  }
}

TEST(Lanes, AddSubtractAndMultiply)
{
  ExpectEach(LanesA + LanesB, [](float a, float b) { return a + b; });
  ExpectEach(LanesA - LanesB, [](float a, float b) { return a - b; });
  ExpectEach(LanesA * LanesB, [](float a, float b) { return a * b; });
  ExpectEach(MinusProduct(LanesA, LanesB, LanesB), [](float a, float b) { return a - b * b; });
}

TEST(Lanes, DivideAndTakeRoots)
{
  ExpectEach(LanesA / LanesB, [](float a, float b) { return a / b; });
  ExpectEach(Sqrt(LanesA), [](float a, float) { return std::sqrt(a); });
}

TEST(Lanes, OfASpreadNumberAreAllTheSame)
{
  ExpectEach(Lanes<W>(skd::Spread(2.5f)), [](float, float) { return 2.5f; });
}

TEST(Lanes, LoadWholeNumbersOf16Bits)
{
  const std::int16_t shorts[W] = { 0, 1, -1, 32767, -32768, 256, -255, 12345 };
  float got[W];
  Lanes<W>::LoadShorts(shorts).Store(got);
  for (int i = 0; i < W; ++i)
  {
    EXPECT_EQ(got[i], static_cast<float>(shorts[i])) << "lane " << i;
  }
}

TEST(Lanes, ChooseLaneByLane)
{
  const Lanes<W> one(1.0f);
  const Lanes<W> two(2.0f);
  ExpectEach(
    IfLessEqual(LanesA, LanesB, one, two), [](float a, float b) { return a <= b ? 1.0f : 2.0f; });
}

TEST(Lanes, MaxAndMinGiveTheSecondWithNaN)
{
  ExpectEach(Max(LanesA, LanesB), [](float a, float b) { return a > b ? a : b; });
  ExpectEach(Min(LanesA, LanesB), [](float a, float b) { return a < b ? a : b; });
}

TEST(Lanes, LessEqualHasABitALaneAndNoneForNaN)
{
  unsigned expected = 0;
  for (int i = 0; i < W; ++i)
  {
    if (A[i] <= B[i])
    {
      expected |= 1u << i;
    }
  }
  EXPECT_EQ(LessEqual(LanesA, LanesB), expected);
  EXPECT_EQ(LessEqual(LanesA, LanesA), 0xefu);
  EXPECT_EQ(LessEqual(Lanes<W>(NaN), LanesB), 0u);
}

constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();

/// Axis by axis the same as `expected(a, b)`.
template <int D, class Got, class Function>
void ExpectEachAxis(const Got& got, const Function& expected)
{
  const skd::Vector<5> a{ { 1.5, -2.0, 0.0, 7.0, -0.25 } };
  const skd::Vector<5> b{ { 2.0, -3.0, 4.0, 7.0, 0.5 } };
  skd::Vector<D> firstA;
  skd::Vector<D> firstB;
  std::copy_n(a.X, D, firstA.X);
  std::copy_n(b.X, D, firstB.X);
  const skd::Vector<D> values = got(skd::AxisLanes<D>(firstA), skd::AxisLanes<D>(firstB)).Values();
  for (int axis = 0; axis < D; ++axis)
  {
    EXPECT_EQ(values[axis], expected(a[axis], b[axis])) << "axis " << axis << " of " << D;
  }
}

template <int D>
void ExpectArithmeticOnAxes()
{
  ExpectEachAxis<D>([](auto a, auto b) { return a + b; }, [](double a, double b) { return a + b; });
  ExpectEachAxis<D>([](auto a, auto b) { return a - b; }, [](double a, double b) { return a - b; });
  ExpectEachAxis<D>([](auto a, auto b) { return a * b; }, [](double a, double b) { return a * b; });
  ExpectEachAxis<D>([](auto a, auto b) { return a / b; }, [](double a, double b) { return a / b; });
  ExpectEachAxis<D>(
    [](auto a, auto b) { return Max(a, b); }, [](double a, double b) { return std::max(a, b); });
  ExpectEachAxis<D>(
    [](auto a, auto b) { return Min(a, b); }, [](double a, double b) { return std::min(a, b); });
  ExpectEachAxis<D>(
    [](auto a, auto) { return Abs(a); }, [](double a, double) { return std::abs(a); });
  ExpectEachAxis<D>([](auto a, auto b) { return TimesSign(a, b); },
    [](double a, double b) { return b < 0.0 ? -a : a; });
  ExpectEachAxis<D>([](auto a, auto) { return skd::AxisLanes<D>(double(a.Signs())); },
    [](double, double) { return double(0x12u & skd::LowBits(D)); });
}

TEST(AxisLanes, DoArithmeticOnEveryAxis)
{
  ExpectArithmeticOnAxes<1>();
  ExpectArithmeticOnAxes<2>();
  ExpectArithmeticOnAxes<3>();
  ExpectArithmeticOnAxes<4>();
  ExpectArithmeticOnAxes<5>();
}

TEST(AxisLanes, AreAllAtMostWithoutNaN)
{
  const skd::AxisLanes<3> least(skd::Vector3{ { 1.0, -2.0, 3.0 } });
  EXPECT_TRUE(AllLessEqual(least, least));
  EXPECT_TRUE(AllLessEqual(least, skd::AxisLanes<3>(3.0)));
  for (int axis = 0; axis < 3; ++axis)
  {
    skd::Vector3 other{ { 0.0, 0.0, 0.0 } };
    other[axis] = 1e-300;
    EXPECT_FALSE(AllLessEqual(skd::AxisLanes<3>(other), skd::AxisLanes<3>(0.0)));
    other[axis] = NotANumber;
    EXPECT_FALSE(AllLessEqual(skd::AxisLanes<3>(other), skd::AxisLanes<3>(0.0)));
    EXPECT_FALSE(AllLessEqual(skd::AxisLanes<3>(0.0), skd::AxisLanes<3>(other)));
  }
}

TEST(AxisLanes, AreStoredAsFloats)
{
  const skd::AxisLanes<3> values(skd::Vector3{ { 96.0, 0.1, -160.0 } });
  float floats[skd::AxisLanes<3>::Room];
  values.StorePadded(floats);
  EXPECT_EQ(floats[0], 96.0f);
  EXPECT_EQ(floats[1], 0.1f);
  EXPECT_EQ(floats[2], -160.0f);
}

TEST(Lanes, HighestBitIsThatOfTheHighestLane)
{
  for (int lane = 0; lane < W; ++lane)
  {
    EXPECT_EQ(skd::HighestBit(1u << lane), lane);
    EXPECT_EQ(skd::HighestBit(1u | 1u << lane), lane);
  }
}

TEST(EightIntegers, AreSumsOfProductsAndTheirSigns)
{
  constexpr std::int16_t least = std::numeric_limits<std::int16_t>::min();
  const skd::ShortPair pairs[W] = { { 0, 0 }, { 1, -1 }, { 8191, 32767 }, { -8191, -32767 },
    { 300, 7 }, { -300, -7 }, { 8191, -32767 }, { least, 1 } };
  const std::uint16_t shifted[W] = { 0, 1, 65534, 65535, 2, 3, 32768, 5 };
  for (const skd::ShortPair with :
    { skd::ShortPair{ 32767, least }, skd::ShortPair{ -2, 100 }, skd::ShortPair{ 1, 0 } })
  {
    const auto sums = skd::EightIntegers::SumsOfProducts(pairs, with);
    const auto others = skd::EightIntegers::Shifted15(shifted);
    unsigned negative = 0, ofSum = 0, ofDifference = 0;
    for (int i = 0; i < W; ++i)
    {
      const auto sum =
        std::uint32_t(pairs[i].First * with.First) + std::uint32_t(pairs[i].Second * with.Second);
      const std::uint32_t other = std::uint32_t(shifted[i]) << 15;
      negative |= (sum >> 31) << i;
      ofSum |= ((sum + other) >> 31) << i;
      ofDifference |= ((other - sum) >> 31) << i;
    }
    EXPECT_EQ(NegativeLanes(sums), negative);
    EXPECT_EQ(NegativeLanes(sums + others), ofSum);
    EXPECT_EQ(NegativeLanes(others - sums), ofDifference);
    EXPECT_EQ(NegativeLanes(sums | (others - sums)), negative | ofDifference);
  }
}

}
