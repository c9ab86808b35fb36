// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// Meshes that break rules: no area, no length, cells twice, slivers, repeated and missing points.

#include "Support/LocatorOnMesh.h"
#include "Support/WatchedBuild.h"

#include <gtest/gtest.h>

using namespace skdtest;

namespace
{

Mesh Repeated(Mesh mesh, int times)
{
  const auto cells = mesh.Cells;
  for (int i = 1; i < times; ++i)
  {
    mesh.Cells.insert(mesh.Cells.end(), cells.begin(), cells.end());
  }
  return mesh;
}

/// Triangles that are segments, or points.
Mesh ZeroArea()
{
  Mesh mesh = TriangleSoup(120, 0.2);
  for (std::size_t cell = 0; cell < mesh.Cells.size(); ++cell)
  {
    const Ids& ids = mesh.Cells[cell].Points;
    Point* p = mesh.Points.data();
    switch (cell % 4)
    {
      case 0: // on a line
        p[ids[2]] = Lerp(p[ids[0]], p[ids[1]], 0.25);
        break;
      case 1: // an edge there and back
        p[ids[2]] = p[ids[0]];
        break;
      case 2: // a point
        p[ids[1]] = p[ids[2]] = p[ids[0]];
        break;
      default:
        break;
    }
  }
  return mesh;
}

/// Triangles a million times as long as high, in all directions.
Mesh Slivers(double height)
{
  Mesh mesh = TriangleSoup(200, 0.4);
  for (const CellSpec& cell : mesh.Cells)
  {
    Point* p = mesh.Points.data();
    const Point up = p[cell.Points[2]] - p[cell.Points[0]];
    p[cell.Points[2]] = Lerp(p[cell.Points[0]], p[cell.Points[1]], 0.3) + height * up;
  }
  return mesh;
}

/// Concentric triangles: all centroids are one point.
Mesh Concentric(int n)
{
  Mesh mesh;
  Random random(180);
  for (int i = 1; i <= n; ++i)
  {
    const Point u = random.Direction();
    const Point v = random.Direction();
    const double size = 0.1 * i;
    mesh.Add(VTK_LINE, { mesh.Add(size * u), mesh.Add((-size) * u) });
    mesh.Add(VTK_LINE, { mesh.Add(size * v), mesh.Add((-size) * v) });
  }
  return mesh;
}

/// Hexahedra with repeated points: wedges, pyramids, sheets and segments in disguise.
Mesh CollapsedHexahedra()
{
  const int same[4][8] = { { 0, 1, 1, 0, 4, 5, 5, 4 }, { 0, 1, 2, 3, 4, 4, 4, 4 },
    { 0, 1, 2, 3, 0, 1, 2, 3 }, { 0, 1, 2, 2, 4, 5, 6, 6 } };
  Mesh mesh = Hexahedra(3);
  for (std::size_t cell = 0; cell < mesh.Cells.size(); ++cell)
  {
    const Ids ids = mesh.Cells[cell].Points;
    for (int i = 0; i < 8; ++i)
    {
      mesh.Cells[cell].Points[i] = ids[same[cell % 4][i]];
    }
  }
  return mesh;
}

Mesh FlatTetrahedra()
{
  return Tetrahedra(3).Map([](const Point& p) { return Point{ p[0], p[1], 0.5 }; });
}

Mesh FlatQuadsToLines()
{
  return Sheet(6, VTK_QUAD).Map([](const Point& p) { return Point{ p[0] + p[1], 0, 1 }; });
}

std::vector<NamedMesh> DegenerateMeshes()
{
  return { { "ZeroArea", [] { return MakePolyData(ZeroArea()); } },
    { "Slivers", [] { return MakePolyData(Slivers(1e-6)); } },
    { "ThinnestSlivers", [] { return MakePolyData(Slivers(1e-13)); } },
    { "EachCellThrice", [] { return MakePolyData(Repeated(SphereTriangles(5), 3)); } },
    { "OneCellAThousandTimes", [] { return MakePolyData(Repeated(TriangleSoup(1, 0.5), 1000)); } },
    { "OneCentroid", [] { return MakePolyData(Concentric(100)); } },
    { "CollapsedHexahedra", [] { return MakeGrid(CollapsedHexahedra()); } },
    { "FlatTetrahedra", [] { return MakeGrid(FlatTetrahedra()); } },
    { "QuadsOnALine", [] { return MakePolyData(FlatQuadsToLines()); } },
    { "LinesOfNoLength",
      []
      {
        return MakePolyData(Helix(50, VTK_LINE)
                              .Map(
                                [](const Point& p) {
                                  return Point{ std::round(p[2]), 0, 0 };
                                }));
      } },
    { "AllInOnePoint",
      []
      {
        return MakePolyData(Sheet(4, VTK_TRIANGLE)
                              .Map(
                                [](const Point&) {
                                  return Point{ 1, 2, 3 };
                                }));
      } },
    { "OneVertex", [] { return MakePolyData(Cloud(1, VTK_VERTEX)); } },
    { "OneTriangle", [] { return MakePolyData(TriangleSoup(1, 1)); } },
    { "TwoTriangles", [] { return MakePolyData(TriangleSoup(2, 1)); } },
    { "FlatInX",
      []
      {
        return MakePolyData(Sheet(7, VTK_TRIANGLE)
                              .Map(
                                [](const Point& p) {
                                  return Point{ -3, p[0], p[1] };
                                }));
      } } };
}

class Degenerate : public LocatorOnMesh
{
protected:
  Point Query(Random& random) { return random.InBox(Grown(this->Reference.GetBounds(), 0.5)); }
};

INSTANTIATE_TEST_SUITE_P(All, Degenerate, testing::ValuesIn(DegenerateMeshes()), NameOfMesh());

TEST_P(Degenerate, EveryCellIsInTheTree)
{
  EXPECT_EQ(this->Locator->GetNumberOfCellsInTree(), this->Data->GetNumberOfCells());
}

TEST_P(Degenerate, ClosestPointIsTheNearest)
{
  Random random(181);
  for (int i = 0; i < 300; ++i)
  {
    const Point x = this->Query(random);
    const Closest c = FindClosest(this->Locator, x);
    ASSERT_NEAR(
      std::sqrt(c.Dist2), this->Reference.FindNearest(x).Distance, this->Reference.Tolerance())
      << "query " << i;
    ASSERT_NEAR(Distance(c.X, x), std::sqrt(c.Dist2), this->Reference.Tolerance());
  }
}

TEST_P(Degenerate, TiesGoToTheLowestId)
{
  Random random(182);
  for (int i = 0; i < 100; ++i)
  {
    const Point x = this->Query(random);
    const Closest c = FindClosest(this->Locator, x);
    const Ranked all = FindClosestCells(this->Locator, x, int(this->Data->GetNumberOfCells()));
    for (std::size_t k = 0; k < all.Cells.size() && all.Distances[k] == all.Distances[0]; ++k)
    {
      ASSERT_LE(c.Cell, all.Cells[k]);
    }
  }
}

TEST_P(Degenerate, BoundsQueriesAreExact)
{
  Random random(183);
  for (int i = 0; i < 100; ++i)
  {
    const Bounds box = BoxOf(this->Query(random), this->Query(random));
    ASSERT_EQ(FindWithinBounds(this->Locator, box), this->Reference.FindWithinBounds(box));
  }
  const Bounds& whole = this->Reference.GetBounds();
  EXPECT_EQ(FindWithinBounds(this->Locator, whole), this->Reference.GetCells());
}

TEST_P(Degenerate, HitsLieOnTheirCells)
{
  Random random(184);
  vtkNew<vtkGenericCell> cell;
  const double size = Scale(this->Reference.GetBounds());
  for (int i = 0; i < 200; ++i)
  {
    const Point x = this->Query(random);
    const Point y = this->Query(random);
    const LineHits hits = FindAllHits(this->Locator, x, y, 0.0, cell);
    for (std::size_t k = 0; k < hits.Cells.size(); ++k)
    {
      ASSERT_LE(this->Reference.DistanceTo(hits.Cells[k], hits.Points[k]), 1e-9 * size);
    }
    ASSERT_EQ(FindFirstHit(this->Locator, x, y).Found, hits.Found);
  }
}

TEST_P(Degenerate, EachCellIsFoundAtItsOwnPoints)
{
  vtkNew<vtkGenericCell> cell;
  for (vtkIdType id = 0; id < this->Data->GetNumberOfCells(); ++id)
  {
    this->Data->GetCell(id, cell);
    Point x;
    cell->GetPoints()->GetPoint(0, x.data());
    const Closest c = FindClosest(this->Locator, x);
    ASSERT_LE(c.Dist2, 1e-28);
    const vtkIdType found = FindCell(this->Locator, x).Cell;
    ASSERT_GE(found, 0);
    ASSERT_LE(found, id);
  }
}

TEST(DegenerateCells, OfTooFewPointsAreHarmless)
{
  Mesh mesh = Sheet(2, VTK_TRIANGLE);
  mesh.Add(VTK_POLYGON, { 5, 5, 5, 5 });
  mesh.Add(VTK_POLY_LINE, { 2, 2, 2 });
  mesh.Add(VTK_TRIANGLE_STRIP, { 1, 1, 1 });
  Mesh few = mesh; // polydata cannot hold these
  few.Add(VTK_POLYGON, { 0 });
  few.Add(VTK_POLYGON, { 0, 1 });
  few.Add(VTK_POLY_LINE, { 3 });
  few.Add(VTK_TRIANGLE_STRIP, { 3, 4 });
  for (const DataSetPointer& data :
    std::vector<DataSetPointer>{ MakeGrid(few), MakePolyData(mesh) })
  {
    const auto locator = MakeLocator(data);
    vtkNew<vtkGenericCell> cell;
    Random random(185);
    for (int i = 0; i < 200; ++i)
    {
      const Point x = random.InBox({ -1, 3, -1, 3, -1, 1 });
      const Point y = random.InBox({ -1, 3, -1, 3, -1, 1 });
      EXPECT_GE(FindClosest(locator, x).Cell, 0);
      FindAllHits(locator, x, y, 0.1, cell);
      FindCell(locator, x, 0.1);
      FindCrossings(locator, x, y);
      FindClosestCells(locator, x, 20);
    }
    EXPECT_EQ(locator->GetNumberOfCellsInTree() + locator->GetNumberOfCellsLeftOut(),
      data->GetNumberOfCells());
  }
}

TEST(DegenerateCells, WithPointsThatDoNotExistAreLeftOut)
{
  Mesh mesh = Sheet(3, VTK_TRIANGLE);
  mesh.Cells[4].Points[1] = 1000000;
  mesh.Cells[7].Points[2] = -5;
  const WatchedBuild build(MakePolyData(mesh));
  EXPECT_EQ(build.Events.Warnings, 1);
  EXPECT_EQ(build.Locator->GetNumberOfCellsLeftOut(), 2);
  EXPECT_EQ(FindClosest(build.Locator, { 0.2, 0.1, 1 }).Dist2, 1.0);
}

TEST(DegenerateCells, OfASliverClosedSurfaceKeepParity)
{
  const Mesh mesh = CubeTriangles(4).Map(
    [](const Point& p) {
      return Point{ p[0], p[1], 1e-9 * p[2] };
    });
  const auto data = MakePolyData(mesh);
  const auto locator = MakeLocator(data);
  Random random(186);
  for (int i = 0; i < 2000; ++i)
  {
    const Point a = random.InBox({ -1, 5, -1, 5, 1, 2 });
    const Point b = random.InBox({ -1, 5, -1, 5, -2, -1 });
    ASSERT_EQ(locator->CountCrossings(a.data(), b.data()) % 2, 0);
  }
}

}
