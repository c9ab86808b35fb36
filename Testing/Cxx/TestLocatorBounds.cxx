// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// Queries of the cells' bounds: FindCellsWithinBounds, FindCellsAlongPlane, InsideCellBounds.
// (FindCellsAlongLine is tested with the all-hits forms of IntersectWithLine.)

#include "Support/LocatorOnMesh.h"

#include <gtest/gtest.h>

using namespace skdtest;

namespace
{

class BoundsOfMesh : public LocatorOnMesh
{
protected:
  Bounds RandomBox(Random& random, double size)
  {
    const Bounds& whole = this->Reference.GetBounds();
    Bounds box = EmptyBounds();
    const Point corner = random.InBox(Grown(whole, 0.1 * Diagonal(whole)));
    Extend(box, corner);
    Extend(box, corner + size * Diagonal(whole) * random.Direction());
    return box;
  }

  /// Cells whose box comes within tol of the plane.
  Ids AlongPlane(const Point& o, const Point& n, double tol)
  {
    Ids cells;
    for (vtkIdType cell : this->Reference.GetCells())
    {
      const Bounds& box = this->Reference.Box(cell);
      const Point center = Center(box) - o;
      double maxDistance = tol * Length(n);
      for (int axis = 0; axis < 3; ++axis)
      {
        maxDistance += 0.5 * (box[2 * axis + 1] - box[2 * axis]) * std::abs(n[axis]);
      }
      if (std::abs(Dot(center, n)) <= maxDistance)
      {
        cells.push_back(cell);
      }
    }
    return cells;
  }
};

INSTANTIATE_TEST_SUITE_P(All, BoundsOfMesh, testing::ValuesIn(AllMeshes()), NameOfMesh());

TEST_P(BoundsOfMesh, WithinBoundsAreExactlyThoseThatOverlap)
{
  Random random(70);
  for (int i = 0; i < 200; ++i)
  {
    const Bounds box = this->RandomBox(random, 0.05 * (i % 10));
    ASSERT_EQ(FindWithinBounds(this->Locator, box), this->Reference.FindWithinBounds(box));
  }
}

TEST_P(BoundsOfMesh, WithinBoundsCountsCellsThatOnlyTouch)
{
  for (vtkIdType cell : this->Reference.GetCells())
  {
    const Bounds& b = this->Reference.Box(cell);
    const Bounds corner = { b[1], b[1] + 1, b[3], b[3] + 1, b[5], b[5] + 1 };
    ASSERT_EQ(FindWithinBounds(this->Locator, corner), this->Reference.FindWithinBounds(corner));
    const Bounds point = { b[0], b[0], b[2], b[2], b[4], b[4] };
    ASSERT_EQ(FindWithinBounds(this->Locator, point), this->Reference.FindWithinBounds(point));
    const Bounds beside = { std::nextafter(b[1], 1e300), b[1] + 1, b[2], b[3], b[4], b[5] };
    ASSERT_EQ(FindWithinBounds(this->Locator, beside), this->Reference.FindWithinBounds(beside));
  }
}

TEST_P(BoundsOfMesh, WithinTheWholeBoundsAreAllCells)
{
  EXPECT_EQ(
    FindWithinBounds(this->Locator, this->Reference.GetBounds()), this->Reference.GetCells());
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(FindWithinBounds(this->Locator, { -inf, inf, -inf, inf, -inf, inf }),
    this->Reference.GetCells());
}

TEST_P(BoundsOfMesh, AlongPlaneAreThoseWhoseBoundsItMeets)
{
  Random random(71);
  const double slack = 1e-13 * Scale(this->Reference.GetBounds());
  for (double tol : { 0.0, 0.05 })
  {
    for (int i = 0; i < 60; ++i)
    {
      const Point o = random.InBox(this->Reference.GetBounds());
      const Point n = random.Between(0.01, 100) * random.Direction();
      const Ids cells = FindAlongPlane(this->Locator, o, n, tol);
      const Ids sure = this->AlongPlane(o, n, tol - slack);
      const Ids possible = this->AlongPlane(o, n, tol + slack);
      ASSERT_EQ(std::adjacent_find(cells.begin(), cells.end()), cells.end()) << "a cell twice";
      ASSERT_TRUE(std::includes(cells.begin(), cells.end(), sure.begin(), sure.end()));
      ASSERT_TRUE(std::includes(possible.begin(), possible.end(), cells.begin(), cells.end()));
    }
  }
}

TEST_P(BoundsOfMesh, InsideCellBoundsIsInsideTheBoxOfThatCell)
{
  Random random(72);
  for (vtkIdType cell : this->Reference.GetCells())
  {
    const Bounds& box = this->Reference.Box(cell);
    for (int i = 0; i < 3; ++i)
    {
      Point x = random.InBox(Grown(box, 0.2 * Diagonal(box)));
      ASSERT_EQ(this->Locator->InsideCellBounds(x.data(), cell), Contains(box, x));
    }
    Point corner = { box[1], box[3], box[4] };
    ASSERT_TRUE(this->Locator->InsideCellBounds(corner.data(), cell)) << "bounds are included";
  }
}

TEST_P(BoundsOfMesh, CachedBoundsGiveTheSameAnswers)
{
  const auto cached = LocatorPointer::New();
  cached->SetDataSet(this->Data);
  cached->CacheCellBoundsOn();
  cached->BuildLocator();
  this->Locator->CacheCellBoundsOff();
  this->Locator->BuildLocator();
  Random random(73);
  for (int i = 0; i < 100; ++i)
  {
    const Bounds box = this->RandomBox(random, 0.1);
    ASSERT_EQ(FindWithinBounds(cached, box), FindWithinBounds(this->Locator, box));
    Point x = Center(box);
    ASSERT_EQ(FindClosest(cached, x), FindClosest(this->Locator, x));
    ASSERT_EQ(FindCell(cached, x), FindCell(this->Locator, x));
    const Point end = { box[1], box[3], box[5] };
    ASSERT_EQ(FindFirstHit(cached, x, end), FindFirstHit(this->Locator, x, end));
    const vtkIdType cell = random.Index(int(this->Data->GetNumberOfCells()));
    ASSERT_EQ(
      cached->InsideCellBounds(x.data(), cell), this->Locator->InsideCellBounds(x.data(), cell));
  }
}

TEST_P(BoundsOfMesh, TheOrderIsTheSameEveryTime)
{
  Random random(74);
  vtkNew<vtkIdList> first, second;
  const auto again = MakeLocator(this->Data);
  for (int i = 0; i < 20; ++i)
  {
    Bounds box = this->RandomBox(random, 0.3);
    this->Locator->FindCellsWithinBounds(box.data(), first);
    again->FindCellsWithinBounds(box.data(), second);
    ASSERT_EQ(ToVector(first), ToVector(second));
    const Point o = Center(box);
    const Point n = random.Direction();
    this->Locator->FindCellsAlongPlane(o.data(), n.data(), 0.0, first);
    again->FindCellsAlongPlane(o.data(), n.data(), 0.0, second);
    ASSERT_EQ(ToVector(first), ToVector(second));
  }
}

TEST(BoundsQueries, InsideCellBoundsOfNoCellIsFalse)
{
  const auto data = MakeGrid(Hexahedra(2));
  const auto locator = MakeLocator(data);
  Point x = { 0.5, 0.5, 0.5 };
  EXPECT_TRUE(locator->InsideCellBounds(x.data(), 0));
  EXPECT_FALSE(locator->InsideCellBounds(x.data(), -1));
  EXPECT_FALSE(locator->InsideCellBounds(x.data(), 8));
}

TEST(BoundsQueries, CacheCellBoundsIsOffAtFirst)
{
  EXPECT_FALSE(LocatorPointer::New()->GetCacheCellBounds());
}

TEST(BoundsQueries, APlaneThroughLatticeFacesMeetsBothSides)
{
  const auto data = MakeGrid(Hexahedra(4));
  const auto locator = MakeLocator(data);
  EXPECT_EQ(FindAlongPlane(locator, { 0, 0, 2 }, { 0, 0, 5 }).size(), 32u);
  EXPECT_EQ(FindAlongPlane(locator, { 0, 0, 2.5 }, { 0, 0, -1 }).size(), 16u);
  EXPECT_EQ(FindAlongPlane(locator, { 0, 0, 5 }, { 0, 0, 1 }).size(), 0u);
  EXPECT_EQ(FindAlongPlane(locator, { 0, 0, 5 }, { 0, 0, 1 }, 1.0).size(), 16u);
}

TEST(BoundsQueries, AreEmptiedOfFormerContents)
{
  const auto data = MakeGrid(Hexahedra(2));
  const auto locator = MakeLocator(data);
  vtkNew<vtkIdList> ids;
  Bounds far = { 50, 51, 50, 51, 50, 51 };
  const Point p1 = { 50, 50, 50 };
  const Point p2 = { 51, 50, 50 };
  ids->InsertNextId(3);
  locator->FindCellsWithinBounds(far.data(), ids);
  EXPECT_EQ(ids->GetNumberOfIds(), 0);
  ids->InsertNextId(3);
  locator->FindCellsAlongLine(p1.data(), p2.data(), 0.0, ids);
  EXPECT_EQ(ids->GetNumberOfIds(), 0);
  ids->InsertNextId(3);
  locator->FindCellsAlongPlane(p1.data(), p2.data(), 0.0, ids);
  EXPECT_EQ(ids->GetNumberOfIds(), 0);
}

}
