// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// Cells of grids that are blanked, and of AMR that are refined elsewhere: nothing is said of them,
// and answers are those of the other cells alone.

#include "Support/AMRMeshes.h"
#include "Support/CurvedMeshes.h"
#include "Support/EventCounter.h"
#include "Support/FilterZoo.h"
#include "Support/MakeOf.h"
#include "Support/QuietWindow.h"
#include "Support/StructuredMeshes.h"
#include "Support/SurfaceMeshes.h"

#include "vtkAppendFilter.h"
#include "vtkSkdTreeBooleanOperation.h"
#include "vtkSkdTreeCellLocator.h"
#include "vtkSkdTreeClosestPoint.h"
#include "vtkSkdTreeCompareSurfaces.h"
#include "vtkSkdTreeCurveIntersection.h"
#include "vtkSkdTreeCurveSurfaceIntersection.h"
#include "vtkSkdTreeMeshAdaptation.h"
#include "vtkSkdTreeMeshRefinement.h"
#include "vtkSkdTreePointInOut.h"
#include "vtkSkdTreeRays.h"
#include "vtkSkdTreeSpatialQuery.h"
#include "vtkSkdTreeWallThickness.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

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
Mesh BallTriangles()
{
  const auto flat = [](const Point& x) -> Point { return { x[0], x[1], 0.9 * x[2] }; };
  return Transformed(SphereTriangles(6), 0.8, { 1.2, 1.1, 1.3 }).Map(flat);
}

PolyDataPointer Ball()
{
  return MakePolyData(BallTriangles());
}

constexpr double NotFinite = 1e9;

/// All numbers of an output but ids and what is reported, by port, place and name, ascending: VTK's
/// outer faces of different data sets are in different orders.
using Numbers = std::map<std::string, std::vector<double>>;

void AddNumbers(vtkFieldData* data, const std::string& where, Numbers& numbers)
{
  for (int i = 0; data && i < data->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = data->GetArray(i);
    const std::string name = array ? array->GetName() : "Id";
    if (name.find("Id") == std::string::npos && name.find("Index") == std::string::npos)
    {
      std::vector<double>& values = numbers[where + name];
      values = ValuesOf(array);
      std::replace_if(
        values.begin(), values.end(), [](double x) { return !std::isfinite(x); }, NotFinite);
      std::sort(values.begin(), values.end());
    }
  }
}

Numbers NumbersOf(vtkAlgorithm* filter)
{
  filter->Update();
  Numbers numbers;
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    vtkDataObject* output = filter->GetOutputDataObject(port);
    for (const int type : { vtkDataObject::POINT, vtkDataObject::CELL, vtkDataObject::ROW })
    {
      const std::string where = std::to_string(port) + " " + std::to_string(type) + " ";
      numbers[where] = { static_cast<double>(output->GetNumberOfElements(type)) };
      AddNumbers(output->GetAttributesAsFieldData(type), where, numbers);
    }
  }
  return numbers;
}

void ExpectEqual(const Numbers& some, const Numbers& others)
{
  ASSERT_EQ(some.size(), others.size());
  for (const auto& [name, values] : some)
  {
    SCOPED_TRACE(name);
    const auto other = others.find(name);
    ASSERT_NE(other, others.end());
    ASSERT_EQ(values.size(), other->second.size());
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      const double expected = other->second[i];
      ASSERT_LE(std::abs(values[i] - expected), 1e-6 * std::max(1.0, std::abs(expected))) << i;
    }
  }
}
}

