// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "AdaptationScenes.h"

#include <gtest/gtest.h>

#include <functional>
#include <random>

namespace
{

using namespace adaptation;
using skd::AdaptOutcome;
using skd::AdaptRules;
using skd::SurfaceShape;

constexpr double Degree = Pi / 180.0;

struct Moved
{
  SurfaceMesh Before;
  SurfaceMesh Mesh;
  SurfaceShape Shape;
  AdaptOutcome Outcome;
};

AdaptRules Given()
{
  AdaptRules rules;
  rules.Monitor.Kind = skd::MonitorKind::Value;
  rules.Monitor.Smoothings = 0;
  rules.Iterations = 40;
  rules.Tolerance = 1e-3;
  return rules;
}

/// With a field that is known everywhere, taken at the middles of cells.
Moved Adapt(const SurfaceMesh& mesh, const std::function<double(const Vector3&)>& field,
  const AdaptRules& rules = Given())
{
  Moved moved{ mesh, mesh, {}, {} };
  EXPECT_TRUE(skd::FitPlane(mesh.Points, 1e-9, moved.Shape) ||
    skd::FitSphere(mesh.Points, 1e-9, moved.Shape));
  skd::Adaptation adaptation(moved.Mesh, moved.Shape, rules);
  const std::vector<skd::CellValidity> cells = [&]
  {
    std::vector<skd::CellValidity> made;
    for (std::uint32_t cell = 0; cell < mesh.Cells.size(); ++cell)
    {
      made.emplace_back(mesh, moved.Shape, cell);
    }
    return made;
  }();
  const auto find = [&](const SurfaceMesh& now, std::vector<double>& values)
  {
    for (std::uint32_t cell = 0; cell < values.size(); ++cell)
    {
      values[cell] = field(skd::CornerMean(now, cell));
      EXPECT_TRUE(cells[cell].IsValid(now, cell));
    }
    return true;
  };
  moved.Outcome = adaptation.Run(find, [](const skd::AdaptState&) { return true; });
  return moved;
}

double OnSphere(const Vector3& x)
{
  return Monitor(std::acos(x[2] / skd::Norm(x)));
}

double Colatitude(const Vector3& x)
{
  return std::acos(std::min(std::max(x[2] / skd::Norm(x), -1.0), 1.0));
}

/// How far points are from where they belong, in degrees: the root mean square.
double ErrorOf(const Moved& moved)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < moved.Mesh.Points.size(); ++i)
  {
    const double error =
      Colatitude(moved.Mesh.Points[i]) - ExactColatitude(Colatitude(moved.Before.Points[i]));
    sum += error * error;
  }
  return std::sqrt(sum / static_cast<double>(moved.Mesh.Points.size())) / Degree;
}

TEST(Adaptation, TheExactMapIsTheKnownOne)
{
  const double known[4] = { 11.59020049, 22.78980005, 35.33687972, 77.46495058 };
  for (int i = 0; i < 4; ++i)
  {
    EXPECT_NEAR(ExactColatitude(30.0 * (i + 1) * Degree) / Degree, known[i], 1e-5);
  }
}

TEST(Adaptation, PolygonsOfASphereGoWhereTheyShouldAndConverge)
{
  const Moved coarse = Adapt(MakePolygons(3), OnSphere);
  const Moved fine = Adapt(MakePolygons(4), OnSphere);
  EXPECT_EQ(fine.Outcome.End, skd::AdaptEnd::Reached);
  EXPECT_LT(ErrorOf(coarse), 0.3);
  EXPECT_LT(ErrorOf(fine), 0.07);
  EXPECT_GT(ErrorOf(coarse), 3.0 * ErrorOf(fine));
  EXPECT_GT(fine.Outcome.Rows.back().SmallestQuality, 0.4);
}

TEST(Adaptation, QuadsOfASphereGoWhereTheyShould)
{
  const Moved moved = Adapt(MakeQuads(16), OnSphere);
  EXPECT_EQ(moved.Outcome.End, skd::AdaptEnd::Reached);
  EXPECT_LT(ErrorOf(moved), 0.2);
  for (const Vector3& x : moved.Mesh.Points)
  {
    EXPECT_NEAR(skd::Norm(x), 1.0, 1e-14);
  }
}

TEST(Adaptation, TrianglesOfASphereGoWhereTheyShould)
{
  const Moved moved = Adapt(MakeTriangles(3), OnSphere);
  EXPECT_LT(ErrorOf(moved), 0.4);
  EXPECT_LT(moved.Outcome.Rows[moved.Outcome.Best].Measure, 0.03);
}

