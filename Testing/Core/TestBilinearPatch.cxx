// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GeometryReference.h"

#include <gtest/gtest.h>

namespace
{

using coretest::Dice;
using skd::ClosestPointOnPatch;
using skd::PatchPoint;
using skd::Vector3;

/// Four points, and how such a quad is called.
struct PatchKind
{
  const char* Name;
  void (*Shape)(Vector3* p, Dice& dice);
};

void Warped(Vector3*, Dice&) {}

void Parallelogram(Vector3* p, Dice&)
{
  p[2] = p[1] + (p[3] - p[0]);
}

void NearlyFlat(Vector3* p, Dice& dice)
{
  p[2] = p[1] + (p[3] - p[0]) + dice.Point(0.1);
}

void Concave(Vector3* p, Dice& dice)
{
  p[2] = p[0] + dice.Between(0.05, 0.4) * ((p[1] - p[0]) + (p[3] - p[0]));
}

void Crossed(Vector3* p, Dice&)
{
  const Vector3 far = p[1] + (p[3] - p[0]);
  p[2] = p[3];
  p[3] = far;
}

void CollapsedToTriangle(Vector3* p, Dice& dice)
{
  p[3] = p[dice.Below(3)];
}

void CollapsedToSegment(Vector3* p, Dice& dice)
{
  const bool isAlongR = dice.Below(2) == 0;
  p[isAlongR ? 3 : 1] = p[0];
  p[2] = p[isAlongR ? 1 : 3];
}

void CollapsedToPoint(Vector3* p, Dice&)
{
  p[1] = p[2] = p[3] = p[0];
}

void Needle(Vector3* p, Dice& dice)
{
  p[3] = p[1] + std::pow(10.0, -dice.Between(0.0, 15.0)) * dice.Point(1.0);
  p[2] = p[1] + (p[3] - p[0]);
}

void Saddle(Vector3* p, Dice& dice)
{
  const double height = dice.Between(0.1, 3.0);
  p[0] = { { -1.0, -1.0, height } };
  p[1] = { { 1.0, -1.0, -height } };
  p[2] = { { 1.0, 1.0, height } };
  p[3] = { { -1.0, 1.0, -height } };
}

void PrintTo(const PatchKind& kind, std::ostream* os)
{
  *os << kind.Name;
}

class PatchKinds : public ::testing::TestWithParam<PatchKind>
{
protected:
  Dice Random{ 12 };
  Vector3 Points[4];

  void MakePatch()
  {
    for (Vector3& point : this->Points)
    {
      point = this->Random.Point(1.0);
    }
    GetParam().Shape(this->Points, this->Random);
  }

  void MovePatch(const Vector3& by)
  {
    for (Vector3& point : this->Points)
    {
      point = point + by;
    }
  }

  Vector3 PointOnPatch()
  {
    const double r = this->Random.Between(0.0, 1.0);
    const double s = this->Random.Between(0.0, 1.0);
    const Vector3* p = this->Points;
    return skd::Lerp(skd::Lerp(p[0], p[1], r), skd::Lerp(p[3], p[2], r), s);
  }

