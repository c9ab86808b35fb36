// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// SetTransform: a moved set has the results of the mesh with moved points.

#include "Support/BruteForce.h"
#include "Support/EventCounter.h"
#include "Support/LocatorCalls.h"
#include "Support/NamedMeshes.h"
#include "Support/RigidMatrix.h"

#include "vtkMatrix4x4.h"

#include <gtest/gtest.h>

using namespace skdtest;

namespace
{

const Point Shift = { 4, -2.5, 1 };

Point Move(const Point& p)
{
  return Rotated(p) + Shift;
}

struct MovableMesh
{
  const char* Name;
  std::function<Mesh()> Make;
  friend void PrintTo(const MovableMesh& mesh, std::ostream* os) { *os << mesh.Name; }
};

std::vector<MovableMesh> MovableMeshes()
{
  return { { "Vertices", [] { return Cloud(200, VTK_VERTEX); } },
    { "Lines", [] { return Helix(150, VTK_LINE); } },
    { "Triangles", [] { return SphereTriangles(8); } }, { "Quads", [] { return SphereQuads(6); } },
    { "Polygons", [] { return Hexagons(6); } }, { "Tetrahedra", [] { return Tetrahedra(3); } },
    { "Hexahedra", [] { return Hexahedra(4).Map(Bent); } }, { "Wedges", [] { return Wedges(3); } },
    { "Pyramids", [] { return Pyramids(3); } }, { "Polyhedra", [] { return Polyhedra(2); } } };
}

/// One locator with a motion, one on the mesh that was really moved.
class MovedSet : public testing::TestWithParam<MovableMesh>
{
protected:
  MovedSet()
    : Data(MakeGrid(GetParam().Make()))
    , MovedData(MakeGrid(GetParam().Make().Map(Move)))
    , Locator(MakeLocator(this->Data))
    , Expected(MakeLocator(this->MovedData))
    , Reference(this->MovedData)
  {
    this->Locator->SetTransform(RigidMatrix(Shift));
  }

  Point Query(Random& random)
  {
    const Bounds& box = this->Reference.GetBounds();
    return random.InBox(Grown(box, 0.1 * Diagonal(box)));
  }

  double Tolerance() const { return 1e-12 * Scale(this->Reference.GetBounds()); }

