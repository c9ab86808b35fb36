// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeSurfaceIntersection as a filter: its inputs and settings, and bad ones.

#include "Support/SurfaceIntersectionRun.h"

#include "Support/ClosestPointRun.h"
#include "Support/EventCounter.h"
#include "Support/StructuredMeshes.h"
#include "Support/SurfaceMeshes.h"
#include "Support/VolumeMeshes.h"

#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkCommand.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkTransform.h"
#include "vtkTransformFilter.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace skdtest;

namespace
{

using CellIdPairs = std::vector<std::pair<vtkIdType, vtkIdType>>;

PolyDataPointer MakeSphere(const Point& center)
{
  return MakePolyData(Transformed(SphereTriangles(8), 1.0, center));
}

//------------------------------------------------------------------------------
// Cells that are cut into triangles keep their ids; lines and vertices are passed over.
TEST(SurfaceIntersectionFilter, CellsOfAllKindsKeepTheirIds)
{
  Mesh mesh;
  mesh.Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 3, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 },
    { 2, 1, 0 }, { 3, 1, 0 }, { 0.5, 2, 0 } };
  mesh.Add(VTK_VERTEX, { 0 });
  mesh.Add(VTK_LINE, { 0, 1 });
  mesh.Add(VTK_QUAD, { 0, 1, 5, 4 });
  mesh.Add(VTK_POLYGON, { 1, 2, 6, 8, 5 });
  mesh.Add(VTK_TRIANGLE_STRIP, { 2, 3, 6, 7 });
  Mesh needle;
  for (const double x : { 0.3, 1.6, 2.9 })
  {
    needle.Add(VTK_TRIANGLE,
      { needle.Add({ x, 0.4, -1 }), needle.Add({ x + 0.01, 0.4, 1 }), needle.Add({ x, 0.41, 1 }) });
  }
  const CellIdPairs expected = { { 2, 0 }, { 3, 1 }, { 4, 2 } };
  EXPECT_EQ(RunCellPairs(MakeIntersection(MakePolyData(mesh), MakePolyData(needle))), expected);
  EXPECT_EQ(RunCellPairs(MakeIntersection(MakeGrid(mesh), MakeGrid(needle))), expected);
}

TEST(SurfaceIntersectionFilter, OfVolumesTheOuterFacesCount)
{
  auto filter = MakeIntersection(MakeImage(5), MakeSphere({ 0, 0, 0 }));
  filter->Update();
  const auto image = MakeImage(5);
  vtkIdType cells = image->GetNumberOfCells();
  for (const CellPair& pair : PairsOf(filter))
  {
    ASSERT_LT(pair.First, cells);
  }
  auto grid = MakeIntersection(MakeGrid(Hexahedra(3)), MakeSphere({ 0, 0, 0 }));
  EXPECT_GT(RunPairs(grid).size(), 0u);
}

//------------------------------------------------------------------------------
TEST(SurfaceIntersectionFilter, BlocksAreReported)
{
  auto near = MakeSphere({ 0.5, 0, 0 });
  auto far = MakeSphere({ 9, 0, 0 });
  auto blocks = MakeBlocks({ far, nullptr, near });
  auto filter = MakeIntersection(MakeSphere({ 0, 0, 0 }), blocks);
  const CellIdPairs pairs = RunCellPairs(filter);
  EXPECT_EQ(pairs, RunCellPairs(MakeIntersection(MakeSphere({ 0, 0, 0 }), near)));
  auto table = vtkTable::SafeDownCast(filter->GetOutputDataObject(2));
  EXPECT_EQ(table->GetColumnByName("SkdFirstBlockIndex"), nullptr);
  auto index = vtkDataArray::SafeDownCast(table->GetColumnByName("SkdSecondBlockIndex"));
  ASSERT_NE(index, nullptr);
  EXPECT_EQ(index->GetRange()[0], 3.0);
  EXPECT_EQ(index->GetRange()[1], 3.0);
  EXPECT_TRUE(OutputOf(filter, 0)->GetPointData()->HasArray("SkdSecondBlockIndex"));
}

