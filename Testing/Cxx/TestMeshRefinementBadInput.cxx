// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeMeshRefinement: input that has nothing, is odd or needs too much; blocks and seams;
// limits, aborts, kept trees.

#include "Support/CellZoo.h"
#include "Support/MeshRefinementRun.h"
#include "Support/NamedMeshes.h"
#include "Support/ProgressRises.h"

#include "vtkMultiBlockDataSet.h"
#include "vtkOverlappingAMR.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkSMPTools.h"

#include <gtest/gtest.h>

using namespace skdtest;

namespace
{

PolyDataPointer MakeTorus()
{
  return MakePolyData(TorusTriangles(24, 12));
}

PolyDataPointer MakePart()
{
  return MakePolyData(Transformed(SphereTriangles(8), 0.4, { 1, 0, 0 }));
}

TEST(MeshRefinementBadInput, WithoutCellsThereIsNothingAndAWarning)
{
  vtkNew<vtkMultiBlockDataSet> noBlocks;
  vtkNew<vtkPolyData> noCells;
  for (vtkDataObject* empty : std::initializer_list<vtkDataObject*>{ noBlocks, noCells })
  {
    RefinementPointer filter = MakeRefinement(empty, MakePart(), 3);
    EventCounter events(filter);
    filter->Update();
    EXPECT_EQ(events.Warnings, 1);
    EXPECT_EQ(events.Errors, 0);
    EXPECT_NE(events.Warning.find("no cells"), std::string::npos);
    EXPECT_EQ(filter->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::CELL), 0);
  }
}

TEST(MeshRefinementBadInput, WithoutAnythingToAskForCellsAllAreRefinedOnce)
{
  auto torus = MakeTorus();
  RefinementPointer filter = MakeRefinement(torus, nullptr, 3, 1);
  EventCounter events(filter);
  EXPECT_EQ(RunRefinement(filter)->GetNumberOfCells(), 4 * torus->GetNumberOfCells());
  filter->SetMaximumLevel(0);
  EXPECT_EQ(RunRefinement(filter)->GetNumberOfCells(), torus->GetNumberOfCells());
  EXPECT_EQ(events.Warnings, 0);
}

TEST(MeshRefinementBadInput, BisectionOfAMeshWithHangingNodesIsWarnedOf)
{
  const auto part = MakePolyData(Transformed(SphereTriangles(8), 0.2, { 0.2, 0.1, 0.05 }));
  const DataSetPointer meshes[] = { MakeTorus(), MakeGrid(Tetrahedra(3)), MakeGrid(Hexahedra(3)),
    MakePolyData(Sheet(5, VTK_QUAD)), MakePolyData(Sheet(5, VTK_TRIANGLE)) };
  for (const DataSetPointer& mesh : meshes)
  {
    for (const int precision : { vtkAlgorithm::SINGLE_PRECISION, vtkAlgorithm::DOUBLE_PRECISION })
    {
      const auto parts = mesh == meshes[0] ? MakePart() : part;
      RefinementPointer regular = MakeRefinement(mesh, parts, 2, 1);
      regular->SetOutputPointsPrecision(precision);
      vtkDataSet* hanging = RunRefinement(regular);
      ASSERT_GT(Reported(regular, "HangingPoints"), 0);
      RefinementPointer bisection = MakeRefinement(hanging, parts, 1, 0);
      EventCounter events(bisection);
      bisection->Update();
      EXPECT_EQ(events.Warnings, 1) << mesh->GetNumberOfCells();
      EXPECT_NE(events.Warning.find("hanging nodes already"), std::string::npos);
      RefinementPointer whole = MakeRefinement(mesh, parts, 2, 0);
      EventCounter none(whole);
      whole->Update();
      EXPECT_EQ(none.Warnings, 0) << none.Warning;
      RefinementPointer again = MakeRefinement(whole->GetOutputDataObject(0), parts, 1, 0);
      EventCounter noneAgain(again);
      again->Update();
      EXPECT_EQ(noneAgain.Warnings, 0) << noneAgain.Warning;
    }
  }
}

TEST(MeshRefinementBadInput, PartsWithoutCellsPassTheMeshOn)
{
  auto torus = MakeTorus();
  vtkNew<vtkPolyData> noParts;
  RefinementPointer filter = MakeRefinement(torus, noParts, 3);
  EventCounter events(filter);
  EXPECT_EQ(RunRefinement(filter)->GetNumberOfCells(), torus->GetNumberOfCells());
  EXPECT_EQ(events.Warnings, 1);
  EXPECT_NE(events.Warning.find("parts have no cells"), std::string::npos) << events.Warning;
}

