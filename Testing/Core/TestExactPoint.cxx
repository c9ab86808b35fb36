// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Geometry/Predicates/ClosePoint.h"
#include "Core/Geometry/Predicates/ExactPoint.h"
#include "Core/Geometry/Predicates/LongPoint.h"
#include "Core/Geometry/Predicates/Orient3D.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <utility>

namespace
{

using skd::BigNumber;
using skd::ExactPoint;
using skd::Vector3;

double AsDouble(const BigNumber& x)
{
  return BigNumber::Ratio(x, BigNumber(1.0));
}

TEST(BigNumber, IsTheDoubleThatItIsMadeOf)
{
  for (const double x : { 0.0, 1.0, -1.0, 3.5, 1e300, -1e-300, 5e-324, 1.7976931348623157e308, 0.1,
         4294967296.0, 4294967295.0, -1.0 / 3.0 })
  {
    EXPECT_EQ(AsDouble(BigNumber(x)), x);
    EXPECT_EQ(BigNumber(x).Sign(), (x > 0.0) - (x < 0.0));
  }
}

TEST(BigNumber, SumsAndProductsOfWholeNumbersAreExact)
{
  std::mt19937_64 random(1);
  for (int i = 0; i < 2000; ++i)
  {
    const auto draw = [&]
    {
      const int bits = static_cast<int>(random() % 31);
      const auto size = static_cast<long long>(random() & ((1ull << bits) - 1));
      return random() & 1 ? size : -size;
    };
    const long long a = draw(), b = draw(), c = draw();
    const BigNumber x(static_cast<double>(a)), y(static_cast<double>(b)), z(static_cast<double>(c));
    EXPECT_EQ(AsDouble(x + y), static_cast<double>(a + b));
    EXPECT_EQ(AsDouble(x - y), static_cast<double>(a - b));
    const long long exact = a * b - b * c;
    EXPECT_EQ((x * y - y * z - BigNumber(static_cast<double>(exact >> 30)) * BigNumber(0x1p30) -
                BigNumber(static_cast<double>(exact & ((1 << 30) - 1))))
                .Sign(),
      0)
      << a << " " << b << " " << c;
  }
}

TEST(BigNumber, LosesNothingBetweenFarNumbers)
{
  const BigNumber huge(1e300), tiny(1e-300), one(1.0);
  EXPECT_EQ((huge + tiny - huge - tiny).Sign(), 0);
  EXPECT_EQ((huge + tiny - huge).Sign(), 1);
  EXPECT_EQ((huge * huge * tiny * tiny - one * huge * tiny * huge * tiny).Sign(), 0);
  EXPECT_EQ(((huge + tiny) * (huge - tiny) - huge * huge).Sign(), -1);
}

TEST(BigNumber, OfManyDigitsIsCopiedAndMoved)
{
  const BigNumber third(1.0 / 3.0);
  BigNumber power = third;
  for (int factors = 2; factors < 40; ++factors) // of any length
  {
    const BigNumber next = power * third;
    BigNumber copy = next;
    EXPECT_EQ((copy - next).Sign(), 0);
    copy = third; // fewer digits
    EXPECT_EQ((copy - third).Sign(), 0);
    copy = power;
    BigNumber moved = std::move(copy);
    EXPECT_EQ((moved - power).Sign(), 0);
    copy = std::move(moved);
    EXPECT_EQ((copy * third - next).Sign(), 0);
    copy = third;
    power = next;
  }
  EXPECT_NEAR(AsDouble(power) / std::pow(1.0 / 3.0, 39), 1.0, 1e-14);
}

Vector3 Draw(std::mt19937& random, double step)
{
  std::uniform_int_distribution<int> any(-9, 9);
  return { { step * any(random), step * any(random), step * any(random) } };
}

TEST(ExactPoint, SignsAreThoseOfOrient)
{
  std::mt19937 random(2);
  for (int i = 0; i < 1000; ++i)
  {
    const double step = i % 2 ? 1.0 : 0.1;
    const Vector3 a = Draw(random, step), b = Draw(random, step), c = Draw(random, step),
                  d = Draw(random, step);
    EXPECT_EQ(skd::ExactVolume(a, b, c, d).Sign(), skd::Orient3D(a, b, c, d));
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_EQ(skd::ExactArea(ExactPoint(a), ExactPoint(b), ExactPoint(c), axis).Sign(),
        skd::Orient2D(a, b, c, axis));
    }
  }
}

