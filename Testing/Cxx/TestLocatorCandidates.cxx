// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// The paper's raw queries: candidate ids, by safety boxes alone.

#include "Support/LocatorOnMesh.h"
#include "Support/PaperArrays.h"
#include "Support/SegmentReference.h"

#include <gtest/gtest.h>

using namespace skdtest;

namespace
{

class CandidatesOfMesh : public LocatorOnMesh
{
protected:
  CandidatesOfMesh()
    : Boxes(PaperArrays(this->Locator).BoxesOfCells(this->Data->GetNumberOfCells()))
    , Slack(1e-13 * Scale(this->Reference.GetBounds()))
  {
  }

  Point Query(Random& random)
  {
    const Bounds& box = this->Reference.GetBounds();
    return random.InBox(Grown(box, 0.3 * Diagonal(box)));
  }

  Ids Closest(const Point& x, const double* reference = nullptr)
  {
    vtkNew<vtkIdList> ids;
    reference ? this->Locator->FindClosestCandidates(x.data(), reference, ids)
              : this->Locator->FindClosestCandidates(x.data(), ids);
    return Sorted(ToVector(ids));
  }

  double NearestAmong(const Ids& cells, const Point& x)
  {
    double nearest = std::numeric_limits<double>::infinity();
    for (vtkIdType cell : cells)
    {
      nearest = std::min(nearest, this->Reference.DistanceTo(cell, x));
    }
    return nearest;
  }

  static double Farthest(const Bounds& box, const Point& x)
  {
    Point away;
    for (int axis = 0; axis < 3; ++axis)
    {
      away[axis] = std::max(x[axis] - box[2 * axis], box[2 * axis + 1] - x[axis]);
    }
    return Length(away);
  }

  /// Exactly the cells whose safety box passes, but for those within rounding of the border.
  void ExpectThoseThatPass(
    const Ids& cells, const std::function<bool(const Bounds&, double grow)>& passes)
  {
    ASSERT_EQ(std::adjacent_find(cells.begin(), cells.end()), cells.end());
    for (vtkIdType cell = 0; cell < vtkIdType(this->Boxes.size()); ++cell)
    {
      const bool found = std::binary_search(cells.begin(), cells.end(), cell);
      if (!found)
      {
        ASSERT_FALSE(passes(this->Boxes[cell], -this->Slack)) << "cell " << cell << " was missed";
      }
      else
      {
        ASSERT_TRUE(passes(this->Boxes[cell], this->Slack)) << "cell " << cell << " is too much";
      }
    }
  }

  std::vector<Bounds> Boxes;
  double Slack;
};

INSTANTIATE_TEST_SUITE_P(All, CandidatesOfMesh, testing::ValuesIn(AllMeshes()), NameOfMesh());

TEST_P(CandidatesOfMesh, OneOfTheClosestHoldsTheNearestPoint)
{
  Random random(90);
  for (int i = 0; i < 60; ++i)
  {
    const Point x = this->Query(random);
    const double expected = this->Reference.FindNearest(x).Distance;
    ASSERT_NEAR(this->NearestAmong(this->Closest(x), x), expected, this->Slack);
  }
}

TEST_P(CandidatesOfMesh, ClosestAreNoMoreThanThePapers)
{
  Random random(91);
  for (int i = 0; i < 60; ++i)
  {
    const Point x = this->Query(random);
    double pessimistic = std::numeric_limits<double>::infinity();
    for (const Bounds& box : this->Boxes)
    {
      pessimistic = std::min(pessimistic, Farthest(box, x));
    }
    const Ids cells = this->Closest(x);
    for (vtkIdType cell : cells)
    {
      ASSERT_LE(Distance(this->Boxes[cell], x), pessimistic + this->Slack);
    }
  }
}

TEST_P(CandidatesOfMesh, AReferenceOnTheMeshSparesCandidates)
{
  Random random(92);
  for (int i = 0; i < 60; ++i)
  {
    const Point x = this->Query(random);
    const auto reference = FindClosest(this->Locator, x).X;
    const Ids with = this->Closest(x, reference.data());
    const Ids without = this->Closest(x);
    ASSERT_TRUE(std::includes(without.begin(), without.end(), with.begin(), with.end()));
    ASSERT_NEAR(this->NearestAmong(with, x), this->Reference.FindNearest(x).Distance, this->Slack);
  }
}

TEST_P(CandidatesOfMesh, AnyOtherReferenceIsHarmless)
{
  Random random(93);
  const double nan = std::nan("");
  const double inf = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 30; ++i)
  {
    const Point x = this->Query(random);
    const double expected = this->Reference.FindNearest(x).Distance;
    const Point references[] = { x, this->Query(random), 1e12 * random.Direction(),
      { nan, nan, nan }, { nan, 0, 0 }, { inf, 0, 0 }, { -inf, inf, 0 } };
    for (const Point& reference : references)
    {
      ASSERT_NEAR(this->NearestAmong(this->Closest(x, reference.data()), x), expected, this->Slack);
    }
  }
}