TEST(MeshRefinementBadInput, PartsThatMissTheMeshPassItOn)
{
  auto torus = MakeTorus();
  RefinementPointer filter =
    MakeRefinement(torus, MakePolyData(Transformed(SphereTriangles(8), 0.4, { 9, 0, 0 })), 3);
  EventCounter events(filter);
  EXPECT_EQ(RunRefinement(filter)->GetNumberOfCells(), torus->GetNumberOfCells());
  EXPECT_EQ(events.Warnings, 1);
  EXPECT_NE(events.Warning.find("intersect no cell"), std::string::npos) << events.Warning;
  // With any other criterion, or nothing to do, that is as it may be.
  filter->SetMaximumLevel(0);
  filter->Update();
  filter->SetMaximumLevel(3);
  filter->SetMinimumLevel(1);
  filter->Update();
  EXPECT_EQ(events.Warnings, 1);
}

TEST(MeshRefinementBadInput, EveryTypeOfCellIsRefinedOrKept)
{
  for (const int type : AllCellTypes())
  {
    const Mesh mesh = ReferenceCell(type, 2);
    auto grid = MakeGrid(mesh);
    for (int method : { 0, 1 })
    {
      RefinementPointer filter = MakeRefinement(grid, nullptr, 1, method);
      filter->SetMinimumLevel(1);
      EventCounter events(filter);
      vtkDataSet* refined = RunRefinement(filter);
      const bool isKept = Reported(filter, "CellsNotRefinable") > 0 || DimensionOf(type) == 0;
      EXPECT_EQ(events.Errors, 0) << NameOfType(type);
      if (isKept)
      {
        ASSERT_EQ(refined->GetNumberOfCells(), grid->GetNumberOfCells()) << NameOfType(type);
        EXPECT_EQ(refined->GetCellType(0), type);
        EXPECT_EQ(refined->GetCell(0)->GetNumberOfPoints(), grid->GetCell(0)->GetNumberOfPoints());
      }
      else
      {
        EXPECT_GT(refined->GetNumberOfCells(), grid->GetNumberOfCells()) << NameOfType(type);
      }
    }
  }
}

TEST(MeshRefinementBadInput, CellsThatAreNotFiniteOrUseAPointTwiceAreKept)
{
  Mesh torus = TorusTriangles(24, 12);
  const vtkIdType good = static_cast<vtkIdType>(torus.Cells.size());
  const vtkIdType nan = torus.Add(Point{ std::numeric_limits<double>::quiet_NaN(), 0, 0 });
  torus.Add(VTK_TRIANGLE, { 0, 1, nan });
  torus.Add(VTK_TRIANGLE, { 5, 5, 6 });
  torus.Add(VTK_POLYGON, { 7, 7, 7, 8 });
  RefinementPointer filter = MakeRefinement(MakeGrid(torus), MakePart(), 2);
  EventCounter events(filter);
  vtkDataSet* refined = RunRefinement(filter);
  EXPECT_EQ(Reported(filter, "CellsNotRefinable"), 3);
  EXPECT_EQ(events.Warnings, 2); // one counts points
  EXPECT_NE(events.Warning.find("3 cells cannot be refined"), std::string::npos);
  RefinementPointer clean = MakeRefinement(MakeTorus(), MakePart(), 2);
  EXPECT_EQ(refined->GetNumberOfCells(), RunRefinement(clean)->GetNumberOfCells() + 3);
  EXPECT_GT(refined->GetNumberOfCells(), good + 100);
  // A quad with a point twice is a triangle.
  Mesh pole;
  pole.Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } };
  pole.Add(VTK_QUAD, { 0, 1, 2, 2 });
  RefinementPointer one = MakeRefinement(MakeGrid(pole), nullptr, 1, 1);
  one->SetMinimumLevel(1);
  EXPECT_EQ(RunRefinement(one)->GetNumberOfCells(), 4);
}

