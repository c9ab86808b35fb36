// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeCurveSurfaceIntersection where the crossings are known.

#include "Support/CurveRun.h"
#include "Support/SurfaceMeshes.h"

#include "vtkSkdTreeCurveSurfaceIntersection.h"

#include <gtest/gtest.h>

using namespace skdtest;

namespace
{

using FilterPointer = vtkSmartPointer<vtkSkdTreeCurveSurfaceIntersection>;

constexpr auto MakeFilter = [](vtkDataObject* curves, vtkDataObject* others = nullptr)
{ return MakeCurveFilter<vtkSkdTreeCurveSurfaceIntersection>(curves, others); };

std::vector<double> Lengths(vtkDataObject* curves, vtkDataObject* surfaces)
{
  return OutputArray(MakeFilter(curves, surfaces), "SkdArcLength");
}

void ExpectNear(
  const std::vector<double>& found, const std::vector<double>& expected, double relative = 1e-12)
{
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    EXPECT_NEAR(found[i], expected[i], relative * std::max(1.0, std::abs(expected[i]))) << i;
  }
}

/// Of the torus R = 1, r = 0.25 and the line from x = -2 at (y, z).
FilterPointer TorusAndLine(double y, double z)
{
  return MakeFilter(MakePolyline({ { -2, y, z }, { 2.3, y, z } }), BezierTorus(1.0, 0.25));
}

Point HelixAt(double t)
{
  return { std::cos(t), std::sin(t), 0.1 * t };
}

/// Each of the cells of a curve runs within the surface, from its begin to its end.
void ExpectWithin(vtkAlgorithm* filter, int cells)
{
  std::vector<double> ends;
  for (int i = 0; i < cells; ++i)
  {
    ends.insert(ends.end(), { 0, 1 });
  }
  EXPECT_EQ(OutputArray(filter, "SkdKind"), std::vector<double>(ends.size(), 2.0));
  ExpectNear(OutputArray(filter, "SkdCurveParameter"), ends);
}

/// A square in the plane z = x, as a quad.
PolyDataPointer SlantedPlane()
{
  return MakePolyData(
    OneCell(VTK_QUAD, { { -3, -3, -3 }, { 3, -3, 3 }, { 3, 3, 3 }, { -3, 3, -3 } }));
}
}

TEST(CurveSurfaceKnown, ALineThroughATorus)
{
  const Point from{ -2, .1, -.05 };
  const Point along{ 1, .02, .03 };
  const Point to = from + (5.0 / Length(along)) * along;
  ExpectNear(Lengths(MakePolyline({ from, to }), BezierTorus(1.0, 0.25)),
    { 0.75730656177192833, 1.2610417307475993, 2.7377575606421169, 3.2367005100859674 });
}

TEST(CurveSurfaceKnown, ALineThatTouchesATorus)
{
  const FilterPointer filter = TorusAndLine(1.25, 0.0);
  ExpectNear(OutputArray(filter, "SkdArcLength"), { 2.0 });
  EXPECT_EQ(OutputArray(filter, "SkdKind"), std::vector<double>{ 1 });
  EXPECT_EQ(OutputArray(filter, "SkdSense"), std::vector<double>{ 0 });
}

TEST(CurveSurfaceKnown, ALineThatHardlyCutsATorus)
{
  ExpectNear(OutputArray(TorusAndLine(1.249999, 0.0), "SkdArcLength"),
    { 2.0 - 1.581138513856392e-3, 2.0 + 1.581138513856392e-3 });
}

TEST(CurveSurfaceKnown, ALineThatHardlyMissesATorus)
{
  EXPECT_TRUE(OutputArray(TorusAndLine(1.250001, 0.0), "SkdArcLength").empty());
}

TEST(CurveSurfaceKnown, ALineThatTouchesATorusInAFourfoldRoot)
{
  const FilterPointer filter = TorusAndLine(1.0, 0.25);
  ExpectNear(OutputArray(filter, "SkdArcLength"), { 2.0 }, 1e-5);
  EXPECT_EQ(OutputArray(filter, "SkdKind"), std::vector<double>{ 1 });
}