TEST_P(CandidatesOfMesh, AlongALineAreTheSafetyBoxesMet)
{
  Random random(94);
  vtkNew<vtkIdList> ids;
  for (int i = 0; i < 60; ++i)
  {
    const Point a = this->Query(random);
    const Point b = this->Query(random);
    this->Locator->FindCandidatesAlongLine(a.data(), b.data(), ids);
    this->ExpectThoseThatPass(Sorted(ToVector(ids)),
      [&](const Bounds& box, double grow) { return EntryIntoBox(a, b, Grown(box, grow)) >= 0; });
  }
}

TEST_P(CandidatesOfMesh, AlongALineHoldEveryHit)
{
  Random random(95);
  vtkNew<vtkIdList> ids;
  vtkNew<vtkGenericCell> cell;
  for (int i = 0; i < 60; ++i)
  {
    const Point a = this->Query(random);
    const Point b = this->Query(random);
    this->Locator->FindCandidatesAlongLine(a.data(), b.data(), ids);
    for (vtkIdType hit : FindAllHits(this->Locator, a, b, 0.0, cell).Cells)
    {
      ASSERT_GE(ids->IsId(hit), 0);
    }
  }
}

TEST_P(CandidatesOfMesh, WithinBoundsAreTheSafetyBoxesThatOverlap)
{
  Random random(96);
  vtkNew<vtkIdList> ids;
  for (int i = 0; i < 60; ++i)
  {
    Bounds query = EmptyBounds();
    Extend(query, this->Query(random));
    Extend(query, this->Query(random));
    this->Locator->FindCandidatesWithinBounds(query.data(), ids);
    this->ExpectThoseThatPass(Sorted(ToVector(ids)),
      [&](const Bounds& box, double grow) { return Overlap(Grown(box, grow), query); });
  }
}

TEST_P(CandidatesOfMesh, WithinARadiusAreTheSafetyBoxesThatNear)
{
  Random random(97);
  vtkNew<vtkIdList> ids;
  const double size = Diagonal(this->Reference.GetBounds());
  for (int i = 0; i < 60; ++i)
  {
    const Point x = this->Query(random);
    const double radius = random.Between(0, 0.5 * size);
    this->Locator->FindCandidatesWithinRadius(x.data(), radius, ids);
    this->ExpectThoseThatPass(Sorted(ToVector(ids)),
      [&](const Bounds& box, double grow) { return Distance(box, x) <= radius + grow; });
  }
}

TEST_P(CandidatesOfMesh, AlongAPlaneAreTheSafetyBoxesMet)
{
  Random random(98);
  vtkNew<vtkIdList> ids;
  for (int i = 0; i < 60; ++i)
  {
    const Point o = this->Query(random);
    const Point n = random.Direction();
    this->Locator->FindCandidatesAlongPlane(o.data(), n.data(), ids);
    this->ExpectThoseThatPass(Sorted(ToVector(ids)),
      [&](const Bounds& box, double grow)
      {
        double maxDistance = 0;
        for (int axis = 0; axis < 3; ++axis)
        {
          maxDistance += (0.5 * (box[2 * axis + 1] - box[2 * axis]) + grow) * std::abs(n[axis]);
        }
        return std::abs(Dot(Center(box) - o, n)) <= maxDistance;
      });
  }
}

TEST(Candidates, AllCellsWhereEpsilonIsTheWholeScene)
{
  const auto data = MakePolyData(SphereTriangles(4));
  const auto locator = LocatorPointer::New();
  locator->SetDataSet(data);
  locator->SetEpsilon(1.0);
  locator->BuildLocator();
  vtkNew<vtkIdList> ids;
  const double x[3] = { 0, 0, 0 };
  locator->FindClosestCandidates(x, ids);
  EXPECT_EQ(ids->GetNumberOfIds(), data->GetNumberOfCells());
}

TEST(Candidates, AnswersDoNotDependOnEpsilon)
{
  const auto data = MakePolyData(TriangleSoup(300, 0.2));
  const auto plain = MakeLocator(data);
  Random random(99);
  for (double epsilon : { 0.0, 1e-12, 1e-3, 0.3 })
  {
    const auto locator = LocatorPointer::New();
    locator->SetDataSet(data);
    locator->SetEpsilon(epsilon);
    locator->BuildLocator();
    for (int i = 0; i < 50; ++i)
    {
      const Point x = random.InBox({ -1, 2, -1, 2, -1, 2 });
      const Point y = random.InBox({ -1, 2, -1, 2, -1, 2 });
      ASSERT_EQ(FindClosest(locator, x), FindClosest(plain, x)) << epsilon;
      ASSERT_EQ(FindFirstHit(locator, x, y), FindFirstHit(plain, x, y)) << epsilon;
      ASSERT_EQ(FindAlongLine(locator, x, y), FindAlongLine(plain, x, y)) << epsilon;
    }
  }
}

}