// A sphere cut in two blocks is as sound as in one.
TEST(SurfaceIntersectionFilter, BlocksOfOneSurfaceAreNeighbours)
{
  const Mesh sphere = SphereTriangles(6);
  auto odd = MakePolyData(Part(sphere, [](std::size_t cell) { return cell % 2 == 1; }));
  auto even = MakePolyData(Part(sphere, [](std::size_t cell) { return cell % 2 == 0; }));
  EXPECT_EQ(RunPairs(MakeIntersection(MakeBlocks({ odd, even }))).size(), 0u);
}

TEST(SurfaceIntersectionFilter, GhostsAreLeftOut)
{
  auto ghostly = MakePolyData(Square(0, 0, 1));
  MarkGhosts(ghostly, { 0 }, vtkDataSetAttributes::DUPLICATECELL);
  auto filter = MakeIntersection(ghostly, MakePolyData(Square(0, 0, 1)));
  EventCounter events(filter);
  EXPECT_EQ(RunPairs(filter).size(), 0u);
}

//------------------------------------------------------------------------------
TEST(SurfaceIntersectionFilter, TheLowestPairIsTheFirstOfAll)
{
  auto filter = MakeIntersection(MakeSphere({ 0, 0, 0 }), MakeSphere({ 0.7, 0.2, 0.3 }));
  const CellIdPairs all = RunCellPairs(filter);
  filter->SetPairsToLowest();
  const CellIdPairs lowest = RunCellPairs(filter);
  ASSERT_EQ(lowest.size(), 1u);
  EXPECT_EQ(lowest[0], all[0]);
  filter->SetPairsToWhetherAny();
  const CellIdPairs any = RunCellPairs(filter);
  ASSERT_EQ(any.size(), 1u);
  EXPECT_TRUE(std::find(all.begin(), all.end(), any[0]) != all.end());
}

TEST(SurfaceIntersectionFilter, NoPairIsNoPairInAllModes)
{
  auto filter = MakeIntersection(MakeSphere({ 0, 0, 0 }), MakeSphere({ 2.5, 0, 0 }));
  for (int pairs : { 0, 1, 2 })
  {
    filter->SetPairs(pairs);
    EXPECT_EQ(RunPairs(filter).size(), 0u);
    EXPECT_EQ(Reported(filter, "Pairs"), 0.0);
  }
}

//------------------------------------------------------------------------------
TEST(SurfaceIntersectionFilter, ClearanceTellsPairsThatAreNear)
{
  auto filter = MakeIntersection(MakePolyData(Square(0, 0, 1)), MakePolyData(Square(1, 0, 1, 0.5)));
  filter->SetClearance(0.49999);
  EXPECT_EQ(RunPairs(filter).size(), 0u);
  filter->SetClearance(0.5);
  const std::vector<CellPair> pairs = RunPairs(filter);
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_EQ(pairs[0].Contact, 0);
  EXPECT_EQ(pairs[0].Distance, 0.5);
  EXPECT_EQ(pairs[0].SecondPoint - pairs[0].FirstPoint, (Point{ 0, 0, 0.5 }));
  vtkPolyData* gaps = OutputOf(filter, 3);
  EXPECT_EQ(gaps->GetNumberOfLines(), 1);
  EXPECT_EQ(gaps->GetCellData()->GetArray("SkdDistance")->GetTuple1(0), 0.5);
  EXPECT_EQ(OutputOf(filter, 0)->GetNumberOfCells(), 0);
}

