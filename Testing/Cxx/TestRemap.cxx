// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeRemap: what is kept, and how well.

#include "Support/AMRMeshes.h"
#include "Support/EventCounter.h"
#include "Support/RemapRun.h"
#include "Support/SphereMeshes.h"
#include "Support/SurfaceMeshes.h"
#include "Support/VolumeMeshes.h"

#include "vtkAbstractArray.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkSMPTools.h"
#include "vtkVariant.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace skdtest;

namespace
{
using Remap = vtkSkdTreeRemap;

/// Y 2,2 of Jones (1999): 2 + cos^2(latitude) cos(2 longitude).
double Y22(const Point& x)
{
  return 2.0 + x[0] * x[0] - x[1] * x[1];
}

/// His cosine hill, about the equator.
double Hill(const Point& x)
{
  const double pi = std::acos(-1.0);
  const double distance = std::acos(std::clamp(-x[0], -1.0, 1.0));
  return 2.0 - std::cos(pi * std::min(1.0, 3.0 * distance / pi));
}

struct SpherePair
{
  explicit SpherePair(int cube, int icosahedron, const std::function<double(const Point&)>& f = Y22)
    : From(CubedSphere(cube))
    , To(IcosahedralDual(icosahedron))
    , Averages(CellAverages(this->From, f))
    , Exact(CellAverages(this->To, f))
    , Source(WithCellArray(MakePolyData(this->From), "f", this->Averages))
    , Input(MakePolyData(this->To))
  {
  }

  double Error(int method, int limiter = Remap::NO_LIMITER) const
  {
    const RemapPointer remap = MakeRemap(this->Input, this->Source, method);
    remap->SetLimiter(limiter);
    const std::vector<double> values = RemappedCells(remap, "f");
    EXPECT_LT(Reported(remap, "ConservationError"), 1e-13);
    EXPECT_NEAR(Reported(remap, "Coverage"), 1.0, 1e-14);
    const std::vector<double> ones(values.size(), 1.0);
    return L2Error(values, this->Exact, ones);
  }

  Mesh From;
  Mesh To;
  std::vector<double> Averages;
  std::vector<double> Exact;
  PolyDataPointer Source;
  PolyDataPointer Input;
};

GridPointer Tetra(const char* name, const std::function<double(const Point&)>& f)
{
  const Mesh mesh = Transformed(Tetrahedra(3), 1.0 / 3.0, { 0, 0, 0 });
  const GridPointer grid = MakeGrid(mesh);
  std::vector<double> values;
  for (const CellSpec& cell : mesh.Cells)
  {
    Point middle = { 0, 0, 0 };
    for (const vtkIdType id : cell.Points)
    {
      middle = middle + 0.25 * mesh.Points[id];
    }
    values.push_back(f(middle)); // the average, if linear
  }
  return WithCellArray(grid, name, values);
}

GridPointer Bricks(int n)
{
  return MakeGrid(Transformed(Hexahedra(n), 1.0 / n, { 0, 0, 0 }));
}
}

TEST(Remap, OnASphereFirstOrderIsConservativeAndOfFirstOrder)
{
  const double coarse = SpherePair(8, 9).Error(Remap::CONSERVATIVE_FIRST_ORDER);
  const double fine = SpherePair(16, 18).Error(Remap::CONSERVATIVE_FIRST_ORDER);
  EXPECT_LT(fine, 6e-3);
  EXPECT_GT(coarse / fine, 1.7);
  EXPECT_LT(coarse / fine, 2.5);
}

TEST(Remap, OnASphereSecondOrderIsConservativeAndOfSecondOrder)
{
  const double coarse = SpherePair(8, 9).Error(Remap::CONSERVATIVE_SECOND_ORDER);
  const double fine = SpherePair(16, 18).Error(Remap::CONSERVATIVE_SECOND_ORDER);
  EXPECT_LT(fine, 1.6e-4);
  EXPECT_GT(coarse / fine, 3.5);
  const double hill = SpherePair(16, 18, Hill).Error(Remap::CONSERVATIVE_SECOND_ORDER);
  EXPECT_LT(3.0 * hill, SpherePair(16, 18, Hill).Error(Remap::CONSERVATIVE_FIRST_ORDER));
}

