// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// Every cell type that VTK has, straight and bent, through every kind of query.

#include "Support/BruteForce.h"
#include "Support/FetchCell.h"
#include "Support/LocatorCalls.h"
#include "Support/ParametricReference.h"

#include <gtest/gtest.h>

using namespace skdtest;

namespace
{

struct CellCase
{
  int Type;
  int Order; // of Lagrange and Bezier cells
  bool IsBent;
};

void PrintTo(const CellCase& c, std::ostream* os)
{
  *os << NameOfType(c.Type);
}

std::vector<CellCase> CellCases()
{
  std::vector<CellCase> cases;
  for (int type : AllCellTypes())
  {
    const bool isAligned = type == VTK_VOXEL || type == VTK_PIXEL;
    for (int order = 1; order <= (IsHigherOrder(type) ? HighestOrder() : 1); ++order)
    {
      if (order < 4) // a straight cell of order 4 has the map of one of order 3
      {
        cases.push_back({ type, order, false });
      }
      if (!isAligned)
      {
        cases.push_back({ type, order, true });
      }
    }
  }
  return cases;
}

std::string NameOfCase(const testing::TestParamInfo<CellCase>& info)
{
  const CellCase& c = info.param;
  return NameOfType(c.Type) + (IsHigherOrder(c.Type) ? "Order" + std::to_string(c.Order) : "") +
    (c.IsBent ? "Bent" : "");
}

// Of a polyhedron the faces have to stay planar.
Point Placement(const CellCase& c, const Point& p)
{
  return !c.IsBent ? p : c.Type == VTK_POLYHEDRON || c.Type == VTK_POLYGON ? Rotated(p) : Bent(p);
}

Point Middle(const std::vector<Point>& points)
{
  Point sum = { 0, 0, 0 };
  for (const Point& p : points)
  {
    sum = sum + p;
  }
  return (1.0 / double(points.size())) * sum;
}

class CellTypes : public testing::TestWithParam<CellCase>
{
protected:
  CellTypes()
    : Data(MakeGrid(Block(ReferenceCell(GetParam().Type, GetParam().Order),
        [](const Point& p) { return Placement(GetParam(), p); })))
    , Locator(MakeLocator(this->Data))
    , Reference(this->Data)
  {
  }

  bool IsEmpty() const { return GetParam().Type == VTK_EMPTY_CELL; }
  double Size() const { return Scale(this->Reference.GetBounds()); }

  Point Query(Random& random) { return random.InBox(Grown(this->Reference.GetBounds(), 0.7)); }

  /// Where VTK puts the middle of a cell, or, given parametric coordinates, that point of it.
  Point PointOf(vtkIdType id, const double* at = nullptr)
  {
    vtkNew<vtkGenericCell> cell; // a new one each time: polyhedra remember the cell before
    FetchCell(this->Data, id, cell);
    if (GetParam().Type == VTK_CONVEX_POINT_SET)
    {
      return Middle(ToVector(cell->GetPoints())); // VTK takes a place outside of its first piece
    }
    Point x, pcoords;
    int subId = cell->GetParametricCenter(pcoords.data());
    std::vector<double> weights(cell->GetNumberOfPoints());
    cell->EvaluateLocation(subId, at ? at : pcoords.data(), x.data(), weights.data());
    return x;
  }

  bool HasReference() const
  {
    const bool isTwisted = GetParam().IsBent &&
      (GetParam().Type == VTK_PENTAGONAL_PRISM || GetParam().Type == VTK_HEXAGONAL_PRISM ||
        GetParam().Type == VTK_CONVEX_POINT_SET || GetParam().Type == VTK_QUADRATIC_POLYGON);
    return !this->IsEmpty() && !isTwisted;
  }

  /// Parametric coordinates of a point inside every cell.
  static Point Inner()
  {
    const bool isRaised = DomainOf(GetParam().Type) == Domain::Pyramid;
    return { 0.31, 0.27, isRaised ? 0.63 : 0.23 };
  }