/// The largest error after moving, cells turned over being told by Adapt.
void ExpectConverges(const SurfaceMesh& mesh, const char* what)
{
  AdaptRules rules = Given();
  rules.Tolerance = 0.015;
  rules.Relaxation = 0.5;
  rules.Iterations = 60;
  const auto aside = [](const Vector3& x)
  {
    return Monitor(std::acos(
      std::min(std::max(Dot(x, Vector3{ { 0.36, 0.48, 0.8 } }) / skd::Norm(x), -1.0), 1.0)));
  };
  const Moved moved = Adapt(mesh, aside, rules);
  EXPECT_EQ(moved.Outcome.End, skd::AdaptEnd::Reached) << what;
  EXPECT_GT(moved.Outcome.Rows[0].Measure, 1.0) << what;
  EXPECT_LT(moved.Outcome.Rows[moved.Outcome.Best].Measure, 0.03) << what;
  EXPECT_LT(moved.Outcome.Rows.size(), 12u) << what;
}

TEST(Adaptation, QuadrilateralsOfACubedSphereConverge)
{
  ExpectConverges(MakeQuads(30), "cubed sphere");
}

TEST(Adaptation, GridsOfLongitudesAndLatitudesConverge)
{
  ExpectConverges(MakeLonLat(36), "longitudes and latitudes");
}

TEST(Adaptation, IrregularTrianglesAndPolygonsConverge)
{
  const SurfaceMesh triangles = MakeIrregular(4);
  ExpectConverges(triangles, "triangles");
  ExpectConverges(MakeDual(triangles), "polygons");
}

// What a potential has at the scale of single cells must not grow from step to step.
TEST(Adaptation, TrianglesOfRandomPointsConverge)
{
  AdaptRules rules = Given();
  rules.Relaxation = 0.5;
  const Moved moved = Adapt(MakeRandomTriangles(2500, 3), OnSphere, rules);
  EXPECT_LT(moved.Outcome.Rows[moved.Outcome.Best].Measure, 0.03);
  EXPECT_EQ(moved.Outcome.Rows.back().Motion.PointsCutBack, 0u);
}

// A few cells that would come too near the bound must not hold all others back.
TEST(Adaptation, FewCellsAtTheBoundOfQualityStopNoOthers)
{
  AdaptRules rules = Given();
  rules.Relaxation = 0.5;
  rules.LeastQuality = 0.25;
  const Moved triangles = Adapt(MakeRandomTriangles(2500, 3), OnSphere, rules);
  EXPECT_LT(triangles.Outcome.Rows[triangles.Outcome.Best].Measure, 0.03);
  EXPECT_GT(triangles.Outcome.Rows[1].Motion.PointsCutBack, 0u);
  rules.LeastQuality = 0.5;
  const Moved polygons = Adapt(MakeDual(MakeIrregular(4)), OnSphere, rules);
  EXPECT_LT(polygons.Outcome.Rows[polygons.Outcome.Best].Measure, 0.03);
  EXPECT_GE(polygons.Outcome.Rows.back().SmallestQuality, 0.5);
}

// Where the bound forbids what shares need, a part of the first step is better than none.
TEST(Adaptation, BoundsThatForbidEqualSharesLeaveAPartOfTheWay)
{
  AdaptRules rules = Given();
  rules.Relaxation = 0.5;
  rules.LeastQuality = 0.65;
  rules.Iterations = 3;
  const Moved moved = Adapt(MakeDual(MakeIrregular(4)), OnSphere, rules);
  EXPECT_LT(moved.Outcome.Rows[1].Motion.Step, 1.0);
  EXPECT_LT(moved.Outcome.Rows[moved.Outcome.Best].Measure, 0.5 * moved.Outcome.Rows[0].Measure);
}

TEST(Adaptation, IterationsDoNotGrowWithTheNumberOfCells)
{
  AdaptRules rules = Given();
  rules.Tolerance = 0.015;
  rules.Relaxation = 0.5;
  const std::size_t coarse = Adapt(MakePolygons(3), OnSphere, rules).Outcome.Rows.size();
  const std::size_t fine = Adapt(MakePolygons(5), OnSphere, rules).Outcome.Rows.size();
  EXPECT_LE(fine, coarse + 2);
}

