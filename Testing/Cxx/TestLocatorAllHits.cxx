// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// IntersectWithLine, the three forms that return all hits; FindCellsAlongLine.

#include "Support/LocatorOnMesh.h"
#include "Support/SegmentReference.h"

#include <gtest/gtest.h>

#include <set>

using namespace skdtest;

namespace
{

class AllHitsOnMesh : public LocatorOnMesh
{
protected:
  /// Where each box, grown by tol, is entered.
  std::vector<BruteForce::Hit> Entries(const std::array<Point, 2>& line, double tol)
  {
    std::vector<BruteForce::Hit> entries;
    for (vtkIdType cell : this->Reference.GetCells())
    {
      const double t = EntryIntoBox(line[0], line[1], Grown(this->Reference.Box(cell), tol));
      if (t >= 0.0)
      {
        entries.push_back({ t, cell });
      }
    }
    std::sort(entries.begin(), entries.end());
    return entries;
  }

  /// All that are surely met are among the cells, and none that is surely not.
  void ExpectEntries(const Ids& cells, const std::array<Point, 2>& line, double tol)
  {
    const double slack = 1e-13 * Scale(this->Reference.GetBounds());
    const std::set<vtkIdType> found(cells.begin(), cells.end());
    ASSERT_EQ(found.size(), cells.size()) << "a cell twice";
    std::set<vtkIdType> sure, possible;
    for (const auto& entry : this->Entries(line, tol + slack))
    {
      possible.insert(entry.Cell);
    }
    for (const auto& entry : this->Entries(line, tol - slack))
    {
      sure.insert(entry.Cell);
    }
    EXPECT_TRUE(std::includes(found.begin(), found.end(), sure.begin(), sure.end()));
    EXPECT_TRUE(std::includes(possible.begin(), possible.end(), found.begin(), found.end()));
  }
  vtkNew<vtkGenericCell> Cell;
};

INSTANTIATE_TEST_SUITE_P(Surfaces, AllHitsOnMesh, testing::ValuesIn(SurfaceMeshes()), NameOfMesh());
INSTANTIATE_TEST_SUITE_P(Volumes, AllHitsOnMesh, testing::ValuesIn(VolumeMeshes()), NameOfMesh());

TEST_P(AllHitsOnMesh, AreThoseOfAllCellsEachOnce)
{
  Random random(40);
  std::size_t total = 0;
  for (int i = 0; i < 200; ++i)
  {
    const auto line = this->Line(random);
    const auto expected = this->Reference.Intersect(line[0], line[1]);
    const LineHits hits = FindAllHits(this->Locator, line[0], line[1], 0.0, this->Cell);
    std::set<vtkIdType> ids, expectedIds;
    for (const auto& hit : expected)
    {
      expectedIds.insert(hit.Cell);
    }
    ids.insert(hits.Cells.begin(), hits.Cells.end());
    ASSERT_EQ(ids, expectedIds) << "line " << i;
    ASSERT_EQ(ids.size(), hits.Cells.size()) << "a cell twice on line " << i;
    ASSERT_EQ(hits.Found, hits.Cells.empty() ? 0 : 1);
    total += ids.size();
  }
  EXPECT_GT(total, 20u);
}

TEST_P(AllHitsOnMesh, AreSortedAlongTheLineAndLieOnIt)
{
  Random random(41);
  const double size = Scale(this->Reference.GetBounds());
  for (int i = 0; i < 100; ++i)
  {
    const auto line = this->Line(random);
    const Point along = line[1] - line[0];
    const LineHits hits = FindAllHits(this->Locator, line[0], line[1], 0.0, this->Cell);
    ASSERT_EQ(hits.Points.size(), hits.Cells.size());
    double last = 0.0;
    for (std::size_t k = 0; k < hits.Points.size(); ++k)
    {
      const double t = Dot(hits.Points[k] - line[0], along) / Dot(along, along);
      ASSERT_LE(Distance(hits.Points[k], Lerp(line[0], line[1], t)), 1e-12 * size);
      ASSERT_GE(t, last - 1e-14);
      last = t;
    }
  }
}

TEST_P(AllHitsOnMesh, EachHitLiesOnItsCell)
{
  Random random(42);
  const double size = Scale(this->Reference.GetBounds());
  for (int i = 0; i < 50; ++i)
  {
    const auto line = this->Line(random);
    const LineHits hits = FindAllHits(this->Locator, line[0], line[1], 0.0, this->Cell);
    for (std::size_t k = 0; k < hits.Points.size(); ++k)
    {
      // Two triangles stand for a warped face.
      ASSERT_LE(this->Reference.DistanceTo(hits.Cells[k], hits.Points[k]), 0.02 * size);
    }
  }
}

TEST_P(AllHitsOnMesh, TheFirstIsTheFirstHit)
{
  Random random(43);
  for (int i = 0; i < 100; ++i)
  {
    const auto line = this->Line(random);
    const LineHit first = FindFirstHit(this->Locator, line[0], line[1]);
    const LineHits hits = FindAllHits(this->Locator, line[0], line[1], 0.0, this->Cell);
    ASSERT_EQ(first.Found, hits.Found);
    if (first.Found)
    {
      ASSERT_EQ(first.Cell, hits.Cells[0]);
      ASSERT_EQ(first.X, hits.Points[0]);
    }
  }
}

TEST_P(AllHitsOnMesh, AllFormsAgree)
{
  Random random(44);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkIdList> ids;
  for (int i = 0; i < 30; ++i)
  {
    const auto line = this->Line(random);
    const LineHits expected = FindAllHits(this->Locator, line[0], line[1], 0.0, this->Cell);
    LineHits hits;
    hits.Found = this->Locator->IntersectWithLine(line[0].data(), line[1].data(), points, ids);
    hits.Points = ToVector(points);
    hits.Cells = ToVector(ids);
    ASSERT_EQ(hits, expected);
    hits.Found = this->Locator->IntersectWithLine(line[0].data(), line[1].data(), 0.0, points, ids);
    hits.Points = ToVector(points);
    hits.Cells = ToVector(ids);
    ASSERT_EQ(hits, expected);
  }
}

TEST_P(AllHitsOnMesh, ListsMayBeNull)
{
  Random random(45);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkIdList> ids;
  for (int i = 0; i < 20; ++i)
  {
    const auto line = this->Line(random);
    const double* p1 = line[0].data();
    const double* p2 = line[1].data();
    const LineHits expected = FindAllHits(this->Locator, line[0], line[1], 0.0, this->Cell);
    EXPECT_EQ(
      this->Locator->IntersectWithLine(p1, p2, 0.0, nullptr, nullptr, this->Cell), expected.Found);
    EXPECT_EQ(
      this->Locator->IntersectWithLine(p1, p2, 0.0, points, nullptr, this->Cell), expected.Found);
    EXPECT_EQ(ToVector(points), expected.Points);
    EXPECT_EQ(
      this->Locator->IntersectWithLine(p1, p2, 0.0, nullptr, ids, this->Cell), expected.Found);
    EXPECT_EQ(ToVector(ids), expected.Cells);
    EXPECT_EQ(this->Locator->IntersectWithLine(p1, p2, nullptr, nullptr), expected.Found);
  }
}

TEST_P(AllHitsOnMesh, WithoutACellTheBoundsAreHit)
{
  Random random(46);
  for (double tol : { 0.0, 0.07 })
  {
    for (int i = 0; i < 40; ++i)
    {
      const auto line = this->Line(random);
      const LineHits hits = FindAllHits(this->Locator, line[0], line[1], tol, nullptr);
      this->ExpectEntries(hits.Cells, line, tol);
      ASSERT_EQ(hits.Found, hits.Cells.empty() ? 0 : 1);
      double last = 0.0;
      for (std::size_t k = 0; k < hits.Points.size(); ++k)
      {
        const Bounds box = Grown(this->Reference.Box(hits.Cells[k]), tol);
        const double t = EntryIntoBox(line[0], line[1], Grown(box, this->Reference.Tolerance()));
        const Point entry = Lerp(line[0], line[1], t);
        ASSERT_LE(Distance(hits.Points[k], entry), 1e-9 * Scale(this->Reference.GetBounds()));
        ASSERT_GE(t, last - 1e-9);
        last = t;
      }
    }
  }
}

TEST_P(AllHitsOnMesh, CellsAlongLineAreThoseWhoseBoundsAreHit)
{
  Random random(47);
  for (double tol : { 0.0, 0.07 })
  {
    for (int i = 0; i < 40; ++i)
    {
      const auto line = this->Line(random);
      const Ids cells = FindAlongLine(this->Locator, line[0], line[1], tol);
      EXPECT_EQ(cells, FindAllHits(this->Locator, line[0], line[1], tol, nullptr).Cells);
      this->ExpectEntries(cells, line, tol);
    }
  }
}

TEST_P(AllHitsOnMesh, ASegmentWithinABoxEntersItAtItsStart)
{
  const vtkIdType cell = this->Reference.GetCells()[this->Reference.GetCells().size() / 2];
  const Bounds& box = this->Reference.Box(cell);
  const Point start = Center(box);
  const Point end = Lerp(start, { box[1], box[3], box[5] }, 0.5);
  const LineHits hits = FindAllHits(this->Locator, start, end, 0.0, nullptr);
  const auto at = std::find(hits.Cells.begin(), hits.Cells.end(), cell);
  ASSERT_NE(at, hits.Cells.end());
  EXPECT_EQ(hits.Points[at - hits.Cells.begin()], start);
}

TEST(AllHits, AtOneParameterTheIdsAscend)
{
  Mesh mesh = Sheet(3, VTK_TRIANGLE);
  std::reverse(mesh.Cells.begin(), mesh.Cells.end());
  const auto data = MakePolyData(mesh);
  const auto locator = MakeLocator(data);
  vtkNew<vtkGenericCell> cell;
  const LineHits hits = FindAllHits(locator, { 1, 1, 1 }, { 1, 1, -1 }, 0.0, cell);
  EXPECT_EQ(hits.Cells.size(), 6u);
  EXPECT_TRUE(std::is_sorted(hits.Cells.begin(), hits.Cells.end()));
}

TEST(AllHits, OfASharedEdgeAreBothCells)
{
  const auto data = MakePolyData(CubeTriangles(2));
  const auto locator = MakeLocator(data);
  vtkNew<vtkGenericCell> cell;
  // Down through the middles of two diagonals, one in the top and one in the bottom.
  const LineHits hits = FindAllHits(locator, { 0.5, 0.5, 3 }, { 0.5, 0.5, -1 }, 0.0, cell);
  ASSERT_EQ(hits.Cells.size(), 4u);
  EXPECT_EQ(hits.Points[0], hits.Points[1]);
  EXPECT_EQ(hits.Points[2], hits.Points[3]);
  EXPECT_LT(hits.Cells[0], hits.Cells[1]);
}

TEST(AllHits, EmptiesTheListsOfAMiss)
{
  const auto data = MakePolyData(Octahedron(1));
  const auto locator = MakeLocator(data);
  vtkNew<vtkGenericCell> cell;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(1, 2, 3);
  vtkNew<vtkIdList> ids;
  ids->InsertNextId(7);
  const Point p1 = { 5, 5, 5 };
  const Point p2 = { 6, 5, 5 };
  for (vtkGenericCell* c : { cell.Get(), static_cast<vtkGenericCell*>(nullptr) })
  {
    EXPECT_EQ(locator->IntersectWithLine(p1.data(), p2.data(), 0.0, points, ids, c), 0);
    EXPECT_EQ(points->GetNumberOfPoints(), 0);
    EXPECT_EQ(ids->GetNumberOfIds(), 0);
  }
}

TEST(AllHits, OfASegmentOfNoLengthAreNone)
{
  const auto data = MakePolyData(Octahedron(1));
  const auto locator = MakeLocator(data);
  vtkNew<vtkGenericCell> cell;
  EXPECT_EQ(FindAllHits(locator, { 1, 0, 0 }, { 1, 0, 0 }, 0.0, cell).Found, 0);
}

TEST(AllHits, OfAStripAreOneThoughTwoTrianglesAreHit)
{
  Mesh mesh;
  mesh.Points = { { 0, 0, 0 }, { 0, 1, 0 }, { 1, 0, 0 }, { 1, 1, 1 }, { 0, 0, 1 }, { 0, 1, 1 } };
  mesh.Add(VTK_TRIANGLE_STRIP, { 0, 1, 2, 3, 4, 5 });
  const auto data = MakePolyData(mesh);
  const auto locator = MakeLocator(data);
  vtkNew<vtkGenericCell> cell;
  const LineHits hits = FindAllHits(locator, { 0.2, 0.3, 3 }, { 0.2, 0.3, -3 }, 0.0, cell);
  ASSERT_EQ(hits.Cells, Ids{ 0 });
  EXPECT_NEAR(hits.Points[0][2], 1.0, 1e-14);
}

}
