// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// IntersectWithLine, the three forms that return the first hit.

#include "Support/LocatorOnMesh.h"
#include "Support/SegmentReference.h"

#include <gtest/gtest.h>

using namespace skdtest;

namespace
{

class FirstHitOnMesh : public LocatorOnMesh
{
};

INSTANTIATE_TEST_SUITE_P(
  Surfaces, FirstHitOnMesh, testing::ValuesIn(SurfaceMeshes()), NameOfMesh());
INSTANTIATE_TEST_SUITE_P(Volumes, FirstHitOnMesh, testing::ValuesIn(VolumeMeshes()), NameOfMesh());

TEST_P(FirstHitOnMesh, IsTheNearestOfTheHitsOfAllCells)
{
  Random random(30);
  int found = 0;
  for (int i = 0; i < 300; ++i)
  {
    const auto line = this->Line(random);
    const auto expected = this->Reference.Intersect(line[0], line[1]);
    const LineHit hit = FindFirstHit(this->Locator, line[0], line[1]);
    ASSERT_EQ(hit.Found, expected.empty() ? 0 : 1) << "line " << i;
    ASSERT_EQ(hit.Found == 1, hit.Cell >= 0);
    if (hit.Found)
    {
      ++found;
      ASSERT_NEAR(hit.T, expected.front().T, 1e-9) << "line " << i;
    }
  }
  EXPECT_GT(found, 20);
}

TEST_P(FirstHitOnMesh, PointLiesOnTheLineAndOnTheCell)
{
  Random random(31);
  const double size = Scale(this->Reference.GetBounds());
  for (int i = 0; i < 200; ++i)
  {
    const auto line = this->Line(random);
    const LineHit hit = FindFirstHit(this->Locator, line[0], line[1]);
    if (!hit.Found)
    {
      continue;
    }
    ASSERT_GE(hit.T, 0.0);
    ASSERT_LE(hit.T, 1.0);
    ASSERT_LE(Distance(hit.X, Lerp(line[0], line[1], hit.T)), 1e-12 * size);
    ASSERT_GE(hit.Cell, 0);
    // Two triangles stand for a warped face, which is off the bilinear one by its warp.
    ASSERT_LE(this->Reference.DistanceTo(hit.Cell, hit.X), 0.02 * size) << "line " << i;
  }
}

TEST_P(FirstHitOnMesh, ParametricCoordinatesReproduceThePoint)
{
  Random random(32);
  const double size = Scale(this->Reference.GetBounds());
  vtkNew<vtkGenericCell> cell;
  std::vector<double> weights(this->Data->GetMaxCellSize() + 1);
  for (int i = 0; i < 100; ++i)
  {
    const auto line = this->Line(random);
    LineHit hit;
    hit.Found = this->Locator->IntersectWithLine(line[0].data(), line[1].data(), 0.0, hit.T,
      hit.X.data(), hit.Pcoords.data(), hit.SubId, hit.Cell, cell);
    if (hit.Found)
    {
      Point x;
      cell->EvaluateLocation(hit.SubId, hit.Pcoords.data(), x.data(), weights.data());
      ASSERT_LE(Distance(x, hit.X), 0.02 * size) << "line " << i << " cell " << hit.Cell;
    }
  }
}

TEST_P(FirstHitOnMesh, AllFormsAgree)
{
  Random random(33);
  vtkNew<vtkGenericCell> cell, expectedCell;
  for (int i = 0; i < 50; ++i)
  {
    const auto line = this->Line(random);
    const LineHit expected = FindFirstHit(this->Locator, line[0], line[1]);
    LineHit h;
    h.Cell = expected.Cell; // the form without an id
    h.Found = this->Locator->IntersectWithLine(
      line[0].data(), line[1].data(), 0.0, h.T, h.X.data(), h.Pcoords.data(), h.SubId);
    ASSERT_EQ(h, expected);
    h = LineHit();
    h.Found = this->Locator->IntersectWithLine(line[0].data(), line[1].data(), 0.0, h.T, h.X.data(),
      h.Pcoords.data(), h.SubId, h.Cell, nullptr);
    ASSERT_EQ(h, expected);
    h = LineHit();
    h.Found = this->Locator->IntersectWithLine(line[0].data(), line[1].data(), 0.0, h.T, h.X.data(),
      h.Pcoords.data(), h.SubId, h.Cell, cell);
    ASSERT_EQ(h, expected);
    if (h.Found)
    {
      this->Data->GetCell(h.Cell, expectedCell);
      ASSERT_EQ(ToVector(cell->GetPointIds()), ToVector(expectedCell->GetPointIds()));
      ASSERT_EQ(ToVector(cell->GetPoints()), ToVector(expectedCell->GetPoints()));
    }
  }
}

TEST_P(FirstHitOnMesh, LinesBesideTheMeshHitNothing)
{
  const Bounds& box = this->Reference.GetBounds();
  const double size = Diagonal(box);
  const Point above = { box[0], box[2], box[5] + 0.01 * size };
  const Point along = { size, size, 0 };
  const LineHit hit = FindFirstHit(this->Locator, above - along, above + along);
  EXPECT_EQ(hit.Found, 0);
  EXPECT_EQ(hit.Cell, -1);
}

class FirstHitOnSheet : public testing::TestWithParam<int>
{
protected:
  DataSetPointer Data = MakeGrid(Sheet(4, GetParam()));
  LocatorPointer Locator = MakeLocator(this->Data);
};

INSTANTIATE_TEST_SUITE_P(
  Types, FirstHitOnSheet, testing::Values(VTK_TRIANGLE, VTK_QUAD, VTK_PIXEL));

TEST_P(FirstHitOnSheet, BothEndsOfTheSegmentCount)
{
  const Point on = { 1.25, 2.5, 0 };
  const Point off = { 1.25, 2.5, 2 };
  const LineHit last = FindFirstHit(this->Locator, off, on);
  EXPECT_EQ(last.Found, 1);
  EXPECT_EQ(last.T, 1.0);
  const LineHit first = FindFirstHit(this->Locator, on, off);
  EXPECT_EQ(first.Found, 1);
  EXPECT_EQ(first.T, 0.0);
}

TEST_P(FirstHitOnSheet, ASegmentThatStopsShortHitsNothing)
{
  EXPECT_EQ(FindFirstHit(this->Locator, { 1.25, 2.5, 2 }, { 1.25, 2.5, 1e-12 }).Found, 0);
}

TEST_P(FirstHitOnSheet, CellsSeenEdgeOnAreNotHit)
{
  EXPECT_EQ(FindFirstHit(this->Locator, { -1, 1.25, 0 }, { 9, 1.25, 0 }).Found, 0);
  EXPECT_EQ(FindFirstHit(this->Locator, { 1.25, 1.25, 0 }, { 1.5, 1.75, 0 }).Found, 0);
}

TEST_P(FirstHitOnSheet, ASegmentOfNoLengthHitsNothing)
{
  EXPECT_EQ(FindFirstHit(this->Locator, { 1.25, 2.5, 0 }, { 1.25, 2.5, 0 }).Found, 0);
  EXPECT_EQ(FindFirstHit(this->Locator, { 1.25, 2.5, 0 }, { 1.25, 2.5, 0 }, 0.1).Found, 0);
}

TEST_P(FirstHitOnSheet, AtAVertexTheLowestIdIsReturned)
{
  vtkNew<vtkIdList> around;
  for (vtkIdType point = 0; point < this->Data->GetNumberOfPoints(); ++point)
  {
    Point p;
    this->Data->GetPoint(point, p.data());
    this->Data->GetPointCells(point, around);
    const Ids cells = ToVector(around);
    const LineHit hit = FindFirstHit(this->Locator, p + Point{ 0, 0, 1 }, p - Point{ 0, 0, 1 });
    ASSERT_EQ(hit.Found, 1) << "point " << point;
    ASSERT_EQ(hit.Cell, *std::min_element(cells.begin(), cells.end()));
    ASSERT_EQ(hit.T, 0.5);
    ASSERT_EQ(hit.X, p);
  }
}

TEST_P(FirstHitOnSheet, ToleranceIsTheDistanceOfAMiss)
{
  const Point above = { 4.05, 1.5, 1 };
  const Point below = { 4.05, 1.5, -1 };
  EXPECT_EQ(FindFirstHit(this->Locator, above, below, 0.0).Found, 0);
  EXPECT_EQ(FindFirstHit(this->Locator, above, below, 0.049).Found, 0);
  EXPECT_EQ(FindFirstHit(this->Locator, above, below, 0.051).Found, 1);
}

TEST_P(FirstHitOnSheet, NegativeToleranceCountsAsZero)
{
  EXPECT_EQ(FindFirstHit(this->Locator, { 1.25, 1.5, 1 }, { 1.25, 1.5, -1 }, -1.0),
    FindFirstHit(this->Locator, { 1.25, 1.5, 1 }, { 1.25, 1.5, -1 }, 0.0));
}

TEST(FirstHit, OfStackedSheetsIsTheNearestFromEitherSide)
{
  Mesh mesh;
  for (int layer = 0; layer < 9; ++layer)
  {
    const double z = (layer * 4) % 9; // ids out of order
    const vtkIdType a = mesh.Add(Point{ -5, -5, z });
    const vtkIdType b = mesh.Add(Point{ 5, -5, z });
    const vtkIdType c = mesh.Add(Point{ 0, 9, z });
    mesh.Add(VTK_TRIANGLE, { a, b, c });
  }
  const auto data = MakePolyData(mesh);
  const auto locator = MakeLocator(data);
  EXPECT_EQ(FindFirstHit(locator, { 0, 0, 20 }, { 0, 0, -20 }).X[2], 8);
  EXPECT_EQ(FindFirstHit(locator, { 0, 0, -20 }, { 0, 0, 20 }).X[2], 0);
  EXPECT_EQ(FindFirstHit(locator, { 0, 0, 4.5 }, { 0, 0, -20 }).X[2], 4);
}

TEST(FirstHit, OfCoincidentCellsIsTheLowestId)
{
  Mesh mesh = Sheet(3, VTK_TRIANGLE);
  const auto cells = mesh.Cells;
  mesh.Cells.insert(mesh.Cells.end(), cells.rbegin(), cells.rend());
  const auto data = MakePolyData(mesh);
  const auto locator = MakeLocator(data);
  Random random(34);
  for (int i = 0; i < 100; ++i)
  {
    const Point p = random.InBox({ 0, 3, 0, 3, 0, 0 });
    const LineHit hit = FindFirstHit(locator, p + Point{ 0.1, 0.2, 1 }, p - Point{ 0.1, 0.2, 1 });
    ASSERT_EQ(hit.Found, 1);
    ASSERT_LT(hit.Cell, static_cast<vtkIdType>(cells.size()));
  }
}

TEST(FirstHit, FromInsideAVolumeCellIsItsFarFace)
{
  const auto tets = MakeGrid(Tetrahedra(1));
  const LineHit hit = FindFirstHit(MakeLocator(tets), { 0.5, 0.5, 0.2 }, { 0.5, 0.5, 5 });
  EXPECT_EQ(hit.Found, 1);
  const auto hexes = MakeGrid(Hexahedra(1));
  const LineHit far = FindFirstHit(MakeLocator(hexes), { 0.5, 0.25, 0.5 }, { 0.5, 0.25, 2.5 });
  EXPECT_EQ(far.Found, 1);
  EXPECT_NEAR(far.T, 0.25, 1e-14);
}

TEST(FirstHit, OfLinesAndVerticesIsWithinTheTolerance)
{
  Random random(35);
  for (const NamedMesh& mesh : CurveMeshes())
  {
    const auto data = mesh.Make();
    const auto locator = MakeLocator(data);
    BruteForce reference(data);
    const double tol = 0.03;
    const double slack = 1e-9;
    vtkNew<vtkGenericCell> cell;
    for (int i = 0; i < 200; ++i)
    {
      const Point through = random.InBox(reference.GetBounds());
      const Point along = 3.0 * Diagonal(reference.GetBounds()) * random.Direction();
      double least = std::numeric_limits<double>::infinity();
      for (vtkIdType id = 0; id < data->GetNumberOfCells(); ++id)
      {
        data->GetCell(id, cell);
        const auto p = ToVector(cell->GetPoints());
        const std::size_t step = cell->GetCellDimension() == 1 ? 1 : 0;
        for (std::size_t k = 0; k + step < p.size(); ++k)
        {
          least =
            std::min(least, SegmentsDistance(through - along, through + along, p[k], p[k + step]));
        }
      }
      const LineHit hit = FindFirstHit(locator, through - along, through + along, tol);
      ASSERT_TRUE(hit.Found || least > tol - slack) << mesh.Name << " " << least;
      ASSERT_TRUE(!hit.Found || least < tol + slack) << mesh.Name << " " << least;
    }
  }
}

}