// A monitor of x alone: columns stay columns, and where they go is known.
TEST(Adaptation, OfASquareBordersSlide)
{
  AdaptRules rules = Given();
  rules.Tolerance = 1e-5;
  const Moved moved = Adapt(
    MakeSquare(20), [](const Vector3& x) { return 1.0 + 4.0 * x[0]; }, rules);
  EXPECT_EQ(moved.Outcome.End, skd::AdaptEnd::Reached);
  for (std::size_t i = 0; i < moved.Mesh.Points.size(); ++i)
  {
    const Vector3& was = moved.Before.Points[i];
    const Vector3& is = moved.Mesh.Points[i];
    const double exact = (std::sqrt(1.0 + 24.0 * was[0]) - 1.0) / 4.0; // x + 2 x^2 = 3 X
    EXPECT_NEAR(is[0], exact, 1e-3);
    EXPECT_NEAR(is[1], was[1], 1e-4);
    EXPECT_EQ(is[2], 0.0);
  }
}

TEST(Adaptation, FixedBordersStay)
{
  AdaptRules rules = Given();
  rules.Freedom.DoBordersSlide = false;
  const auto bump = [](const Vector3& x) {
    return 1.0 + 10.0 * std::exp(-50.0 * skd::Distance2(x, Vector3{ { 0.4, 0.6, 0.0 } }));
  };
  const Moved moved = Adapt(MakeSquare(16), bump, rules);
  double farthest = 0.0;
  for (std::size_t i = 0; i < moved.Mesh.Points.size(); ++i)
  {
    const Vector3& was = moved.Before.Points[i];
    const bool isBorder = was[0] == 0.0 || was[0] == 1.0 || was[1] == 0.0 || was[1] == 1.0;
    const double distance = skd::Norm(moved.Mesh.Points[i] - was);
    EXPECT_TRUE(!isBorder || distance == 0.0);
    farthest = std::max(farthest, distance);
  }
  EXPECT_GT(farthest, 0.05);
  const AdaptOutcome& outcome = moved.Outcome;
  EXPECT_LT(outcome.Rows[outcome.Best].Measure, outcome.Rows[0].Measure / 5.0);
}

// Noise needs what no mesh can do: it must stay valid (Adapt looks), and the best is kept.
TEST(Adaptation, NoiseSpoilsNoCell)
{
  std::mt19937 random(7);
  const Moved moved = Adapt(MakeSquare(16), [&](const Vector3&) { return 1.0 + random() % 100; });
  const AdaptOutcome& outcome = moved.Outcome;
  for (const skd::AdaptRow& row : outcome.Rows)
  {
    EXPECT_GE(row.Measure, outcome.Rows[outcome.Best].Measure);
    EXPECT_GT(row.SmallestQuality, 0.0);
  }
}

TEST(Adaptation, AMonitorThatIsNoneMovesNothing)
{
  const auto nothing = [](const Vector3&) { return std::nan(""); };
  for (const auto& field : std::vector<std::function<double(const Vector3&)>>{ nothing,
         [](const Vector3&) { return -1.0; } })
  {
    const Moved moved = Adapt(MakeSquare(4), field);
    EXPECT_EQ(moved.Outcome.End, skd::AdaptEnd::NoMonitor);
    EXPECT_EQ(moved.Mesh.Points, moved.Before.Points);
  }
  EXPECT_EQ(Adapt(MakeSquare(1), [](const Vector3& x) { return x[0]; }).Outcome.Rows.size(), 1u);
}

// Means of so large numbers are no numbers: that must not go on for ever.
TEST(Adaptation, FieldsNearTheLargestNumberEnd)
{
  for (const double value : { 1e300, 1.7e308 })
  {
    const auto field = [value](const Vector3& x) {
      return x[0] < 0.4 ? value : x[0] < 0.8 ? std::nan("") : 0.5 * value;
    };
    for (const skd::MonitorKind kind :
      { skd::MonitorKind::ArcLength, skd::MonitorKind::Gradient, skd::MonitorKind::Value })
    {
      AdaptRules rules = Given();
      rules.Monitor.Kind = kind;
      rules.Iterations = 2;
      const Moved moved = Adapt(MakeSquare(8), field, rules);
      EXPECT_LE(moved.Outcome.Rows.size(), 3u);
    }
  }
}

