// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeCurveSurfaceIntersection as a filter: parity, options, composite data, bad input.

#include "Support/CurveRun.h"
#include "Support/EventCounter.h"
#include "Support/Folders.h"
#include "Support/OneAndFourThreads.h"
#include "Support/RealMeshes.h"
#include "Support/SurfaceMeshes.h"
#include "Support/TestAmount.h"
#include "Support/VolumeMeshes.h"

#include "vtkMultiBlockDataSet.h"
#include "vtkSMPTools.h"
#include "vtkSkdTreeCurveSurfaceIntersection.h"

#include <gtest/gtest.h>

#include <fstream>
#include <map>

using namespace skdtest;

namespace
{

using Filter = vtkSkdTreeCurveSurfaceIntersection;
using FilterPointer = vtkSmartPointer<Filter>;

constexpr auto MakeFilter = [](vtkDataObject* curves, vtkDataObject* others = nullptr)
{ return MakeCurveFilter<Filter>(curves, others); };

/// Lines whose ends are outside of the bounds, through points that the mesh has on its vertices, on
/// the middles of its edges, and on its cells.
Mesh LinesThrough(vtkDataSet* surface, int count, int seed)
{
  Random random(seed);
  Bounds box;
  surface->GetBounds(box.data());
  const double size = 3.0 * Diagonal(box);
  Mesh lines;
  vtkNew<vtkIdList> ids;
  for (int i = 0; i < count; ++i)
  {
    const vtkIdType cell = random.Index(static_cast<int>(surface->GetNumberOfCells()));
    surface->GetCellPoints(cell, ids);
    const auto corner = [&](int k)
    {
      Point p;
      surface->GetPoint(ids->GetId(k % ids->GetNumberOfIds()), p.data());
      return p;
    };
    const Point through = i % 3 == 0 ? corner(i)
      : i % 3 == 1                   ? 0.5 * (corner(i) + corner(i + 1))
                                     : (1.0 / 3.0) * (corner(0) + corner(1) + corner(2));
    Point direction = random.InBox({ -1, 1, -1, 1, -1, 1 });
    for (double& coordinate : direction)
    {
      coordinate = i % 2 ? std::round(4.0 * coordinate) / 4.0 : coordinate;
    }
    if (Length(direction) > 0.0)
    {
      direction = (1.0 / Length(direction)) * direction;
      lines.Add(
        VTK_LINE, { lines.Add(through - size * direction), lines.Add(through + size * direction) });
    }
  }
  return lines;
}

/// Every line goes in as often as out, and at each of its points, by turns.
void ExpectEven(vtkDataSet* surface, int count, int seed)
{
  const FilterPointer filter =
    MakeFilter(MakePolyData(LinesThrough(surface, count, seed)), surface);
  filter->InterpolateDataOff();
  const std::vector<double> curves = OutputArray(filter, "SkdCurveId");
  const std::vector<double> senses = OutputArray(filter, "SkdSense");
  std::map<double, int> inside;
  for (std::size_t i = 0; i < curves.size(); ++i)
  {
    inside[curves[i]] += static_cast<int>(senses[i]);
  }
  EXPECT_GT(inside.size(), 0.9 * count);
  for (const auto& [curve, sum] : inside)
  {
    ASSERT_EQ(sum, 0) << "line " << curve << " of seed " << seed;
  }
}

PolyDataPointer LineAlongX(double from = -1, double to = 4)
{
  return MakePolyline({ { from, .5, .75 }, { to, .5, .75 } });
}

vtkSmartPointer<vtkMultiBlockDataSet> Blocks(const std::vector<vtkDataSet*>& meshes)
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  for (std::size_t i = 0; i < meshes.size(); ++i)
  {
    blocks->SetBlock(static_cast<unsigned int>(i), meshes[i]);
  }
  return blocks;
}

using Numbers = std::vector<double>;

}

// A hundred thousand lines together.
TEST(CurveSurfaceParity, LinesThroughVerticesAndEdgesOfTriangles)
{
  ExpectEven(MakePolyData(CubeTriangles(3)), Amount(32000), 1);
  ExpectEven(MakePolyData(Triangulated(SphereQuads(6))), Amount(32000), 2);
}

TEST(CurveSurfaceParity, LinesThroughFlatQuads)
{
  ExpectEven(MakePolyData(CubeQuads(4)), Amount(22000), 3);
}

TEST(CurveSurfaceParity, LinesThroughWarpedQuads)
{
  ExpectEven(MakePolyData(SphereQuads(5)), 4000, 4);
}