// Seen along the axis: a point in which two segments cross lies on both, exactly, though it has no
// place among the doubles; and so do crossings of segments between such points.
TEST(ExactPoint, CrossingsLieOnWhatTheyCross)
{
  std::mt19937 random(3);
  int count = 0;
  for (int i = 0; i < 3000; ++i)
  {
    Vector3 x[6];
    for (Vector3& p : x)
    {
      p = Draw(random, 0.1);
      p[2] = p[0] - 3.0 * p[1]; // of one plane, nearly
    }
    if (skd::Orient2D(x[0], x[1], x[2], 2) * skd::Orient2D(x[0], x[1], x[3], 2) >= 0 ||
      skd::Orient2D(x[0], x[1], x[4], 2) * skd::Orient2D(x[0], x[1], x[5], 2) >= 0)
    {
      continue;
    }
    ++count;
    const ExactPoint p(x[0]), q(x[1]), r(x[2]), s(x[3]), t(x[4]), u(x[5]);
    const ExactPoint first = skd::ExactCrossing(r, s, p, q, 2);
    const ExactPoint second = skd::ExactCrossing(t, u, p, q, 2);
    EXPECT_GT(first.W.Sign(), 0);
    EXPECT_EQ(skd::ExactArea(p, q, first, 2).Sign(), 0);
    EXPECT_EQ(skd::ExactArea(r, s, first, 2).Sign(), 0);
    EXPECT_EQ(skd::ExactArea(first, second, p, 2).Sign(), 0);
    const int order = skd::ExactCompare(first, second, 0);
    const double gap = first.Rounded()[0] - second.Rounded()[0];
    EXPECT_TRUE(std::abs(gap) < 1e-14 || (gap > 0) == (order > 0));
    EXPECT_EQ(skd::ExactCompare(first, first, 1), 0);
  }
  EXPECT_GT(count, 100);
}

TEST(ExactPoint, AFilterThatDecidesIsRight)
{
  std::mt19937 random(4);
  std::uniform_real_distribution<double> noise(-1e-9, 1e-9);
  int decided = 0;
  for (int i = 0; i < 20000; ++i)
  {
    Vector3 x[3], y[3];
    for (int k = 0; k < 3; ++k)
    {
      x[k] = y[k] = Draw(random, i % 2 ? 1e-8 : 1.0);
      for (double& coordinate : y[k].X)
      {
        coordinate += noise(random);
      }
    }
    const int told = skd::FilteredOrient2D(y[0], y[1], y[2], 2, 1e-9);
    decided += told != 0;
    EXPECT_TRUE(told == 0 || told == skd::Orient2D(x[0], x[1], x[2], 2));
  }
  EXPECT_GT(decided, 5000);
}

/// Where edges cross planes that differ by rounding, points in pairs of doubles are on a line but
/// for that, and their order is the exact one or not told.
TEST(ClosePoint, OrdersPointsAsExactOnesDo)
{
  std::mt19937_64 random(5);
  const auto draw = [&] { return std::uniform_real_distribution<double>(-1.0, 1.0)(random); };
  int told = 0;
  int untold = 0;
  for (int i = 0; i < 2000; ++i)
  {
    const double size = std::ldexp(1.0, static_cast<int>(random() % 61) - 30);
    const auto at = [&] { return Vector3{ { size * draw(), size * draw(), size * draw() } }; };
    const Vector3 a = at(), b = at(), c = at();
    // A triangle of which one corner is off its plane by rounding, so that crossings of it and of
    // another one with a third plane's edges are not on one line.
    const Vector3 d = a + 0.4 * (b - a) + 0.7 * (c - a);
    const Vector3 p = at();
    const Vector3 normal = Cross(b - a, c - a);
    std::array<skd::ClosePoint, 3> close{ skd::ClosePoint(a), skd::ClosePoint(a),
      skd::ClosePoint(a) };
    std::array<ExactPoint, 3> exact{ ExactPoint(a), ExactPoint(a), ExactPoint(a) };
    bool areCrossings = true;
    for (int k = 0; k < 3; ++k)
    {
      // Edges in one plane, through p.
      const Vector3 from = p + (1.0 / size) * draw() * normal;
      const Vector3 to = p + draw() * (b - a) - (1.0 / size) * draw() * normal;
      const Vector3& third = k == 1 ? d : c;
      const int sides = skd::Orient3D(a, b, third, from) * skd::Orient3D(a, b, third, to);
      areCrossings = areCrossings && sides < 0;
      if (areCrossings)
      {
        close[k] = skd::CloseCrossingWithPlane(from, to, a, b, third);
        exact[k] = skd::ExactCrossingWithPlane(from, to, a, b, third);
      }
    }
    for (int axis = 0; axis < 3 && areCrossings; ++axis)
    {
      const int sign = skd::CloseOrient2D(close[0], close[1], close[2], axis);
      const int expected = skd::ExactArea(exact[0], exact[1], exact[2], axis).Sign();
      EXPECT_TRUE(sign == 0 || sign == expected) << i;
      const auto x = exact[0].Rounded();
      EXPECT_NEAR(close[0].X[axis].High, x[axis], 1e-15 * size);
      told += sign != 0 && std::abs(close[0].Error) < 1e-25 * size;
      untold += sign == 0;
    }
  }
  EXPECT_GT(told, 20 * (untold + 1));
}