TEST(MeshRefinementBadInput, ConcavePolygonsLoseEarsAndCrossedOnesStay)
{
  Mesh mesh;
  mesh.Points = { { 0, 0, 0 }, { 4, 0, 0 }, { 4, 4, 0 }, { 3.5, 0.5, 0 }, { 0, 1, 0 } };
  mesh.Add(VTK_POLYGON, { 0, 1, 2, 3, 4 });
  for (int method : { 0, 1 })
  {
    RefinementPointer filter = MakeRefinement(MakeGrid(mesh), nullptr, 1, method);
    filter->SetMinimumLevel(1);
    const MeshMeasures measures = MeasuresOf(RunRefinement(filter));
    EXPECT_NEAR(measures.Sum, MeasuresOf(MakeGrid(mesh)).Sum, 1e-14);
    EXPECT_GT(measures.Least, 0);
    EXPECT_EQ(measures.Euler, 1);
  }
  Mesh crossed;
  crossed.Points = { { 0, 0, 0 }, { 1, 1, 0 }, { 1, 0, 0 }, { 0, 1, 0 } };
  crossed.Add(VTK_QUAD, { 0, 1, 2, 3 });
  RefinementPointer filter = MakeRefinement(MakeGrid(crossed), nullptr, 1);
  filter->SetMinimumLevel(1);
  EventCounter events(filter);
  EXPECT_EQ(RunRefinement(filter)->GetNumberOfCells(), 1);
  EXPECT_EQ(events.Warnings, 1);
  EXPECT_EQ(Reported(filter, "CellsNotRefinable"), 1);
}

TEST(MeshRefinementBadInput, TinyAndHugeMeshesAndFarOnesAreRefinedAlike)
{
  vtkIdType cells = -1;
  for (const double scale : { 1.0, std::ldexp(1.0, -300), std::ldexp(1.0, 300) })
  {
    for (const double offset : { 0.0, std::ldexp(1.0, 20) })
    {
      const Point by{ offset * scale, 0, 0 };
      Mesh mesh = Sheet(8, VTK_QUAD);
      Mesh part;
      part.Add(VTK_LINE, { part.Add(Point{ 1, 1.25, 0 }), part.Add(Point{ 5, 7.25, 0 }) });
      RefinementPointer filter = MakeRefinement(
        MakePolyData(Transformed(mesh, scale, by)), MakePolyData(Transformed(part, scale, by)), 3);
      const vtkIdType here = RunRefinement(filter)->GetNumberOfCells();
      cells = cells < 0 ? here : cells;
      EXPECT_EQ(here, cells) << scale << " " << offset;
    }
  }
  EXPECT_GT(cells, 64);
}

//------------------------------------------------------------------------------
TEST(MeshRefinementBlocks, FitTogetherAndKeepTheirDataSets)
{
  const Mesh whole = Triangulated(Sheet(6, VTK_QUAD));
  const auto isLeft = [&](std::size_t cell)
  { return whole.Points[static_cast<std::size_t>(whole.Cells[cell].Points[0])][0] < 3; };
  auto left = MakePolyData(Part(whole, isLeft));
  auto right = MakeGrid(Part(whole, [&](std::size_t cell) { return !isLeft(cell); }));
  auto part = MakePolyData(Transformed(SphereTriangles(8), 0.4, { 2.2, 3, 0 }));
  auto blocks = MakeBlocks({ left, nullptr, right });
  RefinementPointer filter = MakeRefinement(blocks, part, 3);
  filter->Update();
  auto output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  ASSERT_NE(output, nullptr);
  ASSERT_EQ(output->GetNumberOfBlocks(), 3u);
  auto first = vtkPolyData::SafeDownCast(output->GetBlock(0));
  auto second = vtkUnstructuredGrid::SafeDownCast(output->GetBlock(2));
  ASSERT_TRUE(first && second && !output->GetBlock(1));
  RefinementPointer alone = MakeRefinement(MakePolyData(whole), part, 3);
  EXPECT_EQ(first->GetNumberOfCells() + second->GetNumberOfCells(),
    RunRefinement(alone)->GetNumberOfCells());
  EXPECT_EQ(Reported(filter, "Cells"), Reported(alone, "Cells"));
  EXPECT_EQ(Reported(filter, "HangingPoints"), 0);
  EXPECT_GT(second->GetNumberOfCells(), right->GetNumberOfCells());
}

