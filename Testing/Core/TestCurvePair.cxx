// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// Common points of two curves, where they are known.

#include "Core/Curves/CurvePairSolver.h"

#include "CurveScenes.h"

#include <gtest/gtest.h>

#include <random>

namespace
{

using namespace skd;

/// A quarter of the circle about the origin, by quarters.
BezierCurve Quarter(double radius, int quarter, const Vector3& centre = {})
{
  static constexpr double points[4][2] = { { 1, 0 }, { 0, 1 }, { -1, 0 }, { 0, -1 } };
  const double* from = points[quarter % 4];
  const double* to = points[(quarter + 1) % 4];
  BezierCurve curve;
  curve.Degree = 2;
  const auto position = [&](double x, double y) {
    return centre + Vector3{ { radius * x, radius * y, 0.0 } };
  };
  curve.Points[0] = Weighted(position(from[0], from[1]), 1.0);
  curve.Points[1] = Weighted(position(from[0] + to[0], from[1] + to[1]), M_SQRT1_2);
  curve.Points[2] = Weighted(position(to[0], to[1]), 1.0);
  return curve;
}

/// The graph of a cubic polynomial with the given values of y at x = 0, 1/3, 2/3, 1.
BezierCurve Graph(const double (&controls)[4])
{
  BezierCurve curve;
  curve.Degree = 3;
  for (int i = 0; i < 4; ++i)
  {
    curve.Points[i] = Weighted({ { i / 3.0, controls[i], 0.0 } }, 1.0);
  }
  return curve;
}

std::vector<CurvePairHit> Solve(const BezierCurve& a, const BezierCurve& b)
{
  CurvePairSolver solver;
  return solver.Solve(a, b, 4e-15);
}

}

TEST(CurvePair, LinesCross)
{
  const auto hits = Solve(BezierCurve::Line({ { 0, 0, 0 } }, { { 4, 4, 4 } }),
    BezierCurve::Line({ { 0, 4, 1 } }, { { 4, 0, 1 } }));
  EXPECT_TRUE(hits.empty()); // one above the other
  const auto intersection = Solve(BezierCurve::Line({ { 0, 0, 0 } }, { { 4, 4, 4 } }),
    BezierCurve::Line({ { 0, 2, 1 } }, { { 2, 0, 1 } }));
  ASSERT_EQ(intersection.size(), 1u);
  EXPECT_NEAR(intersection[0].T, 0.25, 1e-15);
  EXPECT_NEAR(intersection[0].S, 0.5, 1e-15);
}

TEST(CurvePair, LinesThatMeetInAnEnd)
{
  const auto hits = Solve(BezierCurve::Line({ { 0, 0, 0 } }, { { 1, 0, 0 } }),
    BezierCurve::Line({ { 1, 0, 0 } }, { { 1, 1, 0 } }));
  ASSERT_EQ(hits.size(), 1u);
  EXPECT_EQ(hits[0].T, 1.0);
  EXPECT_EQ(hits[0].S, 0.0);
}

TEST(CurvePair, LinesThatOverlap)
{
  const auto hits = Solve(BezierCurve::Line({ { 0, 0, 0 } }, { { 3, 3, 3 } }),
    BezierCurve::Line({ { 2, 2, 2 } }, { { 6, 6, 6 } }));
  ASSERT_EQ(hits.size(), 2u);
  EXPECT_EQ(hits[0].Kind, IntersectionKind::OverlapEnd);
  EXPECT_NEAR(hits[0].T, 2.0 / 3.0, 1e-14);
  EXPECT_EQ(hits[0].S, 0.0);
  EXPECT_EQ(hits[1].T, 1.0);
  EXPECT_NEAR(hits[1].S, 0.25, 1e-14);
  // In line, but apart; and end to end.
  EXPECT_TRUE(Solve(BezierCurve::Line({ { 0, 0, 0 } }, { { 1, 1, 1 } }),
    BezierCurve::Line({ { 2, 2, 2 } }, { { 6, 6, 6 } }))
                .empty());
  const auto touching = Solve(BezierCurve::Line({ { 0, 0, 0 } }, { { 2, 2, 2 } }),
    BezierCurve::Line({ { 2, 2, 2 } }, { { 6, 6, 6 } }));
  ASSERT_EQ(touching.size(), 1u);
  EXPECT_EQ(touching[0].Kind, IntersectionKind::Touching);
}