TEST(Adaptation, GradientsMakeMonitorsInAnyUnit)
{
  AdaptRules rules = Given();
  rules.Monitor.Kind = skd::MonitorKind::ArcLength;
  rules.Iterations = 5;
  const auto step = [](const Vector3& x) { return std::tanh(20.0 * (x[0] - 0.3)); };
  const Moved a = Adapt(MakeSquare(12), step, rules);
  const Moved b = Adapt(
    MakeSquare(12), [&](const Vector3& x) { return 1024.0 * step(x); }, rules);
  EXPECT_EQ(a.Mesh.Points, b.Mesh.Points);
  EXPECT_LT(a.Outcome.Rows[a.Outcome.Best].Measure, 0.5 * a.Outcome.Rows[0].Measure);
}

SurfaceMesh OneCell(const std::vector<Vector3>& points)
{
  SurfaceMesh mesh;
  mesh.Points = points;
  std::vector<std::uint32_t> ids(points.size());
  std::iota(ids.begin(), ids.end(), 0u);
  mesh.Cells.Add(ids.begin(), ids.end());
  mesh.FindEdges();
  return mesh;
}

Vector3 At(double turn)
{
  return { { std::cos(turn * Pi / 180.0), std::sin(turn * Pi / 180.0), 0.0 } };
}

TEST(CellValidity, KnowsFlippedAndCrossedCells)
{
  SurfaceShape plane;
  plane.What = SurfaceShape::Kind::Plane;
  SurfaceMesh mesh = OneCell({ At(0), At(72), At(144), At(216), At(288) });
  const skd::CellValidity cell(mesh, plane, 0);
  EXPECT_TRUE(cell.IsValid(mesh, 0));
  EXPECT_NEAR(cell.QualityOf(mesh, 0), 1.0, 1e-14);
  mesh.Points = { At(0), At(144), At(288), At(72), At(216) }; // a star: each corner turns left
  EXPECT_FALSE(cell.IsValid(mesh, 0));
  mesh.Points = { At(288), At(216), At(144), At(72), At(0) };
  EXPECT_FALSE(cell.IsValid(mesh, 0));
  EXPECT_LT(cell.QualityOf(mesh, 0), 0.0);
  mesh.Points = { At(0), At(72), At(144), At(216), 0.5 * (At(0) + At(216)) }; // flat, by rounding
  EXPECT_LT(cell.QualityOf(mesh, 0), 1e-12);
}

TEST(CellValidity, ConcaveCellsStaySimple)
{
  SurfaceShape plane;
  plane.What = SurfaceShape::Kind::Plane;
  SurfaceMesh mesh = OneCell({ At(0), { { 0.1, 0.1, 0.0 } }, At(90), At(225) });
  const skd::CellValidity cell(mesh, plane, 0);
  EXPECT_TRUE(cell.IsValid(mesh, 0));
  mesh.Points[1] = { { -0.9, -0.9, 0.0 } };
  EXPECT_FALSE(cell.IsValid(mesh, 0));
}

/// How much of a whole step the first one is that makes the areas of cells equal to the monitor.
double FirstStep(SurfaceMesh mesh)
{
  SurfaceShape sphere;
  EXPECT_TRUE(skd::FitSphere(mesh.Points, 1e-9, sphere));
  std::vector<double> integrals;
  for (std::uint32_t cell = 0; cell < mesh.Cells.size(); ++cell)
  {
    integrals.push_back(OnSphere(skd::CornerMean(mesh, cell)) * skd::CellArea(mesh, sphere, cell));
  }
  const skd::FeatureCurves curves(mesh, sphere, {});
  skd::Equidistribution shares(mesh, sphere, curves, integrals);
  const std::vector<double> ones(mesh.Cells.size(), 1.0);
  shares.Update(mesh, ones);
  std::vector<Vector3> positions;
  return shares.Step(mesh, curves, ones, 1.0, positions, 2);
}

// Single points, where panels meet or at poles, make steps no shorter on finer meshes.
TEST(Adaptation, StepsDependOnTheMonitorAlone)
{
  EXPECT_NEAR(FirstStep(MakeQuads(20)), 0.119, 0.004);
  EXPECT_NEAR(FirstStep(MakeQuads(60)), 0.119, 0.004);
  EXPECT_NEAR(FirstStep(MakeTriangles(3)), 0.119, 0.008);
  EXPECT_NEAR(FirstStep(MakeTriangles(5)), 0.119, 0.004);
  EXPECT_NEAR(FirstStep(MakeLonLat(25)), 0.119, 0.008);
  EXPECT_NEAR(FirstStep(MakeLonLat(80)), 0.119, 0.004);
}