TEST(SurfaceIntersectionFilter, ClearancesAreThoseOfALookAtAllPairs)
{
  const Mesh first = TriangleSoup(30, 0.05);
  const Mesh second = Transformed(TriangleSoup(30, 0.05), 1.0, { 0.1, 0.2, 0.05 });
  auto filter = MakeIntersection(MakePolyData(first), MakePolyData(second));
  constexpr double clearance = 0.15;
  filter->SetClearance(clearance);
  CellIdPairs near;
  for (const CellPair& pair : RunPairs(filter))
  {
    near.push_back(pair.Cells());
    EXPECT_NEAR(Distance(pair.FirstPoint, pair.SecondPoint), pair.Distance, 1e-15);
    EXPECT_EQ(pair.Contact == 0, pair.Distance > 0.0);
  }
  const auto at = [](const Mesh& mesh, int cell, int i, int k)
  {
    constexpr int n = 24;
    const auto& ids = mesh.Cells[cell].Points;
    const Point side = Lerp(mesh.Points[ids[1]], mesh.Points[ids[2]], double(k) / n);
    return Lerp(mesh.Points[ids[0]], side, double(i) / n);
  };
  for (int a = 0; a < 30; ++a)
  {
    for (int b = 0; b < 30; ++b)
    {
      double least = 1e9;
      for (int i = 0; i < 25 * 25 * 25 * 25; i += 7)
      {
        least = std::min(least,
          Distance(at(first, a, i % 25, i / 25 % 25), at(second, b, i / 625 % 25, i / 15625)));
      }
      const bool isNear =
        std::find(near.begin(), near.end(), std::pair<vtkIdType, vtkIdType>(a, b)) != near.end();
      ASSERT_TRUE(isNear || least > clearance) << a << " " << b;
      ASSERT_TRUE(!isNear || least < clearance + 0.02) << a << " " << b;
    }
  }
}

//------------------------------------------------------------------------------
// Whole numbers and quarter turns round nothing: moved by the filter or before is the same.
TEST(SurfaceIntersectionFilter, AMovedSourceIsMetWhereItIs)
{
  const Mesh first = LatticeTriangles(100, 4, 1);
  const Mesh second = LatticeTriangles(100, 4, 2);
  auto filter = MakeIntersection(MakePolyData(first), MakePolyData(second));
  filter->Update();
  EXPECT_EQ(Reported(filter, "TreesBuilt"), 2.0);
  for (const double shift : { 1.0, -2.0, 1048576.0 })
  {
    filter->SetTranslation(shift, 1.0, -1.0);
    const CellIdPairs moved = RunCellPairs(filter);
    EXPECT_EQ(Reported(filter, "TreesBuilt"), 0.0);
    auto there = MakePolyData(Transformed(second, 1.0, { shift, 1.0, -1.0 }));
    EXPECT_EQ(moved, RunCellPairs(MakeIntersection(MakePolyData(first), there)));
  }
}

TEST(SurfaceIntersectionFilter, TurnsAreThoseOfVtkProp)
{
  auto still = MakePolyData(Transformed(SphereTriangles(8), 3.2, { 0, 0, 0 }));
  auto moving = MakePolyData(Transformed(CubeTriangles(3), 0.7, { 1, 2, 0.5 }));
  auto filter = MakeIntersection(still, moving);
  filter->SetRotationCenter(0.5, 0.25, 1.0);
  filter->SetRotation(30.0, -50.0, 110.0);
  filter->SetTranslation(-0.4, -0.3, -0.9);
  vtkNew<vtkTransform> transform;
  transform->Translate(-0.4, -0.3, -0.9);
  transform->Translate(0.5, 0.25, 1.0);
  transform->RotateZ(110.0);
  transform->RotateX(30.0);
  transform->RotateY(-50.0);
  transform->Translate(-0.5, -0.25, -1.0);
  auto byMatrix = MakeIntersection(still, moving);
  byMatrix->SetTransform(transform->GetMatrix());
  vtkNew<vtkTransformFilter> mover;
  mover->SetInputData(moving);
  mover->SetTransform(transform);
  mover->Update();
  const CellIdPairs expected = RunCellPairs(MakeIntersection(still, mover->GetOutput()));
  EXPECT_GT(expected.size(), 10u);
  EXPECT_EQ(RunCellPairs(filter), expected);
  EXPECT_EQ(RunCellPairs(byMatrix), expected);
}

