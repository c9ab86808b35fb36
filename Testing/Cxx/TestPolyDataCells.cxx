// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// The cells of vtkPolyData as they are stored: of too few points, in all four arrays, in 32 bit.

#include "Support/EventCounter.h"
#include "Support/LocatorCalls.h"
#include "Support/SurfaceMeshes.h"
#include "Support/VolumeMeshes.h"

#include <gtest/gtest.h>

#include <array>

using namespace skdtest;

namespace
{

enum Kind
{
  Vertices,
  Lines,
  Polygons,
  Strips
};

void SetCells(vtkPolyData* mesh, int kind, vtkCellArray* cells)
{
  switch (kind)
  {
    case Vertices:
      mesh->SetVerts(cells);
      return;
    case Lines:
      mesh->SetLines(cells);
      return;
    case Polygons:
      mesh->SetPolys(cells);
      return;
    default:
      mesh->SetStrips(cells);
  }
}

/// Cells of these sizes, one after the other along the x axis, a unit from one to the next.
PolyDataPointer MakeCells(int kind, const std::vector<int>& sizes)
{
  auto mesh = PolyDataPointer::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  for (std::size_t cell = 0; cell < sizes.size(); ++cell)
  {
    Ids ids;
    for (int i = 0; i < sizes[cell]; ++i)
    {
      ids.push_back(points->InsertNextPoint(double(cell) + 0.1 * i, 0.1 * (i % 2), 0.0));
    }
    cells->InsertNextCell(sizes[cell], ids.data());
  }
  mesh->SetPoints(points);
  SetCells(mesh, kind, cells);
  return mesh;
}

/// Kind of cell, and how many points the one in the middle has.
class SmallCells : public testing::TestWithParam<std::tuple<int, int>>
{
protected:
  int Size = std::get<1>(GetParam());
  bool IsWhole = this->Size >= std::array<int, 4>{ 1, 2, 3, 3 }[std::get<0>(GetParam())];
  PolyDataPointer Mesh = MakeCells(std::get<0>(GetParam()), { 3, this->Size, 3 });
};

INSTANTIATE_TEST_SUITE_P(All, SmallCells,
  testing::Combine(testing::Values(Vertices, Lines, Polygons, Strips), testing::Values(0, 1, 2)));

TEST_P(SmallCells, DoNoHarm)
{
  EventCounter meshEvents(this->Mesh);
  const auto locator = LocatorPointer::New();
  EventCounter events(locator);
  locator->SetDataSet(this->Mesh);
  locator->BuildLocator();
  EXPECT_EQ(locator->GetNumberOfCellsInTree(), this->IsWhole ? 3 : 2);
  EXPECT_EQ(locator->GetNumberOfCellsLeftOut(), this->IsWhole ? 0 : 1);
  EXPECT_EQ(FindClosest(locator, { 0, 0, 1 }).Cell, 0);
  EXPECT_EQ(FindClosest(locator, { 2, 0, 1 }).Cell, 2);
  EXPECT_NEAR(FindClosest(locator, { 2, 0, 1 }).Dist2, 1.0, 1e-12);
  FindFirstHit(locator, { -1, 0.05, 0 }, { 4, 0.05, 0 }, 0.1);
  vtkNew<vtkGenericCell> cell;
  FindAllHits(locator, { -1, 0.05, 0 }, { 4, 0.05, 0 }, 0.1, cell);
  EXPECT_EQ(FindWithinBounds(locator, { 1.9, 3, -1, 1, -1, 1 }), Ids{ 2 });
  FindCell(locator, { 1, 0, 0 }, 0.01);
  FindCrossings(locator, { 2.1, 0.05, 1 }, { 2.1, 0.05, -1 });
  EXPECT_EQ(events.Errors, 0) << events.Error;
  EXPECT_EQ(events.Warnings, this->IsWhole || this->Size == 0 ? 0 : 1) << events.Warning;
  EXPECT_EQ(meshEvents.Errors, 0) << meshEvents.Error;
}

TEST_P(SmallCells, LeaveTheOthersTheirPoints)
{
  const auto locator = MakeLocator(this->Mesh);
  vtkNew<vtkGenericCell> cell;
  const double x[3] = { 2, 0, 1 };
  Closest c;
  locator->FindClosestPoint(x, c.X.data(), cell, c.Cell, c.SubId, c.Dist2);
  ASSERT_EQ(c.Cell, 2);
  ASSERT_EQ(cell->GetNumberOfPoints(), 3);
  EXPECT_EQ(cell->GetPointId(0), 3 + this->Size);
  double first[3];
  cell->GetPoints()->GetPoint(0, first);
  EXPECT_EQ(first[0], 2.0);
}

TEST_P(SmallCells, AreFoundIfTheyAreWhole)
{
  if (!this->IsWhole)
  {
    return;
  }
  const auto locator = MakeLocator(this->Mesh);
  const Closest c = FindClosest(locator, { 0.9, -0.1, 1 });
  EXPECT_EQ(c.Cell, 1);
  EXPECT_NEAR(c.Dist2, 1.02, 1e-6);
}

/// All four kinds in one mesh: ids go through vertices, lines, polygons and strips.
PolyDataPointer MakeAllKinds()
{
  auto mesh = PolyDataPointer::New();
  vtkNew<vtkPoints> points;
  for (const int kind : { Strips, Polygons, Lines, Vertices })
  {
    vtkNew<vtkCellArray> cells;
    for (const int size : { 1, 2, 3, 4, 5 })
    {
      const int used = std::max(size, kind == Vertices ? 1 : kind == Lines ? 2 : 3);
      Ids ids;
      for (int i = 0; i < used; ++i)
      {
        ids.push_back(points->InsertNextPoint(size + 0.1 * i, kind + 0.1 * (i % 2), 0.01 * i));
      }
      cells->InsertNextCell(used, ids.data());
    }
    SetCells(mesh, kind, cells);
  }
  mesh->SetPoints(points);
  return mesh;
}

TEST(PolyDataCells, OfAllFourArraysHaveTheirIds)
{
  const auto mesh = MakeAllKinds();
  const auto locator = MakeLocator(mesh);
  EXPECT_EQ(locator->GetNumberOfCellsInTree(), 20);
  vtkNew<vtkGenericCell> cell;
  for (vtkIdType id = 0; id < mesh->GetNumberOfCells(); ++id)
  {
    mesh->GetCell(id, cell);
    Point x;
    cell->GetPoints()->GetPoint(0, x.data());
    EXPECT_EQ(FindClosest(locator, x).Cell, id);
    EXPECT_LT(FindClosest(locator, x).Dist2, 1e-24);
  }
}

TEST(PolyDataCells, OfDeletedCellsAreLeftOut)
{
  const auto mesh = MakePolyData(SphereTriangles(4));
  mesh->BuildCells();
  mesh->DeleteCell(3);
  const auto locator = MakeLocator(mesh);
  EXPECT_EQ(locator->GetNumberOfCellsLeftOut(), 1);
  EXPECT_EQ(locator->GetNumberOfCellsInTree(), mesh->GetNumberOfCells() - 1);
}

/// The results of some points, of a mesh with its cells in 64 or 32 bit.
template <typename Data>
std::vector<Closest> AnswersOf(Data* data, vtkCellArray* cells, bool in32Bit)
{
  in32Bit ? cells->ConvertTo32BitStorage() : cells->ConvertTo64BitStorage();
  const auto locator = MakeLocator(data);
  EXPECT_EQ(locator->GetNumberOfCellsInTree(), data->GetNumberOfCells());
  std::vector<Closest> answers;
  Random random(190);
  for (int i = 0; i < 200; ++i)
  {
    answers.push_back(FindClosest(locator, random.InBox({ -2, 2, -2, 2, -2, 2 })));
  }
  return answers;
}

TEST(PolyDataCells, AreTheSameIn32Bit)
{
  const auto mesh = MakePolyData(SphereTriangles(8));
  EXPECT_EQ(AnswersOf<vtkPolyData>(mesh, mesh->GetPolys(), true),
    AnswersOf<vtkPolyData>(mesh, mesh->GetPolys(), false));
}

TEST(UnstructuredGridCells, AreTheSameIn32Bit)
{
  const auto grid = MakeGrid(MixedCells(3));
  EXPECT_EQ(AnswersOf<vtkUnstructuredGrid>(grid, grid->GetCells(), true),
    AnswersOf<vtkUnstructuredGrid>(grid, grid->GetCells(), false));
}

TEST(UnstructuredGridCells, OfPointsThatDoNotExistAreLeftOut)
{
  const auto grid = MakeGrid(Tetrahedra(2));
  vtkNew<vtkIdList> ids;
  for (const vtkIdType id : { 0, 1, 2, -1 })
  {
    ids->InsertNextId(id);
  }
  grid->InsertNextCell(VTK_TETRA, ids);
  ids->SetId(3, grid->GetNumberOfPoints());
  grid->InsertNextCell(VTK_TETRA, ids);
  const auto locator = LocatorPointer::New();
  EventCounter events(locator);
  locator->SetDataSet(grid);
  locator->BuildLocator();
  EXPECT_EQ(locator->GetNumberOfCellsLeftOut(), 2);
  EXPECT_EQ(events.Warnings, 1);
}

}