TEST(MeshRefinementBlocks, SeamsStaySeams)
{
  // Cells of a soup share no points; each new point is one on each side, too.
  const Mesh cube = CubeQuads(3);
  for (int method : { 0, 1 })
  {
    RefinementPointer split = MakeRefinement(MakePolyData(Soup(cube)), MakePart(), 2, method);
    RefinementPointer welded = MakeRefinement(MakePolyData(cube), MakePart(), 2, method);
    split->AddDistanceBand(2.5, 2);
    welded->AddDistanceBand(2.5, 2);
    vtkDataSet* first = RunRefinement(split);
    vtkDataSet* second = RunRefinement(welded);
    EXPECT_EQ(first->GetNumberOfCells(), second->GetNumberOfCells());
    EXPECT_GT(first->GetNumberOfPoints(), second->GetNumberOfPoints());
    EXPECT_EQ(Reported(split, "HangingPoints"), Reported(welded, "HangingPoints"));
    EXPECT_EQ(Reported(split, "Points"), Reported(welded, "Points"));
    EXPECT_NEAR(MeasuresOf(second).Sum, 54, 1e-12);
    EXPECT_NEAR(MeasuresOf(first).Sum, 54, 1e-12);
    if (method == 0) // no side of a quad is joined to another, and none comes apart
    {
      EXPECT_NEAR(MeasuresOf(first).OpenMeasure, 4 * 54, 1e-12);
      EXPECT_EQ(MeasuresOf(second).OpenMeasure, 0);
    }
  }
}

TEST(MeshRefinementBlocks, GhostMarksAndActiveArraysAreKept)
{
  auto torus = WithData(MakeTorus());
  torus->GetPointData()->SetActiveScalars("Linear");
  MarkGhosts(torus, { 3, 4, 5 }, vtkDataSetAttributes::DUPLICATECELL);
  RefinementPointer filter = MakeRefinement(torus, nullptr, 1, 1);
  filter->SetMinimumLevel(1);
  vtkDataSet* refined = RunRefinement(filter);
  EXPECT_STREQ(refined->GetPointData()->GetScalars()->GetName(), "Linear");
  const std::vector<double> ghosts = CellValues(refined, "vtkGhostType");
  const std::vector<double> parents = CellValues(refined, "SkdParentCellId");
  ASSERT_EQ(ghosts.size(), parents.size());
  int marked = 0;
  for (std::size_t i = 0; i < ghosts.size(); ++i)
  {
    EXPECT_EQ(ghosts[i], parents[i] >= 3 && parents[i] <= 5 ? 1 : 0);
    marked += ghosts[i] != 0;
  }
  EXPECT_EQ(marked, 12);
}

TEST(MeshRefinementBlocks, OtherDataSetsAndPrecisions)
{
  RefinementPointer image = MakeRefinement(MakeImage(2), nullptr, 1, 1);
  image->SetMinimumLevel(1);
  EXPECT_EQ(RunRefinement(image)->GetNumberOfCells(), 64);
  auto torus = MakePolyData(TorusTriangles(8, 6), VTK_FLOAT);
  const int types[3] = { VTK_FLOAT, VTK_DOUBLE, VTK_FLOAT };
  for (int precision = 0; precision < 3; ++precision)
  {
    RefinementPointer filter = MakeRefinement(torus, nullptr, 1);
    filter->SetMinimumLevel(1);
    filter->SetOutputPointsPrecision(precision);
    auto refined = vtkPointSet::SafeDownCast(RunRefinement(filter));
    EXPECT_EQ(refined->GetPoints()->GetDataType(), types[precision]);
  }
  vtkNew<vtkPartitionedDataSetCollection> collection;
  collection->SetPartition(0, 0, torus);
  collection->SetPartition(1, 0, MakeTorus());
  RefinementPointer filter = MakeRefinement(collection, nullptr, 1, 1);
  filter->SetMinimumLevel(1);
  filter->Update();
  auto output = vtkPartitionedDataSetCollection::SafeDownCast(filter->GetOutputDataObject(0));
  ASSERT_NE(output, nullptr);
  EXPECT_EQ(output->GetPartition(0, 0)->GetNumberOfCells(), 4 * torus->GetNumberOfCells());
  EXPECT_EQ(output->GetPartition(1, 0)->GetNumberOfCells(), 4 * 24 * 12 * 2);
}

