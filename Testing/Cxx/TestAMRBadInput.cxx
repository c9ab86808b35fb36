// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeAMR: input that has nothing, is not finite or needs too much; limits, aborts, kept
// trees.

#include "Support/AMRRun.h"
#include "Support/FilterRun.h"
#include "Support/NamedMeshes.h"
#include "Support/ProgressRises.h"
#include "Support/StructuredMeshes.h"

#include "vtkDoubleArray.h"
#include "vtkHyperTreeGrid.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkOverlappingAMR.h"
#include "vtkPointData.h"
#include "vtkRectilinearGrid.h"

#include <gtest/gtest.h>

using namespace skdtest;

namespace
{

const Bounds UnitCube = { 0, 1, 0, 1, 0, 1 };

vtkIdType RunCells(vtkSkdTreeAMR* filter)
{
  filter->Update();
  return filter->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::CELL);
}

TEST(AMRBadInput, WithoutCellsTheBaseStaysOrThereIsNothing)
{
  vtkNew<vtkMultiBlockDataSet> noBlocks;
  vtkNew<vtkPolyData> noCells;
  for (vtkDataObject* empty : std::initializer_list<vtkDataObject*>{ noBlocks, noCells })
  {
    AMRPointer filter = MakeAMRIn(empty, 4, UnitCube);
    filter->SetBaseDimensions(2, 3, 4);
    EventCounter events(filter);
    EXPECT_EQ(RunCells(filter), 24);
    EXPECT_EQ(events.Errors, 0);
    EXPECT_EQ(events.Warnings, 1);
    filter->AutomaticBoundsOn();
    for (int type : { vtkSkdTreeAMR::HYPER_TREE_GRID, vtkSkdTreeAMR::UNSTRUCTURED_GRID })
    {
      filter->SetOutputType(type);
      EXPECT_EQ(RunCells(filter), 0);
    }
    EXPECT_EQ(events.Errors, 2);
    EXPECT_NE(events.Error.find("no parts to take its bounds from"), std::string::npos)
      << events.Error;
  }
}

Mesh Points(const std::vector<Point>& points)
{
  Mesh mesh;
  for (const Point& point : points)
  {
    mesh.Add(VTK_VERTEX, { mesh.Add(point) });
  }
  return mesh;
}

TEST(AMRBadInput, ASinglePointHasAGridOfOneCellButNoTrees)
{
  const Point x = { 1, 2, 3 };
  for (const Mesh& mesh : { Points({ x }), Points({ x, x, x }) })
  {
    AMRPointer filter = MakeAMR(MakePolyData(mesh), 3);
    EventCounter events(filter);
    EXPECT_EQ(RunCells(filter), 1);
    EXPECT_EQ(events.Errors, 0);
    filter->SetOutputType(vtkSkdTreeAMR::HYPER_TREE_GRID);
    EXPECT_EQ(RunCells(filter), 0);
    EXPECT_EQ(events.Errors, 1);
    EXPECT_NE(events.Error.find("single point"), std::string::npos) << events.Error;
    filter->SetOutputType(vtkSkdTreeAMR::OVERLAPPING_AMR);
    filter->Update();
    EXPECT_EQ(events.Errors, 2);
  }
  AMRPointer flat = MakeAMRIn(MakeTorus(), 3, { 1, 1, 2, 2, 3, 3 });
  flat->SetOutputType(vtkSkdTreeAMR::HYPER_TREE_GRID);
  EventCounter events(flat);
  EXPECT_EQ(RunCells(flat), 0);
  EXPECT_NE(events.Error.find("single point"), std::string::npos) << events.Error;
}

TEST(AMRBadInput, MoreBaseCellsThanThereAreNumbersAreRefused)
{
  AMRPointer filter = MakeAMRIn(MakeTorus(), 3, UnitCube);
  filter->SetBaseDimensions(VTK_INT_MAX, 1, 1);
  EventCounter events(filter);
  EXPECT_EQ(RunCells(filter), 0);
  EXPECT_NE(events.Error.find("2^20"), std::string::npos) << events.Error;
}

