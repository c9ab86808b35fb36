// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// Bad input has the results that the header states, without a crash.

#include "Support/EventCounter.h"
#include "Support/LocatorCalls.h"
#include "Support/PaperArrays.h"
#include "Support/SurfaceMeshes.h"
#include "Support/VolumeMeshes.h"
#include "Support/WatchedBuild.h"

#include <gtest/gtest.h>

using namespace skdtest;

namespace
{

const double NaN = std::nan("");
const double Infinity = std::numeric_limits<double>::infinity();

/// Every query, with ordinary arguments, and the expectation that none finds anything.
void ExpectNothingFound(vtkSkdTreeCellLocator* locator)
{
  const Point a = { -5, 0.1, 0.2 };
  const Point b = { 5, 0.2, 0.1 };
  vtkNew<vtkGenericCell> cell;
  vtkNew<vtkIdList> ids;
  EventCounter events(locator);
  EXPECT_EQ(FindClosest(locator, a).Cell, -1);
  Closest c;
  Point x = a;
  EXPECT_EQ(
    locator->FindClosestPointWithinRadius(x.data(), Infinity, c.X.data(), c.Cell, c.SubId, c.Dist2),
    0);
  EXPECT_EQ(c.Cell, -1);
  EXPECT_EQ(FindFirstHit(locator, a, b).Found, 0);
  EXPECT_EQ(FindFirstHit(locator, a, b, 10.0).Cell, -1);
  EXPECT_EQ(FindAllHits(locator, a, b, 0.0, cell), (LineHits{ 0, {}, {} }));
  EXPECT_EQ(FindAllHits(locator, a, b, 0.0, nullptr), (LineHits{ 0, {}, {} }));
  EXPECT_EQ(FindCrossings(locator, a, b).Number, 0);
  EXPECT_EQ(locator->CountCrossings(a.data(), b.data()), 0);
  EXPECT_EQ(locator->FindCell(x.data()), -1);
  EXPECT_EQ(locator->FindCell(x.data(), 1e300), -1);
  Point pcoords;
  int subId = 0;
  double weights[8];
  EXPECT_EQ(locator->FindCellWithHint(x.data(), 1.0, 0, cell, subId, pcoords.data(), weights), -1);
  EXPECT_EQ(FindWithinBounds(locator, { -9, 9, -9, 9, -9, 9 }), Ids());
  EXPECT_EQ(FindAlongLine(locator, a, b, 1.0), Ids());
  EXPECT_EQ(FindAlongPlane(locator, a, b, 1.0), Ids());
  EXPECT_FALSE(locator->InsideCellBounds(x.data(), 0));
  EXPECT_EQ(FindClosestCells(locator, a, 5).Number, 0);
  EXPECT_EQ(FindWithinRadius(locator, a, 1e300).Number, 0);
  locator->FindClosestCandidates(a.data(), ids);
  EXPECT_EQ(ids->GetNumberOfIds(), 0);
  locator->FindClosestCandidates(a.data(), b.data(), ids);
  EXPECT_EQ(ids->GetNumberOfIds(), 0);
  locator->FindCandidatesAlongLine(a.data(), b.data(), ids);
  EXPECT_EQ(ids->GetNumberOfIds(), 0);
  locator->FindCandidatesWithinRadius(a.data(), 1e300, ids);
  EXPECT_EQ(ids->GetNumberOfIds(), 0);
  vtkNew<vtkIdList> others;
  EXPECT_EQ(locator->FindOverlappingPairs(locator, ids, others), 0);
  EXPECT_TRUE(PaperArrays(locator).S.empty());
  vtkNew<vtkPolyData> picture;
  locator->GenerateRepresentation(0, picture);
  EXPECT_EQ(picture->GetNumberOfCells(), 0);
  EXPECT_EQ(locator->GetNumberOfCellsInTree(), 0);
  EXPECT_EQ(events.Errors, 0) << events.Error;
  EXPECT_EQ(events.Warnings, 0) << events.Warning;
}

TEST(BadInput, NoDataSetFindsNothing)
{
  const auto locator = LocatorPointer::New();
  EventCounter events(locator);
  locator->BuildLocator();
  locator->ForceBuildLocator();
  EXPECT_EQ(events.Errors, 0);
  ExpectNothingFound(locator);
}

TEST(BadInput, NoCellsFindNothing)
{
  vtkNew<vtkPolyData> nothing;
  ExpectNothingFound(MakeLocator(nothing));
  vtkNew<vtkUnstructuredGrid> grid;
  ExpectNothingFound(MakeLocator(grid));
}

TEST(BadInput, PointsWithoutCellsFindNothing)
{
  vtkNew<vtkPolyData> data;
  data->SetPoints(MakePoints({ { 0, 0, 0 }, { 1, 0, 0 } }));
  ExpectNothingFound(MakeLocator(data));
}

TEST(BadInput, OnlyEmptyCellsFindNothing)
{
  Mesh mesh;
  mesh.Add(Point{ 0, 0, 0 });
  mesh.Add(VTK_EMPTY_CELL, {});
  mesh.Add(VTK_EMPTY_CELL, {});
  const auto data = MakeGrid(mesh);
  const auto locator = MakeLocator(data);
  ExpectNothingFound(locator);
  EXPECT_EQ(locator->GetNumberOfCellsLeftOut(), 2);
}

TEST(BadInput, OnlyCellsThatAreNotFiniteFindNothing)
{
  const auto data = MakePolyData(CubeTriangles(1).Map(
    [](const Point& p) {
      return Point{ NaN, p[1], p[2] };
    }));
  const WatchedBuild build(data);
  EXPECT_EQ(build.Events.Warnings, 1);
  ExpectNothingFound(build.Locator);
}

TEST(BadInput, PolygonsOfNoPointsAreLeftOut)
{
  Mesh mesh = Sheet(2, VTK_QUAD);
  mesh.Cells.insert(mesh.Cells.begin(), { VTK_POLYGON, {} });
  const auto data = MakePolyData(mesh);
  const auto locator = MakeLocator(data);
  EXPECT_EQ(locator->GetNumberOfCellsInTree(), 4);
  EXPECT_EQ(locator->GetNumberOfCellsLeftOut(), 1);
  EXPECT_EQ(FindClosest(locator, { 0.5, 0.5, 1 }).Cell, 1);
}

class CellsNotFinite : public testing::TestWithParam<double>
{
};

INSTANTIATE_TEST_SUITE_P(Values, CellsNotFinite, testing::Values(NaN, Infinity, -Infinity));

TEST_P(CellsNotFinite, AreLeftOutWithOneWarningThatCountsThem)
{
  Mesh mesh = Sheet(4, VTK_QUAD);
  mesh.Points[6][2] = GetParam(); // an inner point of four cells
  const WatchedBuild build(MakePolyData(mesh));
  EXPECT_EQ(build.Events.Errors, 0);
  EXPECT_EQ(build.Events.Warnings, 1);
  EXPECT_NE(build.Events.Warning.find("4"), std::string::npos) << build.Events.Warning;
  EXPECT_EQ(build.Locator->GetNumberOfCellsInTree(), 12);
  EXPECT_EQ(build.Locator->GetNumberOfCellsLeftOut(), 4);
}

TEST_P(CellsNotFinite, DoNotDisturbTheOthers)
{
  Mesh mesh = Sheet(4, VTK_QUAD);
  mesh.Points[6][0] = GetParam();
  const auto data = MakePolyData(mesh);
  const WatchedBuild build(data);
  EXPECT_EQ(FindClosest(build.Locator, { 3.5, 3.5, 2 }).Cell, 15);
  EXPECT_EQ(FindClosest(build.Locator, { 3.5, 3.5, 2 }).Dist2, 4.0);
  EXPECT_EQ(FindFirstHit(build.Locator, { 3.5, 3.5, 2 }, { 3.5, 3.5, -2 }).Cell, 15);
  EXPECT_EQ(FindFirstHit(build.Locator, { 0.5, 0.5, 2 }, { 0.5, 0.5, -2 }).Found, 0);
  EXPECT_EQ(FindCell(build.Locator, { 2.5, 0.5, 0 }).Cell, 2);
  Point inBadCell = { 0.5, 0.5, 0 };
  EXPECT_FALSE(build.Locator->InsideCellBounds(inBadCell.data(), 0));
}

TEST_P(CellsNotFinite, OfEveryKindAreLeftOut)
{
  for (Mesh mesh : { Cloud(30, VTK_VERTEX), Helix(20, VTK_LINE), Tetrahedra(2), Voxels(2),
         Wedges(2), Pyramids(2), Polyhedra(2), Hexagons(3), Strips(3) })
  {
    mesh.Points[0][1] = GetParam();
    const auto data = MakeGrid(mesh);
    const WatchedBuild build(data);
    EXPECT_EQ(build.Events.Warnings, 1);
    EXPECT_GT(build.Locator->GetNumberOfCellsLeftOut(), 0);
    EXPECT_EQ(build.Locator->GetNumberOfCellsLeftOut() + build.Locator->GetNumberOfCellsInTree(),
      data->GetNumberOfCells());
  }
}

TEST(BadInput, UnusedPointsThatAreNotFiniteDoNotMatter)
{
  Mesh mesh = Sheet(2, VTK_QUAD);
  mesh.Add(Point{ NaN, Infinity, 0 });
  const WatchedBuild build(MakePolyData(mesh));
  EXPECT_EQ(build.Events.Warnings, 0);
  EXPECT_EQ(build.Locator->GetNumberOfCellsInTree(), 4);
  EXPECT_EQ(FindClosest(build.Locator, { 0.5, 0.5, 3 }).Dist2, 9.0);
}

TEST(BadInput, CellsOfUnknownTypeAreLeftOut)
{
  for (int type : { 17, 40, 51, 63, 200 })
  {
    Mesh mesh = Tetrahedra(1);
    mesh.Cells[2].Type = type;
    const auto data = MakeGrid(mesh);
    const auto locator = MakeLocator(data);
    EXPECT_EQ(locator->GetNumberOfCellsInTree(), 5) << "type " << type;
    EXPECT_EQ(locator->GetNumberOfCellsLeftOut(), 1) << "type " << type;
    EXPECT_GE(FindClosest(locator, { 3, 3, 3 }).Cell, 0) << "type " << type;
  }
}

/// Query points with one coordinate, or all, not finite.
std::vector<Point> BadPoints()
{
  return { { NaN, 0, 0 }, { 0, NaN, 0 }, { 0, 0, NaN }, { NaN, NaN, NaN }, { Infinity, 0, 0 },
    { 0, -Infinity, 0 }, { Infinity, NaN, -Infinity } };
}

class BadQuery : public testing::Test
{
protected:
  GridPointer Data = MakeGrid(Hexahedra(3));
  LocatorPointer Locator = MakeLocator(Data);
};

TEST_F(BadQuery, PointThatIsNotFiniteFindsNothing)
{
  vtkNew<vtkIdList> ids;
  for (Point x : BadPoints())
  {
    EXPECT_EQ(FindClosest(this->Locator, x).Cell, -1);
    Closest c;
    EXPECT_EQ(this->Locator->FindClosestPointWithinRadius(
                x.data(), 1.0, c.X.data(), c.Cell, c.SubId, c.Dist2),
      0);
    EXPECT_EQ(FindCell(this->Locator, x).Cell, -1);
    EXPECT_EQ(FindCell(this->Locator, x, Infinity).Cell, -1);
    EXPECT_EQ(FindClosestCells(this->Locator, x, 3).Number, 0);
    EXPECT_EQ(FindWithinRadius(this->Locator, x, Infinity).Number, 0);
    EXPECT_FALSE(this->Locator->InsideCellBounds(x.data(), 0));
    this->Locator->FindClosestCandidates(x.data(), ids);
    EXPECT_EQ(ids->GetNumberOfIds(), 0);
    this->Locator->FindCandidatesWithinRadius(x.data(), 1.0, ids);
    EXPECT_EQ(ids->GetNumberOfIds(), 0);
  }
}

TEST_F(BadQuery, HintedPointThatIsNotFiniteFindsNothing)
{
  Found f;
  double weights[8];
  for (Point x : BadPoints())
  {
    EXPECT_EQ(this->Locator->FindCellWithHint(
                x.data(), 1.0, 4, nullptr, f.SubId, f.Pcoords.data(), weights),
      -1);
  }
}

TEST_F(BadQuery, LineThatIsNotFiniteFindsNothing)
{
  const Point good = { 1.5, 1.5, 1.5 };
  vtkNew<vtkGenericCell> cell;
  vtkNew<vtkIdList> ids;
  for (const Point& bad : BadPoints())
  {
    for (const auto& line : { std::make_pair(good, bad), std::make_pair(bad, good) })
    {
      EXPECT_EQ(FindFirstHit(this->Locator, line.first, line.second).Found, 0);
      EXPECT_EQ(FindAllHits(this->Locator, line.first, line.second, 0.0, cell).Found, 0);
      EXPECT_EQ(FindAllHits(this->Locator, line.first, line.second, 0.0, nullptr).Found, 0);
      EXPECT_EQ(FindCrossings(this->Locator, line.first, line.second).Number, 0);
      EXPECT_EQ(FindAlongLine(this->Locator, line.first, line.second), Ids());
      this->Locator->FindCandidatesAlongLine(line.first.data(), line.second.data(), ids);
      EXPECT_EQ(ids->GetNumberOfIds(), 0);
    }
  }
}

TEST_F(BadQuery, PlaneThatIsNoneFindsNothing)
{
  vtkNew<vtkIdList> ids;
  const Point good = { 1.5, 1.5, 1.5 };
  std::vector<std::pair<Point, Point>> planes = { { good, { 0, 0, 0 } } };
  for (const Point& bad : BadPoints())
  {
    planes.emplace_back(good, bad);
    planes.emplace_back(bad, good);
  }
  for (const auto& plane : planes)
  {
    EXPECT_EQ(FindAlongPlane(this->Locator, plane.first, plane.second), Ids());
    this->Locator->FindCandidatesAlongPlane(plane.first.data(), plane.second.data(), ids);
    EXPECT_EQ(ids->GetNumberOfIds(), 0);
  }
}

TEST_F(BadQuery, BoxWithNanFindsNothing)
{
  vtkNew<vtkIdList> ids;
  for (int side = 0; side < 6; ++side)
  {
    Bounds box = { 0, 3, 0, 3, 0, 3 };
    box[side] = NaN;
    EXPECT_EQ(FindWithinBounds(this->Locator, box), Ids()) << side;
    this->Locator->FindCandidatesWithinBounds(box.data(), ids);
    EXPECT_EQ(ids->GetNumberOfIds(), 0) << side;
  }
}

TEST_F(BadQuery, UninitializedBoundsFindNothing)
{
  EXPECT_EQ(FindWithinBounds(this->Locator, { 1, -1, 1, -1, 1, -1 }), Ids());
}

TEST_F(BadQuery, NegativeOrNanRadiusOfCandidatesFindsNothing)
{
  const Point x = { 1.5, 1.5, 1.5 };
  vtkNew<vtkIdList> ids;
  for (double radius : { -1.0, -Infinity, NaN })
  {
    this->Locator->FindCandidatesWithinRadius(x.data(), radius, ids);
    EXPECT_EQ(ids->GetNumberOfIds(), 0);
  }
}

TEST_F(BadQuery, NanToleranceFindsNoMoreThanNone)
{
  const Point a = { -1, 1.5, 1.4 };
  const Point b = { 4, 1.5, 1.4 };
  EXPECT_NE(FindFirstHit(this->Locator, a, b, NaN).Cell, 13);
  EXPECT_LE(FindAlongLine(this->Locator, a, b, NaN).size(), 3u);
  EXPECT_LE(FindAlongPlane(this->Locator, a, { 0, 0, 1 }, NaN).size(), 9u);
  EXPECT_EQ(FindCell(this->Locator, { 9, 9, 9 }, NaN).Cell, -1);
}

TEST_F(BadQuery, HugeCoordinatesAreHarmless)
{
  for (double huge : { 1e150, 1e200, 1e308 })
  {
    EXPECT_GE(FindClosest(this->Locator, { huge, -huge, huge }).Cell, -1);
    EXPECT_EQ(FindCell(this->Locator, { huge, 0, 0 }).Cell, -1);
    EXPECT_LE(FindFirstHit(this->Locator, { -huge, 1.5, 1.4 }, { huge, 1.5, 1.4 }).Found, 1);
    EXPECT_EQ(FindWithinRadius(this->Locator, { huge, 0, 0 }, 1.0).Number, 0);
  }
}

TEST_F(BadQuery, SegmentOfNoLengthHitsNothing)
{
  const Point x = { 1.5, 1.5, 1.5 };
  vtkNew<vtkGenericCell> cell;
  EXPECT_EQ(FindAllHits(this->Locator, x, x, 0.0, cell).Found, 0);
  EXPECT_EQ(this->Locator->CountCrossings(x.data(), x.data()), 0);
}

}