TEST(MeshRefinementBlocks, PolyDataOfAllKindsIsInOrder)
{
  Mesh mesh = Strips(4);
  const vtkIdType a = mesh.Add(Point{ 9, 9, 9 });
  const vtkIdType b = mesh.Add(Point{ 10, 9, 9 });
  mesh.Add(VTK_VERTEX, { a });
  mesh.Add(VTK_LINE, { a, b });
  mesh.Add(VTK_POLY_LINE, { b, a, 0 });
  mesh.Add(VTK_TRIANGLE, { 0, 1, a });
  auto surface = WithData(MakePolyData(mesh));
  RefinementPointer filter = MakeRefinement(surface, nullptr, 1, 1);
  filter->SetMinimumLevel(1);
  auto refined = vtkPolyData::SafeDownCast(RunRefinement(filter));
  EXPECT_EQ(refined->GetNumberOfVerts(), 1);
  EXPECT_EQ(refined->GetNumberOfLines(), 3);
  EXPECT_EQ(refined->GetNumberOfStrips(), 0);
  const std::vector<double> parents = CellValues(refined, "SkdParentCellId");
  ASSERT_EQ(static_cast<vtkIdType>(parents.size()), refined->GetNumberOfCells());
  std::vector<double> sums(static_cast<std::size_t>(surface->GetNumberOfCells()), 0.0);
  vtkNew<vtkGenericCell> cell;
  for (std::size_t i = 0; i < parents.size(); ++i)
  {
    EXPECT_EQ(CellValues(refined, "Number")[i], 10 * parents[i]);
    refined->GetCell(static_cast<vtkIdType>(i), cell);
    sums[static_cast<std::size_t>(parents[i])] += cell->GetCellDimension();
    EXPECT_EQ(cell->GetCellDimension(),
      surface->GetCell(static_cast<vtkIdType>(parents[i]))->GetCellDimension());
  }
  EXPECT_TRUE(std::all_of(sums.begin() + 1, sums.end(), [](double sum) { return sum > 0; }));
}

//------------------------------------------------------------------------------
TEST(MeshRefinementLimits, TheCellLimitStopsItAtASoundMesh)
{
  for (int method : { 0, 1 })
  {
    RefinementPointer whole = MakeRefinement(MakeTorus(), MakePart(), 5, method);
    const vtkIdType all = RunRefinement(whole)->GetNumberOfCells();
    EXPECT_EQ(Reported(whole, "StoppedAtLevel"), -1);
    EXPECT_EQ(Reported(whole, "EstimatedCells"), all);
    RefinementPointer filter = MakeRefinement(MakeTorus(), MakePart(), 5, method);
    filter->SetCellLimit(2000);
    EventCounter events(filter);
    vtkDataSet* refined = RunRefinement(filter);
    EXPECT_LE(refined->GetNumberOfCells(), 2000);
    EXPECT_GT(refined->GetNumberOfCells(), 700);
    EXPECT_EQ(events.Warnings, 1);
    const double level = Reported(filter, "StoppedAtLevel");
    EXPECT_TRUE(level > 0 && level < 5);
    const std::string expected =
      "Stopped at level " + std::to_string(static_cast<int>(level)) + " of 5";
    EXPECT_NE(events.Warning.find(expected), std::string::npos) << events.Warning;
    EXPECT_GT(Reported(filter, "EstimatedCells"), 2000);
    const MeshMeasures measures = MeasuresOf(refined);
    EXPECT_NEAR(measures.Sum, MeasuresOf(MakeTorus()).Sum, 1e-12);
    if (method == 0)
    {
      EXPECT_EQ(measures.Euler, 0);
      EXPECT_EQ(measures.OpenFaces, 0);
    }
  }
}

/// A mesh of triangles and one of hexahedra, moved along x.
std::vector<vtkSmartPointer<vtkDataSet>> MeshesAt(double x)
{
  return { MakePolyData(Transformed(Sheet(4, VTK_TRIANGLE), 1.0, { x, 0, 0 })),
    MakePolyData(Transformed(Sheet(4, VTK_QUAD), 1.0, { x, 0, 0 })),
    MakeGrid(Transformed(Hexahedra(2), 1.0, { x, 0, 0 })),
    MakeGrid(Transformed(Tetrahedra(2), 1.0, { x, 0, 0 })) };
}