// The table of the literature; the full one is made by Testing/Benchmark/remap_convergence.py.
TEST(Remap, ErrorsAreThoseOfTempestRemapOrLess)
{
  const SpherePair pair(15, 16);
  EXPECT_LT(pair.Error(Remap::CONSERVATIVE_FIRST_ORDER), 1.2 * 5.575e-3);
  EXPECT_LT(pair.Error(Remap::CONSERVATIVE_SECOND_ORDER), 1.578e-4);
  EXPECT_LT(pair.Error(Remap::CONSERVATIVE_SECOND_ORDER, Remap::BARTH_JESPERSEN), 1.578e-4);
}

TEST(Remap, ConstantsStayAndFirstOrderKeepsBounds)
{
  SpherePair pair(6, 5, Hill);
  const std::vector<double> constant(pair.Averages.size(), 0.3);
  WithCellArray(pair.Source, "constant", constant);
  for (const int method : { Remap::CONSERVATIVE_FIRST_ORDER, Remap::CONSERVATIVE_SECOND_ORDER })
  {
    for (const int normalization : { Remap::COVERED, Remap::WHOLE })
    {
      const RemapPointer remap = MakeRemap(pair.Input, pair.Source, method);
      remap->SetNormalization(normalization);
      for (const double value : RemappedCells(remap, "constant"))
      {
        ASSERT_NEAR(value, 0.3, 1e-14);
      }
    }
  }
  const auto [least, greatest] = std::minmax_element(pair.Averages.begin(), pair.Averages.end());
  for (const double value :
    RemappedCells(MakeRemap(pair.Input, pair.Source, Remap::CONSERVATIVE_FIRST_ORDER), "f"))
  {
    ASSERT_GE(value, *least);
    ASSERT_LE(value, *greatest);
  }
}

TEST(Remap, MassDoesNotDriftBackAndForth)
{
  const SpherePair pair(6, 5);
  PolyDataPointer there = pair.Input;
  PolyDataPointer here = pair.Source;
  const RemapPointer go = MakeRemap(there, here, Remap::CONSERVATIVE_SECOND_ORDER);
  const RemapPointer come = MakeRemap(here, there, Remap::CONSERVATIVE_SECOND_ORDER);
  go->PassInputDataOff();
  come->PassInputDataOff();
  come->SetInputConnection(1, go->GetOutputPort());
  come->Update();
  const double before = Reported(go, "SourceIntegral");
  for (int cycle = 0; cycle < 10; ++cycle)
  {
    vtkNew<vtkPolyData> back;
    back->ShallowCopy(come->GetOutputDataObject(0));
    go->SetSourceData(back);
    come->Update();
    EXPECT_EQ(Reported(go, "WeightsFound"), 0);
  }
  EXPECT_NEAR(Reported(come, "TargetIntegral"), before, 2e-14 * before);
}

TEST(Remap, VolumesOfOneShapeToAnotherKeepLinearFields)
{
  const GridPointer tetra = Tetra("f", Linear);
  const RemapPointer remap = MakeRemap(Bricks(4), tetra, Remap::CONSERVATIVE_SECOND_ORDER);
  remap->SetLimiter(Remap::NO_LIMITER);
  const std::vector<double> values = RemappedCells(remap, "f");
  const GridPointer bricks = Bricks(4);
  for (vtkIdType i = 0; i < bricks->GetNumberOfCells(); ++i)
  {
    Bounds b;
    bricks->GetCellBounds(i, b.data());
    const Point middle = { 0.5 * (b[0] + b[1]), 0.5 * (b[2] + b[3]), 0.5 * (b[4] + b[5]) };
    ASSERT_NEAR(values[static_cast<std::size_t>(i)], Linear(middle), 1e-12) << i;
  }
  EXPECT_LT(Reported(remap, "ConservationError"), 1e-13);
  EXPECT_NEAR(Reported(remap, "TargetIntegral"), Linear({ 0.5, 0.5, 0.5 }), 1e-12);
  EXPECT_NEAR(Reported(remap, "Coverage"), 1.0, 1e-14);
}

