// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// Common points of curves and patches, where they are known.

#include "Core/Curves/CurvePatchSolver.h"

#include "CurveScenes.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace
{

using namespace skd;

/// Quarter circles' control points: cosine, sine, weight.
constexpr double Quarter[3][3] = { { 1, 0, 1 }, { 1, 1, M_SQRT1_2 }, { 0, 1, 1 } };

/// The patch of a torus about z that begins at (phi, theta) quarters.
BezierPatch TorusPatch(double R, double r, int phi, int theta)
{
  const auto rotated = [](const double(&p)[3], int quarters, double(&out)[2])
  {
    static constexpr int cosines[4] = { 1, 0, -1, 0 };
    const int c = cosines[quarters % 4];
    const int s = cosines[(quarters + 3) % 4];
    out[0] = c * p[0] - s * p[1];
    out[1] = s * p[0] + c * p[1];
  };
  BezierPatch patch;
  patch.DegreeR = patch.DegreeS = 2;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      double around[2];
      double tube[2];
      rotated(Quarter[i], phi, around);
      rotated(Quarter[j], theta, tube);
      const double radius = R + r * tube[0];
      patch.Point(i, j) = Weighted(
        { { radius * around[0], radius * around[1], r * tube[1] } }, Quarter[i][2] * Quarter[j][2]);
    }
  }
  return patch;
}

struct Found
{
  std::vector<double> T;
  std::vector<IntersectionKind> Kinds;
  int Sum = 0;
};

/// Of all patches of the torus; points that two patches share once.
Found OnTorus(const BezierCurve& curve, double tolerance = 4e-15)
{
  CurvePatchSolver solver;
  std::vector<CurvePatchHit> all;
  for (int patch = 0; patch < 16; ++patch)
  {
    const auto& hits = solver.Solve(curve, TorusPatch(1.0, 0.25, patch % 4, patch / 4), tolerance);
    all.insert(all.end(), hits.begin(), hits.end());
  }
  std::sort(all.begin(), all.end(),
    [](const CurvePatchHit& a, const CurvePatchHit& b) { return a.T < b.T; });
  Found found;
  for (const CurvePatchHit& hit : all)
  {
    if (found.T.empty() || hit.T - found.T.back() > hit.Slack)
    {
      found.T.push_back(hit.T);
      found.Kinds.push_back(hit.Kind);
      found.Sum += hit.Passes;
    }
  }
  return found;
}

BezierCurve LineFrom(const Vector3& origin, const Vector3& direction, double length)
{
  return BezierCurve::Line(origin, origin + (length / Norm(direction)) * direction);
}

}

TEST(CurvePatch, ALineCrossesATorusFourTimes)
{
  const Found found = OnTorus(LineFrom({ { -2, .1, -.05 } }, { { 1, .02, .03 } }, 4.0));
  const double expected[4] = { 0.75730656177192833, 1.2610417307475993, 2.7377575606421169,
    3.2367005100859674 };
  ASSERT_EQ(found.T.size(), 4u);
  for (int i = 0; i < 4; ++i)
  {
    EXPECT_NEAR(4.0 * found.T[i], expected[i], 1e-12 * expected[i]);
    EXPECT_EQ(found.Kinds[i], IntersectionKind::Crossing);
  }
  EXPECT_EQ(found.Sum, 0);
}

TEST(CurvePatch, ALineTouchesATorus)
{
  const Found found = OnTorus(LineFrom({ { -2, 1.25, 0 } }, { { 1, 0, 0 } }, 4.3));
  ASSERT_EQ(found.T.size(), 1u);
  EXPECT_NEAR(4.3 * found.T[0], 2.0, 1e-12);
  EXPECT_EQ(found.Kinds[0], IntersectionKind::Touching);
}

TEST(CurvePatch, ALineCutsATorusCloseByTwice)
{
  const Found found = OnTorus(LineFrom({ { -2, 1.249999, 0 } }, { { 1, 0, 0 } }, 4.3));
  ASSERT_EQ(found.T.size(), 2u);
  EXPECT_NEAR(4.3 * found.T[0] - 2.0, -1.581138513856392e-3, 1e-12);
  EXPECT_NEAR(4.3 * found.T[1] - 2.0, 1.581138513856392e-3, 1e-12);
}

TEST(CurvePatch, ALineMissesATorusCloseBy)
{
  EXPECT_TRUE(OnTorus(LineFrom({ { -2, 1.250001, 0 } }, { { 1, 0, 0 } }, 4.3)).T.empty());
}

TEST(CurvePatch, ALineMeetsATorusInAFourfoldRoot)
{
  const Found found = OnTorus(LineFrom({ { -2, 1, .25 } }, { { 1, 0, 0 } }, 4.3));
  ASSERT_EQ(found.T.size(), 1u);
  EXPECT_NEAR(4.3 * found.T[0], 2.0, 1e-5); // it is known to the fourth root of rounding
  EXPECT_EQ(found.Kinds[0], IntersectionKind::Touching);
}