TEST(SurfaceIntersectionFilter, AClearanceWithoutEndTakesAllPairs)
{
  auto filter = MakeIntersection(MakePolyData(TriangleSoup(9, 0.1)),
    MakePolyData(Transformed(TriangleSoup(7, 0.1), 1.0, { 5, 5, 5 })));
  filter->SetClearance(VTK_DOUBLE_MAX);
  EXPECT_EQ(RunPairs(filter).size(), 63u);
}

TEST(SurfaceIntersectionFilter, ATransformThatIntervalsIsRefused)
{
  auto filter = MakeIntersection(MakeSphere({ 0, 0, 0 }), MakeSphere({ 2.5, 0, 0 }));
  EventCounter events(filter);
  vtkNew<vtkMatrix4x4> matrix;
  matrix->SetElement(0, 0, 2.0);
  filter->SetTransform(matrix);
  EXPECT_EQ(events.Errors, 1);
  EXPECT_EQ(filter->GetTransform(), nullptr);
}

//------------------------------------------------------------------------------
TEST(SurfaceIntersectionFilter, TreesAreKeptWhileSurfacesAreTheSame)
{
  auto first = MakeSphere({ 0, 0, 0 });
  auto second = MakeSphere({ 1, 0, 0 });
  auto filter = MakeIntersection(first, second);
  filter->Update();
  const vtkIdType pairs = static_cast<vtkIdType>(PairsOf(filter).size());
  filter->SetSourceData(MakeSphere({ 1, 0, 0 })); // equal values
  filter->Update();
  EXPECT_EQ(Reported(filter, "TreesBuilt"), 0.0);
  EXPECT_EQ(static_cast<vtkIdType>(PairsOf(filter).size()), pairs);
  filter->SetSourceData(MakeSphere({ 1.5, 0, 0 }));
  filter->Update();
  EXPECT_EQ(Reported(filter, "TreesBuilt"), 1.0);
  filter->RemoveAllInputConnections(1);
  EXPECT_EQ(RunPairs(filter).size(), 0u) << "a sphere with itself";
}

//------------------------------------------------------------------------------
TEST(SurfaceIntersectionFilter, NoFacesGiveAWarningAndNothing)
{
  vtkNew<vtkPolyData> empty;
  auto points = MakePolyData(Helix(5, VTK_LINE));
  for (vtkPolyData* none : { empty.Get(), points.Get() })
  {
    for (const bool isFirst : { true, false })
    {
      auto sphere = MakeSphere({ 0, 0, 0 });
      auto filter = isFirst ? MakeIntersection(none, sphere) : MakeIntersection(sphere, none);
      EventCounter events(filter);
      EXPECT_EQ(RunPairs(filter).size(), 0u);
      EXPECT_EQ(events.Warnings, 1);
      EXPECT_EQ(events.Errors, 0);
      EXPECT_EQ(OutputOf(filter, 0)->GetNumberOfCells(), 0);
    }
  }
  auto alone = MakeIntersection(empty);
  EventCounter events(alone);
  EXPECT_EQ(RunPairs(alone).size(), 0u);
  EXPECT_EQ(events.Warnings, 1);
}

