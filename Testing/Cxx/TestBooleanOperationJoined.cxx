// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeBooleanOperation: pieces of one face are joined again, also over operations that follow
// each other.

#include "Support/Reported.h"
#include "Support/SolidRun.h"
#include "Support/SurfaceMeshes.h"

#include "vtkCellData.h"
#include "vtkIntArray.h"

using namespace skdtest;

namespace
{
using Filter = vtkSkdTreeBooleanOperation;

/// An upright prism, whose quads are two triangles each.
Mesh Prism(const Point& middle, double radius, double height, int sides)
{
  Mesh mesh;
  for (const double z : { -0.5 * height, 0.5 * height })
  {
    for (int i = 0; i < sides; ++i)
    {
      const double angle = 2.0 * std::acos(-1.0) * i / sides;
      mesh.Add(middle + Point{ radius * std::cos(angle), radius * std::sin(angle), z });
    }
  }
  const vtkIdType n = sides;
  for (vtkIdType i = 0; i < n; ++i)
  {
    const vtkIdType next = (i + 1) % n;
    mesh.Add(VTK_TRIANGLE, { i, next, n + next });
    mesh.Add(VTK_TRIANGLE, { i, n + next, n + i });
    if (i > 1)
    {
      mesh.Add(VTK_TRIANGLE, { 0, i, i - 1 });
      mesh.Add(VTK_TRIANGLE, { n, n + i - 1, n + i });
    }
  }
  return mesh;
}

/// A plate, and what is to be taken out of it.
struct Drilled
{
  Mesh Plate;
  std::vector<Mesh> Holes;
  int Sides = 7;
};

Drilled MakeDrilled(int perSide, const std::function<Point(const Point&)>& where)
{
  Drilled drilled;
  const double size = perSide;
  drilled.Plate = BoxTriangles({ 0, 0, 0 }, { size, size, 0.5 }).Map(where);
  for (int i = 0; i < perSide * perSide; ++i)
  {
    const Point middle{ i % perSide + 0.5, i / perSide + 0.5, 0.25 };
    drilled.Holes.push_back(Prism(middle, 0.3, 1.0, drilled.Sides).Map(where));
  }
  return drilled;
}

/// The fewest triangles that have its corners.
std::size_t LeastOf(const Drilled& drilled)
{
  const std::size_t holes = drilled.Holes.size();
  const std::size_t corners = holes * static_cast<std::size_t>(drilled.Sides);
  return 2 * (4 + corners + 2 * holes - 2) + 2 * corners + 8;
}

vtkSmartPointer<vtkPolyData> Subtract(vtkPolyData* from, vtkPolyData* what, bool joins = true)
{
  vtkNew<Filter> filter;
  filter->SetInputData(from);
  filter->SetSourceData(what);
  filter->SetOperationToDifference();
  filter->SetJoinPieces(joins);
  EXPECT_EQ(CountBadEdges(RunSolid(filter)), 0);
  return vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
}

vtkSmartPointer<vtkPolyData> Chain(const Drilled& drilled, bool joins)
{
  vtkSmartPointer<vtkPolyData> left = MakePolyData(drilled.Plate);
  for (const Mesh& hole : drilled.Holes)
  {
    left = Subtract(left, MakePolyData(hole), joins);
  }
  return left;
}

/// The least height of its triangles, relative to their longest sides.
double LeastShape(const Mesh& mesh)
{
  double least = 1.0;
  for (const CellSpec& cell : mesh.Cells)
  {
    const Point& a = mesh.Points[cell.Points[0]];
    const Point& b = mesh.Points[cell.Points[1]];
    const Point& c = mesh.Points[cell.Points[2]];
    const double longest = std::max({ Distance(a, b), Distance(b, c), Distance(c, a) });
    least = std::min(least, Length(Cross(b - a, c - a)) / (longest * longest));
  }
  return least;
}

void ExpectLeast(const Drilled& drilled)
{
  const auto atOnce = Subtract(MakePolyData(drilled.Plate), MakePolyData(Together(drilled.Holes)));
  const auto inTurn = Chain(drilled, true);
  const double volume = Reported(atOnce, "Volume");
  EXPECT_EQ(static_cast<std::size_t>(atOnce->GetNumberOfCells()), LeastOf(drilled));
  EXPECT_EQ(static_cast<std::size_t>(inTurn->GetNumberOfCells()), LeastOf(drilled));
  EXPECT_NEAR(Reported(inTurn, "Volume"), volume, 1e-12 * volume);
  EXPECT_GT(LeastShape(MeshOf(atOnce)), 1e-3);
  EXPECT_GT(LeastShape(MeshOf(inTurn)), 1e-3);
}

TEST(BooleanOperationJoined, HolesOneByOneLeaveNoPieces)
{
  ExpectLeast(MakeDrilled(4, [](const Point& p) { return p; }));
}

TEST(BooleanOperationJoined, TurnedPlanesStayPlanes)
{
  for (std::uint64_t seed = 0; seed < 4; ++seed)
  {
    Random random(seed);
    const RandomRotation rotation(random, false);
    const Point by = random.InBox({ -5, 5, -5, 5, -5, 5 });
    SCOPED_TRACE(seed);
    ExpectLeast(MakeDrilled(3, [&](const Point& p) { return rotation(p) + by; }));
  }
}

TEST(BooleanOperationJoined, OffGivesAllPieces)
{
  const Drilled drilled = MakeDrilled(2, [](const Point& p) { return p; });
  const auto joined = Chain(drilled, true);
  const auto pieces = Chain(drilled, false);
  EXPECT_GT(pieces->GetNumberOfCells(), joined->GetNumberOfCells());
  EXPECT_TRUE(joined->GetCellData()->HasArray("SkdFaceId"));
  EXPECT_FALSE(pieces->GetCellData()->HasArray("SkdFaceId"));
  EXPECT_NEAR(Reported(pieces, "Volume"), Reported(joined, "Volume"), 1e-13);
}

/// The area of the faces with each value of an array.
std::map<int, double> AreasBy(vtkPolyData* surface, const char* name)
{
  std::map<int, double> areas;
  const Mesh mesh = MeshOf(surface);
  for (std::size_t cell = 0; cell < mesh.Cells.size(); ++cell)
  {
    const Ids& ids = mesh.Cells[cell].Points;
    const Point& a = mesh.Points[ids[0]];
    const double value =
      surface->GetCellData()->GetArray(name)->GetTuple1(static_cast<vtkIdType>(cell));
    areas[static_cast<int>(value)] +=
      0.5 * Length(Cross(mesh.Points[ids[1]] - a, mesh.Points[ids[2]] - a));
  }
  return areas;
}

TEST(BooleanOperationJoined, CellsWithOtherDataStayApart)
{
  const Drilled drilled = MakeDrilled(3, [](const Point& p) { return p; });
  const auto plate = MakePolyData(drilled.Plate);
  const auto holes = MakePolyData(Together(drilled.Holes));
  for (vtkPolyData* mesh : { plate.Get(), holes.Get() })
  {
    vtkNew<vtkIntArray> codes;
    codes->SetName("code");
    for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
    {
      codes->InsertNextValue(static_cast<int>(cell) + (mesh == plate ? 0 : 1000));
    }
    mesh->GetCellData()->AddArray(codes);
  }
  const auto expected = AreasBy(Subtract(plate, holes, false), "code");
  const auto areas = AreasBy(Subtract(plate, holes, true), "code");
  ASSERT_EQ(areas.size(), expected.size());
  for (const auto& [code, area] : expected)
  {
    EXPECT_NEAR(areas.at(code), area, 1e-13) << code;
  }
}

/// What is not cut keeps its faces, and polygons stay polygons.
TEST(BooleanOperationJoined, WhatIsNotCutStays)
{
  const Mesh box = CubeQuads(3);
  vtkNew<Filter> filter;
  filter->SetInputData(0, MakePolyData(box));
  filter->SetSourceData(MakePolyData(Transformed(box, 1.0, { 10, 0, 0 })));
  filter->Update();
  auto* output = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
  EXPECT_EQ(output->GetNumberOfCells(), static_cast<vtkIdType>(2 * box.Cells.size()));
}

/// A number that faces have in common joins only what lies in one plane.
TEST(BooleanOperationJoined, NumbersOfOthersDoNoHarm)
{
  const auto ball = MakePolyData(Outward(SphereTriangles(6)));
  const auto box = MakePolyData(BoxTriangles({ -2, -2, 0.1 }, { 2, 2, 2 }));
  const auto expected = Subtract(ball, box);
  for (vtkPolyData* mesh : { ball.Get(), box.Get() })
  {
    vtkNew<vtkIntArray> numbers;
    numbers->SetName("SkdFaceId");
    numbers->SetNumberOfValues(mesh->GetNumberOfCells());
    numbers->FillValue(7);
    mesh->GetCellData()->AddArray(numbers);
  }
  const auto numbered = Subtract(ball, box);
  EXPECT_NEAR(Reported(numbered, "Volume"), Reported(expected, "Volume"), 1e-13);
  EXPECT_EQ(numbered->GetNumberOfCells(), expected->GetNumberOfCells());
}

/// Random chains: each result is closed, has no more faces than without joining, and is solid where
/// it should be; the volume is that of all at once.
TEST(BooleanOperationJoined, RandomChains)
{
  const int first = SetInEnvironment("SKDTREE_FUZZ_FIRST", 0);
  const int count = std::max(3, SetInEnvironment("SKDTREE_FUZZ_PAIRS", 40) / 10);
  for (int number = first; number < first + count; ++number)
  {
    SCOPED_TRACE(number);
    Random random(2000000u + static_cast<std::uint64_t>(number));
    const Mesh block = BoxTriangles({ -1, -1, -1 }, { 1, 1, 1 }).Map(RandomRotation(random, false));
    auto left = MakePolyData(block);
    std::vector<Mesh> tools;
    for (int i = 0; i < 10; ++i)
    {
      std::string what;
      tools.push_back(
        MovedAnywhere(random, Transformed(AnySolid(random, what), 0.5, { 0, 0, 0 }), what));
      left = Subtract(left, MakePolyData(tools.back()));
    }
    const Mesh result = MeshOf(left);
    const Mesh all = Together(tools);
    ExpectSolid(random, { &block, &all },
      Combined(Filter::DIFFERENCE, InsideTestOf(block), InsideTestOf(all)), result);
    const Mesh atOnce = Combine(block, all, Filter::DIFFERENCE);
    EXPECT_NEAR(Measures(result).Volume, Measures(atOnce).Volume,
      1e-12 * Measures(block).Volume + Measures(all).Rounding);
  }
}
}
