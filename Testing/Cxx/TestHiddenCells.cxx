// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// Cells of grids that are blanked, and of AMR that are refined elsewhere: nothing is said of them,
// and answers are those of the other cells alone.

#include "Support/AMRMeshes.h"
#include "Support/EventCounter.h"
#include "Support/MakeOf.h"
#include "Support/StructuredMeshes.h"
#include "Support/SurfaceMeshes.h"

#include "vtkAppendFilter.h"
#include "vtkSkdTreeCellLocator.h"
#include "vtkSkdTreeClosestPoint.h"
#include "vtkSkdTreeCurveIntersection.h"
#include "vtkSkdTreeCurveSurfaceIntersection.h"
#include "vtkSkdTreeMeshAdaptation.h"
#include "vtkSkdTreeMeshRefinement.h"
#include "vtkSkdTreePointInOut.h"
#include "vtkSkdTreeRays.h"
#include "vtkSkdTreeWallThickness.h"

#include <gtest/gtest.h>

using namespace skdtest;

namespace
{
GridPointer Appended(vtkDataSet* mesh)
{
  vtkNew<vtkAppendFilter> append;
  append->SetInputData(mesh);
  append->Update();
  return append->GetOutput();
}

/// A grid of which points are hidden, and the cells that have them.
vtkSmartPointer<vtkStructuredGrid> WithHiddenPoints()
{
  auto grid = MakeStructured(3);
  grid->BlankPoint(0);
  grid->BlankPoint(21);
  return grid;
}

vtkSmartPointer<vtkImageData> ImageWithHiddenPoint(int n)
{
  auto image = MakeImage(n);
  image->AllocatePointGhostArray();
  image->GetPointGhostArray()->SetValue(0, vtkDataSetAttributes::HIDDENPOINT);
  return image;
}

/// With other values where nothing is shown, and what is shown alone.
struct Pair
{
  vtkSmartPointer<vtkOverlappingAMR> Blocks = MakeAMR();
  GridPointer Shown = ShownCellsOf(Blocks);
};

/// No sphere, on which samples of grids would count by their latitude.
PolyDataPointer Ball()
{
  const auto flat = [](const Point& x) -> Point { return { x[0], x[1], 0.9 * x[2] }; };
  return MakePolyData(Transformed(SphereTriangles(6), 0.8, { 1.2, 1.1, 1.3 }).Map(flat));
}
}

TEST(HiddenCells, AreNotBrokenWhereVtkAppendsThem)
{
  for (const GridPointer& mesh : { Appended(Blanked(MakeUniformGrid(3))),
         Appended(Blanked(MakeStructured(3))), Appended(WithHiddenPoints()) })
  {
    vtkNew<vtkSkdTreeCellLocator> locator;
    EventCounter events(locator);
    locator->SetDataSet(mesh);
    locator->BuildLocator();
    EXPECT_EQ(events.Warnings, 0) << events.Warning;
    EXPECT_GT(locator->GetNumberOfCellsLeftOut(), 0);
    EXPECT_LT(locator->GetNumberOfCellsLeftOut(), 27);
  }
}

TEST(HiddenCells, WithoutMarksOrWithOtherFaultsAreNamed)
{
  const GridPointer mesh = Appended(Blanked(MakeUniformGrid(3)));
  mesh->GetCellGhostArray()->SetValue(4, 0);
  vtkNew<vtkSkdTreeCellLocator> locator;
  EventCounter events(locator);
  locator->SetDataSet(mesh);
  locator->BuildLocator();
  EXPECT_EQ(events.Warnings, 1);
  EXPECT_NE(events.Warning.find("1 of 27 cells is broken"), std::string::npos) << events.Warning;
  EXPECT_NE(events.Warning.find("it is cell 4"), std::string::npos) << events.Warning;
}