// Also of potentials that differ from cell to cell.
TEST(PotentialGradients, ThoseOfNeighboursAreAlikeAtAPole)
{
  constexpr std::uint32_t n = 60;
  const SurfaceMesh mesh = MakeLonLat(n);
  SurfaceShape sphere;
  ASSERT_TRUE(skd::FitSphere(mesh.Points, 1e-9, sphere));
  skd::PotentialGradients gradients;
  gradients.Build(mesh, sphere);
  std::mt19937 random(7);
  std::vector<double> values(mesh.Cells.size());
  for (double& value : values)
  {
    value = random() / 4294967296.0;
  }
  double difference = 0.0, largest = 0.0;
  for (const skd::MeshEdge& edge : mesh.Edges)
  {
    const Vector3& a = mesh.Points[edge.Points[0]];
    const Vector3& b = mesh.Points[edge.Points[1]];
    if (std::abs(a[2]) > std::cos(1.5 * Pi / n) && std::abs(a[2] - b[2]) < 1e-9)
    {
      const Vector3 slope = gradients.At(values, edge.Points[0]);
      difference = std::max(difference, Norm(gradients.At(values, edge.Points[1]) - slope));
      largest = std::max(largest, Norm(slope));
    }
  }
  EXPECT_GT(largest, 0.0);
  EXPECT_LT(difference, 0.25 * largest);
}

/// Flows of a mesh of triangles, the same or of random weights, and what cells gain of random y.
int StepsToSolve(const SurfaceMesh& mesh, bool isRandom, double tolerance, double& worst)
{
  skd::EdgeLaplacian matrix;
  matrix.NumberOfCells = mesh.Cells.size();
  std::mt19937 random(3);
  for (const skd::MeshEdge& edge : mesh.Edges)
  {
    matrix.Flows.push_back(
      { { edge.Cells[0], edge.Cells[1] }, isRandom ? 1.0 + random() % 9 : 1.0 });
  }
  std::vector<double> exact(mesh.Cells.size()), losses, found;
  for (double& value : exact)
  {
    value = random() % 1000;
  }
  matrix.Apply(exact, losses);
  skd::detail::Scale(losses, -1.0);
  const skd::Aggregation levels(matrix);
  const int steps = skd::SolveForGains(matrix, levels, losses, tolerance, 100, found);
  worst = 0.0;
  for (std::size_t i = 0; i < exact.size(); ++i)
  {
    worst = std::max(worst, std::abs(found[i] - found[0] - exact[i] + exact[0]));
  }
  return steps;
}

TEST(Aggregation, GainsAreSolvedForInAsManyStepsOnAnyMesh)
{
  for (const bool isRandom : { false, true })
  {
    int most = 0, least = 1000;
    for (int level = 2; level < 6; ++level) // 320 to 20480 cells
    {
      double worst = 0.0;
      const int steps = StepsToSolve(MakeTriangles(level), isRandom, 1e-12, worst);
      EXPECT_LT(worst, 1e-5);
      most = std::max(most, steps);
      least = std::min(least, steps);
    }
    EXPECT_LT(most, 60);
    EXPECT_LT(most, 2 * least);
  }
}

TEST(QuadraticFit, IsExactForQuadraticsAndFindsNothingAcrossALine)
{
  std::mt19937 random(11);
  const auto uniform = [&] { return random() / 4294967296.0 - 0.5; };
  for (const double thickness : { 1.0, 0.01, 0.0 })
  {
    skd::QuadraticFit fit;
    std::vector<double> values;
    for (int i = 0; i < 14; ++i)
    {
      const double x = uniform(), y = thickness * uniform();
      fit.Add(x, y);
      values.push_back(3.0 + 2.0 * x - y + x * x - 3.0 * x * y + 0.5 * y * y);
    }
    double along = 0.0, across = 0.0;
    const auto weights = fit.FindWeights();
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      along += weights[i][0] * values[i];
      across += weights[i][1] * values[i];
    }
    EXPECT_NEAR(along, 2.0, 1e-4);
    EXPECT_NEAR(across, thickness > 0.0 ? -1.0 : 0.0, thickness > 0.0 ? 1e-2 : 1e-12);
  }
}

/// 0.3 x^2 - 0.1 x y + 0.2 y^2 + 0.05 x
double QuadraticAt(const Vector3& x)
{
  return 0.3 * x[0] * x[0] - 0.1 * x[0] * x[1] + 0.2 * x[1] * x[1] + 0.05 * x[0];
}