TEST(CurveSurfaceKnown, ALineThroughASphere)
{
  const FilterPointer filter =
    MakeFilter(MakePolyline({ { -3, .1, .2 }, { 3, .1, .2 } }), BezierSphere(1.0));
  const double half = std::sqrt(0.95);
  ExpectNear(OutputArray(filter, "SkdArcLength"), { 3.0 - half, 3.0 + half });
  EXPECT_EQ(OutputArray(filter, "SkdSense").size(), 2u);
}

TEST(CurveSurfaceKnown, ALineThroughThePolesOfASphere)
{
  const FilterPointer filter =
    MakeFilter(MakePolyline({ { 0, 0, -3 }, { 0, 0, 3 } }), BezierSphere(1.0));
  ExpectNear(OutputArray(filter, "SkdArcLength"), { 2.0, 4.0 });
  EXPECT_EQ(OutputArray(filter, "SkdKind"), (std::vector<double>{ 0, 0 }));
}

TEST(CurveSurfaceKnown, VivianisCurveAndAPlane)
{
  const auto viviani = [](double t) {
    return Point{ 1 + std::cos(t), std::sin(t), 2 * std::sin(t / 2) };
  };
  constexpr int pieces = 60;
  const FilterPointer filter =
    MakeFilter(LagrangeCurve(viviani, 0.0, 4 * M_PI, pieces), SlantedPlane());
  ExpectNear(PlacesOfPieces(filter, 0.0, 4 * M_PI, pieces),
    { 1.33247886498503051, 4.95070644219455597 }, 2e-15);
}

TEST(CurveSurfaceKnown, AHelixAndASphere)
{
  constexpr int pieces = 80;
  const FilterPointer filter =
    MakeFilter(LagrangeCurve(HelixAt, -12.0, 12.0, pieces), BezierSphere(1.5));
  ExpectNear(PlacesOfPieces(filter, -12.0, 12.0, pieces),
    { -11.1803398874989485, 11.1803398874989485 }, 2e-15);
}

TEST(CurveSurfaceKnown, AHelixAndACylinderBesideIt)
{
  constexpr int pieces = 80;
  const FilterPointer filter =
    MakeFilter(LagrangeCurve(HelixAt, -12.0, 12.0, pieces), BezierCylinder(1.0, 4.0, { 1, 0, 0 }));
  std::vector<double> expected; // (cos t - 1)^2 + sin^2 t = 1: cos t = 1/2
  for (int turn = -2; turn <= 1; ++turn)
  {
    expected.push_back(2 * M_PI * turn + M_PI / 3);
    expected.push_back(2 * M_PI * (turn + 1) - M_PI / 3);
  }
  ExpectNear(PlacesOfPieces(filter, -12.0, 12.0, pieces), expected);
  EXPECT_EQ(OutputArray(filter, "SkdKind"), std::vector<double>(8, 0.0));
}

TEST(CurveSurfaceKnown, AHelixAndCylindersAboutItsAxis)
{
  constexpr int pieces = 80;
  const FilterPointer filter =
    MakeFilter(LagrangeCurve(HelixAt, -12.0, 12.0, pieces), BezierCylinder(1.0, 4.0));
  ExpectWithin(filter, pieces);
  for (double radius : { 1.0 - 1e-10, 1.0 + 1e-10 })
  {
    filter->SetSourceData(BezierCylinder(radius, 4.0));
    EXPECT_TRUE(OutputPoints(filter).empty()) << radius;
  }
}

// They are cut into no more than so many parts: what is left of a pair is looked at bit by bit.
TEST(CurveSurfaceKnown, ACurveThatNearlyRunsWithinACylinderCrossesItWhereItDoes)
{
  constexpr int pieces = 4;
  for (double amplitude : { 1e-6, 1e-10 })
  {
    const auto weave = [&](double t)
    {
      const double r = 1 + amplitude * std::sin(5 * t);
      return Point{ r * std::cos(t), r * std::sin(t), 0.1 * t };
    };
    const FilterPointer filter =
      MakeFilter(LagrangeCurve(weave, 0.1, 1.5, pieces), BezierCylinder(1.0, 4.0));
    const std::vector<double> positions = PlacesOfPieces(filter, 0.1, 1.5, pieces);
    ASSERT_EQ(positions.size(), 2u) << amplitude;
    EXPECT_NEAR(positions[0], M_PI / 5, 1e-14 / amplitude);
    EXPECT_NEAR(positions[1], 2 * M_PI / 5, 1e-14 / amplitude);
    EXPECT_EQ(OutputArray(filter, "SkdSense"), (std::vector<double>{ 1, -1 }));
  }
}