  /// By the cell's faces, or by its parametric coordinates, or by its box that it fills.
  double DistanceTo(vtkIdType id, const Point& x)
  {
    if (GetParam().Type == VTK_CONVEX_POINT_SET || GetParam().Type == VTK_QUADRATIC_POLYGON)
    {
      return Distance(this->Reference.Box(id), x);
    }
    if (DomainOf(GetParam().Type) == Domain::None)
    {
      return this->Reference.DistanceTo(id, x);
    }
    vtkNew<vtkGenericCell> cell;
    FetchCell(this->Data, id, cell);
    return ParametricCell(cell->GetRepresentativeCell()).DistanceTo(x);
  }

  double LeastDistance(const Point& x)
  {
    double least = std::numeric_limits<double>::infinity();
    for (vtkIdType id : this->Reference.GetCells())
    {
      // A curved cell may bulge out of the box of its points.
      const Bounds& box = this->Reference.Box(id);
      if (Distance(Grown(box, 0.3 * Diagonal(box)), x) <= least)
      {
        least = std::min(least, this->DistanceTo(id, x));
      }
    }
    return least;
  }

  GridPointer Data;
  LocatorPointer Locator;
  BruteForce Reference;
};

INSTANTIATE_TEST_SUITE_P(All, CellTypes, testing::ValuesIn(CellCases()), NameOfCase);

TEST_P(CellTypes, AreInTheTreeUnlessEmpty)
{
  EXPECT_EQ(this->Locator->GetNumberOfCellsInTree(), this->IsEmpty() ? 0 : 8);
  EXPECT_EQ(this->Locator->GetNumberOfCellsLeftOut(), this->IsEmpty() ? 8 : 0);
}

TEST_P(CellTypes, ClosestPointIsNoFartherThanAnyPointOfTheCells)
{
  if (!this->HasReference())
  {
    GTEST_SKIP() << "no reference";
  }
  Random random(130);
  for (int i = 0; i < 6; ++i)
  {
    const Point x = this->Query(random);
    const Closest c = FindClosest(this->Locator, x);
    ASSERT_GE(c.Cell, 0);
    ASSERT_NEAR(std::sqrt(c.Dist2), this->LeastDistance(x), 1e-6 * this->Size());
  }
}

TEST_P(CellTypes, ClosestPointIsAtItsDistance)
{
  Random random(136);
  for (int i = 0; i < 40; ++i)
  {
    const Point x = this->Query(random);
    const Closest c = FindClosest(this->Locator, x);
    ASSERT_EQ(c.Cell < 0, this->IsEmpty());
    if (c.Cell >= 0)
    {
      ASSERT_NEAR(std::sqrt(c.Dist2), Distance(c.X, x), 1e-9 * this->Size());
    }
  }
}

TEST_P(CellTypes, ClosestPointLiesOnItsCell)
{
  if (!this->HasReference())
  {
    GTEST_SKIP() << "no reference";
  }
  Random random(131);
  for (int i = 0; i < 6; ++i)
  {
    const Closest c = FindClosest(this->Locator, this->Query(random));
    ASSERT_LE(this->DistanceTo(c.Cell, c.X), 1e-6 * this->Size()) << "cell " << c.Cell;
  }
}

TEST_P(CellTypes, PointsOfTheCellAreAtNoDistance)
{
  if (!this->HasReference() || DomainOf(GetParam().Type) == Domain::None)
  {
    GTEST_SKIP() << "no parametric coordinates";
  }
  const Point inner = this->Inner();
  for (vtkIdType id : this->Reference.GetCells())
  {
    const Closest c = FindClosest(this->Locator, this->PointOf(id, inner.data()));
    ASSERT_LE(std::sqrt(c.Dist2), 1e-6 * this->Size()) << "cell " << id;
  }
}

TEST_P(CellTypes, TheMiddleOfAVolumeIsFoundInIt)
{
  if (DimensionOf(GetParam().Type) != 3)
  {
    GTEST_SKIP() << "not a volume";
  }
  vtkNew<vtkGenericCell> cell;
  for (vtkIdType id : this->Reference.GetCells())
  {
    const Point x = this->PointOf(id);
    const Found f = FindCell(this->Locator, x);
    ASSERT_EQ(f.Cell, id);
    Point sum = { 0, 0, 0 };
    FetchCell(this->Data, id, cell);
    const auto points = ToVector(cell->GetPoints());
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      sum = sum + f.Weights[i] * points[i];
    }
    ASSERT_LE(Distance(sum, x), 1e-6 * this->Size()) << "cell " << id;
  }
}