TEST(CurvePair, CirclesCross)
{
  // Two unit circles, one unit apart: x = 1/2.
  int count = 0;
  for (int i = 0; i < 16; ++i)
  {
    for (const CurvePairHit& hit : Solve(Quarter(1.0, i % 4), Quarter(1.0, i / 4, { { 1, 0, 0 } })))
    {
      EXPECT_NEAR(hit.X[0], 0.5, 1e-15);
      EXPECT_NEAR(std::abs(hit.X[1]), std::sqrt(0.75), 1e-15);
      ++count;
    }
  }
  EXPECT_EQ(count, 2);
}

TEST(CurvePair, CirclesTouch)
{
  // Inside each other at (cos, sin) of 30 degrees.
  const Vector3 centre{ { 0.5 * std::sqrt(0.75), 0.25, 0 } };
  const auto hits = Solve(Quarter(1.0, 0), Quarter(0.5, 0, centre));
  ASSERT_EQ(hits.size(), 1u);
  EXPECT_EQ(hits[0].Kind, IntersectionKind::Touching);
  EXPECT_NEAR(hits[0].X[0], std::sqrt(0.75), 1e-11);
  EXPECT_NEAR(hits[0].X[1], 0.5, 1e-11);
  const Vector3 apart{ { 0.5 * std::sqrt(0.75) - 1e-9, 0.25, 0 } };
  EXPECT_TRUE(Solve(Quarter(1.0, 0), Quarter(0.5, 0, apart)).empty());
}

TEST(CurvePair, EqualCirclesOverlap)
{
  const auto hits = Solve(Quarter(1.0, 0), Quarter(1.0, 0));
  ASSERT_EQ(hits.size(), 2u);
  EXPECT_EQ(hits[0].Kind, IntersectionKind::OverlapEnd);
  EXPECT_EQ(hits[0].T, 0.0);
  EXPECT_EQ(hits[1].T, 1.0);
  // The same arc from the middle on, made anew.
  const auto half = Solve(Quarter(1.0, 0), Quarter(1.0, 0).Restricted(0.5, 1.0));
  ASSERT_EQ(half.size(), 2u);
  EXPECT_NEAR(half[0].T, 0.5, 1e-13);
}

TEST(CurvePair, CubicsCrossNineTimes)
{
  // Chebyshev's polynomial over [0, 1], and the same with x and y exchanged.
  const BezierCurve graph = Graph({ 0.0, 3.0, -2.0, 1.0 });
  BezierCurve rotated = graph;
  for (int i = 0; i < 4; ++i)
  {
    std::swap(rotated.Points[i][0], rotated.Points[i][1]);
  }
  const auto hits = Solve(graph, rotated);
  EXPECT_EQ(hits.size(), 9u);
  for (const CurvePairHit& hit : hits)
  {
    EXPECT_LE(hit.Gap, 8e-15);
    EXPECT_EQ(hit.Kind, IntersectionKind::Crossing);
  }
}

TEST(CurvePair, ADoubleAndATripleRoot)
{
  const BezierCurve line = BezierCurve::Line({ { -1, 0, 0 } }, { { 2, 0, 0 } });
  // y = (x - 1/2)^2, and y = (x - 1/2)^3
  const auto twice = Solve(Graph({ 0.25, -1.0 / 12, -1.0 / 12, 0.25 }), line);
  ASSERT_EQ(twice.size(), 1u);
  EXPECT_EQ(twice[0].Kind, IntersectionKind::Touching);
  EXPECT_NEAR(twice[0].T, 0.5, 1e-12);
  const auto thrice = Solve(Graph({ -0.125, 0.125, -0.125, 0.125 }), line);
  ASSERT_EQ(thrice.size(), 1u);
  EXPECT_NEAR(thrice[0].T, 0.5, 1e-5);
  // A little higher and lower.
  EXPECT_TRUE(
    Solve(Graph({ .25 + 1e-12, -1.0 / 12 + 1e-12, -1.0 / 12 + 1e-12, .25 + 1e-12 }), line).empty());
  const auto apart =
    Solve(Graph({ .25 - 1e-12, -1.0 / 12 - 1e-12, -1.0 / 12 - 1e-12, .25 - 1e-12 }), line);
  ASSERT_EQ(apart.size(), 2u);
  EXPECT_NEAR(apart[1].T - apart[0].T, 2e-6, 1e-8);
}