TEST(Remap, PointDataAreIntegratedAsLinearBetweenThePoints)
{
  const GridPointer tetra = WithData(MakeGrid(Transformed(Tetrahedra(3), 1.0 / 3.0, { 0, 0, 0 })));
  const GridPointer bricks = Bricks(2);
  const RemapPointer remap = MakeRemap(bricks, tetra, Remap::CONSERVATIVE_FIRST_ORDER);
  remap->GenerateOverlapMeshOn();
  const std::vector<double> values = RemappedCells(remap, "Linear");
  ASSERT_EQ(values.size(), 8u);
  EXPECT_NEAR(values[0], Linear({ 0.25, 0.25, 0.25 }), 1e-12);
  EXPECT_NEAR(values[7], Linear({ 0.75, 0.75, 0.75 }), 1e-12);
  auto* overlaps = vtkDataSet::SafeDownCast(remap->GetOutputDataObject(2));
  double sum = 0.0;
  for (const double measure : ValuesOf(overlaps->GetCellData()->GetArray("Measure")))
  {
    sum += measure;
  }
  EXPECT_NEAR(sum, 1.0, 1e-13);
}

/// As pieces of a mesh may have them.
TEST(Remap, PointDataOfPolyhedraDoNotDependOnTheOrderOfTheirPoints)
{
  const auto remapped = [](std::size_t factor)
  {
    const Mesh hexahedra = Hexahedra(2);
    const auto numberOf = [factor](std::size_t point) { return factor * point % 27; };
    Mesh mesh;
    mesh.Points.resize(27);
    for (std::size_t point = 0; point < 27; ++point)
    {
      mesh.Points[numberOf(point)] = hexahedra.Points[point];
    }
    for (const CellSpec& cell : hexahedra.Cells)
    {
      Ids corners;
      for (const vtkIdType corner : cell.Points)
      {
        corners.push_back(static_cast<vtkIdType>(numberOf(static_cast<std::size_t>(corner))));
      }
      mesh.Cells.push_back({ VTK_POLYHEDRON, PolyhedronOf(corners) });
    }
    const GridPointer grid = MakeGrid(Transformed(mesh, 0.5, { 0, 0, 0 }));
    grid->GetPointData()->AddArray(MakeArray("f", grid->GetNumberOfPoints(),
      [&](vtkIdType i)
      {
        const Point& x = mesh.Points[static_cast<std::size_t>(i)];
        return std::sin(7.0 * x[0] + 5.0 * x[1] + 3.0 * x[2]);
      }));
    return RemappedCells(MakeRemap(Bricks(3), grid, Remap::CONSERVATIVE_FIRST_ORDER), "f");
  };
  const std::vector<double> values = remapped(1);
  const std::vector<double> others = remapped(7);
  ASSERT_EQ(values.size(), 27u);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    EXPECT_NEAR(values[i], others[i], 1e-14) << i;
  }
}

TEST(Remap, ArraysOfCellsAndPointsWithOneNameAreReportedApart)
{
  const GridPointer tetra = WithData(MakeGrid(Transformed(Tetrahedra(3), 1.0 / 3.0, { 0, 0, 0 })));
  const auto n = static_cast<std::size_t>(tetra->GetNumberOfCells());
  const GridPointer source = WithCellArray(tetra, "Linear", std::vector<double>(n, 3.0));
  const RemapPointer remap = MakeRemap(Bricks(2), source, Remap::CONSERVATIVE_FIRST_ORDER);
  remap->Update();
  vtkFieldData* report = remap->GetOutputDataObject(0)->GetFieldData();
  vtkAbstractArray* names = report->GetAbstractArray("SkdReportArray");
  ASSERT_NE(names, nullptr);
  for (const auto& [name, integral] :
    { std::pair("Linear", 3.0), std::pair("Linear (points)", Linear({ 0.5, 0.5, 0.5 })) })
  {
    const vtkIdType row = names->LookupValue(vtkVariant(name));
    ASSERT_GE(row, 0) << name;
    for (const char* what : { "SourceIntegral", "OverlapIntegral", "TargetIntegral" })
    {
      vtkDataArray* values = report->GetArray((std::string("SkdReport") + what).c_str());
      EXPECT_NEAR(values->GetTuple1(row), integral, 1e-12) << name << " " << what;
    }
  }
}