TEST(CurveSurfaceKnown, AHelixAcrossAPlane)
{
  const FilterPointer filter = MakeFilter(LagrangeCurve(HelixAt, 0.5, 20.0, 60), SlantedPlane());
  const std::vector<double> positions = PlacesOfPieces(filter, 0.5, 20.0, 60);
  ASSERT_EQ(positions.size(), 3u); // cos t = t / 10
  for (double t : positions)
  {
    EXPECT_NEAR(std::cos(t), 0.1 * t, 1e-14);
  }
}

TEST(CurveSurfaceKnown, ACircleOfTheTorusRunsWithinIt)
{
  // The torus' highest circle: both run together all around, cell by cell.
  ExpectWithin(MakeFilter(BezierCircle(1.0, { 0, 0, 0.25 }), BezierTorus(1.0, 0.25)), 4);
}

TEST(CurveSurfaceKnown, AKnotOnATorusRunsWithinIt)
{
  const auto knot = [](double t)
  {
    const double r = 1 + 0.25 * std::cos(3 * t);
    return Point{ r * std::cos(2 * t), r * std::sin(2 * t), 0.25 * std::sin(3 * t) };
  };
  constexpr int pieces = 50; // borders of patches are within pieces
  ExpectWithin(
    MakeFilter(LagrangeCurve(knot, 0.0, 2 * M_PI, pieces), BezierTorus(1.0, 0.25)), pieces);
}

TEST(CurveSurfaceKnown, ASplineThroughPointsIsVtksOwn)
{
  // A closed polyline on a circle, as a spline: it leaves the polygon, so meets a plane that misses
  // all of its straight parts.
  const auto circle = [](double t) { return Point{ std::cos(t), std::sin(t), 0.0 }; };
  const PolyDataPointer polyline = MakePolyline(Sampled(circle, 0.0, 2 * M_PI, 8));
  const double x = 0.99;
  const PolyDataPointer plane = MakePolyData(Transformed(
    OneCell(VTK_QUAD, { { x, -2, -2 }, { x, 2, -2 }, { x, 2, 2 }, { x, -2, 2 } }), 1.0, {}));
  const FilterPointer filter = MakeFilter(polyline, plane);
  EXPECT_EQ(OutputPoints(filter).size(), 2u); // the corner at x = 1
  const double straight = std::abs(OutputPoints(filter)[0][1]);
  for (int form : { vtkSkdTreeCurveSurfaceIntersection::CARDINAL_SPLINE,
         vtkSkdTreeCurveSurfaceIntersection::KOCHANEK_SPLINE })
  {
    filter->SetPolylineForm(form);
    const std::vector<Point> points = OutputPoints(filter);
    ASSERT_EQ(points.size(), 2u);
    EXPECT_GT(std::abs(points[0][1]), 1.5 * straight); // rounder than the corner
    EXPECT_NEAR(std::hypot(points[0][0], points[0][1]), 1.0, 0.03);
  }
}

TEST(CurveSurfaceKnown, AWarpedQuadIsBilinear)
{
  // z = x y
  const PolyDataPointer saddle =
    MakePolyData(OneCell(VTK_QUAD, { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 1 }, { 0, 1, 0 } }));
  const FilterPointer filter = MakeFilter(MakePolyline({ { .3, .6, -1 }, { .3, .6, 1 } }), saddle);
  ExpectNear(OutputArray(filter, "SkdArcLength"), { 1.18 });
  ExpectNear(OutputArray(filter, "SkdPCoords"), { .3, .6, 0 });
  // Along the diagonal it is met twice.
  filter->SetInputDataObject(0, MakePolyline({ { 0, 0, .1 }, { 1, 1, .4 } }));
  const double root = std::sqrt(0.09 + 0.4); // t^2 = .1 + .3 t
  ExpectNear(OutputArray(filter, "SkdCurveParameter"), { (0.3 + root) / 2 });
}

