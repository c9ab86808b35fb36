// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeRemap between surfaces in space that nearly coincide.

#include "Support/EventCounter.h"
#include "Support/Folders.h"
#include "Support/RealMeshes.h"
#include "Support/RemapRun.h"
#include "Support/SurfaceMeshes.h"

#include "vtkMultiBlockDataSet.h"
#include "vtkQuadricDecimation.h"
#include "vtkTable.h"

#include <gtest/gtest.h>

#include <filesystem>

using namespace skdtest;

namespace
{
using Remap = vtkSkdTreeRemap;
using Function = std::function<double(const Point&)>;

constexpr double Pi = 3.14159265358979323846;

/// A tube of radius 1 and length 2 about the z axis, normals outward. Triangles may be skewed.
Mesh Tube(int around, int along, double rotated, double skew, bool isOfTriangles)
{
  Mesh mesh;
  for (int k = 0; k <= along; ++k)
  {
    for (int i = 0; i < around; ++i)
    {
      const double angle = 2.0 * Pi * (i + rotated + skew * k) / around;
      mesh.Add(Point{ std::cos(angle), std::sin(angle), 2.0 * k / along });
    }
  }
  for (int k = 0; k < along; ++k)
  {
    for (int i = 0; i < around; ++i)
    {
      const vtkIdType a = k * around + i, b = k * around + (i + 1) % around;
      mesh.Add(VTK_QUAD, { a, b, b + around, a + around });
    }
  }
  return isOfTriangles ? Triangulated(mesh) : mesh;
}

struct Cells
{
  std::vector<double> Areas;
  std::vector<Point> Middles;
};

/// As the triangles of the edges and the mean of the corners.
Cells CellsOf(const Mesh& mesh)
{
  Cells cells;
  for (const CellSpec& cell : mesh.Cells)
  {
    Point middle{ 0, 0, 0 };
    for (const vtkIdType id : cell.Points)
    {
      middle = middle + (1.0 / cell.Points.size()) * mesh.Points[id];
    }
    double area = 0.0;
    for (std::size_t i = 0; i < cell.Points.size(); ++i)
    {
      const Point& a = mesh.Points[cell.Points[i]];
      const Point& b = mesh.Points[cell.Points[(i + 1) % cell.Points.size()]];
      area += 0.5 * Length(Cross(a - middle, b - middle));
    }
    cells.Areas.push_back(area);
    cells.Middles.push_back(middle);
  }
  return cells;
}

std::vector<double> At(const Mesh& mesh, const Function& f)
{
  std::vector<double> values;
  for (const Point& middle : CellsOf(mesh).Middles)
  {
    values.push_back(f(middle));
  }
  return values;
}

double IntegralOf(const Mesh& mesh, const std::vector<double>& values)
{
  const Cells cells = CellsOf(mesh);
  double sum = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    sum += cells.Areas[i] * values[i];
  }
  return sum;
}

RemapPointer RemapOf(const Mesh& from, const std::vector<double>& values, const Mesh& to,
  int method = Remap::CONSERVATIVE_FIRST_ORDER)
{
  return MakeRemap(MakePolyData(to), WithCellArray(MakePolyData(from), "f", values), method);
}

double Smooth(const Point& x)
{
  return 2.0 + x[0] * x[1] + std::cos(1.5 * x[2]);
}

/// The root of the mean square of what results are off.
double ErrorOf(const Mesh& from, const Mesh& to, int method)
{
  const RemapPointer remap = RemapOf(from, At(from, Smooth), to, method);
  remap->SetLimiter(Remap::NO_LIMITER);
  remap->SetGeometry(Remap::CURVED_SURFACE);
  std::vector<double> squares = RemappedCells(remap, "f");
  const std::vector<double> exact = At(to, Smooth);
  for (std::size_t i = 0; i < squares.size(); ++i)
  {
    squares[i] = (squares[i] - exact[i]) * (squares[i] - exact[i]);
  }
  return std::sqrt(
    IntegralOf(to, squares) / IntegralOf(to, std::vector<double>(squares.size(), 1.0)));
}