TEST(AMRBadInput, StopsWhereCoordinatesTellNoCellsApart)
{
  for (const int type : { vtkSkdTreeAMR::HYPER_TREE_GRID, vtkSkdTreeAMR::UNSTRUCTURED_GRID })
  {
    AMRPointer filter =
      MakeAMR(MakePolyData(Transformed(TorusTriangles(24, 12), 1.0, { 1e15, 0, 0 })), 12);
    filter->SetOutputType(type);
    EventCounter events(filter);
    EXPECT_LT(RunCells(filter), 1000);
    EXPECT_EQ(events.Warnings, 1);
    EXPECT_NE(events.Warning.find("resolution"), std::string::npos) << events.Warning;
  }
  AMRPointer near =
    MakeAMR(MakePolyData(Transformed(TorusTriangles(24, 12), 1.0, { 1e12, 0, 0 })), 5);
  EventCounter events(near);
  EXPECT_GT(RunCells(near), 1000);
  EXPECT_EQ(events.Warnings, 0);
}

TEST(AMRBadInput, ABaseThatMissesThePartsStays)
{
  AMRPointer filter = MakeAMRIn(MakeTorus(), 4, { 10, 11, 10, 11, 10, 11 });
  EventCounter events(filter);
  EXPECT_EQ(RunCells(filter), 1);
  EXPECT_EQ(events.Warnings, 1);
  EXPECT_NE(events.Warning.find("do not intersect the base mesh"), std::string::npos);
}

TEST(AMRBadInput, PartsThatReachOutOfTheBaseAreCutOff)
{
  AMRPointer filter = MakeAMRIn(MakeTorus(), 3, { 0, 1, 0, 1, 0, 1 });
  EventCounter events(filter);
  EXPECT_GT(RunCells(filter), 8);
  EXPECT_EQ(events.Warnings + events.Errors, 0);
}

TEST(AMRBadInput, BoundsThatMakeNoBaseAreRefused)
{
  const Bounds bad[] = { { 0, 1, 2, 1, 0, 1 }, { -1e308, 1e308, 0, 1, 0, 1 } };
  for (const Bounds& box : bad)
  {
    AMRPointer filter = MakeAMRIn(MakeTorus(), 3, box);
    EventCounter events(filter);
    EXPECT_EQ(RunCells(filter), 0);
    EXPECT_EQ(events.Errors, 1);
  }
  AMRPointer filter = MakeAMR(MakeTorus(), 3);
  EventCounter events(filter);
  filter->SetBaseMeshData(MakeRotatedImage(3));
  EXPECT_EQ(RunCells(filter), 0);
  EXPECT_NE(events.Error.find("direction matrix"), std::string::npos) << events.Error;
  filter->SetBaseMeshData(nullptr);
  filter->SetBaseCellSize(1e-9);
  EXPECT_EQ(RunCells(filter), 0);
  EXPECT_EQ(events.Errors, 2);
  filter->SetBaseCellSize(0.01);
  filter->SetCellLimit(1000);
  EXPECT_EQ(RunCells(filter), 0);
  EXPECT_EQ(events.Errors, 3);
  EXPECT_NE(events.Error.find("CellLimit"), std::string::npos) << events.Error;
}

TEST(AMRBadInput, OverlappingBlocksNeedBaseCellsOfOneSize)
{
  vtkNew<vtkRectilinearGrid> uneven;
  vtkNew<vtkDoubleArray> planes;
  for (double plane : { -2.0, 0.0, 1.0, 2.0 })
  {
    planes->InsertNextValue(plane);
  }
  uneven->SetDimensions(4, 4, 4);
  uneven->SetXCoordinates(planes);
  uneven->SetYCoordinates(planes);
  uneven->SetZCoordinates(planes);
  AMRPointer filter = MakeAMR(MakeTorus(), 3);
  filter->SetOutputType(vtkSkdTreeAMR::OVERLAPPING_AMR);
  EventCounter events(filter);
  filter->Update();
  EXPECT_EQ(events.Errors, 0);
  filter->SetBaseMeshData(uneven);
  filter->Update();
  EXPECT_EQ(events.Errors, 1);
  EXPECT_NE(events.Error.find("of equal size"), std::string::npos) << events.Error;
  auto blocks = vtkOverlappingAMR::SafeDownCast(filter->GetOutputDataObject(0));
  EXPECT_EQ(blocks->GetNumberOfLevels(), 0u);
}