TEST(HiddenCells, AreKeptByRefinementWithoutAWord)
{
  for (const DataSetPointer& mesh : std::vector<DataSetPointer>{
         Blanked(MakeUniformGrid(3)), Blanked(MakeStructured(3)), WithHiddenPoints() })
  {
    const auto filter = MakeOf<vtkSkdTreeMeshRefinement>(mesh, nullptr);
    EventCounter events(filter);
    filter->SetMaximumLevel(1);
    filter->Update();
    EXPECT_EQ(events.Warnings, 0) << events.Warning;
    EXPECT_EQ(Reported(filter, "CellsNotRefinable"), 0.0);
  }
}

// They would cut cells beside them.
TEST(HiddenCells, AreNotRefined)
{
  const auto mesh = MakeGrid(Hexahedra(2));
  MarkGhosts(mesh, { 0, 3 }, vtkDataSetAttributes::REFINEDCELL);
  const auto filter = MakeOf<vtkSkdTreeMeshRefinement>(mesh, nullptr);
  filter->SetMaximumLevel(1);
  filter->SetMethod(vtkSkdTreeMeshRefinement::REGULAR);
  filter->Update();
  EXPECT_EQ(Reported(filter, "Cells"), 6 * 8 + 2);
}

TEST(HiddenCells, StayHiddenWhereAGridIsRefined)
{
  const auto filter = MakeOf<vtkSkdTreeMeshRefinement>(ImageWithHiddenPoint(3), nullptr);
  filter->SetMaximumLevel(1);
  filter->SetMethod(vtkSkdTreeMeshRefinement::REGULAR);
  filter->Update();
  auto* output = vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(0));
  ASSERT_EQ(output->GetNumberOfCells(), 26 * 8 + 1);
  EXPECT_EQ(output->GetCellType(0), VTK_EMPTY_CELL);
  EXPECT_NE(output->GetCellType(1), VTK_EMPTY_CELL);
}

TEST(HiddenCells, AreNotExtracted)
{
  using InOut = vtkSkdTreePointInOut;
  const Pair pair;
  for (const int ask : { InOut::POINTS, InOut::CELL_CENTERS })
  {
    std::vector<vtkIdType> cells;
    for (vtkDataObject* mesh : std::vector<vtkDataObject*>{ pair.Blocks, pair.Shown })
    {
      const auto filter = MakeOf<InOut>(mesh, Ball());
      filter->SetAsk(ask);
      filter->SetExtract(InOut::INSIDE);
      filter->Update();
      cells.push_back(filter->GetOutputDataObject(1)->GetNumberOfElements(vtkDataObject::CELL));
    }
    EXPECT_EQ(cells[0], cells[1]);
    EXPECT_GT(cells[0], 0);
  }
}

TEST(HiddenCells, HaveNoFacesForCurvesAndAreNoCurves)
{
  const auto image = ImageWithHiddenPoint(1);
  Mesh mesh;
  mesh.Add(VTK_LINE, { mesh.Add({ -2, 0.6, 2.1 }), mesh.Add({ 2, 0.7, 2.2 }) });
  const auto line = MakePolyData(mesh);
  const auto faces = MakeOf<vtkSkdTreeCurveSurfaceIntersection>(line, image);
  faces->VolumeFacesOn();
  faces->Update();
  EXPECT_EQ(Reported(faces, "Hits"), 0.0);
  const auto row = vtkSmartPointer<vtkImageData>::New();
  row->SetDimensions(5, 1, 1);
  row->SetOrigin(-1.7, 0.65, 2.15);
  MarkGhosts(row, { 0, 1, 2, 3 }, vtkDataSetAttributes::REFINEDCELL);
  const auto curves = MakeOf<vtkSkdTreeCurveIntersection>(row, line);
  curves->Update();
  EXPECT_EQ(Reported(curves, "Curves"), 0.0);
}