/// Turned about two axes, so that no edges of two spheres coincide.
Mesh Rotated(Mesh mesh)
{
  const double c = std::cos(0.4), s = std::sin(0.4);
  return mesh.Map(
    [&](const Point& p)
    {
      const Point q{ c * p[0] - s * p[1], s * p[0] + c * p[1], p[2] };
      return Point{ q[0], c * q[1] - s * q[2], s * q[1] + c * q[2] };
    });
}

/// Of a radius that is not quite 1.
Mesh Dented(Mesh mesh)
{
  return mesh.Map([](const Point& p) { return (1.0 + 0.002 * std::sin(3.0 * p[0])) * p; });
}

std::string WarningsOf(vtkSkdTreeRemap* remap)
{
  const EventCounter events(remap);
  remap->Update();
  EXPECT_EQ(events.Errors, 0) << events.Error;
  return events.Warning;
}

/// Two sheets of 5 x 5 and one unit, the upper one facing up, the lower one down.
Mesh Plate(int n, double bottom, double top)
{
  const Mesh upper = Transformed(Sheet(n, VTK_QUAD), 5.0 / n, { 0, 0, top });
  Mesh lower = Transformed(Sheet(n, VTK_QUAD), 5.0 / n, { 0, 0, bottom });
  for (CellSpec& cell : lower.Cells)
  {
    std::reverse(cell.Points.begin(), cell.Points.end());
  }
  return Together({ upper, lower });
}

/// 1 on its first half, 2 on the other.
std::vector<double> Halves(const Mesh& mesh)
{
  std::vector<double> values(mesh.Cells.size(), 2.0);
  std::fill_n(values.begin(), values.size() / 2, 1.0);
  return values;
}

Mesh Reversed(Mesh mesh)
{
  for (CellSpec& cell : mesh.Cells)
  {
    std::reverse(cell.Points.begin(), cell.Points.end());
  }
  return mesh;
}
}

TEST(RemapNearSurfaces, IntegralsAndConstantsAreKept)
{
  struct Pair
  {
    Mesh From, To;
  };
  const Pair pairs[] = { { Tube(17, 6, 0.0, 0.0, false), Tube(23, 9, 0.3, 0.2, true) },
    { SphereTriangles(6), Dented(Rotated(SphereTriangles(7))) },
    { Dented(Rotated(SphereQuads(7))), SphereTriangles(6) },
    { TorusQuads(24, 12), TorusTriangles(31, 17) } };
  for (const auto& [from, to] : pairs)
  {
    const std::vector<double> values = At(from, Smooth);
    const double whole = IntegralOf(from, values);
    for (const int method : { Remap::CONSERVATIVE_FIRST_ORDER, Remap::CONSERVATIVE_SECOND_ORDER })
    {
      for (const int limiter :
        { Remap::NO_LIMITER, Remap::BARTH_JESPERSEN, Remap::CLIP_AND_ASSURED_SUM })
      {
        const RemapPointer remap = RemapOf(from, values, to, method);
        remap->SetLimiter(limiter);
        remap->Update();
        EXPECT_NEAR(Reported(remap, "TargetIntegral"), whole, 1e-13 * whole);
        EXPECT_NEAR(Reported(remap, "SourceIntegral"), whole, 1e-13 * whole);
        EXPECT_LE(Reported(remap, "ConservationError"), 1e-14);
        remap->SetNormalization(Remap::WHOLE);
        EXPECT_NEAR(IntegralOf(to, RemappedCells(remap, "f")), whole, 1e-13 * whole);
      }
    }
    const std::vector<double> constant(from.Cells.size(), 0.3);
    const RemapPointer remap = RemapOf(from, constant, to, Remap::CONSERVATIVE_SECOND_ORDER);
    EXPECT_EQ(RemappedCells(remap, "f"), std::vector<double>(to.Cells.size(), 0.3));
    EXPECT_EQ(Reported(remap, "InputCellsEmpty"), 0);
  }
}