TEST(ClosePoint, KnowsNothingWithoutACrossing)
{
  const Vector3 a{ { 0, 0, 0 } }, b{ { 1, 0, 0 } }, c{ { 0, 1, 0 } };
  const Vector3 p{ { 0.2, 0.2, 0 } }, q{ { 0.5, 0.3, 0 } };
  EXPECT_TRUE(std::isinf(skd::CloseCrossingWithPlane(p, q, a, b, c).Error)); // in the plane
  const Vector3 tiny{ { 1e-90, 0, 0 } }, other{ { 0, 1e-90, 0 } };
  const Vector3 low{ { 1e-91, 1e-91, -1e-90 } }, high{ { 1e-91, 1e-91, 1e-90 } };
  const skd::ClosePoint none = skd::CloseCrossingWithPlane(low, high, a, tiny, other);
  EXPECT_TRUE(std::isinf(none.Error));
  EXPECT_EQ(skd::CloseOrient2D(none, skd::ClosePoint(b), skd::ClosePoint(c), 2), 0);
}

/// Crossings of lines through crossings, which differ by rounding or less, or not at all.
TEST(LongPoint, OrdersCrossingsAsExactOnesDo)
{
  std::mt19937_64 random(6);
  const auto draw = [&] { return std::uniform_real_distribution<double>(-1.0, 1.0)(random); };
  int told = 0;
  int nearlyOnLine = 0;
  int onLine = 0;
  for (int i = 0; i < 2000; ++i)
  {
    const double size = std::ldexp(1.0, static_cast<int>(random() % 61) - 30);
    const double noise = std::ldexp(size, -static_cast<int>(random() % 54));
    const auto nearby = [&](double x, double y) {
      return ExactPoint(Vector3{ { size * x + noise * draw(), size * y + noise * draw(), 0.0 } });
    };
    std::vector<ExactPoint> crossings; // of lines with nearly one line
    for (const double x : { -0.5, 0.1, 0.7, 0.3 })
    {
      const double slope = draw();
      crossings.push_back(skd::ExactCrossing(
        nearby(-1.0, 0.1), nearby(1.0, 0.2), nearby(x - slope, -1.0), nearby(x + slope, 1.0), 2));
    }
    crossings.push_back(
      skd::ExactCrossing(crossings[0], crossings[1], nearby(0.2, -0.7), nearby(0.4, 1.0), 2));
    const std::array<std::array<int, 3>, 3> triples{ { { 0, 1, 2 }, { 1, 4, 3 }, { 0, 1, 4 } } };
    for (const auto& [a, b, c] : triples)
    {
      const int expected = skd::ExactArea(crossings[a], crossings[b], crossings[c], 2).Sign();
      const int sign = skd::LongOrient2D(skd::LongPoint(crossings[a]), skd::LongPoint(crossings[b]),
        skd::LongPoint(crossings[c]), 2);
      EXPECT_TRUE(sign == 0 || sign == expected) << i;
      told += sign != 0;
      onLine += expected == 0;
      nearlyOnLine += expected != 0 && noise < 0x1p-48 * size;
      EXPECT_TRUE(expected == 0 || sign != 0) << i;
    }
  }
  EXPECT_GE(onLine, 2000);
  EXPECT_GT(nearlyOnLine, 200);
  EXPECT_GT(told, 3900);
}

TEST(LongPoint, IsThePointToTwoHundredBits)
{
  const auto at = [](double x, double y) { return ExactPoint(Vector3{ { x, y, 1e300 } }); };
  const ExactPoint third = skd::ExactCrossing(at(0, 0), at(1, 3), at(0, 1), at(2, 1), 2);
  const skd::LongPoint point(third);
  EXPECT_EQ(AsDouble(point.X[0]), 1.0 / 3.0);
  EXPECT_EQ((point.X[1] - BigNumber(1.0)).Sign(), 0);
  EXPECT_EQ((point.X[2] - BigNumber(1e300)).Sign(), 0);
  BigNumber error = point.X[0] * BigNumber(3.0) - BigNumber(1.0);
  EXPECT_NE(error.Sign(), 0);
  EXPECT_LT(std::abs(AsDouble(error)), 0x1p-200);
  EXPECT_LE(std::abs(AsDouble(error)), 3.0 * std::ldexp(1.0, 32 * point.Error));
  // Nothing is told of points within the error of a line.
  EXPECT_EQ(skd::LongOrient2D(point, point, point, 2), 0);
}

}