TEST(MeshRefinementLimits, StopsWhereCoordinatesTellNoPointsApart)
{
  for (const int method : { 0, 1 })
  {
    for (const double x : { 1e15, -3e15, 4e15 })
    {
      for (const auto& mesh : MeshesAt(x))
      {
        RefinementPointer filter = MakeRefinement(mesh, nullptr, 12, method);
        filter->SetMinimumLevel(12);
        EventCounter events(filter);
        vtkDataSet* refined = RunRefinement(filter);
        EXPECT_LT(refined->GetNumberOfCells(), 20000) << x << " " << method;
        EXPECT_EQ(events.Errors, 0);
        EXPECT_EQ(events.Warnings, 1) << x << " " << method;
        EXPECT_NE(events.Warning.find("resolution"), std::string::npos) << events.Warning;
      }
    }
  }
}

TEST(MeshRefinementLimits, GoesOnWhereCoordinatesTellPointsApart)
{
  for (const int method : { 0, 1 })
  {
    const auto near = MeshesAt(0);
    const auto far = MeshesAt(std::ldexp(1.0, 40));
    for (std::size_t i = 0; i < near.size(); ++i)
    {
      RefinementPointer here = MakeRefinement(near[i], nullptr, 3, method);
      RefinementPointer there = MakeRefinement(far[i], nullptr, 3, method);
      here->SetMinimumLevel(2);
      there->SetMinimumLevel(2);
      EventCounter events(there);
      EXPECT_EQ(RunRefinement(there)->GetNumberOfCells(), RunRefinement(here)->GetNumberOfCells());
      EXPECT_EQ(events.Warnings, 0);
    }
  }
}

TEST(MeshRefinementLimits, LevelsZeroAndThirty)
{
  auto torus = MakeTorus();
  RefinementPointer none = MakeRefinement(torus, MakePart(), 0);
  EXPECT_EQ(RunRefinement(none)->GetNumberOfCells(), torus->GetNumberOfCells());
  Mesh point;
  point.Add(VTK_VERTEX, { point.Add({ 0.3, 0.3, 0.0 }) });
  for (int method : { 0, 1 })
  {
    RefinementPointer deep =
      MakeRefinement(MakePolyData(Sheet(1, VTK_QUAD)), MakePolyData(point), 99, method);
    EXPECT_EQ(deep->GetMaximumLevel(), 30);
    vtkDataSet* refined = RunRefinement(deep);
    const std::vector<double> levels = CellValues(refined, "SkdLevel");
    EXPECT_EQ(*std::max_element(levels.begin(), levels.end()), 30);
    EXPECT_LT(refined->GetNumberOfCells(), 1000);
    EXPECT_NEAR(MeasuresOf(refined).Sum, 1.0, 1e-12);
  }
}

TEST(MeshRefinementLimits, ProgressRisesAndAnAbortStopsIt)
{
  RefinementPointer filter = MakeRefinement(MakeTorus(), MakePart(), 6);
  ExpectProgressToRise(filter, 8);
  const double cells = Reported(filter, "Cells");
  filter->Modified();
  AbortAt(filter, 0.2);
  EXPECT_LT(filter->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::CELL), cells);
  RunRefinement(filter);
  EXPECT_EQ(Reported(filter, "Cells"), cells);
}

TEST(MeshRefinementLimits, TreesAreKeptWhileThePartsAreTheSame)
{
  RefinementPointer filter = MakeRefinement(MakeTorus(), MakePart(), 2);
  RunRefinement(filter);
  EXPECT_EQ(Reported(filter, "TreesBuilt"), 1);
  filter->SetInputDataObject(0, MakeTorus());
  filter->SetPartsData(MakePart());
  filter->SetMaximumLevel(3);
  RunRefinement(filter);
  EXPECT_EQ(Reported(filter, "TreesBuilt"), 0);
  filter->SetPartsData(MakePolyData(SphereTriangles(4)));
  RunRefinement(filter);
  EXPECT_EQ(Reported(filter, "TreesBuilt"), 1);
}

TEST(MeshRefinementLimits, TheSameWhateverTheNumberOfThreads)
{
  std::vector<std::vector<double>> found;
  for (int threads : { 1, 4 })
  {
    vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads },
      [&]
      {
        RefinementPointer filter = MakeRefinement(WithData(MakeTorus()), MakePart(), 4);
        filter->AddDistanceBand(0.3, 3);
        vtkDataSet* refined = RunRefinement(filter);
        found.push_back(CellValues(refined, "SkdParentCellId"));
        for (vtkIdType i = 0; i < refined->GetNumberOfPoints(); ++i)
        {
          const double* x = refined->GetPoint(i);
          found.back().insert(found.back().end(), x, x + 3);
        }
      });
  }
  EXPECT_EQ(found[0], found[1]);
}

}