TEST(RemapNearSurfaces, ErrorsFallWithTheOrder)
{
  const auto expect = [](const std::function<Mesh(int)>& from, const std::function<Mesh(int)>& to)
  {
    const double first[] = { ErrorOf(from(1), to(1), Remap::CONSERVATIVE_FIRST_ORDER),
      ErrorOf(from(2), to(2), Remap::CONSERVATIVE_FIRST_ORDER) };
    const double second[] = { ErrorOf(from(1), to(1), Remap::CONSERVATIVE_SECOND_ORDER),
      ErrorOf(from(2), to(2), Remap::CONSERVATIVE_SECOND_ORDER) };
    EXPECT_GT(first[0] / first[1], 1.8);
    EXPECT_GT(second[0] / second[1], 3.4);
    EXPECT_LT(second[1], 0.2 * first[1]);
  };
  expect([](int n) { return Tube(17 * n, 6 * n, 0.0, 0.0, false); },
    [](int n) { return Tube(23 * n, 9 * n, 0.3, 0.2, true); });
  expect([](int n) { return SphereTriangles(7 * n); },
    [](int n) { return Rotated(SphereQuads(8 * n)); });
}

TEST(RemapNearSurfaces, LimitersBound)
{
  const Mesh from = Tube(17, 6, 0.0, 0.0, false);
  const std::vector<double> jump = At(from, [](const Point& p) { return p[0] > 0.1 ? 1.0 : 0.0; });
  for (const int limiter : { Remap::BARTH_JESPERSEN, Remap::CLIP_AND_ASSURED_SUM })
  {
    const RemapPointer remap =
      RemapOf(from, jump, Tube(23, 9, 0.3, 0.2, true), Remap::CONSERVATIVE_SECOND_ORDER);
    remap->SetLimiter(limiter);
    for (const double value : RemappedCells(remap, "f"))
    {
      EXPECT_GE(value, -1e-15);
      EXPECT_LE(value, 1.0 + 1e-15);
    }
  }
}

TEST(RemapNearSurfaces, FlatOnesAreAsInThePlane)
{
  const Mesh from = Transformed(Sheet(5, VTK_QUAD), 1.0, { 0, 0, 0 });
  const Mesh to = Transformed(Sheet(7, VTK_TRIANGLE), 0.75, { -0.1, 0.05, 0 });
  for (const int method : { Remap::CONSERVATIVE_FIRST_ORDER, Remap::CONSERVATIVE_SECOND_ORDER })
  {
    const RemapPointer plane = RemapOf(from, At(from, Smooth), to, method);
    const RemapPointer curved = RemapOf(from, At(from, Smooth), to, method);
    curved->SetGeometry(Remap::CURVED_SURFACE);
    for (const char* name : { "f", "SkdCoverage", "SkdFraction" })
    {
      const std::vector<double> expected = RemappedCells(plane, name);
      const std::vector<double> found = RemappedCells(curved, name);
      ASSERT_EQ(expected.size(), found.size());
      for (std::size_t i = 0; i < found.size(); ++i)
      {
        EXPECT_NEAR(found[i], expected[i], 1e-13);
      }
    }
  }
}

// Also where the sides of one mesh are nearer to the wrong sides of the other.
TEST(RemapNearSurfaces, SidesOfAPlateDoNotMix)
{
  for (const double top : { 0.5, 0.05 })
  {
    const Mesh plate = Plate(5, 0.0, top), to = Plate(7, -0.02, top - 0.02);
    for (const Mesh& target : { to, Reversed(to) })
    {
      const RemapPointer remap = RemapOf(plate, Halves(plate), target);
      EXPECT_EQ(WarningsOf(remap), "");
      EXPECT_EQ(RemappedCells(remap, "f"), Halves(to));
    }
  }
  // Of a thinner one what is thick elsewhere tells which side is which.
  const Mesh from =
    Together({ Plate(5, 0.0, 0.01), Transformed(Plate(5, 0.0, 1.0), 3.0, { 20, 0, 0 }) });
  const Mesh to =
    Together({ Plate(7, -0.02, -0.01), Transformed(Plate(7, 0.0, 1.0), 3.0, { 20, 0, 0 }) });
  const auto sides = [](const Mesh& mesh, int n)
  {
    std::vector<double> values;
    for (std::size_t i = 0; i < mesh.Cells.size(); ++i)
    {
      values.push_back(i / (n * n) % 2 == 0 ? 1.0 : 2.0);
    }
    return values;
  };
  const RemapPointer remap = RemapOf(from, sides(from, 5), to);
  EXPECT_EQ(RemappedCells(remap, "f"), sides(to, 7));
}