  GridPointer Data;
  GridPointer MovedData;
  LocatorPointer Locator;
  LocatorPointer Expected;
  BruteForce Reference;
};

INSTANTIATE_TEST_SUITE_P(All, MovedSet, testing::ValuesIn(MovableMeshes()), NameOfMesh());

TEST_P(MovedSet, HasTheSameClosestPoints)
{
  Random random(110);
  for (int i = 0; i < 100; ++i)
  {
    const Point x = this->Query(random);
    const Closest c = FindClosest(this->Locator, x);
    const Closest e = FindClosest(this->Expected, x);
    ASSERT_NEAR(std::sqrt(c.Dist2), std::sqrt(e.Dist2), this->Tolerance());
    ASSERT_NEAR(Distance(c.X, x), std::sqrt(c.Dist2), this->Tolerance());
    ASSERT_LE(this->Reference.DistanceTo(c.Cell, c.X), 1e-9 * Scale(this->Reference.GetBounds()));
  }
}

TEST_P(MovedSet, HasTheSameHits)
{
  Random random(111);
  vtkNew<vtkGenericCell> cell;
  const double tol = this->Data->GetCell(0)->GetCellDimension() < 2 ? 0.05 : 0.0;
  for (int i = 0; i < 100; ++i)
  {
    const Bounds& box = this->Reference.GetBounds();
    const Point through = random.InBox(box);
    const Point along = 2 * Diagonal(box) * random.Direction();
    const Point p1 = through - along;
    const Point p2 = through + along;
    const LineHit h = FindFirstHit(this->Locator, p1, p2, tol);
    const LineHit e = FindFirstHit(this->Expected, p1, p2, tol);
    ASSERT_EQ(h.Found, e.Found);
    ASSERT_EQ(h.Cell, e.Cell);
    const LineHits all = FindAllHits(this->Locator, p1, p2, tol, cell);
    const LineHits expected = FindAllHits(this->Expected, p1, p2, tol, cell);
    ASSERT_EQ(Ids(all.Cells).size(), expected.Cells.size());
    if (h.Found)
    {
      ASSERT_NEAR(h.T, e.T, 1e-9);
      ASSERT_LE(Distance(h.X, e.X), 1e-8);
      ASSERT_LE(Distance(all.Points.back(), expected.Points.back()), 1e-8);
    }
  }
}

TEST_P(MovedSet, HasTheSameCells)
{
  Random random(112);
  for (int i = 0; i < 100; ++i)
  {
    const Point x = this->Query(random);
    for (double tol2 : { 0.0, 0.3 })
    {
      const Found f = FindCell(this->Locator, x, tol2);
      const Found e = FindCell(this->Expected, x, tol2);
      ASSERT_EQ(f.Cell < 0, e.Cell < 0);
      if (f.Cell >= 0)
      {
        ASSERT_NEAR(this->Reference.DistanceTo(f.Cell, x), this->Reference.DistanceTo(e.Cell, x),
          this->Tolerance());
      }
      if (f.Cell >= 0 && f.Cell == e.Cell && tol2 == 0.0)
      {
        ASSERT_LE(Distance(f.Pcoords, e.Pcoords), 1e-9);
      }
    }
  }
}

TEST_P(MovedSet, HasTheSameCellsWithinBounds)
{
  Random random(113);
  for (int i = 0; i < 100; ++i)
  {
    const Bounds box = BoxOf(this->Query(random), this->Query(random));
    ASSERT_EQ(FindWithinBounds(this->Locator, box), FindWithinBounds(this->Expected, box));
  }
}

TEST_P(MovedSet, HasTheSameCellsAlongLinesAndPlanes)
{
  Random random(114);
  for (int i = 0; i < 100; ++i)
  {
    const Point a = this->Query(random);
    const Point b = this->Query(random);
    Ids line = FindAlongLine(this->Locator, a, b, 0.01);
    Ids expected = FindAlongLine(this->Expected, a, b, 0.01);
    std::sort(line.begin(), line.end());
    std::sort(expected.begin(), expected.end());
    ASSERT_EQ(line, expected);
    ASSERT_EQ(FindAlongPlane(this->Locator, a, b - a, 0.01),
      FindAlongPlane(this->Expected, a, b - a, 0.01));
  }
}

TEST_P(MovedSet, HasTheSameCellBounds)
{
  Random random(115);
  for (vtkIdType cell = 0; cell < this->Data->GetNumberOfCells(); ++cell)
  {
    const Bounds& box = this->Reference.Box(cell);
    Point x = random.InBox(Grown(box, 0.2 * Diagonal(box)));
    ASSERT_EQ(this->Locator->InsideCellBounds(x.data(), cell), Contains(box, x));
  }
}

TEST_P(MovedSet, HasTheSameNeighbours)
{
  Random random(116);
  for (int i = 0; i < 20; ++i)
  {
    const Point x = this->Query(random);
    const Ranked r = FindClosestCells(this->Locator, x, 10);
    const Ranked e = FindClosestCells(this->Expected, x, 10);
    ASSERT_EQ(r.Number, e.Number);
    for (std::size_t k = 0; k < r.Distances.size(); ++k)
    {
      ASSERT_NEAR(r.Distances[k], e.Distances[k], this->Tolerance());
    }
    const double radius = random.Between(0.2, 1.5);
    ASSERT_EQ(FindWithinRadius(this->Locator, x, radius).Cells,
      FindWithinRadius(this->Expected, x, radius).Cells);
  }
}

TEST_P(MovedSet, HasCandidatesThatHoldTheAnswers)
{
  Random random(117);
  vtkNew<vtkIdList> ids;
  for (int i = 0; i < 50; ++i)
  {
    const Point x = this->Query(random);
    const Point y = this->Query(random);
    const auto covers = [&ids](const Ids& exact)
    {
      const Ids candidates = Sorted(ToVector(ids));
      return std::includes(candidates.begin(), candidates.end(), exact.begin(), exact.end());
    };
    this->Locator->FindClosestCandidates(x.data(), ids);
    ASSERT_TRUE(covers({ FindClosest(this->Expected, x).Cell }));
    this->Locator->FindCandidatesWithinRadius(x.data(), 0.7, ids);
    ASSERT_TRUE(covers(FindWithinRadius(this->Expected, x, 0.7).Cells));
    this->Locator->FindCandidatesAlongPlane(x.data(), y.data(), ids);
    for (vtkIdType cell : FindAlongPlane(this->Expected, x, y))
    {
      // The moved boxes are turned: they may be missed where only the box of the moved cell is met.
      ASSERT_TRUE(ids->IsId(cell) >= 0 || this->Data->GetCell(cell)->GetNumberOfPoints() > 1);
    }
    vtkNew<vtkGenericCell> cell;
    this->Locator->FindCandidatesAlongLine(x.data(), y.data(), ids);
    Ids hits = FindAllHits(this->Expected, x, y, 0.0, cell).Cells;
    std::sort(hits.begin(), hits.end());
    ASSERT_TRUE(covers(hits));
  }
}

TEST_P(MovedSet, HandsOutMovedCells)
{
  Random random(118);
  vtkNew<vtkGenericCell> cell, expected;
  const Point x = this->Query(random);
  Closest c;
  this->Locator->FindClosestPoint(x.data(), c.X.data(), cell, c.Cell, c.SubId, c.Dist2);
  this->MovedData->GetCell(c.Cell, expected);
  ASSERT_EQ(ToVector(cell->GetPointIds()), ToVector(expected->GetPointIds()));
  for (vtkIdType i = 0; i < cell->GetNumberOfPoints(); ++i)
  {
    Point a, b;
    cell->GetPoints()->GetPoint(i, a.data());
    expected->GetPoints()->GetPoint(i, b.data());
    ASSERT_LE(Distance(a, b), this->Tolerance());
  }
}

class Transform : public testing::Test
{
protected:
  PolyDataPointer Data = MakePolyData(SphereTriangles(6));
  LocatorPointer Locator = MakeLocator(Data);