TEST(CurveSurfaceParity, FarFromTheOrigin)
{
  ExpectEven(MakePolyData(Transformed(CubeTriangles(3), 1e-3, { 1e5 / 3, -1e6 / 7, 1e4 / 9 })),
    Amount(14000), 5);
}

TEST(CurveSurfaceParity, ClosedPolylinesThroughRealSurfaces)
{
  const DataSetPointer brain = ReadMesh(DataFolder() + "/fly_brain_neuropil.vtp");
  ASSERT_TRUE(brain);
  ExpectEven(brain, 3000, 6);
}

TEST(CurveSurfaceFilter, TellsAllAboutAHit)
{
  const FilterPointer filter = MakeFilter(LineAlongX(), MakePolyData(CubeQuads(2)));
  EXPECT_EQ(OutputArray(filter, "SkdCurveId"), (Numbers{ 0, 0 }));
  EXPECT_EQ(OutputArray(filter, "SkdHitNumber"), (Numbers{ 1, 2 }));
  EXPECT_EQ(OutputArray(filter, "SkdSense"), (Numbers{ 1, -1 }));
  EXPECT_EQ(OutputArray(filter, "SkdKind"), (Numbers{ 0, 0 }));
  EXPECT_EQ(OutputArray(filter, "SkdAngle"), (Numbers{ 90, 90 }));
  EXPECT_EQ(OutputArray(filter, "SkdNormal"), (Numbers{ -1, 0, 0, 1, 0, 0 }));
  EXPECT_EQ(OutputArray(filter, "SkdArcLength"), (Numbers{ 1, 3 }));
  EXPECT_EQ(OutputArray(filter, "SkdCurveParameter"), (Numbers{ 0.2, 0.6 }));
  EXPECT_EQ(OutputPoints(filter)[0], (Point{ 0, .5, .75 }));
  EXPECT_EQ(OutputCellArray(filter, "SkdNumberOfHits", 2), Numbers{ 2 });
  EXPECT_EQ(Reported(filter, "Hits"), 2);
  EXPECT_EQ(Reported(filter, "SurfaceElements"), 48);
}

TEST(CurveSurfaceFilter, SelectsHits)
{
  const FilterPointer filter = MakeFilter(LineAlongX(), MakePolyData(CubeQuads(2)));
  filter->SetHitSelection(Filter::FIRST_HIT);
  EXPECT_EQ(OutputArray(filter, "SkdArcLength"), Numbers{ 1 });
  filter->SetHitSelection(Filter::NTH_HIT);
  filter->SetHitNumber(2);
  EXPECT_EQ(OutputArray(filter, "SkdArcLength"), Numbers{ 3 });
  EXPECT_EQ(OutputArray(filter, "SkdHitNumber"), Numbers{ 2 });
  filter->SetHitNumber(3);
  EXPECT_TRUE(OutputArray(filter, "SkdArcLength").empty());
  EXPECT_EQ(OutputCellArray(filter, "SkdNumberOfHits", 2), Numbers{ 2 });
}

TEST(CurveSurfaceFilter, TakesTheOuterFacesOfVolumes)
{
  const FilterPointer filter = MakeFilter(LineAlongX(), MakeGrid(Hexahedra(2)));
  EXPECT_EQ(OutputArray(filter, "SkdArcLength").size(), 2u);
  EXPECT_EQ(OutputArray(filter, "SkdSense"), (Numbers{ 1, -1 }));
  filter->VolumeFacesOff();
  EventCounter events(filter);
  EXPECT_TRUE(OutputArray(filter, "SkdArcLength").empty());
  EXPECT_EQ(events.Warnings, 2); // no surfaces: neither a cell nor at all
}

TEST(CurveSurfaceFilter, APolylineVertexOnTheSurfaceIsOneHit)
{
  const PolyDataPointer cube = MakePolyData(CubeTriangles(2));
  const Mesh through = OneCell(VTK_POLY_LINE, { { -1, .5, .7 }, { 0, .5, .7 }, { 1, .6, .7 } });
  EXPECT_EQ(OutputArray(MakeFilter(MakePolyData(through), cube), "SkdSense"), Numbers{ 1 });
  const Mesh touching = OneCell(VTK_POLY_LINE, { { -1, .5, .7 }, { 0, .5, .7 }, { -1, .6, .7 } });
  const FilterPointer filter = MakeFilter(MakePolyData(touching), cube);
  EXPECT_EQ(OutputArray(filter, "SkdSense"), Numbers{ 0 });
  EXPECT_EQ(OutputArray(filter, "SkdKind"), Numbers{ 1 });
}