TEST(RemapNearSurfaces, MeshesThatTellNoSideAreToldOf)
{
  const Mesh from = Plate(5, 0.0, 0.5);
  Mesh to = Plate(7, -0.02, 0.48);
  for (std::size_t i = 0; i < to.Cells.size(); i += 2)
  {
    std::reverse(to.Cells[i].Points.begin(), to.Cells[i].Points.end());
  }
  RemapPointer remap = RemapOf(from, Halves(from), to);
  remap->SetSurfaceDistance(0.1);
  EXPECT_NE(WarningsOf(remap).find("ordered in no one way"), std::string::npos);
  EXPECT_EQ(RemappedCells(remap, "f"), Halves(to));
}

TEST(RemapNearSurfaces, WhatHasNoPartnerIsToldOf)
{
  const Mesh from = Tube(40, 20, 0.0, 0.0, false);
  Mesh half = Tube(44, 10, 0.3, 0.0, false);
  half.Map([](const Point& p) { return Point{ p[0], p[1], 0.5 * p[2] }; });
  const std::vector<double> values = At(from, Smooth);
  RemapPointer remap = RemapOf(from, values, half);
  EXPECT_NE(WarningsOf(remap).find("cells of Source (50.0"), std::string::npos);
  EXPECT_NEAR(Reported(remap, "SourceCoverage"), 0.5, 1e-13);
  EXPECT_LE(Reported(remap, "ConservationError"), 1e-14);
  EXPECT_NEAR(Reported(remap, "OverlapIntegral"), Reported(remap, "TargetIntegral"), 1e-12);

  Mesh wide = Tube(44, 18, 0.3, 0.0, false);
  wide.Map([](const Point& p) { return Point{ 1.3 * p[0], 1.3 * p[1], p[2] }; });
  remap = RemapOf(from, values, wide);
  EXPECT_NE(WarningsOf(remap).find("set SurfaceDistance"), std::string::npos);
  remap->SetSurfaceDistance(0.35);
  EXPECT_EQ(WarningsOf(remap), "");
  EXPECT_NEAR(Reported(remap, "TargetIntegral"), IntegralOf(from, values), 1e-12);
  EXPECT_NEAR(Reported(remap, "SurfaceGap"), 0.3, 0.01);
  remap->SetSurfaceAngle(2.0);
  EXPECT_NE(WarningsOf(remap), "");
  EXPECT_LT(Reported(remap, "SourceCoverage"), 0.9);
}

TEST(RemapNearSurfaces, FoldsAreSharedOut)
{
  Mesh to; // a strip with a pleat between x = 1.5 and 2
  const double x[] = { 0, 1, 2, 1.5, 3, 4 }, z[] = { 0, 0, 0.02, 0.04, 0, 0 };
  for (int i = 0; i < 6; ++i)
  {
    to.Add(Point{ x[i], 0, z[i] });
    to.Add(Point{ x[i], 4, z[i] });
  }
  for (vtkIdType i = 0; i < 5; ++i)
  {
    to.Add(VTK_QUAD, { 2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1 });
  }
  const Mesh from = Sheet(4, VTK_QUAD);
  const std::vector<double> values = At(from, Smooth);
  const RemapPointer remap = RemapOf(from, values, to, Remap::CONSERVATIVE_SECOND_ORDER);
  remap->SetNormalization(Remap::WHOLE);
  remap->SetLimiter(Remap::NO_LIMITER);
  const std::string warning = WarningsOf(remap);
  const std::vector<double> found = RemappedCells(remap, "f");
  double sum = 0.0;
  const Cells cells = CellsOf(to);
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    sum += std::isnan(found[i]) ? 0.0 : found[i] * cells.Areas[i];
  }
  EXPECT_NEAR(sum, IntegralOf(from, values), 1e-13 * sum);
  EXPECT_NE(warning.find("4 cells of Source are covered more than once"), std::string::npos)
    << warning;
}

