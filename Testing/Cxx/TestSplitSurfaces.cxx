// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeSurfaceIntersection: both surfaces split along the curves.

#include "Support/SplitSurfaceRun.h"

#include "Support/ClosestPointRun.h"
#include "Support/Folders.h"
#include "Support/NamedMeshes.h"
#include "Support/RealMeshes.h"
#include "Support/SurfaceMeshes.h"

#include "vtkDoubleArray.h"
#include "vtkSMPTools.h"
#include "vtkStringArray.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace skdtest;

namespace
{

IntersectionPointer MakeSplit(vtkDataObject* input, vtkDataObject* source = nullptr)
{
  auto filter = MakeIntersection(input, source);
  filter->SplitSurfacesOn();
  filter->JoinCurvesOff();
  filter->Update();
  return filter;
}

SplitSurface InputOf(vtkSkdTreeSurfaceIntersection* filter)
{
  return SplitSurface(OutputOf(filter, 4));
}

SplitSurface SourceOf(vtkSkdTreeSurfaceIntersection* filter)
{
  return SplitSurface(OutputOf(filter, 5));
}

/// Each cell's pieces make up the cell: vector areas, so nothing is flipped or left out.
void ExpectAreasKept(const SplitSurface& split, const Mesh& mesh, double tolerance = 1e-12)
{
  const auto areas = split.AreasOfCells();
  double total = 0.0;
  for (std::size_t cell = 0; cell < mesh.Cells.size(); ++cell)
  {
    const auto& ids = mesh.Cells[cell].Points;
    Point area = { 0, 0, 0 };
    for (std::size_t i = 2; i < ids.size(); ++i)
    {
      area = area +
        0.5 *
          Cross(mesh.Points[ids[i - 1]] - mesh.Points[ids[0]],
            mesh.Points[ids[i]] - mesh.Points[ids[0]]);
    }
    total += Length(area);
    const auto found = areas.find(static_cast<vtkIdType>(cell));
    ASSERT_NE(found, areas.end()) << "cell " << cell;
    EXPECT_LE(Length(found->second - area), tolerance * Length(area)) << "cell " << cell;
  }
  EXPECT_NEAR(split.Area(), total, tolerance * total);
}

/// The least distance to one of the points.
double DistanceTo(const Point& x, const std::vector<Point>& points)
{
  double least = 1e300;
  for (const Point& p : points)
  {
    least = std::min(least, Distance(x, p));
  }
  return least;
}

/// The ends of all segments of the curves are corners of a split surface.
void ExpectEndsAreCorners(vtkSkdTreeSurfaceIntersection* filter, const SplitSurface& split)
{
  for (const auto& [p, q, a, b] : SegmentsOf(OutputOf(filter, 0)))
  {
    EXPECT_LT(DistanceTo(p, split.Points), 1e-14) << a << " " << b;
    EXPECT_LT(DistanceTo(q, split.Points), 1e-14) << a << " " << b;
  }
}

//------------------------------------------------------------------------------
TEST(SplitSurfaces, AreNoneUnlessAskedFor)
{
  auto sphere = MakePolyData(SphereTriangles(6));
  auto filter =
    MakeIntersection(sphere, MakePolyData(Transformed(SphereTriangles(6), 1, { 1, 0, 0 })));
  filter->Update();
  EXPECT_EQ(OutputOf(filter, 4)->GetNumberOfCells(), 0);
  filter->SplitSurfacesOn();
  filter->SetPairsToWhetherAny();
  filter->Update();
  EXPECT_EQ(OutputOf(filter, 4)->GetNumberOfCells(), 0);
}

TEST(SplitSurfaces, TwoSpheresAreCutInTwoRegionsEach)
{
  const Mesh first = SphereTriangles(16);
  const Mesh second = Transformed(SphereTriangles(15), 0.9, { 0.31, 0.67, 0.5 });
  auto filter = MakeSplit(MakePolyData(first), MakePolyData(second));
  const SplitSurface a = InputOf(filter);
  const SplitSurface b = SourceOf(filter);
  EXPECT_EQ(a.CountRegions(), 2);
  EXPECT_EQ(b.CountRegions(), 2);
  EXPECT_EQ(a.CountBorderEdges(), 0u);
  EXPECT_EQ(b.CountBorderEdges(), 0u);
  ExpectAreasKept(a, first);
  ExpectAreasKept(b, second);
  const auto edgesOfA = a.Edges();
  const auto edgesOfB = b.Edges();
  for (const auto& [p, q, cellOfA, cellOfB] : SegmentsOf(OutputOf(filter, 0)))
  {
    EXPECT_TRUE(edgesOfA.count({ p, q }));
    EXPECT_TRUE(edgesOfB.count({ p, q }));
  }
  EXPECT_GT(Reported(filter, "InputTrianglesSplit"), 40.0);
}

TEST(SplitSurfaces, WhatDoesNotMeetStaysAsItIs)
{
  const Mesh first = SphereTriangles(4);
  auto filter =
    MakeSplit(MakePolyData(first), MakePolyData(Transformed(SphereTriangles(4), 1.0, { 9, 0, 0 })));
  const SplitSurface split = InputOf(filter);
  ASSERT_EQ(split.Triangles.size(), first.Cells.size());
  for (std::size_t i = 0; i < split.Triangles.size(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_EQ(split.Points[split.Triangles[i][k]], first.Points[first.Cells[i].Points[k]]);
    }
  }
}

//------------------------------------------------------------------------------
// What the surfaces are cut along has the same edges in both: seen from either, the triangles on
// the sides of a common edge meet the other surface along it.
class LatticeSplit : public testing::TestWithParam<int>
{
};

/// Where segments meet, cross, overlap in one triangle; corners on edges; areas in areas.
TEST_P(LatticeSplit, KeepsAreasAndBorders)
{
  for (int seed = 0; seed < 25; ++seed)
  {
    const Mesh first = LatticeTriangles(12, GetParam(), 2 * seed + 1);
    const Mesh second = LatticeTriangles(9, GetParam(), 2 * seed + 2);
    auto filter = MakeSplit(MakePolyData(first), MakePolyData(second));
    ExpectAreasKept(InputOf(filter), first);
    ExpectAreasKept(SourceOf(filter), second);
    ExpectEndsAreCorners(filter, InputOf(filter));
    ExpectEndsAreCorners(filter, SourceOf(filter));
  }
}

/// Split surfaces that are looked at again meet in whole edges, corners and pieces only: cells that
/// touch in a segment have it as an edge, those that overlap... on lattices nothing is rounded
/// away when crossings are, so points are compared: no corner lies inside of an edge or piece.
TEST_P(LatticeSplit, PiecesOfOneSurfaceMeetInPoints)
{
  for (int seed = 0; seed < 10; ++seed)
  {
    const Mesh mesh = LatticeTriangles(14, GetParam(), 77 + seed);
    auto filter = MakeSplit(MakePolyData(mesh));
    const SplitSurface split = InputOf(filter);
    ExpectAreasKept(split, mesh);
    EXPECT_EQ(OutputOf(filter, 5)->GetNumberOfCells(), 0);
    // No corner lies on an edge's inside, to rounding.
    const auto edges = split.Edges();
    for (const auto& [p, q] : edges)
    {
      for (const Point& x : split.Points)
      {
        const double length = Length(q - p);
        const double t = Dot(x - p, q - p) / (length * length);
        const double miss = Length(Cross(x - p, q - p)) / length;
        EXPECT_FALSE(t > 1e-9 && t < 1.0 - 1e-9 && miss < 1e-12)
          << "seed " << seed << " t " << t << " miss " << miss;
      }
    }
  }
}

/// Both surfaces: the corners of either that lie on the other are corners of the other.
TEST_P(LatticeSplit, BothHaveTheSamePointsWhereTheyMeet)
{
  for (int seed = 0; seed < 10; ++seed)
  {
    const Mesh first = LatticeTriangles(10, GetParam(), 177 + seed);
    const Mesh second = LatticeTriangles(10, GetParam(), 277 + seed);
    auto filter = MakeSplit(MakePolyData(first), MakePolyData(second));
    const SplitSurface sides[2] = { InputOf(filter), SourceOf(filter) };
    for (int side = 0; side < 2; ++side)
    {
      const SplitSurface& of = sides[side];
      const auto edges = of.Edges();
      for (const Point& x : sides[1 - side].Points)
      {
        for (const auto& [p, q] : edges)
        {
          const double length = Length(q - p);
          const double t = Dot(x - p, q - p) / (length * length);
          const double miss = Length(Cross(x - p, q - p)) / length;
          EXPECT_FALSE(t > 1e-9 && t < 1.0 - 1e-9 && miss < 1e-12) << "seed " << seed;
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Reaches, LatticeSplit, testing::Values(2, 3, 5, 9));

//------------------------------------------------------------------------------
TEST(SplitSurfaces, SquaresOfOnePlaneKeepBothPiecesOfTheirOverlap)
{
  const Mesh first = Square(0, 0, 1);
  const Mesh second = Square(0.5, 0.25, 1);
  auto filter = MakeSplit(MakePolyData(first), MakePolyData(second));
  for (const SplitSurface& split : { InputOf(filter), SourceOf(filter) })
  {
    EXPECT_EQ(split.CountRegions(), 2);
    EXPECT_DOUBLE_EQ(split.Area(), 1.0);
    std::map<vtkIdType, double> areas;
    for (std::size_t i = 0; i < split.Triangles.size(); ++i)
    {
      areas[split.Regions[i]] += 0.5 * Length(split.TwiceAreaOf(i));
    }
    EXPECT_DOUBLE_EQ(std::min(areas[0], areas[1]), 0.5 * 0.75);
  }
}

TEST(SplitSurfaces, ACubeStandsOnARegionOfTheTable)
{
  const Mesh cube = Transformed(CubeQuads(3), 1.0, { 0.5, 0.25, 0.0 });
  auto filter = MakeSplit(MakePolyData(cube), MakePolyData(Square(-2, -3, 7)));
  const SplitSurface floor = InputOf(filter);
  EXPECT_EQ(floor.CountRegions(), 2) << "the floor, and walls and roof";
  EXPECT_EQ(floor.CountBorderEdges(), 0u);
  const SplitSurface table = SourceOf(filter);
  EXPECT_EQ(table.CountRegions(), 2);
  EXPECT_DOUBLE_EQ(table.Area(), 49.0);
}

TEST(SplitSurfaces, ManySegmentsMayCrossOneTriangle)
{
  const Mesh table = Square(-40, -40, 80, 0.1);
  const Mesh torus = TorusTriangles(300, 40);
  auto filter = MakeSplit(MakePolyData(table), MakePolyData(torus));
  const SplitSurface split = InputOf(filter);
  EXPECT_GT(split.Triangles.size(), 600u);
  EXPECT_EQ(split.CountRegions(), 3) << "outside, in the torus, in its hole";
  ExpectAreasKept(split, table);
  ExpectAreasKept(SourceOf(filter), torus);
  EXPECT_EQ(SourceOf(filter).CountBorderEdges(), 0u);
}

// Three spheres, in one data set: their circles meet in two points, of all three.
TEST(SplitSurfaces, OfOneSurfaceItIsCutByItself)
{
  Mesh mesh;
  for (const Point& center : { Point{ 0, 0, 0 }, { 0.9, 0.1, 0 }, { 0.4, 0.8, 0.1 } })
  {
    const Mesh sphere = Transformed(SphereTriangles(9), 1.0, center);
    const auto before = static_cast<vtkIdType>(mesh.Points.size());
    mesh.Points.insert(mesh.Points.end(), sphere.Points.begin(), sphere.Points.end());
    for (const auto& cell : sphere.Cells)
    {
      mesh.Add(VTK_TRIANGLE,
        { before + cell.Points[0], before + cell.Points[1], before + cell.Points[2] });
    }
  }
  auto filter = MakeSplit(MakePolyData(mesh));
  const SplitSurface split = InputOf(filter);
  ExpectAreasKept(split, mesh);
  EXPECT_EQ(split.CountBorderEdges(), 0u);
  EXPECT_EQ(split.CountRegions(), 12) << "each sphere: in none, one, other, or both of the others";
  const vtkIdType triple = static_cast<vtkIdType>(split.Points.size());
  EXPECT_GT(triple, OutputOf(filter, 0)->GetNumberOfPoints()) << "two points more than its curves'";
}

TEST(SplitSurfaces, AMovedSourceIsSplitWhereItIs)
{
  const Mesh first = SphereTriangles(8);
  auto filter = MakeSplit(MakePolyData(first), MakePolyData(first));
  filter->SetTranslation(1, 0.25, 0.5);
  filter->Update();
  auto there =
    MakeSplit(MakePolyData(first), MakePolyData(Transformed(first, 1, { 1, 0.25, 0.5 })));
  for (const int port : { 4, 5 })
  {
    const SplitSurface a(OutputOf(filter, port));
    const SplitSurface b(OutputOf(there, port));
    EXPECT_EQ(a.Points, b.Points);
    EXPECT_EQ(a.Triangles, b.Triangles);
  }
}

TEST(SplitSurfaces, FarTinyAndHugeAreSplitAlike)
{
  const Mesh first = LatticeTriangles(20, 4, 4);
  const Mesh second = LatticeTriangles(20, 4, 5);
  const auto run = [&](double factor, const Point& offset)
  {
    return InputOf(MakeSplit(MakePolyData(Transformed(first, factor, offset)),
      MakePolyData(Transformed(second, factor, offset))));
  };
  const SplitSurface here = run(1.0, { 0, 0, 0 });
  for (const double factor : { std::ldexp(1.0, -900), std::ldexp(1.0, 900) })
  {
    EXPECT_EQ(run(factor, { 0, 0, 0 }).Triangles, here.Triangles) << factor;
  }
  const double far = std::ldexp(1.0, 30);
  const SplitSurface there = run(1.0, { far, -far, far });
  ASSERT_EQ(there.Points.size(), here.Points.size());
  for (std::size_t i = 0; i < here.Points.size(); ++i)
  {
    EXPECT_LT(Distance(there.Points[i] - Point{ far, -far, far }, here.Points[i]), 1e-6);
  }
}

TEST(SplitSurfaces, ThreadsDoNotMatter)
{
  const Mesh mesh = LatticeTriangles(60, 5, 6);
  const auto run = [&](int threads)
  {
    vtkSMPTools::Initialize(threads);
    return InputOf(MakeSplit(MakePolyData(mesh)));
  };
  const SplitSurface alone = run(1);
  const SplitSurface many = run(4);
  EXPECT_EQ(alone.Points, many.Points);
  EXPECT_EQ(alone.Triangles, many.Triangles);
  EXPECT_EQ(alone.Regions, many.Regions);
  vtkSMPTools::Initialize(0);
}

//------------------------------------------------------------------------------
/// Adds x + 2 y + 3 z of points, and cells' ids as strings.
void AddData(vtkPolyData* mesh)
{
  vtkNew<vtkDoubleArray> heights;
  heights->SetName("height");
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const double* x = mesh->GetPoint(i);
    heights->InsertNextValue(x[0] + 2.0 * x[1] + 3.0 * x[2]);
  }
  mesh->GetPointData()->AddArray(heights);
  vtkNew<vtkStringArray> names;
  names->SetName("name");
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    names->InsertNextValue(std::to_string(i));
  }
  mesh->GetCellData()->AddArray(names);
}

void ExpectDataPassed(vtkPolyData* split)
{
  auto heights = split->GetPointData()->GetArray("height");
  auto names = vtkStringArray::SafeDownCast(split->GetCellData()->GetAbstractArray("name"));
  ASSERT_TRUE(heights && names);
  for (vtkIdType i = 0; i < split->GetNumberOfPoints(); ++i)
  {
    const double* x = split->GetPoint(i);
    EXPECT_NEAR(heights->GetTuple1(i), x[0] + 2.0 * x[1] + 3.0 * x[2], 1e-13);
  }
  for (vtkIdType i = 0; i < split->GetNumberOfCells(); ++i)
  {
    const auto id =
      static_cast<vtkIdType>(split->GetCellData()->GetArray("SkdCellId")->GetTuple1(i));
    EXPECT_EQ(names->GetValue(i), std::to_string(id));
  }
}

TEST(SplitSurfaces, DataArePassedOn)
{
  auto first = MakePolyData(SphereQuads(9));
  auto second = MakePolyData(Transformed(SphereTriangles(8), 1.0, { 0.6, 0.2, 0.7 }));
  AddData(first);
  AddData(second);
  auto filter = MakeSplit(first, second);
  ExpectDataPassed(OutputOf(filter, 4));
  ExpectDataPassed(OutputOf(filter, 5));
}

// Blocks of one surface: points where they meet are of both.
TEST(SplitSurfaces, BlocksAreReportedAndDataAreOfTheBlock)
{
  auto first = MakePolyData(Square(0, 0, 1));
  auto second = MakePolyData(Square(1, 0, 1));
  AddData(first);
  AddData(second);
  Mesh wall;
  wall.Points = { { -1, 0.3, -1 }, { 4, 0.3, -1 }, { 4, 0.6, 1 }, { -1, 0.6, 1 } };
  wall.Add(VTK_QUAD, { 0, 1, 2, 3 });
  auto filter = MakeSplit(MakeBlocks({ first, nullptr, second }), MakePolyData(wall));
  ExpectDataPassed(OutputOf(filter, 4));
  auto blocks = OutputOf(filter, 4)->GetCellData()->GetArray("SkdBlockIndex");
  ASSERT_NE(blocks, nullptr);
  EXPECT_EQ(blocks->GetRange()[0], 1.0);
  EXPECT_EQ(blocks->GetRange()[1], 3.0);
  EXPECT_FALSE(OutputOf(filter, 5)->GetCellData()->HasArray("SkdBlockIndex"));
  EXPECT_EQ(InputOf(filter).CountRegions(), 2);
}

//------------------------------------------------------------------------------
class SplitReal : public testing::TestWithParam<const char*>
{
};

// Scans and models that meet themselves: what was closed stays closed, and no area is lost.
TEST_P(SplitReal, KeepAreasAndBorders)
{
  const std::string file = ExtraDataFolder() + "/A_surface/" + GetParam();
  if (!std::filesystem::exists(file))
  {
    GTEST_SKIP() << "no " << file;
  }
  auto mesh = ReadMesh(file);
  auto alone = MakeSplit(mesh, MakePolyData(Square(1e6, 1e6, 1)));
  const SplitSurface before = InputOf(alone);
  const SplitSurface after = InputOf(MakeSplit(mesh));
  EXPECT_GT(after.Triangles.size(), before.Triangles.size());
  const double total = before.Area();
  EXPECT_NEAR(after.Area(), total, 1e-12 * total);
  std::map<vtkIdType, Point> areas = before.AreasOfCells();
  for (const auto& [cell, area] : after.AreasOfCells())
  {
    EXPECT_LT(Length(areas[cell] - area), 1e-15 * total) << cell;
  }
  const double border = before.BorderLength();
  EXPECT_NEAR(after.BorderLength(), border, 1e-12 * border);
  if (before.CountBorderEdges() == 0)
  {
    EXPECT_EQ(after.CountBorderEdges(), 0u);
  }
}
INSTANTIATE_TEST_SUITE_P(Files, SplitReal,
  testing::Values("bones.vtp", "man.vtp", "mannequin-devil.vtp", "propellerTip.obj", "camel.vtp",
    "ChineseDragon-10kv.vtp", "pig_open.stl"));

/// Rows of what a port gives, by value: corners of cells, and the ids beside them.
std::vector<std::vector<double>> RowsOf(vtkSkdTreeSurfaceIntersection* filter, int port)
{
  std::vector<std::vector<double>> rows;
  if (auto* table = vtkTable::SafeDownCast(filter->GetOutputDataObject(port)))
  {
    for (vtkIdType i = 0; i < table->GetNumberOfRows(); ++i)
    {
      rows.push_back({ table->GetValueByName(i, "SkdFirstCellId").ToDouble(),
        table->GetValueByName(i, "SkdSecondCellId").ToDouble() });
    }
    return rows;
  }
  auto* cells = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(port));
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
  {
    std::vector<double> row;
    vtkPoints* points = cells->GetCell(i)->GetPoints();
    for (vtkIdType k = 0; k < points->GetNumberOfPoints(); ++k)
    {
      row.insert(row.end(), points->GetPoint(k), points->GetPoint(k) + 3);
    }
    for (int array = 0; array < cells->GetCellData()->GetNumberOfArrays(); ++array)
    {
      row.push_back(cells->GetCellData()->GetArray(array)->GetComponent(i, 0));
    }
    rows.push_back(row);
  }
  return rows;
}

TEST(SplitSurfaces, SharesOfSeveralProcessesAreWhatOneGives)
{
  const auto input = MakePolyData(SphereTriangles(8));
  const auto source = MakePolyData(Transformed(SphereTriangles(7), 1.0, { 0.9, 0.3, 0.2 }));
  const auto alone = MakeSplit(input, source);
  for (const int pieces : { 2, 3, 40 })
  {
    std::vector<std::vector<double>> together[6];
    for (int piece = 0; piece < pieces; ++piece)
    {
      auto filter = MakeIntersection(input, source);
      filter->SplitSurfacesOn();
      filter->JoinCurvesOff();
      filter->UpdatePiece(piece, pieces, 0);
      for (int port = 0; port < 6; ++port)
      {
        const auto rows = RowsOf(filter, port);
        together[port].insert(together[port].end(), rows.begin(), rows.end());
      }
    }
    for (int port = 0; port < 6; ++port)
    {
      EXPECT_EQ(together[port], RowsOf(alone, port)) << pieces << " pieces, port " << port;
    }
  }
}

}