TEST(CurvePair, NearMissesAreNoHits)
{
  std::mt19937 engine(11);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  const auto random = [&]
  {
    BezierCurve curve;
    curve.Degree = 3;
    for (int i = 0; i < 4; ++i)
    {
      curve.Points[i] = Weighted({ { number(engine), number(engine), 0.0 } }, 1.0);
    }
    return curve;
  };
  int crossings = 0;
  for (int round = 0; round < 500; ++round)
  {
    const BezierCurve a = random();
    BezierCurve b = random();
    const auto flat = Solve(a, b);
    crossings += static_cast<int>(flat.size());
    for (const CurvePairHit& hit : flat)
    {
      EXPECT_LE(hit.Gap, 8e-15);
    }
    for (int i = 0; i < 4; ++i)
    {
      b.Points[i][2] = 1e-12;
    }
    EXPECT_TRUE(Solve(a, b).empty());
  }
  EXPECT_GT(crossings, 200);
}

// A quadric of any curve, not only of one of the two.
TEST(SeparatingQuadric, SeparatesNoCurvesThatMeet)
{
  std::mt19937 engine(7);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  const auto point = [&] { return Vector3{ { any(engine), any(engine), any(engine) } }; };
  for (int round = 0; round < 2000; ++round)
  {
    BezierCurve curves[3];
    for (BezierCurve& curve : curves)
    {
      curve.Degree = 1 + static_cast<int>(engine() % MaximumDegree);
      const double size = std::pow(10.0, 3.0 * any(engine) - 3.0);
      for (int i = 0; i <= curve.Degree; ++i)
      {
        curve.Points[i] = Weighted(size * point(), round % 2 ? 1.0 : 1.5 + any(engine));
      }
    }
    const Vector3 shift = curves[0].At(0.3).X - curves[1].At(0.6).X;
    for (int i = 0; i <= curves[1].Degree; ++i)
    {
      curves[1].Points[i] = Weighted(curves[1].Control(i) + shift, curves[1].Points[i][3]);
    }
    for (const BezierCurve& bent : curves)
    {
      EXPECT_FALSE(SeparatingQuadric(bent.At(0.5)).Separates(curves[0], curves[1], 8e-16)) << round;
    }
  }
}

TEST(SeparatingQuadric, SeparatesCirclesAboutOneCentre)
{
  const BezierCurve circle = Quarter(1.0, 0);
  for (double gap : { 1e-3, 1e-9, 1e-13, -1e-13, -1e-9 })
  {
    const BezierCurve other = Quarter(1.0 + gap, 0);
    EXPECT_TRUE(SeparatingQuadric(circle.At(0.5)).Separates(other, circle, 4e-15)) << gap;
    EXPECT_FALSE(SeparatingQuadric(circle.At(0.5)).Separates(other, circle, 2.0 * std::abs(gap)))
      << gap;
    EXPECT_TRUE(Solve(other, circle).empty()) << gap;
  }
}

TEST(SeparatingQuadric, OfALineIsNone)
{
  const BezierCurve line = BezierCurve::Line({ { 0, 0, 0 } }, { { 1, 0, 0 } });
  EXPECT_FALSE(SeparatingQuadric(line.At(0.5)).Separates(line, Quarter(9.0, 0), 0.0));
}

namespace
{

const BezierCurve Axis = BezierCurve::Line({ { -1.25, 0, 0 } }, { { 2, 0, 0 } });

/// What they have in common, whichever comes first.
std::vector<CurvePairHit> SolveBothWays(const BezierCurve& a, const BezierCurve& b)
{
  const auto hits = Solve(a, b);
  EXPECT_EQ(Solve(b, a).size(), hits.size());
  return hits;
}

}

TEST(CurvePair, RootsOfOddOrderAreOneCrossing)
{
  for (const int degree : { 3, 5, 7, 9 })
  {
    for (const double root : { 0.0, 0.125, 0.3, 0.5, 0.875, 1.0 })
    {
      for (const double slope : { 0.0, 1e-16, 1e-13, 1e-11, 1e-10, 1e-6 })
      {
        const auto hits = SolveBothWays(coretest::Power(degree, root, slope, 0.0, 1), Axis);
        ASSERT_EQ(hits.size(), 1u) << degree << " at " << root << " with " << slope;
        EXPECT_EQ(hits[0].Kind, IntersectionKind::Crossing)
          << degree << " " << root << " " << slope;
        EXPECT_NEAR(hits[0].T, root, std::pow(4e-15, 1.0 / degree)) << degree << " " << root;
      }
    }
  }
}

TEST(CurvePair, RootsOfEvenOrderAreOneTouch)
{
  for (const int degree : { 2, 4, 6, 8 })
  {
    for (const double root : { 0.0, 0.125, 0.3, 0.5, 0.875, 1.0 })
    {
      const auto hits = SolveBothWays(coretest::Power(degree, root, 0.0, 0.0, 1), Axis);
      ASSERT_EQ(hits.size(), 1u) << degree << " at " << root;
      EXPECT_EQ(hits[0].Kind, IntersectionKind::Touching) << degree << " at " << root;
    }
  }
}