  /// Whether the parameters are in their range, and give the point.
  void ExpectConsistent(const PatchPoint& found, const Vector3& x, double tolerance)
  {
    EXPECT_TRUE(found.R >= 0.0 && found.R <= 1.0 && found.S >= 0.0 && found.S <= 1.0);
    const double there =
      static_cast<double>(coretest::PatchDistance(this->Points, x, found.R, found.S));
    EXPECT_NEAR(there, std::sqrt(found.Dist2), tolerance);
    EXPECT_NEAR(skd::Norm(found.Point - x), std::sqrt(found.Dist2), tolerance);
  }
};

TEST_P(PatchKinds, NoPositionOnThePatchIsNearer)
{
  for (int i = 0; i < 150; ++i)
  {
    this->MakePatch();
    const Vector3 x = this->Random.Point(1.5);
    const PatchPoint found = ClosestPointOnPatch(this->Points, x);
    EXPECT_LE(std::sqrt(found.Dist2), coretest::PatchDistance(this->Points, x) + 4e-15);
    this->ExpectConsistent(found, x, 4e-15);
  }
}

TEST_P(PatchKinds, APointOfThePatchIsOnIt)
{
  for (int i = 0; i < 1000; ++i)
  {
    this->MakePatch();
    const Vector3 x = this->PointOnPatch();
    const PatchPoint found = ClosestPointOnPatch(this->Points, x);
    EXPECT_LE(std::sqrt(found.Dist2), 4e-15);
    this->ExpectConsistent(found, x, 4e-15);
  }
}

TEST_P(PatchKinds, FarPointsFindTheirNearestToo)
{
  for (int i = 0; i < 50; ++i)
  {
    this->MakePatch();
    const Vector3 x = this->Random.Point(1000.0);
    const double distance = std::sqrt(ClosestPointOnPatch(this->Points, x).Dist2);
    EXPECT_NEAR(distance, coretest::PatchDistance(this->Points, x), 1e-15 * distance);
  }
}

TEST_P(PatchKinds, ALargeCommonOffsetCostsNothingMore)
{
  for (int i = 0; i < 50; ++i)
  {
    this->MakePatch();
    const Vector3 offset = this->Random.Point(std::pow(10.0, this->Random.Between(6.0, 9.0)));
    this->MovePatch(offset);
    const Vector3 x = offset + this->Random.Point(1.5);
    const PatchPoint found = ClosestPointOnPatch(this->Points, x);
    EXPECT_LE(std::sqrt(found.Dist2), coretest::PatchDistance(this->Points, x) + 4e-15);
  }
}

TEST_P(PatchKinds, WorksAtAllScales)
{
  for (const double scale : { 1e-50, 1e-20, 1e20, 1e50 })
  {
    this->MakePatch();
    const Vector3 x = this->Random.Point(1.5);
    const double plain = std::sqrt(ClosestPointOnPatch(this->Points, x).Dist2);
    for (Vector3& point : this->Points)
    {
      point = scale * point;
    }
    EXPECT_NEAR(
      std::sqrt(ClosestPointOnPatch(this->Points, scale * x).Dist2) / scale, plain, 4e-15);
  }
}

TEST_P(PatchKinds, ALimitHidesOnlyWhatIsBeyondIt)
{
  for (int i = 0; i < 300; ++i)
  {
    this->MakePatch();
    const Vector3 x = this->Random.Point(3.0);
    const double dist2 = ClosestPointOnPatch(this->Points, x).Dist2;
    EXPECT_EQ(ClosestPointOnPatch(this->Points, x, dist2 * (1.0 + 1e-12) + 1e-30).Dist2, dist2);
    EXPECT_GE(ClosestPointOnPatch(this->Points, x, 0.25 * dist2).Dist2, dist2);
  }
}

TEST_P(PatchKinds, NaNGivesNoDistance)
{
  this->MakePatch();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(ClosestPointOnPatch(this->Points, { { nan, 0.0, 0.0 } }).Dist2 < 1e300);
  EXPECT_FALSE(ClosestPointOnPatch(this->Points, { { 0.0, 0.0, nan } }, 1.0).Dist2 < 1e300);
}

INSTANTIATE_TEST_SUITE_P(BilinearPatch, PatchKinds,
  ::testing::Values(PatchKind{ "Warped", Warped }, PatchKind{ "Parallelogram", Parallelogram },
    PatchKind{ "NearlyFlat", NearlyFlat }, PatchKind{ "Concave", Concave },
    PatchKind{ "Crossed", Crossed }, PatchKind{ "CollapsedToTriangle", CollapsedToTriangle },
    PatchKind{ "CollapsedToSegment", CollapsedToSegment },
    PatchKind{ "CollapsedToPoint", CollapsedToPoint }, PatchKind{ "Needle", Needle },
    PatchKind{ "Saddle", Saddle }),
  [](const auto& info) { return std::string(info.param.Name); });

TEST(ClosestPointOnPatch, OnAnEdgeIsThatOfTheSegmentToTheLastBit)
{
  Dice dice(13);
  int onEdge = 0;
  for (int i = 0; i < 1000; ++i)
  {
    const Vector3 p[4] = { dice.Point(1.0), dice.Point(1.0), dice.Point(1.0), dice.Point(1.0) };
    const Vector3 x = dice.Point(4.0);
    const PatchPoint found = ClosestPointOnPatch(p, x);
    if (found.S == 0.0 && found.R > 0.0 && found.R < 1.0)
    {
      const skd::SegmentPoint<3> onSegment = skd::ClosestPointOnSegment(p[1], p[0], x);
      EXPECT_EQ(found.Point, onSegment.Point);
      EXPECT_EQ(found.Dist2, onSegment.Dist2);
      ++onEdge;
    }
  }
  EXPECT_GT(onEdge, 50);
}

// On the axis of a saddle two opposite corners, or two curves, are equally near.
TEST(ClosestPointOnPatch, OfTwoEquallyNearPositionsEitherWillDo)
{
  const Vector3 p[4] = { { { -1.0, -1.0, 2.0 } }, { { 1.0, -1.0, -2.0 } }, { { 1.0, 1.0, 2.0 } },
    { { -1.0, 1.0, -2.0 } } };
  for (const double height : { -5.0, -1.0, -0.5, 0.0, 0.5, 1.0, 5.0 })
  {
    const Vector3 x{ { 0.0, 0.0, height } };
    EXPECT_NEAR(std::sqrt(ClosestPointOnPatch(p, x).Dist2), coretest::PatchDistance(p, x), 4e-15);
  }
}

TEST(VisitRisingRoots, FindsWhereAPolynomialRises)
{
  // (t - 0.25) (t - 0.5) (t - 0.75) rises at the first and the last root.
  const skd::BernsteinPolynomial<3> cubic{ { -0.09375, 0.135416666666666657, -0.135416666666666657,
    0.09375 } };
  std::vector<double> roots;
  skd::VisitRisingRoots(cubic, [&](double t) { roots.push_back(t); });
  ASSERT_EQ(roots.size(), 2u);
  std::sort(roots.begin(), roots.end());
  EXPECT_NEAR(roots[0], 0.25, 1e-14);
  EXPECT_NEAR(roots[1], 0.75, 1e-14);
}

}