TEST(CurveSurfaceFilter, ACurveWithinAFaceTellsBothEnds)
{
  const FilterPointer filter =
    MakeFilter(MakePolyline({ { -1, .5, 2 }, { .3, .5, 2 }, { 1.1, 1.7, 2 } }),
      MakePolyData(CubeTriangles(2)));
  EXPECT_EQ(OutputArray(filter, "SkdKind"), (Numbers{ 2, 2 }));
  EXPECT_EQ(OutputPoints(filter)[0], (Point{ 0, .5, 2 }));
  EXPECT_EQ(OutputPoints(filter)[1], (Point{ 1.1, 1.7, 2 }));
}

TEST(CurveSurfaceFilter, CutsCurvesAndTellsTheirParts)
{
  const PolyDataPointer outer = MakePolyData(CubeTriangles(2));
  const PolyDataPointer inner = MakePolyData(Transformed(CubeTriangles(1), 0.5, { .25, .25, .5 }));
  const FilterPointer filter = MakeFilter(LineAlongX(), Blocks({ outer, inner }));
  filter->CutCurvesOn();
  EXPECT_EQ(OutputArray(filter, "SkdBlockIndex"), (Numbers{ 1, 2, 2, 1 }));
  EXPECT_EQ(OutputCellArray(filter, "SkdPartsInside", 1), (Numbers{ 0, 1, 2, 1, 0 }));
  EXPECT_EQ(OutputCellArray(filter, "SkdPartId", 1), (Numbers{ -1, 1, 2, 1, -1 }));
  EXPECT_EQ(OutputCellArray(filter, "SkdPieceNumber", 1), (Numbers{ 0, 1, 2, 3, 4 }));
  EXPECT_EQ(OutputPoints(filter, 1).size(), 10u);
  // From the middle of both outward.
  filter->SetInputDataObject(0, LineAlongX(0.5));
  EXPECT_EQ(OutputCellArray(filter, "SkdPartsInside", 1), (Numbers{ 2, 1, 0 }));
  EXPECT_EQ(OutputCellArray(filter, "SkdPartId", 1), (Numbers{ 2, 1, -1 }));
}

// One data set of two cubes, the smaller inside of the larger.
TEST(CurveSurfaceFilter, PartsAreBlocksValuesOrPieces)
{
  Mesh both = CubeTriangles(2);
  const auto before = static_cast<vtkIdType>(both.Points.size());
  const std::size_t outer = both.Cells.size();
  const Mesh inner = Transformed(CubeTriangles(1), 0.5, { .25, .25, .5 });
  both.Points.insert(both.Points.end(), inner.Points.begin(), inner.Points.end());
  for (const auto& cell : inner.Cells)
  {
    both.Add(
      VTK_TRIANGLE, { before + cell.Points[0], before + cell.Points[1], before + cell.Points[2] });
  }
  const PolyDataPointer source = MakePolyData(both);
  vtkNew<vtkDoubleArray> names;
  names->SetName("name");
  for (std::size_t cell = 0; cell < both.Cells.size(); ++cell)
  {
    names->InsertNextValue(cell < outer ? 41.0 : 7.2);
  }
  source->GetCellData()->AddArray(names);
  const FilterPointer filter = MakeFilter(LineAlongX(), source);
  filter->CutCurvesOn();
  EXPECT_EQ(OutputArray(filter, "SkdPartId"), (Numbers{ 0, 0, 0, 0 }));
  EXPECT_EQ(OutputCellArray(filter, "SkdPartsInside", 1), (Numbers{ 0, 1, 0, 1, 0 }));
  filter->SetParts(Filter::CONNECTED_PIECES);
  for (int run = 0; run < 2; ++run, filter->Modified())
  {
    EXPECT_EQ(OutputArray(filter, "SkdPartId"), (Numbers{ 0, 1, 1, 0 }));
    EXPECT_EQ(OutputCellArray(filter, "SkdPartsInside", 1), (Numbers{ 0, 1, 2, 1, 0 }));
    EXPECT_EQ(OutputCellArray(filter, "SkdPartId", 1), (Numbers{ -1, 0, 1, 0, -1 }));
  }
  filter->SetParts(Filter::CELL_ARRAY);
  filter->SetPartArray("name");
  EXPECT_EQ(OutputArray(filter, "SkdPartId"), (Numbers{ 41, 7, 7, 41 }));
  EXPECT_EQ(OutputCellArray(filter, "SkdPartId", 1), (Numbers{ -1, 41, 7, 41, -1 }));
  filter->SetPartArray("none such");
  EventCounter events(filter);
  EXPECT_EQ(OutputArray(filter, "SkdPartId"), (Numbers{ 0, 0, 0, 0 }));
  EXPECT_EQ(events.Errors, 1);
}