// Each block has points of its own in both. Boxes of trees are rounded. What is asked of outer
// faces has no answers of cells that are shown but of the mesh: see TestPiecesOfMeshes.cxx.
TEST(HiddenCells, SourcesInLevelsAnswerAsOneMeshOfWhatIsShown)
{
  const QuietWindow quiet;
  const Pair pair;
  const std::set<std::string> asSource = { "ClosestPointOn", "RaysOn", "InOutOfCells", "ProbeOf",
    "QueryByCells", "AMRGrid", "RefinementAt" };
  std::size_t found = 0;
  for (const FilterSetup& setup : AllFilterSetups())
  {
    if (asSource.count(setup.Name) > 0)
    {
      SCOPED_TRACE(setup.Name);
      ++found;
      ExpectEqual(NumbersOf(setup.Make(pair.Blocks)), NumbersOf(setup.Make(pair.Shown)));
    }
  }
  EXPECT_EQ(found, asSource.size());
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

TEST(HiddenCells, AreNotMovedAndHoldNoOthers)
{
  Mesh mesh = BallTriangles();
  const auto shown = static_cast<vtkIdType>(mesh.Cells.size());
  const GridPointer alone = MakeGrid(mesh);
  const vtkIdType own = mesh.Add({ 7, 5, 3 });
  mesh.Add(VTK_TRIANGLE, { 0, 1, own });
  mesh.Add(VTK_TRIANGLE, { 0, 1, 20 });
  mesh.Add(VTK_TETRA, { 2, 3, 40, 50 });
  const GridPointer marked = MakeGrid(mesh);
  MarkGhosts(marked, { shown, shown + 1, shown + 2 }, vtkDataSetAttributes::HIDDENCELL);
  const Pair pair;
  std::vector<std::vector<double>> moves;
  for (const GridPointer& input : { alone, marked })
  {
    const auto filter = MakeOf<vtkSkdTreeMeshAdaptation>(input, pair.Shown);
    EventCounter events(filter);
    filter->SetFieldArray("f");
    filter->SetMaximumIterations(2);
    filter->Update();
    EXPECT_EQ(events.Warnings, 1); // of the error that is left
    EXPECT_EQ(events.Warning.find("of Input"), std::string::npos) << events.Warning;
    EXPECT_EQ(Reported(filter, "MovedCells"), static_cast<double>(shown));
    auto* output = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
    EXPECT_EQ(output->GetCellGhostArray() != nullptr, input == marked);
    moves.push_back(PointArray(output, "SkdDisplacement"));
  }
  moves[0].resize(moves[1].size(), 0.0); // the point that hidden cells alone have stays
  EXPECT_GT(*std::max_element(moves[0].begin(), moves[0].end()), 0.0);
  EXPECT_EQ(moves[0], moves[1]);
}

// The hidden triangle covers the sheet, and comes first by the positions of its corners.
TEST(HiddenCells, HaveNoPartInWhatAMeshMissesOfAField)
{
  Mesh mesh = Transformed(Sheet(8, VTK_QUAD), 0.125, { 0, 0, 0 });
  std::vector<double> errors;
  for (const bool hasHidden : { false, true })
  {
    const auto hidden = static_cast<vtkIdType>(mesh.Cells.size());
    if (hasHidden)
    {
      mesh.Add(
        VTK_TRIANGLE, { mesh.Add({ -1, -1, 0 }), mesh.Add({ 4, -1, 0 }), mesh.Add({ -1, 4, 0 }) });
    }
    const PolyDataPointer source = MakePolyData(mesh);
    const auto value = [&](vtkIdType i)
    { return hasHidden && i + 3 >= source->GetNumberOfPoints() ? HiddenValue : 1.0 + i % 9; };
    source->GetPointData()->AddArray(MakeArray("f", source->GetNumberOfPoints(), value));
    if (hasHidden)
    {
      MarkGhosts(source, { hidden }, vtkDataSetAttributes::HIDDENCELL);
    }
    const auto input = MakePolyData(Transformed(Sheet(5, VTK_QUAD), 0.2, { 0, 0, 0 }));
    const auto filter = MakeOf<vtkSkdTreeMeshAdaptation>(input, source);
    filter->SetMonitor(vtkSkdTreeMeshAdaptation::VALUE);
    filter->SetMaximumIterations(2);
    filter->Update();
    errors.push_back(Reported(filter, "EquidistributionOfField"));
  }
  EXPECT_GT(errors[0], 0.0);
  EXPECT_EQ(errors[0], errors[1]);
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

// The third point of the hidden triangle is far from the sphere.
TEST(HiddenCells, HaveNoPartInNormalsAtPoints)
{
  Mesh mesh = SphereTriangles(6);
  const auto alone = MakeOf<vtkSkdTreeWallThickness>(MakePolyData(mesh), nullptr);
  const auto size = mesh.Points.size();
  mesh.Add(VTK_TRIANGLE, { 0, 1, mesh.Add({ 7, 5, 3 }) });
  const auto surface = MakePolyData(mesh);
  MarkGhosts(surface, { surface->GetNumberOfCells() - 1 }, vtkDataSetAttributes::HIDDENCELL);
  const auto marked = MakeOf<vtkSkdTreeWallThickness>(surface, nullptr);
  std::vector<std::vector<double>> thickness;
  for (const auto& filter : { alone, marked })
  {
    filter->SetNumberOfRays(1);
    filter->Update();
    thickness.push_back(PointArray(filter->GetOutputDataObject(0), "SkdThickness"));
  }
  thickness[1].resize(size);
  for (std::size_t i = 0; i < size; ++i)
  {
    ASSERT_NEAR(thickness[0][i], thickness[1][i], 1e-9) << i;
  }
}

// VTK's outer faces of such a grid are polygons that end where they begin.
TEST(HiddenCells, OfGridsLeaveFacesAsQuads)
{
  const auto structured = MakeStructured(3);
  const GridPointer listed = Appended(structured);
  std::vector<std::vector<double>> thickness;
  for (const DataSetPointer& mesh : std::vector<DataSetPointer>{ structured, listed })
  {
    MarkGhosts(mesh, { 0, 4, 13, 22 }, vtkDataSetAttributes::HIDDENCELL);
    const auto filter = MakeOf<vtkSkdTreeWallThickness>(mesh, nullptr);
    filter->SetNumberOfRays(3);
    filter->Update();
    thickness.push_back(PointArray(filter->GetOutputDataObject(0), "SkdThickness"));
  }
  ASSERT_EQ(thickness[0].size(), thickness[1].size());
  for (std::size_t i = 0; i < thickness[0].size(); ++i)
  {
    ASSERT_EQ(std::isnan(thickness[0][i]), std::isnan(thickness[1][i])) << i;
    if (!std::isnan(thickness[0][i]))
    {
      ASSERT_NEAR(thickness[0][i], thickness[1][i], 1e-9) << i;
    }
  }
}

TEST(HiddenCells, HaveNoPointsToCompare)
{
  Mesh mesh = Helix(20, VTK_LINE);
  std::vector<std::vector<double>> distances;
  for (const bool hasHidden : { false, true })
  {
    const std::size_t shown = mesh.Cells.size();
    if (hasHidden)
    {
      mesh.Add(VTK_LINE, { mesh.Add({ 1.2, 1.1, 1.3 }), mesh.Add({ 9, 9, 9 }) });
    }
    const auto lines = MakeGrid(mesh);
    if (hasHidden)
    {
      MarkGhosts(lines, { static_cast<vtkIdType>(shown) }, vtkDataSetAttributes::HIDDENCELL);
    }
    const auto filter = MakeOf<vtkSkdTreeCompareSurfaces>(Ball(), lines);
    filter->Update();
    distances.push_back(PointArray(filter->GetOutputDataObject(0), "SkdDistance"));
  }
  EXPECT_FALSE(distances[0].empty());
  EXPECT_EQ(distances[0], distances[1]);
}

// Of this the deviation of facets from curved faces is a share.
TEST(HiddenCells, HaveNoPartInTheSizeOfAMesh)
{
  Mesh mesh = CurvedBlock(VTK_QUADRATIC_TETRA, 1);
  std::vector<double> lengths;
  for (const bool hasHidden : { false, true })
  {
    const auto hidden = static_cast<vtkIdType>(mesh.Cells.size());
    if (hasHidden)
    {
      mesh.Add(VTK_LINE, { mesh.Add({ 70, 70, 70 }), mesh.Add({ 80, 70, 70 }) });
    }
    const auto curved = MakeGrid(mesh);
    if (hasHidden)
    {
      MarkGhosts(curved, { hidden }, vtkDataSetAttributes::HIDDENCELL);
    }
    const auto filter = MakeOf<vtkSkdTreePointInOut>(Ball(), curved);
    filter->Update();
    lengths.push_back(Reported(filter, "ChordalLength"));
  }
  EXPECT_GT(lengths[0], 0.0);
  EXPECT_EQ(lengths[0], lengths[1]);
}

// Hits nearer than a share of the size of the source are left out, and a plane has room for what it
// cuts.
TEST(HiddenCells, FarAwayHaveNoPartInRaysAndCutsByAPlane)
{
  Mesh mesh = BallTriangles();
  const GridPointer alone = MakeGrid(mesh);
  const auto hidden = static_cast<vtkIdType>(mesh.Cells.size());
  const vtkIdType far = mesh.Add({ 1e30, -1e30, 1e30 });
  mesh.Add(VTK_TRIANGLE, { 0, far, mesh.Add({ -1e30, 1e30, 1e30 }) });
  const GridPointer marked = MakeGrid(mesh);
  MarkGhosts(marked, { hidden }, vtkDataSetAttributes::HIDDENCELL);
  std::vector<double> found;
  for (const GridPointer& grid : { alone, marked })
  {
    const auto rays = MakeOf<vtkSkdTreeRays>(MakeQueries({ { 1.2, 1.1, 1.3 } }), grid);
    rays->SetAlongToDirection();
    rays->SetDirection(0.5, 0.6, 0.7);
    rays->Update();
    found.push_back(Reported(rays, "Hits"));
    const auto cut = MakeOf<vtkSkdTreeBooleanOperation>(grid, nullptr);
    cut->SetOperation(vtkSkdTreeBooleanOperation::DIFFERENCE);
    cut->CutByPlaneOn();
    cut->SetPlaneOrigin(1.2, 1.1, 1.3);
    cut->SetPlaneNormal(1.0, 0.2, 0.1);
    cut->Update();
    found.push_back(Reported(cut, "Volume"));
  }
  EXPECT_GT(found[0], 0.0);
  EXPECT_GT(found[1], 0.0);
  EXPECT_EQ(found[0], found[2]);
  EXPECT_NEAR(found[1], found[3], 1e-9 * found[1]);
}

TEST(HiddenCells, AreNamedWhereNothingElseIsThere)
{
  const auto mesh = MakeGrid(Hexahedra(1));
  MarkGhosts(mesh, { 0 }, vtkDataSetAttributes::HIDDENCELL);
  const auto filter = MakeOf<vtkSkdTreeSpatialQuery>(mesh, nullptr);
  EventCounter events(filter);
  filter->Update();
  EXPECT_EQ(events.Warnings, 1);
  EXPECT_NE(events.Warning.find("hidden"), std::string::npos) << events.Warning;
}