TEST(Remap, PartlyCoveredCellsAreNormalisedAsAskedAndAmountsAreDivided)
{
  // Two unit squares, of which the target's first covers the second's left half and more.
  const auto source = WithCellArray(MakePolyData(Sheet(1, VTK_QUAD)), "f", { 8.0 });
  const auto input = MakePolyData(Transformed(Sheet(1, VTK_QUAD), 1.0, { 0.75, 0, 0 }));
  RemapPointer remap = MakeRemap(input, source, Remap::CONSERVATIVE_FIRST_ORDER);
  EXPECT_EQ(RemappedCells(remap, "f"), (std::vector<double>{ 8.0 }));
  EXPECT_EQ(RemappedCells(remap, "SkdCoverage"), (std::vector<double>{ 0.25 }));
  EXPECT_EQ(Reported(remap, "InputCellsPartlyCovered"), 1);
  remap->SetNormalization(Remap::WHOLE);
  EXPECT_EQ(RemappedCells(remap, "f"), (std::vector<double>{ 2.0 }));
  EXPECT_EQ(Reported(remap, "TargetIntegral"), 2.0);
  EXPECT_EQ(Reported(remap, "SourceIntegral"), 8.0);
  remap->AddExtensiveArray("f");
  remap->SetNormalization(Remap::COVERED);
  EXPECT_EQ(RemappedCells(remap, "f"), (std::vector<double>{ 2.0 }));
  remap->SetMinimumCoverage(0.5);
  EXPECT_TRUE(std::isnan(RemappedCells(remap, "f")[0]));
  EXPECT_EQ(RemappedCells(remap, "SkdValid"), (std::vector<double>{ 0.0 }));
}

TEST(Remap, MissingValuesDoNotCountOrSpread)
{
  const auto source =
    WithCellArray(MakePolyData(Sheet(2, VTK_QUAD)), "f", { 1.0, std::nan(""), -9999.0, 5.0 });
  WithCellArray(source, "m", { 1, 1, 1, 0 });
  const auto input = MakePolyData(Transformed(Sheet(1, VTK_QUAD), 2.0, { 0, 0, 0 }));
  RemapPointer remap = MakeRemap(input, source, Remap::CONSERVATIVE_FIRST_ORDER);
  remap->SetUseMissingValue(true);
  EXPECT_EQ(RemappedCells(remap, "f"), (std::vector<double>{ 3.0 }));
  EXPECT_EQ(Reported(remap, "Coverage"), 0.5);
  remap->SetMaskArray("m");
  EXPECT_EQ(RemappedCells(remap, "f"), (std::vector<double>{ 1.0 }));
  remap->SetMissingValues(Remap::SPREAD);
  EXPECT_TRUE(std::isnan(RemappedCells(remap, "f")[0]));
}

TEST(Remap, InterpolationGivesNanWhereValuesDoNotCount)
{
  const auto source =
    WithCellArray(MakePolyData(Sheet(2, VTK_QUAD)), "f", { 1.0, 2.0, -9999.0, 5.0 });
  WithCellArray(source, "m", { 1, 1, 1, 0 });
  const auto input = MakePolyData(Sheet(2, VTK_QUAD));
  RemapPointer remap = MakeRemap(input, source, Remap::INTERPOLATION);
  remap->SetResultsOn(Remap::CELLS);
  EXPECT_EQ(RemappedCells(remap, "f"), (std::vector<double>{ 1.0, 2.0, -9999.0, 5.0 }));
  remap->SetUseMissingValue(true);
  remap->SetMaskArray("m");
  const EventCounter events(remap);
  const std::vector<double> values = RemappedCells(remap, "f");
  EXPECT_EQ(values[0], 1.0);
  EXPECT_EQ(values[1], 2.0);
  EXPECT_TRUE(std::isnan(values[2]) && std::isnan(values[3]));
  EXPECT_TRUE(RemappedCells(remap, "m").empty());
  EXPECT_EQ(events.Warning, "");
  EXPECT_EQ(source->GetCellData()->GetArray("f")->GetTuple1(2), -9999.0); // still its own
}