TEST(CurveSurfaceFilter, EqualFacesOfTwoBlocksAreTwoHits)
{
  const PolyDataPointer left = MakePolyData(CubeTriangles(1));
  const PolyDataPointer right = MakePolyData(Transformed(CubeTriangles(1), 1.0, { 1, 0, 0 }));
  const FilterPointer filter =
    MakeFilter(MakePolyline({ { -1, .5, .5 }, { 4, .5, .5 } }), Blocks({ left, right }));
  EXPECT_EQ(OutputArray(filter, "SkdBlockIndex"), (Numbers{ 1, 1, 2, 2 }));
  EXPECT_EQ(OutputArray(filter, "SkdSense"), (Numbers{ 1, -1, 1, -1 }));
}

TEST(CurveSurfaceFilter, InterpolatesDataOfBothSides)
{
  const PolyDataPointer line = LineAlongX();
  const PolyDataPointer cube = MakePolyData(CubeTriangles(2));
  const auto add = [](vtkDataSetAttributes* to, const char* name, vtkIdType n, auto value)
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    for (vtkIdType i = 0; i < n; ++i)
    {
      array->InsertNextValue(value(i));
    }
    to->AddArray(array);
  };
  add(line->GetPointData(), "Heat", 2, [](vtkIdType i) { return 10.0 * i; });
  add(line->GetCellData(), "Fibre", 1, [](vtkIdType) { return 7.0; });
  add(cube->GetPointData(), "Height", cube->GetNumberOfPoints(),
    [&](vtkIdType i) { return cube->GetPoint(i)[2] + 5.0 * cube->GetPoint(i)[0]; });
  add(cube->GetCellData(), "Heat", cube->GetNumberOfCells(), [](vtkIdType) { return 1.0; });
  const FilterPointer filter = MakeFilter(line, cube);
  EventCounter events(filter);
  EXPECT_EQ(OutputArray(filter, "Heat"), (Numbers{ 2, 6 }));
  EXPECT_EQ(OutputArray(filter, "Fibre"), (Numbers{ 7, 7 }));
  const Numbers height = OutputArray(filter, "Height");
  EXPECT_NEAR(height[0], 0.75, 1e-14);
  EXPECT_NEAR(height[1], 10.75, 1e-14);
  EXPECT_EQ(events.Warnings, 1); // Heat of the cells
}

TEST(CurveSurfaceFilter, KeepsTheTree)
{
  const PolyDataPointer cube = MakePolyData(CubeTriangles(2));
  const FilterPointer filter = MakeFilter(LineAlongX(), cube);
  filter->Update();
  EXPECT_EQ(Reported(filter, "TreesBuilt"), 1);
  filter->SetInputDataObject(0, LineAlongX(0.5));
  filter->Update();
  EXPECT_EQ(Reported(filter, "TreesBuilt"), 0);
  PolyDataPointer copy = PolyDataPointer::New();
  copy->DeepCopy(cube);
  filter->SetSourceData(copy);
  filter->Update();
  EXPECT_EQ(Reported(filter, "TreesBuilt"), 0);
  copy->GetPoints()->SetPoint(0, 9, 9, 9);
  copy->GetPoints()->Modified();
  copy->Modified();
  filter->Update();
  EXPECT_EQ(Reported(filter, "TreesBuilt"), 1);
}