Vector3 SlopeAt(const Vector3& x)
{
  return { { 0.6 * x[0] - 0.1 * x[1] + 0.05, 0.4 * x[1] - 0.1 * x[0], 0.0 } };
}

std::vector<Vector3> MiddlesOf(const SurfaceMesh& mesh)
{
  std::vector<Vector3> middles;
  for (std::uint32_t cell = 0; cell < mesh.Cells.size(); ++cell)
  {
    middles.push_back(skd::CornerMean(mesh, cell));
  }
  return middles;
}

// Where x goes to y = x + slope(x) the way back from y is x - y, the gradient of a quadratic.
TEST(ConjugatePotential, IsExactForQuadratics)
{
  SurfaceShape plane;
  plane.What = SurfaceShape::Kind::Plane;
  SurfaceMesh image = MakeSquare(9);
  const std::vector<Vector3> from = MiddlesOf(image);
  std::vector<double> values;
  for (const Vector3& x : from)
  {
    values.push_back(QuadraticAt(x));
  }
  for (Vector3& x : image.Points)
  {
    x = x + SlopeAt(x);
  }
  const skd::ConjugatePotential back(image, plane, from, values);
  std::vector<Vector3> at;
  for (const Vector3& x : from)
  {
    at.push_back(x + Vector3{ { 0.03, 0.01, 0.0 } }); // elsewhere than cells have gone
  }
  const std::vector<double> found = back.FindAll(at);
  for (std::size_t i = 0; i < at.size(); ++i)
  {
    const double x = at[i][0] - 0.05; // (1 + A) x for the x that goes to `at`
    const double y = at[i][1];
    const double determinant = 1.6 * 1.4 - 0.01;
    const Vector3 source{ { (1.4 * x + 0.1 * y) / determinant, (1.6 * y + 0.1 * x) / determinant,
      0.0 } };
    EXPECT_NEAR(found[i], -QuadraticAt(source) - 0.5 * skd::Distance2(source, at[i]), 1e-13);
  }
}

TEST(SmoothPotential, KeepsQuadraticsAndTakesWhatGradientsDoNotTell)
{
  const SurfaceMesh mesh = MakeRandomTriangles(200, 1);
  std::vector<Vector3> middles = MiddlesOf(mesh), slopes;
  std::vector<double> exact, values;
  std::mt19937 random(1);
  for (Vector3& x : middles)
  {
    x[2] = 0.0;
    slopes.push_back(SlopeAt(x));
    exact.push_back(QuadraticAt(x));
    values.push_back(exact.back() + (random() % 2 == 0 ? 0.1 : -0.1));
  }
  std::vector<double> kept = exact;
  skd::SmoothPotential(mesh.Edges, middles, slopes, 4, kept);
  skd::SmoothPotential(mesh.Edges, middles, slopes, 20, values);
  double sum = 0.0;
  for (std::size_t i = 0; i < exact.size(); ++i)
  {
    EXPECT_NEAR(kept[i], exact[i], 1e-13);
    sum += (values[i] - exact[i]) * (values[i] - exact[i]);
  }
  EXPECT_LT(std::sqrt(sum / static_cast<double>(exact.size())), 0.04);
}

TEST(FitShape, PlanesAndSpheresAreFound)
{
  SurfaceShape shape;
  SurfaceMesh mesh = MakeTriangles(1);
  EXPECT_FALSE(skd::FitPlane(mesh.Points, 1e-6, shape));
  for (Vector3& x : mesh.Points)
  {
    x = 3.0 * x + Vector3{ { 100.0, 20.0, -7.0 } };
  }
  ASSERT_TRUE(skd::FitSphere(mesh.Points, 1e-9, shape));
  EXPECT_NEAR(shape.Radius, 3.0, 1e-11);
  EXPECT_NEAR(shape.Centre[0], 100.0, 1e-11);
  mesh.Points[3] = 1.001 * mesh.Points[3];
  EXPECT_FALSE(skd::FitSphere(mesh.Points, 1e-6, shape));
  ASSERT_TRUE(skd::FitPlane(MakeSquare(3).Points, 1e-9, shape));
  EXPECT_EQ(shape.Normal[2], 1.0);
  EXPECT_FALSE(skd::FitSphere(MakeSquare(3).Points, 1e-9, shape));
}

}