TEST(CurvePair, CrossingsAtSmallAnglesAreFoundWhereverTheCurveIsCut)
{
  for (double slope = 0.1; slope > 1e-6; slope *= 0.3)
  {
    for (int k = 0; k <= 8; ++k)
    {
      const BezierCurve curve =
        coretest::Power(2, k / 8.0, slope, 0.0, 1); // also crosses at k / 8 - slope
      const std::size_t expected = k / 8.0 > slope ? 2 : 1;
      ASSERT_EQ(SolveBothWays(curve, Axis).size(), expected) << k << " with " << slope;
      for (const double end : { 0.0, 1.0 }) // each part reports it
      {
        if (k / 8.0 != end)
        {
          const auto hits =
            SolveBothWays(curve.Restricted(std::min(end, k / 8.0), std::max(end, k / 8.0)), Axis);
          ASSERT_FALSE(hits.empty()) << k << " with " << slope;
          EXPECT_EQ(end == 0.0 ? hits.back().T : hits.front().T, 1.0 - end) << k << " " << slope;
        }
      }
    }
  }
}

TEST(CurvePair, LinesOfRoundedCoordinatesRunAlongEachOther)
{
  std::mt19937 engine(5);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  for (int round = 0; round < 1000; ++round)
  {
    const Vector3 a{ { any(engine), any(engine), any(engine) } };
    const Vector3 b{ { any(engine), any(engine), any(engine) } };
    const auto hits = SolveBothWays(BezierCurve::Line(a, b),
      BezierCurve::Line(Lerp(a, b, 0.3), Lerp(a, b, 0.3 + 0.01 * any(engine))));
    ASSERT_EQ(hits.size(), 2u) << round;
    EXPECT_EQ(hits[0].Kind, IntersectionKind::OverlapEnd);
  }
}

// Two curves through a common point at a given angle, wherever on both; both ends and where curves
// are halved among them.
TEST(CurvePair, NoCrossingAtASmallAngleIsLost)
{
  std::mt19937 engine(1);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  constexpr double tolerance = 8e-15;
  for (int round = 0; round < 1800; ++round)
  {
    BezierCurve curves[2];
    double positions[2];
    for (int which = 0; which < 2; ++which)
    {
      BezierCurve& curve = curves[which];
      curve.Degree = 1 + static_cast<int>(engine() % 4);
      for (int i = 0; i <= curve.Degree; ++i)
      {
        const Vector3 x{ { any(engine), any(engine), round % 2 ? 0.0 : any(engine) } };
        curve.Points[i] = Weighted(x, round % 5 ? 1.0 : 1.5 + any(engine));
      }
      const auto eighths = static_cast<double>(engine() % 9);
      positions[which] = engine() % 2 ? 0.125 * eighths : 0.5 + 0.5 * any(engine);
    }
    const CurvePoint at = curves[0].At(positions[0]);
    const CurvePoint from = curves[1].At(positions[1]);
    const double angle = std::pow(10.0, -(round % 9));
    const Vector3 along = (1.0 / Norm(at.D1)) * at.D1;
    Vector3 side = Cross({ { 0, 0, 1 } }, along);
    side = (1.0 / Norm(side)) * side;
    const Vector3 wanted = std::cos(angle) * along + std::sin(angle) * side;
    const Vector3 axis = Cross((1.0 / Norm(from.D1)) * from.D1, wanted);
    const double cosine = Dot(from.D1, wanted) / Norm(from.D1);
    for (int i = 0; i <= curves[1].Degree; ++i)
    {
      const Vector3 x = curves[1].Control(i) - from.X;
      const Vector3 rotated =
        cosine * x + Cross(axis, x) + (Dot(axis, x) / (1.0 + cosine)) * axis; // Rodrigues's
      curves[1].Points[i] = Weighted(at.X + rotated, curves[1].Points[i][3]);
    }
    for (int first = 0; first < 2; ++first)
    {
      CurvePairSolver solver;
      const auto& hits = solver.Solve(curves[first], curves[1 - first], tolerance);
      const auto isThere = [&](const CurvePairHit& hit)
      {
        return std::abs(hit.T - positions[first]) <= 1e-9 + hit.SlackT &&
          std::abs(hit.S - positions[1 - first]) <= 1e-9 + hit.SlackS;
      };
      EXPECT_GE(std::count_if(hits.begin(), hits.end(), isThere), 1) << round << " at " << angle;
    }
  }
}