TEST(CurveSurfaceFilter, AnswersTheRestOfBadInput)
{
  const double nan = std::nan("");
  Mesh curves = OneCell(VTK_LINE, { { -1, .5, .75 }, { 4, .5, .75 } });
  curves.Add(VTK_LINE, { curves.Add({ 1, 1, 1 }), curves.Add({ 1, 1, 1 }) });
  curves.Add(VTK_LINE, { curves.Add({ nan, 1, 1 }), curves.Add({ 1, 1, 1 }) });
  curves.Add(VTK_TRIANGLE, { 0, 1, 2 });
  Mesh surfaces = CubeTriangles(2);
  surfaces.Add(VTK_TRIANGLE, { surfaces.Add({ nan, 0, 0 }), 0, 1 });
  surfaces.Add(VTK_LINE, { 0, 1 });
  surfaces.Add(VTK_TRIANGLE, { 0, 0, 0 });
  const FilterPointer filter = MakeFilter(MakeGrid(curves), MakeGrid(surfaces));
  filter->SetChordTolerance(0.0);
  EventCounter events(filter);
  EXPECT_EQ(OutputArray(filter, "SkdArcLength"), (Numbers{ 1, 3 }));
  EXPECT_EQ(events.Errors, 0);
  // Points; no length, not finite, no curve; not finite, no surface; tolerance.
  EXPECT_EQ(events.Warnings, 7);
  EXPECT_EQ(OutputCellArray(filter, "SkdNumberOfHits", 2), (Numbers{ 2, 0, 0, 0 }));
}

TEST(CurveSurfaceFilter, RefusesWeightsThatAreNotPositive)
{
  const GridPointer sphere = BezierSphere(1.0);
  sphere->GetPointData()->GetRationalWeights()->SetTuple1(0, 0.0);
  const GridPointer circle = BezierCircle(0.5);
  circle->GetPointData()->GetRationalWeights()->SetTuple1(1, -1.0);
  const FilterPointer filter = MakeFilter(circle, sphere);
  EventCounter events(filter);
  filter->Update();
  EXPECT_EQ(events.Warnings, 2);
  EXPECT_NE(events.Warning.find("weight that is not positive"), std::string::npos);
  EXPECT_EQ(Reported(filter, "Curves"), 3);
  EXPECT_EQ(Reported(filter, "SurfaceElements"), 7);
}

TEST(CurveSurfaceFilter, HasAValidOutputWithoutInput)
{
  const FilterPointer filter = MakeFilter(PolyDataPointer::New(), PolyDataPointer::New());
  filter->CutCurvesOn();
  EventCounter events(filter);
  filter->Update();
  EXPECT_EQ(events.Warnings, 2);
  EXPECT_EQ(OutputPoints(filter).size(), 0u);
  EXPECT_EQ(OutputPoints(filter, 1).size(), 0u);
}

TEST(CurveSurfaceFilter, AnswersTheSameWithAnyNumberOfThreads)
{
  const PolyDataPointer surface = MakePolyData(SphereQuads(4));
  const PolyDataPointer lines = MakePolyData(LinesThrough(surface, 500, 9));
  const auto [one, four] = OneAndFourThreads(
    [&]
    {
      const FilterPointer filter = MakeFilter(lines, surface);
      const Numbers lengths = OutputArray(filter, "SkdArcLength");
      return std::make_pair(lengths, OutputArray(filter, "SkdCellId"));
    });
  EXPECT_EQ(one, four);
  EXPECT_GT(one.first.size(), 100u);
}

TEST(CurveSurfaceFilter, StopsWhenAskedTo)
{
  const PolyDataPointer surface = MakePolyData(CubeTriangles(2));
  const FilterPointer filter = MakeFilter(MakePolyData(LinesThrough(surface, 20000, 3)), surface);
  vtkNew<vtkCallbackCommand> stop;
  stop->SetClientData(filter);
  stop->SetCallback([](vtkObject*, unsigned long, void* self, void*)
    { static_cast<Filter*>(self)->SetAbortExecute(1); });
  filter->AddObserver(vtkCommand::ProgressEvent, stop);
  filter->Update();
  EXPECT_LT(OutputPoints(filter).size(), 20000u);
}

TEST(CurveSurfaceFilter, EachNeuronEntersTheLateralHornOnce)
{
  SKD_LEAVE_OUT_OF_FEWER_TESTS();
  const std::string folder = ExtraDataFolder() + "/F_curves/";
  const DataSetPointer horn = std::filesystem::exists(folder + "hemibrain_LH.obj")
    ? ReadMesh(folder + "hemibrain_LH.obj")
    : DataSetPointer();
  if (!horn)
  {
    GTEST_SKIP() << "skipped: " << folder << " is not there";
  }
  for (const char* name : { "hemibrain_722817260.vtp", "hemibrain_754534424.vtp" })
  {
    const FilterPointer filter = MakeFilter(ReadMesh(folder + name), horn);
    const Numbers senses = OutputArray(filter, "SkdSense");
    ASSERT_EQ(senses.size(), 1u) << name;
    EXPECT_EQ(std::abs(senses[0]), 1.0) << name; // the skeleton's lines run either way
  }
}