TEST(SurfaceIntersectionFilter, FacesThatAreNoneAreCounted)
{
  Mesh mesh = Square(0, 0, 1);
  const vtkIdType nan = mesh.Add({ std::nan(""), 0, 0 });
  const vtkIdType far = mesh.Add({ 0, std::numeric_limits<double>::infinity(), 0 });
  const vtkIdType middle = mesh.Add({ 0.5, 0.5, 0 });
  mesh.Add(VTK_TRIANGLE, { 0, 1, nan });
  mesh.Add(VTK_TRIANGLE, { 0, 1, far });
  mesh.Add(VTK_TRIANGLE, { 0, 1, 1 });
  mesh.Add(VTK_TRIANGLE, { 0, middle, 2 }); // on one line
  auto filter = MakeIntersection(MakePolyData(mesh), MakePolyData(Square(0.2, 0.2, 3)));
  EXPECT_EQ(RunCellPairs(filter), (CellIdPairs{ { 0, 0 } }));
  EXPECT_EQ(Reported(filter, "FacesLeftOut"), 3.0);
  EXPECT_EQ(Reported(filter, "TrianglesWithoutArea"), 1.0);
}

//------------------------------------------------------------------------------
TEST(SurfaceIntersectionFilter, APolygonOfManyIsReadBesideSomeOfTooFew)
{
  constexpr int corners = 200;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> polygons;
  std::vector<vtkIdType> ids;
  for (int i = 0; i < corners; ++i)
  {
    const double angle = 2.0 * vtkMath::Pi() * i / corners;
    ids.push_back(points->InsertNextPoint(2.0 * std::cos(angle), 2.0 * std::sin(angle), 0.1));
  }
  for (const vtkIdType size : { 0, 1, 2, corners, 2, 1, 0 })
  {
    polygons->InsertNextCell(size, ids.data());
  }
  vtkNew<vtkPolyData> plate;
  plate->SetPoints(points);
  plate->SetPolys(polygons);
  const auto sphere = MakePolyData(Transformed(SphereTriangles(12), 1.0, { 0, 0, 0 }));
  auto filter = MakeIntersection(plate, sphere);
  filter->Update();
  // Where VTK cannot fetch such cells they are hidden, which is no fault.
  EXPECT_EQ(Reported(filter, "FacesLeftOut"), VTK_SKD_BUILDS_ALL_CELLS ? 6.0 : 0.0);
  EXPECT_EQ(Reported(filter, "Curves"), 1.0);
  for (const CellPair& pair : PairsOf(filter))
  {
    EXPECT_EQ(pair.First, 3);
  }
}

//------------------------------------------------------------------------------
TEST(SurfaceIntersectionFilter, ThreadsDoNotMatter)
{
  const Mesh mesh = LatticeTriangles(300, 9, 6);
  const auto run = [&](int threads)
  {
    vtkSMPTools::Initialize(threads);
    auto filter = MakeIntersection(MakePolyData(mesh));
    filter->JoinCurvesOff();
    filter->Update();
    return std::make_pair(RunCellPairs(filter), SegmentsOf(OutputOf(filter, 0)));
  };
  const auto alone = run(1);
  EXPECT_TRUE(run(4) == alone);
  vtkSMPTools::Initialize(0);
}

TEST(SurfaceIntersectionFilter, ProgressRisesAndAnAbortStops)
{
  auto filter = MakeIntersection(MakePolyData(SphereTriangles(40)),
    MakePolyData(Transformed(SphereTriangles(40), 1, { 1, 0, 0 })));
  std::vector<double> found;
  vtkNew<vtkCallbackCommand> watch;
  watch->SetClientData(&found);
  watch->SetCallback(
    [](vtkObject* caller, unsigned long, void* to, void*)
    {
      auto* progress = static_cast<std::vector<double>*>(to);
      progress->push_back(vtkAlgorithm::SafeDownCast(caller)->GetProgress());
      vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(progress->back() > 0.4);
    });
  filter->AddObserver(vtkCommand::ProgressEvent, watch);
  filter->Update();
  EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
  EXPECT_GT(found.size(), 2u);
  const std::size_t some = PairsOf(filter).size();
  filter->RemoveAllObservers();
  filter->SetAbortExecute(0);
  filter->Modified();
  EXPECT_GT(RunPairs(filter).size(), some);
}

}