TEST(Remap, CellsBetweenParallelsContainWhatIsBelowTheGreatCircle)
{
  const double radians = std::acos(-1.0) / 180.0;
  const auto at = [&](double longitude, double latitude)
  {
    const double lon = radians * longitude, lat = radians * latitude;
    return Point{ std::cos(lat) * std::cos(lon), std::cos(lat) * std::sin(lon), std::sin(lat) };
  };
  Mesh cell;
  cell.Points = { at(0, 60), at(90, 60), at(90, 80), at(0, 80) };
  cell.Cells = { { VTK_QUAD, { 0, 1, 2, 3 } } };
  // Below the circle's arc, which is at 67.8 degrees in the middle, and below that of 80 degrees;
  // beside; on corners and sides; on the other side of the Earth.
  Mesh samples;
  samples.Points = { at(45, 62), at(45, 79), at(45, 81), at(45, 59), at(-1, 70), at(0, 60),
    at(90, 70), at(30, 60), at(225, 70) };
  for (vtkIdType i = 0; i < 9; ++i)
  {
    samples.Cells.push_back({ VTK_VERTEX, { i } });
  }
  const auto source = MakeGrid(samples);
  source->GetPointData()->AddArray(
    MakeArray("f", 9, [](vtkIdType i) { return static_cast<double>(1 << i); }));
  RemapPointer remap = MakeRemap(MakePolyData(cell), source, Remap::CONTAINED);
  remap->SetGeometry(Remap::SPHERE);
  remap->SetStatistic(Remap::SUM);
  remap->SetInputEdgesAlongParallels(true);
  EXPECT_EQ(RemappedCells(remap, "f"), (std::vector<double>{ 1 + 2 + 32 + 64 + 128 }));
  remap->SetInputEdgesAlongParallels(false);
  EXPECT_EQ(RemappedCells(remap, "f"), (std::vector<double>{ 2 + 4 + 32 + 64 }));
}

TEST(Remap, StripsOnASphereContainNothingAndThisIsSaid)
{
  Mesh strip = CubedSphere(2);
  strip.Cells[0] = { VTK_TRIANGLE_STRIP, strip.Cells[0].Points };
  RemapPointer remap = MakeRemap(MakeGrid(strip), MakePolyData(CubedSphere(4)), Remap::CONTAINED);
  remap->SetGeometry(Remap::SPHERE);
  const EventCounter events(remap);
  remap->Update();
  EXPECT_NE(events.Warning.find("1 cells of Input contain nothing"), std::string::npos);
}

TEST(Remap, VectorsTurnWithTheSphere)
{
  const Mesh mesh = CubedSphere(4);
  const PolyDataPointer source = MakePolyData(mesh);
  vtkNew<vtkDoubleArray> east;
  east->SetName("east");
  east->SetNumberOfComponents(3);
  const std::vector<double> x = CellAverages(mesh, [](const Point& p) { return p[0]; });
  const std::vector<double> y = CellAverages(mesh, [](const Point& p) { return p[1]; });
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    const double length = std::max(std::hypot(x[i], y[i]), 1e-3);
    east->InsertNextTuple3(-y[i] / length, x[i] / length, 0.0);
  }
  source->GetCellData()->AddArray(east);
  const Mesh to = CubedSphere(6);
  RemapPointer remap = MakeRemap(MakePolyData(to), source, Remap::CONSERVATIVE_FIRST_ORDER);
  const std::vector<double> rotated = RemappedCells(remap, "east");
  const std::vector<double> cx = CellAverages(to, [](const Point& p) { return p[0]; });
  const std::vector<double> cy = CellAverages(to, [](const Point& p) { return p[1]; });
  const std::vector<double> cz = CellAverages(to, [](const Point& p) { return p[2]; });
  double along = 0.0;
  for (std::size_t i = 0; i < cx.size(); ++i)
  {
    along = std::max(along,
      std::abs(rotated[3 * i] * cx[i] + rotated[3 * i + 1] * cy[i] + rotated[3 * i + 2] * cz[i]));
  }
  EXPECT_LT(along, 1e-8); // they are tangent to the sphere, as well as its cells' middles are known
  remap->RotateVectorsOff();
  const std::vector<double> mapped = RemappedCells(remap, "east");
  EXPECT_EQ(mapped[2], 0.0);
  EXPECT_NE(mapped, rotated);
}