TEST(AMRBadInput, CellsThatAreNotFiniteAreLeftOut)
{
  Mesh torus = TorusTriangles(24, 12);
  AMRPointer good = MakeAMRIn(MakePolyData(torus), 3, { -2, 2, -2, 2, -2, 2 });
  const vtkIdType cells = RunCells(good);
  torus.Points.push_back({ std::numeric_limits<double>::quiet_NaN(), 0, 0 });
  torus.Add(VTK_TRIANGLE, { 0, 1, static_cast<vtkIdType>(torus.Points.size()) - 1 });
  AMRPointer filter = MakeAMRIn(MakePolyData(torus), 3, { -2, 2, -2, 2, -2, 2 });
  EXPECT_EQ(RunCells(filter), cells);
  EXPECT_EQ(Reported(filter, "PartCellsLeftOut"), 1);
}

TEST(AMRBadInput, LevelsZeroAndThirty)
{
  Mesh point;
  point.Add(VTK_VERTEX, { point.Add({ 0.3, 0.3, 0.3 }) });
  AMRPointer filter = MakeAMRIn(MakePolyData(point), 0, UnitCube);
  EXPECT_EQ(RunCells(filter), 1);
  filter->SetMaximumLevel(99);
  EXPECT_EQ(filter->GetMaximumLevel(), 30);
  EXPECT_EQ(RunCells(filter), 30 * 7 + 1);
  filter->SetBranchFactor(3);
  EXPECT_EQ(RunCells(filter), 30 * 26 + 1);
}

TEST(AMRBadInput, LongAndThinCellsAreRefinedAsThoseOfAPlacedCopy)
{
  const Mesh torus = TorusTriangles(24, 12);
  Mesh thin = torus;
  thin.Map([](const Point& p) { return Point{ 1e6 * p[0], p[1], 1e-6 * p[2] }; });
  AMRPointer reference = MakeAMRIn(MakePolyData(torus), 5, { -1.6, 1.7, -1.5, 1.8, -0.7, 0.6 });
  AMRPointer filter =
    MakeAMRIn(MakePolyData(thin), 5, { -1.6e6, 1.7e6, -1.5, 1.8, -0.7e-6, 0.6e-6 });
  reference->Update();
  filter->Update();
  EXPECT_GT(Reported(filter, "CutCells"), 500);
  EXPECT_EQ(ReportedRow(filter, "LeavesAtLevel"), ReportedRow(reference, "LeavesAtLevel"));
  EXPECT_EQ(ReportedRow(filter, "CutAtLevel"), ReportedRow(reference, "CutAtLevel"));
}

TEST(AMRBadInput, ConformingOfWhatCannotConformIsLeftAndAWarningSaysSo)
{
  const Bounds flat = { -2, 2, -2, 2, 0.1, 0.1 };
  const Bounds solid = { -2, 2, -2, 2, -2, 2 };
  const auto warningsOf = [](const Bounds& box, int type)
  {
    AMRPointer filter = MakeAMRIn(MakeTorus(), 4, box);
    filter->SetOutputType(type);
    filter->ConformingOn();
    EventCounter events(filter);
    const vtkIdType cells = RunCells(filter);
    filter->ConformingOff();
    EXPECT_EQ(events.Errors, 0);
    EXPECT_TRUE(events.Warnings == 0 || cells == RunCells(filter));
    EXPECT_TRUE(
      events.Warnings == 0 || events.Warning.find("Conforming is ignored") != std::string::npos);
    return events.Warnings;
  };
  EXPECT_EQ(warningsOf(flat, vtkSkdTreeAMR::UNSTRUCTURED_GRID), 0);
  EXPECT_EQ(warningsOf(solid, vtkSkdTreeAMR::UNSTRUCTURED_GRID), 1);
  EXPECT_EQ(warningsOf(flat, vtkSkdTreeAMR::HYPER_TREE_GRID), 1);
  EXPECT_EQ(warningsOf(solid, vtkSkdTreeAMR::OVERLAPPING_AMR), 1);
}

