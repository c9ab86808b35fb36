// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Search/Tree/Lanes.h"

#include <gtest/gtest.h>

#include <cmath>
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

}