TEST(CurveSurfaceKnown, QuadraticTrianglesAndTheirNeighboursMeetALineOnce)
{
  // Two quadratic triangles share the curved edge above y = x.
  Mesh mesh;
  const auto bump = [](double x, double y) { return Point{ x, y, x * (1 - x) + y * (1 - y) }; };
  const auto add = [&](double x, double y) { return mesh.Add(bump(x, y)); };
  mesh.Add(VTK_QUADRATIC_TRIANGLE,
    { add(0, 0), add(1, 0), add(1, 1), add(.5, 0), add(1, .5), add(.5, .5) });
  mesh.Add(VTK_QUADRATIC_TRIANGLE,
    { add(0, 0), add(1, 1), add(0, 1), add(.5, .5), add(.5, 1), add(0, .5) });
  const GridPointer grid = MakeGrid(mesh);
  for (double x : { 0.1, 0.25, 1.0 / 3.0, 0.7, 0.9 })
  {
    const FilterPointer filter = MakeFilter(MakePolyline({ { x, x, 2 }, { x, x, -1 } }), grid);
    ExpectNear(OutputArray(filter, "SkdArcLength"), { 2.0 - 2.0 * x * (1 - x) });
    EXPECT_EQ(OutputArray(filter, "SkdSense"), std::vector<double>{ 1 });
    EXPECT_EQ(OutputArray(filter, "SkdCellId"), std::vector<double>{ 0 });
  }
}

TEST(CurveSurfaceKnown, FarFromTheOriginAndTiny)
{
  for (const auto& [scale, offset] :
    { std::pair(1e-6, 0.0), std::pair(1e6, 0.0), std::pair(1e-20, 0.0), std::pair(1.0, 1e6) })
  {
    const Point shift{ offset, offset, offset };
    const PolyDataPointer cube = MakePolyData(Transformed(CubeTriangles(2), scale, shift));
    const Mesh line = OneCell(VTK_LINE, { { -1, .5, .75 }, { 4, .5, .75 } });
    const FilterPointer filter = MakeFilter(MakePolyData(Transformed(line, scale, shift)), cube);
    ExpectNear(OutputArray(filter, "SkdCurveParameter"), { 0.2, 0.6 }, 1e-15 * (1 + offset));
    EXPECT_EQ(OutputArray(filter, "SkdSense"), (std::vector<double>{ 1, -1 }));
  }
}

// (t, t / 2, (t - root)^degree) through z = 0.
TEST(CurveSurfaceKnown, ARootOfHigherOrderIsOnePlace)
{
  Mesh plane;
  for (double x = -1.0; x < 2.0; x += 0.5)
  {
    plane.Add(VTK_QUAD,
      { plane.Add({ x, -2, 0 }), plane.Add({ x + 0.5, -2, 0 }), plane.Add({ x + 0.5, 2, 0 }),
        plane.Add({ x, 2, 0 }) });
  }
  for (const int degree : { 2, 3, 4, 5, 6, 7 })
  {
    for (const double root : { 0.125, 0.3, 0.5 }) // the last on an edge
    {
      for (const double slope : { 0.0, 1e-13, 1e-10 })
      {
        std::vector<Point> points;
        for (int i = 0; i <= degree; ++i)
        {
          const double x = static_cast<double>(i) / degree;
          points.push_back({ x, 0.5 * x,
            std::pow(1.0 - root, i) * std::pow(-root, degree - i) +
              (degree % 2) * slope * (x - root) });
        }
        std::rotate(points.begin() + 1, points.end() - 1, points.end()); // ends first
        const FilterPointer filter =
          MakeFilter(MakeGrid(OneCell(VTK_BEZIER_CURVE, points)), MakePolyData(plane));
        EXPECT_EQ(OutputArray(filter, "SkdSense"), (std::vector<double>{ degree % 2 ? -1.0 : 0.0 }))
          << degree << " at " << root;
      }
    }
  }
}
