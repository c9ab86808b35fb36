// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// Curved cells whose distances are known without a search: circles and cylinders by rational Bezier
// cells, and what holds at every scale.

#include "Support/CellZoo.h"
#include "Support/LocatorCalls.h"

#include "vtkPointData.h"

#include <gtest/gtest.h>

using namespace skdtest;

namespace
{

GridPointer WithRationalWeights(const Mesh& mesh, const std::vector<double>& weights)
{
  GridPointer grid = MakeGrid(mesh);
  vtkNew<vtkDoubleArray> rational;
  rational->SetName("RationalWeights");
  for (double weight : weights)
  {
    rational->InsertNextValue(weight);
  }
  grid->GetPointData()->SetRationalWeights(rational);
  return grid;
}

/// A quarter of the unit circle around the origin.
GridPointer QuarterCircle()
{
  Mesh mesh;
  mesh.Points = { { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 } };
  mesh.Add(VTK_BEZIER_CURVE, { 0, 1, 2 });
  return WithRationalWeights(mesh, { 1, 1, std::sqrt(0.5) });
}

/// A quarter of a cylinder of radius 1 around the z axis, of height 1. Corners, the middles of
/// edges 01, 12, 32, 03, then the middle.
GridPointer QuarterCylinder()
{
  Mesh mesh;
  mesh.Points = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 1, 1 }, { 1, 0, 1 }, { 1, 1, 0 }, { 0, 1, 0.5 },
    { 1, 1, 1 }, { 1, 0, 0.5 }, { 1, 1, 0.5 } };
  mesh.Add(VTK_BEZIER_QUADRILATERAL, { 0, 1, 2, 3, 4, 5, 6, 7, 8 });
  const double w = std::sqrt(0.5);
  return WithRationalWeights(mesh, { 1, 1, 1, 1, w, 1, w, 1, w });
}

/// In the first octant, so that the nearest point of a quarter is that of the whole.
Point PointAround(Random& random, double radius)
{
  const double angle = random.Between(0, std::acos(0.0));
  return { radius * std::cos(angle), radius * std::sin(angle), random.Between(0, 1) };
}

/// `test(answer, x, radius)` for points around a quarter, by their distance from its axis.
template <class Test>
void ForClosestPoints(vtkDataSet* grid, int seed, const Test& test)
{
  const auto locator = MakeLocator(grid);
  Random random(seed);
  for (int i = 0; i < 300; ++i)
  {
    const double radius = random.Between(0.1, 3);
    const Point x = PointAround(random, radius);
    test(FindClosest(locator, x), x, radius);
  }
}

TEST(RationalBezier, CurveIsAtTheDistanceOfItsCircle)
{
  const auto grid = QuarterCircle();
  ForClosestPoints(grid, 150,
    [](const Closest& c, const Point& x, double radius)
    {
      EXPECT_NEAR(c.Dist2, (radius - 1) * (radius - 1) + x[2] * x[2], 1e-12);
      EXPECT_NEAR(Length(c.X), 1.0, 1e-9);
    });
}

TEST(RationalBezier, SurfaceIsAtTheDistanceOfItsCylinder)
{
  const auto grid = QuarterCylinder();
  ForClosestPoints(grid, 151,
    [](const Closest& c, const Point&, double radius)
    { EXPECT_NEAR(std::sqrt(c.Dist2), std::abs(radius - 1), 1e-12); });
}

TEST(RationalBezier, SurfaceIsHitWhereItsCylinderIs)
{
  const auto grid = QuarterCylinder();
  const auto locator = MakeLocator(grid);
  Random random(152);
  for (int i = 0; i < 300; ++i)
  {
    const Point inside = PointAround(random, random.Between(0, 0.95));
    const Point outside = PointAround(random, random.Between(1.05, 5));
    const LineHit hit = FindFirstHit(locator, inside, outside, 0.0);
    ASSERT_EQ(hit.Found, 1);
    ASSERT_NEAR(std::hypot(hit.X[0], hit.X[1]), 1.0, 1e-12);
    ASSERT_LE(Distance(hit.X, Lerp(inside, outside, hit.T)), 1e-12);
  }
}

TEST(RationalBezier, LinesPastTheCurveHitWithinTheToleranceOnly)
{
  const auto grid = QuarterCircle();
  const auto locator = MakeLocator(grid);
  Random random(153);
  for (int i = 0; i < 300; ++i)
  {
    Point x = PointAround(random, random.Between(0.8, 1.2));
    const double gap = std::abs(std::hypot(x[0], x[1]) - 1);
    const Point up = { 0, 0, 2 };
    ASSERT_EQ(FindFirstHit(locator, x - up, x + up, gap + 1e-9).Found, 1);
    ASSERT_EQ(FindFirstHit(locator, x - up, x + up, gap - 1e-9).Found, 0);
  }
}

class CurvedScale : public testing::TestWithParam<int>
{
};

INSTANTIATE_TEST_SUITE_P(PowersOfTwo, CurvedScale, testing::Values(-100, -30, 30, 100));

TEST_P(CurvedScale, ScalesEveryAnswer)
{
  const double scale = std::ldexp(1.0, GetParam());
  for (int type : { VTK_QUADRATIC_EDGE, VTK_QUADRATIC_QUAD, VTK_QUADRATIC_TETRA,
         VTK_QUADRATIC_HEXAHEDRON, VTK_QUADRATIC_WEDGE, VTK_BIQUADRATIC_TRIANGLE })
  {
    Mesh mesh = ReferenceCell(type, 1).Map(Bent);
    const auto grid = MakeGrid(mesh);
    const auto scaledGrid = MakeGrid(mesh.Map([&](const Point& p) { return scale * p; }));
    const auto locator = MakeLocator(grid);
    const auto scaled = MakeLocator(scaledGrid);
    Random random(154);
    for (int i = 0; i < 100; ++i)
    {
      const Point x = random.InBox({ -1, 2, -1, 2, -1, 2 });
      const Point y = random.InBox({ -1, 2, -1, 2, -1, 2 });
      ASSERT_EQ(FindClosest(scaled, scale * x).X, scale * FindClosest(locator, x).X);
      const LineHit hit = FindFirstHit(locator, x, y, 0.01);
      const LineHit scaledHit = FindFirstHit(scaled, scale * x, scale * y, scale * 0.01);
      ASSERT_EQ(hit.Found, scaledHit.Found);
      ASSERT_EQ(hit.T, scaledHit.T);
    }
  }
}

}