TEST(CurvePatch, ACircleOfATorusRunsWithinIt)
{
  BezierCurve circle; // a quarter of the tube at phi = 45 degrees
  circle.Degree = 2;
  for (int i = 0; i < 3; ++i)
  {
    const double radius = 1.0 + 0.25 * Quarter[i][0];
    circle.Points[i] =
      Weighted({ { M_SQRT1_2 * radius, M_SQRT1_2 * radius, .25 * Quarter[i][1] } }, Quarter[i][2]);
  }
  CurvePatchSolver solver;
  const auto& hits = solver.Solve(circle, TorusPatch(1.0, 0.25, 0, 0), 4e-15);
  ASSERT_EQ(hits.size(), 2u);
  EXPECT_EQ(hits[0].Kind, IntersectionKind::OverlapEnd);
  EXPECT_TRUE(hits[0].Begins);
  EXPECT_NEAR(hits[0].T, 0.0, 1e-9);
  EXPECT_NEAR(hits[1].T, 1.0, 1e-9);
}

TEST(CurvePatch, APatchWhoseSidesEndWhereTheyBegin)
{
  // A cubic loop drawn along z: from side to side there is no way along r.
  BezierPatch patch;
  patch.DegreeR = 3;
  const double loop[4][2] = { { 0, 0 }, { 4, 3 }, { -4, 3 }, { 0, 0 } };
  for (int i = 0; i < 4; ++i)
  {
    patch.Point(i, 0) = Weighted({ { loop[i][0], loop[i][1], 0 } }, 1.0);
    patch.Point(i, 1) = Weighted({ { loop[i][0], loop[i][1], 2 } }, 1.0);
  }
  CurvePatchSolver solver;
  const auto& hits =
    solver.Solve(BezierCurve::Line({ { -3, 1, 1 } }, { { 3, 1, 1 } }), patch, 4e-15);
  ASSERT_EQ(hits.size(), 2u);
  EXPECT_NEAR(hits[0].X[0], -hits[1].X[0], 1e-14);
  EXPECT_EQ(hits[0].Passes, -hits[1].Passes);
}

TEST(CurvePatch, RandomLinesCrossTheTorusEvenly)
{
  std::mt19937 engine(3);
  std::uniform_real_distribution<double> number(-1.3, 1.3);
  for (int round = 0; round < 300; ++round)
  {
    const Vector3 through{ { number(engine), number(engine), 0.2 * number(engine) } };
    const Vector3 direction{ { number(engine), number(engine), number(engine) } };
    const double length = 8.0;
    const Found found =
      OnTorus(LineFrom(through - (4.0 / Norm(direction)) * direction, direction, length));
    EXPECT_EQ(found.T.size() % 2, 0u) << round;
    EXPECT_EQ(found.Sum, 0) << round;
    for (const double t : found.T)
    {
      const Vector3 x = through + (length * t - 4.0) / Norm(direction) * direction;
      const double tube = std::hypot(std::hypot(x[0], x[1]) - 1.0, x[2]);
      EXPECT_NEAR(tube, 0.25, 1e-13);
    }
  }
}

TEST(SeparatingQuadric, SeparatesNoCurveFromAPatchThatItMeets)
{
  std::mt19937 engine(9);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  const auto point = [&](double size) {
    return size * Vector3{ { any(engine), any(engine), any(engine) } };
  };
  for (int round = 0; round < 1000; ++round)
  {
    const double size = std::pow(10.0, 3.0 * any(engine) - 3.0);
    const auto weight = [&] { return round % 2 ? 1.0 : 1.5 + any(engine); };
    BezierPatch patch;
    patch.DegreeR = 1 + static_cast<int>(engine() % 4);
    patch.DegreeS = 1 + static_cast<int>(engine() % 4);
    for (int i = 0; i < patch.Size(); ++i)
    {
      patch.Points[i] = Weighted(point(size), weight());
    }
    BezierCurve curve;
    curve.Degree = 1 + static_cast<int>(engine() % MaximumDegree);
    for (int i = 0; i <= curve.Degree; ++i)
    {
      curve.Points[i] = Weighted(point(0.1 * size), weight());
    }
    const Vector3 shift = patch.At(0.2, 0.7).X - curve.At(0.4).X;
    for (int i = 0; i <= curve.Degree; ++i)
    {
      curve.Points[i] = Weighted(curve.Control(i) + shift, curve.Points[i][3]);
    }
    EXPECT_FALSE(SeparatingQuadric(patch).Separates(curve, patch, 8e-16)) << round;
    EXPECT_FALSE(SeparatingQuadric(curve.At(0.4)).Separates(curve, patch, 8e-16)) << round;
  }
}