TEST_P(CellTypes, FarOutsideNoCellIsFound)
{
  EXPECT_EQ(FindCell(this->Locator, { 50, 50, 50 }).Cell, -1);
  EXPECT_EQ(FindCell(this->Locator, { 50, 50, 50 }, 1e6).Cell < 0, this->IsEmpty());
}

TEST_P(CellTypes, ALineThroughTheMiddleHits)
{
  if (DimensionOf(GetParam().Type) < 2)
  {
    GTEST_SKIP() << "not a surface or volume";
  }
  Random random(132);
  vtkNew<vtkGenericCell> cell;
  for (vtkIdType id : this->Reference.GetCells())
  {
    const Point inner = this->Inner();
    const Point x = this->PointOf(id, inner.data());
    const Point along = 6.0 * random.Direction();
    const LineHits hits = FindAllHits(this->Locator, x - along, x + along, 1e-6, cell);
    ASSERT_EQ(hits.Found, 1) << "cell " << id;
    ASSERT_NE(std::find(hits.Cells.begin(), hits.Cells.end(), id), hits.Cells.end());
    ASSERT_EQ(FindFirstHit(this->Locator, x - along, x + along, 1e-6).Cell, hits.Cells[0]);
  }
}

TEST_P(CellTypes, WithinBoundsAreThoseWhoseBoundsOverlap)
{
  Random random(133);
  for (int i = 0; i < 30; ++i)
  {
    const Bounds box = BoxOf(this->Query(random), this->Query(random));
    ASSERT_EQ(FindWithinBounds(this->Locator, box), this->Reference.FindWithinBounds(box));
  }
}

TEST_P(CellTypes, NeighboursAreInOrder)
{
  Random random(134);
  const int number = GetParam().Order < 3 ? 10 : 2; // evaluating the others is expensive
  for (int i = 0; i < number; ++i)
  {
    const Point x = this->Query(random);
    const Ranked r = FindClosestCells(this->Locator, x, 100);
    ASSERT_EQ(r.Number, this->Locator->GetNumberOfCellsInTree());
    ASSERT_TRUE(std::is_sorted(r.Distances.begin(), r.Distances.end()));
    for (std::size_t k = 0; k < r.Cells.size(); ++k)
    {
      const Ranked within = FindWithinRadius(this->Locator, x, r.Distances[k] + 1e-9);
      ASSERT_GT(within.Number, vtkIdType(k));
    }
  }
}

TEST_P(CellTypes, EveryOtherQueryIsHarmless)
{
  Random random(135);
  vtkNew<vtkIdList> ids, others;
  for (int i = 0; i < 10; ++i)
  {
    const Point x = this->Query(random);
    const Point y = this->Query(random);
    FindCrossings(this->Locator, x, y);
    this->Locator->CountCrossings(x.data(), y.data());
    FindAlongPlane(this->Locator, x, y);
    FindAlongLine(this->Locator, x, y, 0.1);
    FindFirstHit(this->Locator, x, y, 0.1);
    FindCell(this->Locator, x, 0.5);
    this->Locator->FindClosestCandidates(x.data(), ids);
    EXPECT_EQ(ids->GetNumberOfIds() == 0, this->IsEmpty());
  }
  EXPECT_EQ(this->Locator->FindOverlappingPairs(this->Locator, ids, others) == 0, this->IsEmpty());
}

TEST(CellTypesOf, VtkAreAllTried)
{
  // 0-3, 4-16, 21-37, 41, 42 and the Lagrange and Bezier ones without pyramids.
  EXPECT_GE(AllCellTypes().size(), 48u);
}

}