TEST(RemapNearSurfaces, BlocksAreAsOneMesh)
{
  const Mesh from = Tube(17, 6, 0.0, 0.0, false), to = Tube(23, 9, 0.3, 0.2, true);
  const auto part = [&](bool isFirst)
  { return Part(to, [&](std::size_t i) { return (i < to.Cells.size() / 3) == isFirst; }); };
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, MakePolyData(part(true)));
  blocks->SetBlock(1, MakePolyData(part(false)));
  const auto source = WithCellArray(MakePolyData(from), "f", At(from, Smooth));
  const RemapPointer remap = MakeRemap(blocks, source, Remap::CONSERVATIVE_SECOND_ORDER);
  remap->Update();
  auto* output = vtkMultiBlockDataSet::SafeDownCast(remap->GetOutputDataObject(0));
  std::vector<double> found;
  for (unsigned int i = 0; i < 2; ++i)
  {
    const std::vector<double> some =
      ValuesOf(vtkDataSet::SafeDownCast(output->GetBlock(i))->GetCellData()->GetArray("f"));
    found.insert(found.end(), some.begin(), some.end());
  }
  const RemapPointer whole = RemapOf(from, At(from, Smooth), to, Remap::CONSERVATIVE_SECOND_ORDER);
  const std::vector<double> expected = RemappedCells(whole, "f");
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    EXPECT_NEAR(found[i], expected[i], 1e-14);
  }
  EXPECT_NEAR(Reported(remap, "TargetIntegral"), Reported(whole, "TargetIntegral"), 1e-13);
  EXPECT_EQ(Reported(remap, "WeightsFound"), 2);
  source->GetCellData()->GetArray("f")->Modified();
  remap->Modified();
  remap->Update();
  EXPECT_EQ(Reported(remap, "WeightsFound"), 0);
}

TEST(RemapNearSurfaces, PointDataWeightsAndOverlaps)
{
  const Mesh from = Dented(Rotated(SphereQuads(9))), to = SphereTriangles(10);
  const auto source = MakePolyData(from);
  source->GetPointData()->AddArray(MakeArray("p", source->GetNumberOfPoints(),
    [&](vtkIdType i) { return Smooth(from.Points[static_cast<std::size_t>(i)]); }));
  source->GetPointData()->AddArray(
    MakeArray("one", source->GetNumberOfPoints(), [](vtkIdType) { return 1.0; }));
  const RemapPointer remap = MakeRemap(MakePolyData(to), source, Remap::CONSERVATIVE_FIRST_ORDER);
  remap->GenerateWeightsOn();
  remap->GenerateOverlapMeshOn();
  EXPECT_EQ(RemappedCells(remap, "one"), std::vector<double>(to.Cells.size(), 1.0));
  const Cells cells = CellsOf(to);
  const std::vector<double> values = RemappedCells(remap, "p");
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    EXPECT_NEAR(values[i], Smooth(cells.Middles[i]), 0.03);
  }
  EXPECT_LE(Reported(remap, "ConservationError"), 1e-14);
  const double area = IntegralOf(from, std::vector<double>(from.Cells.size(), 1.0));
  auto* table = vtkTable::SafeDownCast(remap->GetOutputDataObject(1));
  double sum = 0.0;
  for (const double measure :
    ValuesOf(vtkDataArray::SafeDownCast(table->GetColumnByName("Measure"))))
  {
    sum += measure;
  }
  EXPECT_NEAR(sum, area, 1e-13 * area);
  auto* overlaps = vtkDataSet::SafeDownCast(remap->GetOutputDataObject(2));
  sum = 0.0;
  for (const double measure : ValuesOf(overlaps->GetCellData()->GetArray("Measure")))
  {
    sum += measure;
  }
  EXPECT_NEAR(sum, area, 1e-13 * area);
}