TEST(HiddenCells, HaveNoPartInTheRangeOfAField)
{
  const Pair pair;
  std::vector<double> cells;
  for (vtkDataObject* field : std::vector<vtkDataObject*>{ pair.Blocks, pair.Shown })
  {
    for (const char* name : { "f", "c" })
    {
      const auto filter = MakeOf<vtkSkdTreeMeshRefinement>(MakeGrid(Hexahedra(4)), nullptr);
      filter->SetMaximumLevel(1);
      filter->SetFieldData(field);
      filter->AddFieldArray(name);
      filter->SetFieldTest(vtkSkdTreeMeshRefinement::VALUE);
      filter->RelativeFieldThresholdOn();
      filter->SetFieldRange(0.7, 1.0);
      filter->Update();
      cells.push_back(Reported(filter, "Cells"));
    }
  }
  EXPECT_EQ(cells[0], cells[2]);
  EXPECT_EQ(cells[1], cells[3]);
  EXPECT_GT(cells[0], 64.0);
  EXPECT_GT(cells[1], 64.0);
}

TEST(HiddenCells, HaveNoPartInAFieldThatAMeshFollows)
{
  const Pair pair;
  std::vector<std::vector<double>> areas;
  for (vtkDataObject* field : std::vector<vtkDataObject*>{ pair.Blocks, pair.Shown })
  {
    const auto filter = MakeOf<vtkSkdTreeMeshAdaptation>(Ball(), field);
    filter->SetFieldArray("f");
    filter->SetMaximumIterations(2);
    filter->Update();
    auto* mesh = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
    areas.push_back(ValuesOf(mesh->GetCellData()->GetArray("SkdArea")));
  }
  EXPECT_FALSE(areas[0].empty());
  EXPECT_EQ(areas[0], areas[1]);
}

TEST(HiddenCells, SendNoRays)
{
  const Pair pair;
  for (const int start : { vtkSkdTreeRays::POINTS, vtkSkdTreeRays::CELL_CENTERS })
  {
    std::vector<vtkIdType> hits;
    for (vtkDataObject* mesh : std::vector<vtkDataObject*>{ pair.Blocks, pair.Shown })
    {
      const auto filter = MakeOf<vtkSkdTreeRays>(mesh, Ball());
      EventCounter events(filter);
      filter->SetStart(start);
      filter->SetAlongToDirection();
      filter->SetDirection(0.5, 0.6, 0.7);
      filter->SetHitsToAllHits();
      filter->Update();
      EXPECT_EQ(events.Warnings, 0) << events.Warning;
      hits.push_back(filter->GetOutputDataObject(1)->GetNumberOfElements(vtkDataObject::POINT));
    }
    EXPECT_EQ(hits[0], hits[1]);
    EXPECT_GT(hits[0], 0);
  }
}

TEST(HiddenCells, HaveNoLinesToWhatIsNearest)
{
  const Pair pair;
  const auto filter = MakeOf<vtkSkdTreeClosestPoint>(pair.Blocks, Ball());
  filter->GenerateLinesOn();
  filter->Update();
  EXPECT_EQ(filter->GetOutputDataObject(1)->GetNumberOfElements(vtkDataObject::CELL),
    pair.Shown->GetNumberOfPoints());
}

TEST(HiddenCells, HaveNoThicknessAndNoneIsMissed)
{
  Mesh mesh = SphereTriangles(6);
  mesh.Add(VTK_TRIANGLE, { mesh.Add({ 3, 0, 0 }), mesh.Add({ 4, 0, 0 }), mesh.Add({ 3, 1, 0 }) });
  const auto surface = MakePolyData(mesh);
  MarkGhosts(surface, { surface->GetNumberOfCells() - 1 }, vtkDataSetAttributes::HIDDENCELL);
  const auto filter = MakeOf<vtkSkdTreeWallThickness>(surface, nullptr);
  EventCounter events(filter);
  filter->SetNumberOfRays(1);
  filter->Update();
  EXPECT_EQ(events.Warnings, 0) << events.Warning;
}