TEST(Remap, AutomaticallyCellDataAreConservedAndPointDataInterpolated)
{
  const auto source = WithData(MakeGrid(Transformed(Hexahedra(3), 1.0 / 3.0, { 0, 0, 0 })));
  const auto input = Bricks(2);
  RemapPointer remap = MakeRemap(input, source, Remap::AUTOMATIC_METHOD);
  const std::vector<double> linear = RemappedPoints(remap, "Linear");
  ASSERT_EQ(linear.size(), 27u);
  for (vtkIdType i = 0; i < 27; ++i)
  {
    Point p;
    input->GetPoint(i, p.data());
    ASSERT_NEAR(linear[static_cast<std::size_t>(i)], Linear(p), 1e-12);
  }
  EXPECT_EQ(RemappedCells(remap, "Number").size(), 8u);
  EXPECT_TRUE(RemappedCells(remap, "Linear").empty());
  remap->SetMethod(Remap::INTERPOLATION);
  remap->SetResultsOn(Remap::CELLS);
  remap->AddGradientArray("Linear");
  EXPECT_NEAR(RemappedCells(remap, "Linear")[0], Linear({ 0.25, 0.25, 0.25 }), 1e-12);
  EXPECT_NEAR(RemappedCells(remap, "Linear_Gradient")[1], -2.0, 1e-10);
}

TEST(Remap, ContainedStatisticsCountAndLump)
{
  const auto source =
    WithData(MakePolyData(Transformed(Sheet(8, VTK_QUAD), 0.25, { 0.01, 0.01, 0 })));
  const auto input = MakePolyData(Sheet(2, VTK_QUAD));
  RemapPointer remap = MakeRemap(input, source, Remap::CONTAINED);
  EXPECT_EQ(RemappedCells(remap, "SkdCount"), (std::vector<double>{ 16, 16, 16, 16 }));
  const std::vector<double> numbers = RemappedCells(remap, "Number");
  EXPECT_DOUBLE_EQ(numbers[0], 10 * 13.5);
  remap->SetStatistic(Remap::MAXIMUM);
  EXPECT_EQ(RemappedCells(remap, "Number")[0], 10 * 27);
  remap->SetStatistic(Remap::MEAN);
  remap->SetResultsOn(Remap::POINTS);
  const std::vector<double> points = RemappedPoints(remap, "Number");
  EXPECT_DOUBLE_EQ(points[4], 0.25 * (numbers[0] + numbers[1] + numbers[2] + numbers[3]));
  EXPECT_DOUBLE_EQ(points[0], numbers[0]);
}

TEST(Remap, WhatIsContainedIsShown)
{
  const auto input = MakeGrid(Transformed(Hexahedra(1), 3.0, { -0.1, -0.1, -0.1 }));
  for (const char* name : { "f", "c", "SkdCount" })
  {
    for (const bool isOfPoints : { true, false })
    {
      const auto only = [isOfPoints](vtkDataSet* mesh)
      {
        mesh->GetAttributes(isOfPoints ? vtkDataObject::CELL : vtkDataObject::POINT)
          ->RemoveArray(isOfPoints ? "c" : "f");
      };
      const auto blocks = MakeAMR();
      const GridPointer grid = ShownCellsOf(blocks);
      only(blocks->GetDataSet(0, 0));
      only(blocks->GetDataSet(1, 0));
      only(grid);
      EXPECT_EQ(RemappedCells(MakeRemap(input, blocks, Remap::CONTAINED), name),
        RemappedCells(MakeRemap(input, grid, Remap::CONTAINED), name))
        << name << isOfPoints;
    }
  }
}

TEST(Remap, LumpedMassesKeepTheIntegral)
{
  const SpherePair pair(4, 4);
  RemapPointer remap = MakeRemap(pair.Input, pair.Source, Remap::CONSERVATIVE_FIRST_ORDER);
  remap->SetResultsOn(Remap::POINTS);
  const std::vector<double> values = RemappedPoints(remap, "f");
  ASSERT_EQ(values.size(), pair.To.Points.size());
  const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
  EXPECT_GE(*least, 1.0);
  EXPECT_LE(*greatest, 3.0);
}

TEST(Remap, IsTheSameOnAnyNumberOfThreads)
{
  const SpherePair pair(6, 8);
  const auto run = [&]
  {
    return RemappedCells(MakeRemap(pair.Input, pair.Source, Remap::CONSERVATIVE_SECOND_ORDER), "f");
  };
  const std::vector<double> values = run();
  vtkSMPTools::LocalScope(vtkSMPTools::Config{ 1 }, [&] { EXPECT_EQ(run(), values); });
}