TEST(AMRBadInput, ValuesThatAreNotFiniteAskForNothing)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  auto image = MakeImage(4);
  vtkNew<vtkDoubleArray> values;
  values->SetName("Odd");
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    values->InsertNextValue(i % 3 == 0 ? nan : i % 3 == 1 ? infinity : 7.0);
  }
  image->GetPointData()->AddArray(values);
  Mesh point;
  point.Add(VTK_VERTEX, { point.Add({ 1.6, 1.6, 1.6 }) });
  for (const int test :
    { vtkSkdTreeAMR::DIFFERENCE, vtkSkdTreeAMR::GRADIENT, vtkSkdTreeAMR::VALUE })
  {
    AMRPointer filter = MakeAMRIn(MakePolyData(point), 3, { 0, 4, 0, 4, 0, 4 });
    const vtkIdType cells = RunCells(filter);
    filter->SetFieldData(image);
    filter->AddFieldArray("Odd");
    filter->SetFieldTest(test);
    filter->SetFieldRange(8.0, 1e300);
    EXPECT_EQ(RunCells(filter), cells) << test;
    filter->SetFieldRange(6.0, 8.0); // the one value that is finite
    EXPECT_EQ(RunCells(filter) > cells, test == vtkSkdTreeAMR::VALUE) << test;
  }
}

TEST(AMRBadInput, TheCellLimitStopsAtALevelAndTellsWhich)
{
  AMRPointer whole = MakeAMR(MakeTorus(), 6);
  const std::vector<Leaf> all = RunLeaves(whole);
  const std::vector<double> cut = ReportedRow(whole, "CutAtLevel");
  AMRPointer filter = MakeAMR(MakeTorus(), 6);
  filter->SetCellLimit(10000);
  EventCounter events(filter);
  const std::vector<Leaf> leaves = RunLeaves(filter);
  const int level = static_cast<int>(Reported(filter, "StoppedAtLevel"));
  EXPECT_TRUE(level > 2 && level < 6) << level;
  EXPECT_EQ(events.Warnings, 1);
  const std::string expected = "Stopped at level " + std::to_string(level) + " of 6";
  EXPECT_NE(events.Warning.find(expected), std::string::npos) << events.Warning;
  EXPECT_LE(Reported(filter, "AllCells"), 10000);
  const std::vector<double> soFar = ReportedRow(filter, "CutAtLevel");
  EXPECT_EQ(soFar, std::vector<double>(cut.begin(), cut.begin() + level + 1));
  EXPECT_EQ(Reported(whole, "StoppedAtLevel"), -1);
}

TEST(AMRBadInput, TheCellLimitHoldsWhileBalancing)
{
  AMRPointer filter = MakeAMR(MakeTorus(), 5);
  const double unbalanced = (RunCells(filter), Reported(filter, "AllCells"));
  filter->SetBalance(vtkSkdTreeAMR::CORNER);
  filter->SetCellLimit(static_cast<vtkIdType>(unbalanced) + 100);
  EventCounter events(filter);
  RunCells(filter);
  EXPECT_EQ(events.Warnings, 1);
  EXPECT_LE(Reported(filter, "AllCells"), unbalanced + 100);
  EXPECT_GT(Reported(filter, "AllCells"), unbalanced);
}

TEST(AMRBadInput, ProgressRisesAndAnAbortStopsIt)
{
  AMRPointer filter = MakeAMR(MakeTorus(), 6);
  filter->ComputeInsideOn();
  filter->ComputeDistanceOn();
  ExpectProgressToRise(filter, 10);
  const double cells = Reported(filter, "Cells");
  filter->Modified();
  AbortAt(filter, 0.15);
  const vtkIdType partial =
    filter->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::CELL);
  EXPECT_LT(partial, cells);
  EXPECT_EQ(RunCells(filter), cells);
}

TEST(AMRBadInput, TreesAreKeptWhileThePartsAreTheSame)
{
  auto torus = MakeTorus();
  AMRPointer filter = MakeAMR(torus, 3);
  filter->Update();
  EXPECT_EQ(Reported(filter, "TreesBuilt"), 1);
  filter->SetMaximumLevel(4);
  filter->Update();
  EXPECT_EQ(Reported(filter, "TreesBuilt"), 0);
  auto again = MakeTorus();
  filter->SetInputDataObject(0, again);
  filter->Update();
  EXPECT_EQ(Reported(filter, "TreesBuilt"), 0);
  again->GetPoints()->SetPoint(0, 0, 0, 5);
  again->GetPoints()->Modified();
  filter->Update();
  EXPECT_EQ(Reported(filter, "TreesBuilt"), 1);
}

}