TEST(RemapNearSurfaces, AmountsAreKept)
{
  const Mesh from = Tube(17, 6, 0.0, 0.0, false), to = Tube(23, 9, 0.3, 0.2, true);
  const RemapPointer remap = RemapOf(from, std::vector<double>(from.Cells.size(), 2.0), to);
  remap->AddExtensiveArray("f");
  double sum = 0.0;
  for (const double amount : RemappedCells(remap, "f"))
  {
    sum += amount;
  }
  EXPECT_NEAR(sum, 2.0 * from.Cells.size(), 1e-11);
}

// Also one whose halves are equal, so that it has no area and no normal.
TEST(RemapNearSurfaces, PolygonsThatCrossThemselvesAreToldOf)
{
  const Mesh from = Tube(17, 6, 0.0, 0.0, false);
  Mesh to = Tube(23, 9, 0.3, 0.0, true);
  const Ids ids{ to.Add(Point{ 0.5, 0, 1 }), to.Add(Point{ 0.5, 0.25, 1.25 }),
    to.Add(Point{ 0.5, 0.25, 1 }), to.Add(Point{ 0.5, 0, 1.25 }) };
  to.Add(VTK_POLYGON, ids);
  const RemapPointer remap = RemapOf(from, At(from, Smooth), to);
  const std::string warning = WarningsOf(remap);
  EXPECT_NE(
    warning.find("1 polygons of Input (the first: cell 414) cross themselves"), std::string::npos)
    << warning;
}

TEST(RemapNearSurfaces, TheAutomaticMethodTakesThemIfToldTo)
{
  const Mesh from = Plate(5, 0.0, 0.05), to = Plate(7, -0.02, 0.03);
  const RemapPointer remap = RemapOf(from, Halves(from), to, Remap::AUTOMATIC_METHOD);
  remap->SetGeometry(Remap::CURVED_SURFACE);
  EXPECT_EQ(WarningsOf(remap), "");
  EXPECT_EQ(RemappedCells(remap, "f"), Halves(to));
  EXPECT_LE(Reported(remap, "ConservationError"), 1e-14);
}

TEST(RemapNearSurfaces, AScanAndItsDecimation)
{
  const std::string file = ExtraDataFolder() + "/A_surface/dragon_res4.ply";
  if (!std::filesystem::exists(file))
  {
    GTEST_SKIP() << "there is no " << file;
  }
  const DataSetPointer scan = ReadMesh(file);
  vtkNew<vtkQuadricDecimation> decimation;
  decimation->SetInputData(scan);
  decimation->SetTargetReduction(0.8);
  decimation->Update();
  vtkNew<vtkPolyData> coarse;
  coarse->ShallowCopy(decimation->GetOutput());
  coarse->GetCellData()->AddArray(MakeArray(
    "f", coarse->GetNumberOfCells(), [](vtkIdType i) { return 1.0 + std::sin(double(i)); }));
  coarse->GetCellData()->AddArray(
    MakeArray("one", coarse->GetNumberOfCells(), [](vtkIdType) { return 0.3; }));
  const RemapPointer remap = MakeRemap(scan, coarse, Remap::CONSERVATIVE_FIRST_ORDER);
  for (const double value : RemappedCells(remap, "one"))
  {
    EXPECT_TRUE(value == 0.3 || std::isnan(value));
  }
  EXPECT_LE(Reported(remap, "ConservationError"), 1e-13);
  EXPECT_GT(Reported(remap, "SourceCoverage"), 0.99);
  EXPECT_LT(Reported(remap, "InputCellsEmpty"), 450);
}
