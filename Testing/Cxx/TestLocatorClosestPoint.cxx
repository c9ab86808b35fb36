// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// FindClosestPoint and FindClosestPointWithinRadius in all their forms.

#include "Support/CellZoo.h"
#include "Support/LocatorOnMesh.h"
#include "Support/LongCells.h"
#include "Support/SurfaceMeshes.h"
#include "Support/VolumeMeshes.h"

#include <gtest/gtest.h>

using namespace skdtest;

namespace
{

const double Infinity = std::numeric_limits<double>::infinity();

struct WithinRadius
{
  vtkIdType Found = -2;
  Closest Answer;
  int Inside = -2;
};

WithinRadius FindWithin(vtkSkdTreeCellLocator* locator, Point x, double radius)
{
  WithinRadius w;
  vtkNew<vtkGenericCell> cell;
  w.Found = locator->FindClosestPointWithinRadius(x.data(), radius, w.Answer.X.data(), cell,
    w.Answer.Cell, w.Answer.SubId, w.Answer.Dist2, w.Inside);
  return w;
}

class ClosestPointOnMesh : public LocatorOnMesh
{
protected:
  /// Points near and far, on cells and off.
  std::vector<Point> Queries(int count)
  {
    Random random(20);
    std::vector<Point> queries;
    const Bounds& box = this->Reference.GetBounds();
    const double size = Diagonal(box);
    for (int i = 0; i < count; ++i)
    {
      queries.push_back(random.InBox(Grown(box, (i % 3) * 0.3 * size)));
    }
    queries.push_back(Center(box));
    queries.push_back({ box[0], box[2], box[4] });
    queries.push_back({ box[1] + 1e3 * size, box[3], box[5] });
    return queries;
  }
};

INSTANTIATE_TEST_SUITE_P(All, ClosestPointOnMesh, testing::ValuesIn(AllMeshes()), NameOfMesh());

TEST_P(ClosestPointOnMesh, DistanceIsThatOfTheNearestOfAllCells)
{
  for (const Point& x : this->Queries(150))
  {
    const Closest c = FindClosest(this->Locator, x);
    const double expected = this->Reference.FindNearest(x).Distance;
    const double tolerance = this->Reference.Tolerance() + 1e-14 * Length(x);
    ASSERT_NEAR(std::sqrt(c.Dist2), expected, tolerance)
      << "from (" << x[0] << ", " << x[1] << ", " << x[2] << ")";
  }
}

TEST_P(ClosestPointOnMesh, ReturnedPointLiesOnTheReturnedCell)
{
  for (const Point& x : this->Queries(100))
  {
    const Closest c = FindClosest(this->Locator, x);
    ASSERT_GE(c.Cell, 0);
    ASSERT_LT(c.Cell, this->Data->GetNumberOfCells());
    // The foot of a perpendicular is known to the root of the precision where cells are curved.
    ASSERT_LE(this->Reference.DistanceTo(c.Cell, c.X), 1e-9 * Scale(this->Reference.GetBounds()));
  }
}

TEST_P(ClosestPointOnMesh, Dist2IsTheSquaredDistanceToTheReturnedPoint)
{
  for (const Point& x : this->Queries(100))
  {
    const Closest c = FindClosest(this->Locator, x);
    ASSERT_NEAR(
      std::sqrt(c.Dist2), Distance(x, c.X), this->Reference.Tolerance() + 1e-14 * Length(x));
  }
}

TEST_P(ClosestPointOnMesh, ReturnedCellIsTheNearest)
{
  for (const Point& x : this->Queries(100))
  {
    const Closest c = FindClosest(this->Locator, x);
    const double tolerance = this->Reference.Tolerance() + 1e-14 * Length(x);
    ASSERT_NEAR(this->Reference.DistanceTo(c.Cell, x), std::sqrt(c.Dist2), tolerance);
  }
}

void ExpectCell(vtkGenericCell* cell, vtkDataSet* data, vtkIdType id)
{
  vtkNew<vtkGenericCell> expected;
  data->GetCell(id, expected);
  EXPECT_EQ(cell->GetCellType(), expected->GetCellType());
  EXPECT_EQ(ToVector(cell->GetPointIds()), ToVector(expected->GetPointIds()));
  EXPECT_EQ(ToVector(cell->GetPoints()), ToVector(expected->GetPoints()));
}

TEST_P(ClosestPointOnMesh, GenericCellHoldsTheReturnedCell)
{
  vtkNew<vtkGenericCell> cell;
  for (const Point& x : this->Queries(20))
  {
    Closest c;
    this->Locator->FindClosestPoint(x.data(), c.X.data(), cell, c.Cell, c.SubId, c.Dist2);
    ExpectCell(cell, this->Data, c.Cell);
  }
}

/// Of the cell's points, which keep them until they are modified. (VTK does not say so where it
/// loads cells of structured grids and polyhedra.)
void ExpectBounds(vtkGenericCell* cell, vtkDataSet* data, vtkIdType id)
{
  Bounds box, expected;
  cell->GetPoints()->GetBounds(box.data());
  data->GetCellBounds(id, expected.data());
  EXPECT_EQ(box, expected);
}

TEST(ClosestPointCell, IsThatOfVtkHoweverItIsStored)
{
  vtkNew<vtkGenericCell> cell; // each time another cell is in it
  for (const int type : { VTK_FLOAT, VTK_DOUBLE, VTK_SHORT })
  {
    const vtkSmartPointer<vtkPointSet> meshes[] = { MakeGrid(MixedCells(2), type),
      MakePolyData(CubeTriangles(2), type), MakePolyData(CubeQuads(2), type, true),
      MakePolyData(Strips(2), type), MakeGrid(SeparateQuadraticHexahedra(2), type) };
    for (vtkPointSet* mesh : meshes)
    {
      const auto locator = MakeLocator(mesh);
      for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
      {
        Closest c;
        locator->FindClosestPoint(mesh->GetPoint(i), c.X.data(), cell, c.Cell, c.SubId, c.Dist2);
        ExpectCell(cell, mesh, c.Cell);
        ExpectBounds(cell, mesh, c.Cell);
      }
    }
  }
}

/// What a caller may do to a cell that it has got: another cell is loaded into it afterwards.
/// (In double precision it stays, for what is stored in float would be rounded.)
void Misuse(vtkGenericCell* cell, int how, int pointType)
{
  switch (how % 5)
  {
    case 0:
      cell->GetPoints()->SetNumberOfPoints(how);
      break;
    case 1:
      cell->GetPointIds()->Reset();
      break;
    case 2:
      cell->GetPoints()->SetDataType(pointType);
      break;
    case 3:
      cell->SetCellType(how % 2 == 0 ? VTK_WEDGE : VTK_EMPTY_CELL);
      break;
    default:
      break;
  }
}

TEST(ClosestPointCell, IsThatOfVtkForEveryTypeWhateverWasInIt)
{
  int how = 0;
  for (const int pointType : { VTK_FLOAT, VTK_DOUBLE })
  {
    vtkNew<vtkGenericCell> cell; // for all types
    for (const int type : AllCellTypes())
    {
      const Mesh block = Block(ReferenceCell(type, 1), Unmoved);
      const auto grid = MakeGrid(block, pointType);
      for (const bool ids64 : { true, false })
      {
        ids64 ? grid->GetCells()->ConvertTo64BitStorage()
              : grid->GetCells()->ConvertTo32BitStorage();
        const auto locator = MakeLocator(grid);
        for (const Point& x : block.Points)
        {
          Closest c;
          locator->FindClosestPoint(x.data(), c.X.data(), cell, c.Cell, c.SubId, c.Dist2);
          ASSERT_EQ(c.Cell >= 0, type != VTK_EMPTY_CELL);
          if (c.Cell >= 0)
          {
            ExpectCell(cell, grid, c.Cell);
          }
          Misuse(cell, ++how, pointType);
        }
      }
    }
  }
}

// Without a hull it is searched as points, and loaded as what it is.
TEST(ClosestPointCell, IsAConvexPointSetOfEqualPoints)
{
  Mesh mesh;
  mesh.Points.assign(4, Point{ { 1.0, 2.0, 3.0 } });
  mesh.Add(VTK_CONVEX_POINT_SET, { 0, 1, 2, 3 });
  const auto grid = MakeGrid(mesh);
  vtkNew<vtkGenericCell> cell;
  Closest c;
  MakeLocator(grid)->FindClosestPoint(
    mesh.Points[0].data(), c.X.data(), cell, c.Cell, c.SubId, c.Dist2);
  ASSERT_EQ(c.Cell, 0);
  ExpectCell(cell, grid, 0);
}

TEST_P(ClosestPointOnMesh, AllFormsAgree)
{
  for (Point x : this->Queries(30))
  {
    const Closest expected = FindClosest(this->Locator, x);
    vtkNew<vtkGenericCell> cell;
    Closest c;
    this->Locator->FindClosestPoint(x.data(), c.X.data(), cell, c.Cell, c.SubId, c.Dist2);
    EXPECT_EQ(c, expected);
    c = Closest();
    this->Locator->FindClosestPoint(x.data(), c.X.data(), nullptr, c.Cell, c.SubId, c.Dist2);
    EXPECT_EQ(c, expected);
    c = Closest();
    EXPECT_EQ(this->Locator->FindClosestPointWithinRadius(
                x.data(), Infinity, c.X.data(), c.Cell, c.SubId, c.Dist2),
      1);
    EXPECT_EQ(c, expected);
    c = Closest();
    EXPECT_EQ(this->Locator->FindClosestPointWithinRadius(
                x.data(), Infinity, c.X.data(), cell, c.Cell, c.SubId, c.Dist2),
      1);
    EXPECT_EQ(c, expected);
    EXPECT_EQ(FindWithin(this->Locator, x, Infinity).Answer, expected);
  }
}

TEST_P(ClosestPointOnMesh, LocationIsWhatTheCellFoundSaysOfThePoint)
{
  const auto size = static_cast<std::size_t>(this->Data->GetMaxCellSize());
  for (const Point& x : this->Queries(50))
  {
    const Closest c = FindClosest(this->Locator, x);
    Closest location, evaluated;
    Point pcoords, expected;
    std::vector<double> weights(size), expectedWeights(size);
    location.Cell = this->Locator->FindClosestLocation(x.data(), Infinity, location.X.data(),
      location.SubId, pcoords.data(), location.Dist2, weights.data());
    ASSERT_TRUE(this->Locator->EvaluateCell(c.Cell, x.data(), evaluated.X.data(), evaluated.SubId,
      expected.data(), evaluated.Dist2, expectedWeights.data()));
    evaluated.Cell = c.Cell;
    ASSERT_EQ(location, evaluated);
    ASSERT_EQ(pcoords, expected);
    ASSERT_EQ(weights, expectedWeights);
    ASSERT_EQ(this->Locator->FindClosestLocation(x.data(), -1.0, location.X.data(), location.SubId,
                pcoords.data(), location.Dist2, nullptr),
      -1);
  }
}

TEST_P(ClosestPointOnMesh, WithinRadiusFindsExactlyWhatIsWithin)
{
  for (const Point& x : this->Queries(60))
  {
    const Closest c = FindClosest(this->Locator, x);
    const double distance = std::sqrt(c.Dist2);
    const double margin = 1e-9 * (distance + Scale(this->Reference.GetBounds()));
    const WithinRadius wide = FindWithin(this->Locator, x, distance + margin);
    ASSERT_EQ(wide.Found, 1);
    ASSERT_EQ(wide.Answer, c);
    if (distance > margin)
    {
      ASSERT_EQ(FindWithin(this->Locator, x, distance - margin).Found, 0);
    }
  }
}

TEST_P(ClosestPointOnMesh, PointsOfTheMeshAreAtDistanceZero)
{
  vtkNew<vtkGenericCell> cell;
  for (vtkIdType id = 0; id < this->Data->GetNumberOfCells(); id += 3)
  {
    this->Data->GetCell(id, cell);
    Point x;
    cell->GetPoints()->GetPoint(0, x.data());
    const Closest c = FindClosest(this->Locator, x);
    ASSERT_LE(std::sqrt(c.Dist2), 1e-14 * Scale(this->Reference.GetBounds())) << "cell " << id;
    ASSERT_LE(c.Cell, id) << "ties go to the lowest id";
  }
}

TEST(ClosestPoint, RadiusIsIncluded)
{
  const auto data = MakePolyData(Octahedron(1));
  const auto locator = MakeLocator(data);
  EXPECT_EQ(FindWithin(locator, { 3, 0, 0 }, 2.0).Found, 1);
  EXPECT_EQ(FindWithin(locator, { 3, 0, 0 }, std::nextafter(2.0, 0.0)).Found, 0);
}

TEST(ClosestPoint, RadiusZeroFindsOnlyWhatTouches)
{
  const auto data = MakePolyData(Octahedron(1));
  const auto locator = MakeLocator(data);
  EXPECT_EQ(FindWithin(locator, { 1, 0, 0 }, 0.0).Found, 1);
  EXPECT_EQ(FindWithin(locator, { 1, 1e-9, 0 }, 0.0).Found, 0);
}

TEST(ClosestPoint, NegativeOrNanRadiusFindsNothing)
{
  const auto data = MakePolyData(Octahedron(1));
  const auto locator = MakeLocator(data);
  for (double radius : { -1.0, -Infinity, std::nan("") })
  {
    const WithinRadius w = FindWithin(locator, { 1, 0, 0 }, radius);
    EXPECT_EQ(w.Found, 0) << radius;
    EXPECT_EQ(w.Answer.Cell, -1) << radius;
  }
}

TEST(ClosestPoint, TiesGoToTheLowestId)
{
  Mesh mesh = Octahedron(1);
  const auto cells = mesh.Cells;
  mesh.Cells.insert(mesh.Cells.end(), cells.begin(), cells.end()); // every triangle twice
  const auto data = MakePolyData(mesh);
  const auto locator = MakeLocator(data);
  EXPECT_EQ(FindClosest(locator, { 3, 0, 0 }).Cell, 0);
  EXPECT_EQ(FindClosest(locator, { -3, 0, 0 }).Cell, 1);
  EXPECT_EQ(FindClosest(locator, { 0, -3, 0 }).Cell, 2);
  EXPECT_EQ(FindClosest(locator, { 0, 0, -3 }).Cell, 4);
  EXPECT_EQ(FindClosest(locator, { -3, -3, -3 }).Cell, 7);
}

TEST(ClosestPoint, InsideTellsWhetherThePointProjectsIntoTheCell)
{
  const auto data = MakeGrid(Sheet(1, VTK_QUAD));
  const auto locator = MakeLocator(data);
  EXPECT_EQ(FindWithin(locator, { 0.5, 0.5, 3 }, Infinity).Inside, 1);
  EXPECT_EQ(FindWithin(locator, { 2, 0.5, 0 }, Infinity).Inside, 0);
  const auto cube = MakeGrid(Hexahedra(1));
  const auto solid = MakeLocator(cube);
  EXPECT_EQ(FindWithin(solid, { 0.5, 0.25, 0.5 }, Infinity).Inside, 1);
  EXPECT_EQ(FindWithin(solid, { 0.5, 0.25, 1.5 }, Infinity).Inside, 0);
}

TEST(ClosestPoint, InsideAVolumeCellTheDistanceIsZero)
{
  const auto data = MakeGrid(Tetrahedra(2));
  const auto locator = MakeLocator(data);
  const Point x = { 0.3, 1.2, 0.9 };
  const Closest c = FindClosest(locator, x);
  EXPECT_EQ(c.Dist2, 0.0);
  EXPECT_EQ(c.X, x);
}

TEST(ClosestPoint, SubIdNamesThePieceOfAPolyLineOrStrip)
{
  Mesh line;
  line.Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 3, 0, 0 } };
  line.Add(VTK_POLY_LINE, { 0, 1, 2, 3 });
  const auto polyline = MakePolyData(line);
  EXPECT_EQ(FindClosest(MakeLocator(polyline), { 2.5, 1, 0 }).SubId, 2);
  const auto strip = MakePolyData(Strips(4));
  const Closest c = FindClosest(MakeLocator(strip), { 2.9, 0.9, 0.2 });
  EXPECT_EQ(c.Cell, 0);
  EXPECT_EQ(c.SubId, 5);
}

TEST(ClosestPoint, AnswersThroughTheAbstractClass)
{
  const auto data = MakePolyData(Octahedron(1));
  const auto locator = MakeLocator(data);
  vtkAbstractCellLocator* abstract = locator;
  const Point x = { 3, 0, 0 };
  Closest c;
  abstract->FindClosestPoint(x.data(), c.X.data(), c.Cell, c.SubId, c.Dist2);
  EXPECT_EQ(c, FindClosest(locator, x));
  EXPECT_EQ(c.Dist2, 4.0);
}

TEST(ClosestPoint, FarQueriesAreAsRightAsNearOnes)
{
  const auto data = MakePolyData(SphereTriangles(8));
  const auto locator = MakeLocator(data);
  BruteForce reference(data);
  Random random(5);
  for (double factor : { 1e3, 1e6, 1e9, 1e100 })
  {
    const Point x = factor * random.Direction();
    const double expected = reference.FindNearest(x).Distance;
    EXPECT_NEAR(std::sqrt(FindClosest(locator, x).Dist2) / expected, 1.0, 1e-14) << factor;
  }
}

}