namespace
{

/// A part of z = 0.
BezierPatch Plane(bool isTriangle)
{
  BezierPatch plane;
  plane.DegreeR = plane.DegreeS = 1;
  plane.IsTriangle = isTriangle;
  for (int i = 0; i < 2; ++i)
  {
    for (int j = 0; j < 2; ++j)
    {
      plane.Point(i, j) = Weighted({ { 8.0 * i - 2.0, 8.0 * j - 2.0, 0.0 } }, 1.0);
    }
  }
  return plane;
}

}

TEST(CurvePatch, RootsOfAnyOrderAreOnePosition)
{
  CurvePatchSolver solver;
  for (const int degree : { 2, 3, 4, 5, 8, 9 })
  {
    for (const double root : { 0.0, 0.3, 0.5, 1.0 })
    {
      for (const double slope : { 0.0, 1e-14, 1e-11, 1e-6 })
      {
        const bool isOdd = degree % 2 == 1;
        for (int turn = 0; turn < 4 && (isOdd || slope == 0.0); ++turn)
        {
          BezierCurve curve = coretest::Power(degree, root, slope, 0.5, 2);
          for (int i = 0; i <= degree && turn % 2; ++i)
          {
            curve.Points[i][2] *= -1.0;
          }
          const auto& hits = solver.Solve(curve, Plane(turn > 1), 4e-15);
          ASSERT_EQ(hits.size(), 1u) << degree << " at " << root << " with " << slope;
          EXPECT_EQ(hits[0].Kind, isOdd ? IntersectionKind::Crossing : IntersectionKind::Touching)
            << degree;
          EXPECT_EQ(hits[0].Passes, isOdd ? (turn % 2 ? -1 : 1) : 0) << degree << " at " << root;
          EXPECT_NEAR(hits[0].T, root, std::pow(4e-15, 1.0 / degree)) << degree;
        }
      }
    }
  }
}

// A curve through a point of a patch at a given angle, wherever on both, is found to pass there.
TEST(CurvePatch, NoCrossingAtASmallAngleIsLost)
{
  std::mt19937 engine(1);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  const auto point = [&] { return Vector3{ { any(engine), any(engine), any(engine) } }; };
  CurvePatchSolver solver;
  for (int round = 0; round < 450; ++round)
  {
    const double spread = round % 5 ? 0.0 : 1.0; // of weights
    BezierCurve curve;
    BezierPatch patch;
    curve.Degree = 1 + static_cast<int>(engine() % 4);
    patch.DegreeR = 1 + static_cast<int>(engine() % 2);
    patch.DegreeS = 1 + static_cast<int>(engine() % 2);
    for (int i = 0; i <= patch.DegreeR; ++i)
    {
      for (int j = 0; j <= patch.DegreeS; ++j)
      {
        const Vector3 flat{ { 2.0 * i / patch.DegreeR, 2.0 * j / patch.DegreeS, 0.0 } };
        patch.Point(i, j) = Weighted(flat + 0.3 * point(), 1.0 + 0.5 * spread * any(engine));
      }
    }
    for (int i = 0; i <= curve.Degree; ++i)
    {
      curve.Points[i] = Weighted(point(), 1.0 + 0.5 * spread * any(engine));
    }
    const double t =
      engine() % 2 ? 0.125 * static_cast<double>(engine() % 9) : 0.5 + 0.5 * any(engine);
    const CurvePoint from = curve.At(t);
    const SurfacePoint at =
      patch.At(0.5 + 0.5 * any(engine), 0.125 * static_cast<double>(engine() % 9));
    const double angle = std::pow(10.0, -(round % 9));
    const Vector3 along = (1.0 / Norm(at.DR)) * at.DR;
    const Vector3 wanted =
      std::cos(angle) * along + (std::sin(angle) / Norm(at.Normal())) * at.Normal();
    const Vector3 axis = Cross((1.0 / Norm(from.D1)) * from.D1, wanted);
    const double cosine = Dot(from.D1, wanted) / Norm(from.D1);
    for (int i = 0; i <= curve.Degree; ++i)
    {
      const Vector3 x = curve.Control(i) - from.X;
      const Vector3 rotated =
        cosine * x + Cross(axis, x) + (Dot(axis, x) / (1.0 + cosine)) * axis; // Rodrigues's
      curve.Points[i] = Weighted(at.X + rotated, curve.Points[i][3]);
    }
    const auto& hits = solver.Solve(curve, patch, 8e-15);
    const auto isThere = [&](const CurvePatchHit& hit)
    {
      const bool passes = hit.Passes == 1 || angle < 1e-5; // two may be as near as rounding
      return std::abs(hit.T - t) <= 1e-9 + hit.Slack && passes;
    };
    const auto areWithin = !hits.empty() && hits[0].Kind == IntersectionKind::OverlapEnd;
    EXPECT_TRUE(areWithin || std::count_if(hits.begin(), hits.end(), isThere) >= 1)
      << round << " at " << angle;
  }
}