  /// Whether a change of one element of the identity is refused, with one error.
  bool IsRefused(int row, int column, double value)
  {
    this->Locator->SetTransform(RigidMatrix(Shift));
    EventCounter events(this->Locator);
    vtkNew<vtkMatrix4x4> matrix;
    matrix->SetElement(row, column, value);
    this->Locator->SetTransform(matrix);
    EXPECT_LE(events.Errors, 1);
    const bool kept =
      this->Locator->GetTransform() && this->Locator->GetTransform()->GetElement(0, 3) == Shift[0];
    EXPECT_EQ(events.Errors == 1, kept) << "an error, and the former motion stays";
    return events.Errors == 1;
  }
};

TEST_F(Transform, IsNoneAtFirst)
{
  EXPECT_EQ(this->Locator->GetTransform(), nullptr);
}

TEST_F(Transform, OfNoneBringsTheSetBack)
{
  const Point x = { 3, 2, 1 };
  const Closest before = FindClosest(this->Locator, x);
  this->Locator->SetTransform(RigidMatrix(Shift));
  EXPECT_NE(FindClosest(this->Locator, x).Dist2, before.Dist2);
  this->Locator->SetTransform(nullptr);
  EXPECT_EQ(this->Locator->GetTransform(), nullptr);
  EXPECT_EQ(FindClosest(this->Locator, x), before);
}

TEST_F(Transform, DoesNotRebuildTheTree)
{
  const vtkMTimeType built = this->Locator->GetBuildTime();
  this->Locator->SetTransform(RigidMatrix(Shift));
  this->Locator->BuildLocator();
  FindClosest(this->Locator, { 1, 2, 3 });
  EXPECT_EQ(this->Locator->GetBuildTime(), built);
}

TEST_F(Transform, IsCopied)
{
  const auto motion = RigidMatrix(Shift);
  this->Locator->SetTransform(motion);
  const Closest before = FindClosest(this->Locator, { 1, 2, 3 });
  motion->SetElement(0, 3, 1000);
  EXPECT_EQ(FindClosest(this->Locator, { 1, 2, 3 }), before);
  EXPECT_EQ(this->Locator->GetTransform()->GetElement(0, 3), Shift[0]);
}

TEST_F(Transform, SetBeforeTheBuildIsUsed)
{
  const auto locator = LocatorPointer::New();
  locator->SetTransform(RigidMatrix(Shift));
  locator->SetDataSet(this->Data);
  locator->BuildLocator();
  this->Locator->SetTransform(RigidMatrix(Shift));
  EXPECT_EQ(FindClosest(locator, { 1, 2, 3 }), FindClosest(this->Locator, { 1, 2, 3 }));
}

TEST_F(Transform, AReflectionKeepsDistancesAndIsTaken)
{
  vtkNew<vtkMatrix4x4> mirror;
  mirror->SetElement(0, 0, -1);
  mirror->SetElement(0, 3, 10);
  EventCounter events(this->Locator);
  this->Locator->SetTransform(mirror);
  EXPECT_EQ(events.Errors, 0);
  EXPECT_NEAR(FindClosest(this->Locator, { 10, 0, 5 }).Dist2, 16.0, 0.5);
}

TEST_F(Transform, ThatScalesIsRefused)
{
  EXPECT_TRUE(this->IsRefused(0, 0, 2.0));
  EXPECT_TRUE(this->IsRefused(2, 2, 1.0 + 1e-7));
}

TEST_F(Transform, ThatShearsIsRefused)
{
  EXPECT_TRUE(this->IsRefused(0, 1, 0.5));
}

TEST_F(Transform, WithPerspectiveIsRefused)
{
  EXPECT_TRUE(this->IsRefused(3, 0, 0.1));
  EXPECT_TRUE(this->IsRefused(3, 3, 2.0));
}

TEST_F(Transform, ThatIsNotFiniteIsRefused)
{
  EXPECT_TRUE(this->IsRefused(0, 0, std::nan("")));
  EXPECT_TRUE(this->IsRefused(1, 3, std::numeric_limits<double>::infinity()));
}

TEST_F(Transform, WithinRoundingOfRigidIsTaken)
{
  EXPECT_FALSE(this->IsRefused(0, 0, 1.0 + 1e-12));
}

}
