// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// FindClosestCells and FindCellsWithinRadius.

#include "Support/LocatorOnMesh.h"

#include <gtest/gtest.h>

#include <set>

using namespace skdtest;

namespace
{

class NeighboursOnMesh : public LocatorOnMesh
{
protected:
  std::vector<Point> Queries(int count)
  {
    Random random(80);
    std::vector<Point> queries;
    const Bounds& box = this->Reference.GetBounds();
    for (int i = 0; i < count; ++i)
    {
      queries.push_back(random.InBox(Grown(box, 0.2 * Diagonal(box))));
    }
    return queries;
  }

  std::vector<double> SortedDistances(const Point& x)
  {
    std::vector<double> distances;
    for (vtkIdType cell : this->Reference.GetCells())
    {
      distances.push_back(this->Reference.DistanceTo(cell, x));
    }
    std::sort(distances.begin(), distances.end());
    return distances;
  }
};

INSTANTIATE_TEST_SUITE_P(All, NeighboursOnMesh, testing::ValuesIn(AllMeshes()), NameOfMesh());

TEST_P(NeighboursOnMesh, TheKNearestHaveTheKLeastDistances)
{
  const double tolerance = 4 * this->Reference.Tolerance();
  for (const Point& x : this->Queries(8))
  {
    const auto expected = this->SortedDistances(x);
    for (int k : { 1, 2, 7, 40 })
    {
      const Ranked r = FindClosestCells(this->Locator, x, k);
      ASSERT_EQ(r.Number, std::min<vtkIdType>(k, vtkIdType(expected.size())));
      ASSERT_EQ(r.Cells.size(), std::size_t(r.Number));
      ASSERT_EQ(r.Distances.size(), std::size_t(r.Number));
      ASSERT_EQ(std::set<vtkIdType>(r.Cells.begin(), r.Cells.end()).size(), r.Cells.size());
      for (std::size_t i = 0; i < r.Cells.size(); ++i)
      {
        ASSERT_NEAR(r.Distances[i], expected[i], tolerance) << i << " of " << k;
        ASSERT_NEAR(this->Reference.DistanceTo(r.Cells[i], x), r.Distances[i], tolerance);
      }
    }
  }
}

TEST_P(NeighboursOnMesh, AreOrderedByDistanceThenId)
{
  for (const Point& x : this->Queries(10))
  {
    const Ranked r = FindClosestCells(this->Locator, x, 30);
    for (std::size_t i = 1; i < r.Cells.size(); ++i)
    {
      ASSERT_LE(r.Distances[i - 1], r.Distances[i]);
      if (r.Distances[i - 1] == r.Distances[i])
      {
        ASSERT_LT(r.Cells[i - 1], r.Cells[i]);
      }
    }
  }
}

TEST_P(NeighboursOnMesh, TheFirstIsTheClosestPointsCell)
{
  for (const Point& x : this->Queries(30))
  {
    const Closest c = FindClosest(this->Locator, x);
    const Ranked r = FindClosestCells(this->Locator, x, 3);
    ASSERT_EQ(r.Cells[0], c.Cell);
    ASSERT_NEAR(r.Distances[0], std::sqrt(c.Dist2), this->Reference.Tolerance());
  }
}

TEST_P(NeighboursOnMesh, AllAreFoundWhenMoreAreAskedFor)
{
  const Ranked r = FindClosestCells(this->Locator, Center(this->Reference.GetBounds()), 1 << 20);
  Ids cells = r.Cells;
  std::sort(cells.begin(), cells.end());
  EXPECT_EQ(cells, this->Reference.GetCells());
}

TEST_P(NeighboursOnMesh, WithinARadiusAreExactlyTheCellsThatNear)
{
  const double size = Diagonal(this->Reference.GetBounds());
  const double slack = 4 * this->Reference.Tolerance();
  for (const Point& x : this->Queries(8))
  {
    for (double radius : { 0.0, 0.02 * size, 0.15 * size, 0.5 * size })
    {
      const Ranked r = FindWithinRadius(this->Locator, x, radius);
      ASSERT_EQ(r.Number, vtkIdType(r.Cells.size()));
      ASSERT_EQ(r.Distances.size(), r.Cells.size());
      ASSERT_TRUE(std::is_sorted(r.Cells.begin(), r.Cells.end()));
      std::size_t at = 0;
      for (vtkIdType cell : this->Reference.GetCells())
      {
        const double distance = this->Reference.DistanceTo(cell, x);
        const bool found = at < r.Cells.size() && r.Cells[at] == cell;
        ASSERT_TRUE(found || distance > radius - slack) << "cell " << cell << " was missed";
        ASSERT_TRUE(!found || distance < radius + slack) << "cell " << cell << " is too far";
        if (found)
        {
          ASSERT_NEAR(r.Distances[at], distance, slack);
          ++at;
        }
      }
      ASSERT_EQ(at, r.Cells.size()) << "a cell twice, or one that there is not";
    }
  }
}

class NeighboursOfSheet : public testing::Test
{
protected:
  PolyDataPointer Data = MakePolyData(Sheet(4, VTK_QUAD));
  LocatorPointer Locator = MakeLocator(this->Data);
};

TEST_F(NeighboursOfSheet, TiesGoByTheIds)
{
  const Ranked r = FindClosestCells(this->Locator, { 2, 2, 0 }, 3);
  EXPECT_EQ(r.Cells, (Ids{ 5, 6, 9 }));
}

TEST_F(NeighboursOfSheet, TheRadiusIsIncluded)
{
  EXPECT_EQ(FindWithinRadius(this->Locator, { 0.5, 0.5, 2 }, 2.0).Cells, Ids{ 0 });
  EXPECT_EQ(FindWithinRadius(this->Locator, { 0.5, 0.5, 2 }, 1.9999999).Cells, Ids());
}

TEST_F(NeighboursOfSheet, NoneAreAskedForNoneAreFound)
{
  for (int k : { 0, -1, -1000 })
  {
    const Ranked r = FindClosestCells(this->Locator, { 2, 2, 0 }, k);
    EXPECT_EQ(r.Number, 0);
    EXPECT_TRUE(r.Cells.empty());
    EXPECT_TRUE(r.Distances.empty());
  }
}

TEST_F(NeighboursOfSheet, NegativeOrNanRadiusFindsNothing)
{
  for (double radius : { -1.0, std::nan("") })
  {
    EXPECT_EQ(FindWithinRadius(this->Locator, { 2, 2, 0 }, radius).Number, 0);
  }
}

TEST_F(NeighboursOfSheet, AnInfiniteRadiusFindsAll)
{
  EXPECT_EQ(
    FindWithinRadius(this->Locator, { 2, 2, 9 }, std::numeric_limits<double>::infinity()).Number,
    16);
}

TEST_F(NeighboursOfSheet, DistancesMayBeLeftOut)
{
  const Point x = { 0.5, 0.5, 2 };
  vtkNew<vtkIdList> ids;
  EXPECT_EQ(this->Locator->FindClosestCells(x.data(), 2, ids, nullptr), 2);
  EXPECT_EQ(ToVector(ids), FindClosestCells(this->Locator, x, 2).Cells);
  EXPECT_EQ(this->Locator->FindCellsWithinRadius(x.data(), 2.0, ids, nullptr), 1);
  EXPECT_EQ(ToVector(ids), Ids{ 0 });
}

TEST_F(NeighboursOfSheet, EmptiesTheListsOfAMiss)
{
  const Point x = { 0.5, 0.5, 2 };
  vtkNew<vtkIdList> ids;
  ids->InsertNextId(9);
  vtkNew<vtkDoubleArray> distances;
  distances->InsertNextValue(9);
  EXPECT_EQ(this->Locator->FindCellsWithinRadius(x.data(), 1.0, ids, distances), 0);
  EXPECT_EQ(ids->GetNumberOfIds(), 0);
  EXPECT_EQ(distances->GetNumberOfTuples(), 0);
}

}
