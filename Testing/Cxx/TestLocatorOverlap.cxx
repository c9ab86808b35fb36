// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// FindOverlappingPairs: tree against tree (Algorithm 5.4).

#include "Support/NamedMeshes.h"
#include "Support/PaperArrays.h"
#include "Support/RigidMatrix.h"

#include "vtkMatrix4x4.h"

#include <gtest/gtest.h>

#include <set>

using namespace skdtest;

namespace
{

using Pairs = std::vector<std::pair<vtkIdType, vtkIdType>>;

struct PairQuery
{
  vtkIdType Number;
  Pairs Found;
};

PairQuery FindPairs(vtkSkdTreeCellLocator* a, vtkSkdTreeCellLocator* b)
{
  vtkNew<vtkIdList> ofA, ofB;
  PairQuery query;
  query.Number = a->FindOverlappingPairs(b, ofA, ofB);
  EXPECT_EQ(ofA->GetNumberOfIds(), ofB->GetNumberOfIds());
  for (vtkIdType i = 0; i < ofA->GetNumberOfIds(); ++i)
  {
    query.Found.emplace_back(ofA->GetId(i), ofB->GetId(i));
  }
  return query;
}

std::vector<Bounds> BoxesOf(vtkSkdTreeCellLocator* locator)
{
  return PaperArrays(locator).BoxesOfCells(locator->GetDataSet()->GetNumberOfCells());
}

/// All pairs of boxes that overlap when the second set is moved by `shift`.
Pairs AllPairs(vtkSkdTreeCellLocator* a, vtkSkdTreeCellLocator* b, const Point& shift = { 0, 0, 0 })
{
  Pairs pairs;
  const auto boxesA = BoxesOf(a);
  const auto boxesB = BoxesOf(b);
  for (std::size_t i = 0; i < boxesA.size(); ++i)
  {
    for (std::size_t j = 0; j < boxesB.size(); ++j)
    {
      Bounds moved = boxesB[j];
      for (int side = 0; side < 6; ++side)
      {
        moved[side] += shift[side / 2];
      }
      if (Overlap(boxesA[i], moved))
      {
        pairs.emplace_back(i, j);
      }
    }
  }
  return pairs;
}

class OverlapOfMeshes : public testing::TestWithParam<NamedMesh>
{
};

INSTANTIATE_TEST_SUITE_P(All, OverlapOfMeshes, testing::ValuesIn(AllMeshes()), NameOfMesh());

TEST_P(OverlapOfMeshes, PairsAreThoseWhoseSafetyBoxesOverlap)
{
  const auto data = GetParam().Make();
  const auto other = MakePolyData(Transformed(SphereTriangles(5), 1.3, { 1, 0.5, 0.7 }));
  const auto a = MakeLocator(data);
  const auto b = MakeLocator(other);
  const PairQuery query = FindPairs(a, b);
  EXPECT_EQ(query.Found, AllPairs(a, b));
  EXPECT_EQ(query.Number, vtkIdType(query.Found.size()));
}

TEST_P(OverlapOfMeshes, WithItselfHoldsEachCellWithItself)
{
  const auto data = GetParam().Make();
  const auto locator = MakeLocator(data);
  const PairQuery query = FindPairs(locator, locator);
  EXPECT_EQ(query.Found, AllPairs(locator, locator));
  const std::set<Pairs::value_type> set(query.Found.begin(), query.Found.end());
  for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i)
  {
    ASSERT_EQ(set.count({ i, i }), 1u);
  }
}

class OverlapOfTwo : public testing::Test
{
protected:
  PolyDataPointer DataA = MakePolyData(TorusTriangles(20, 10));
  PolyDataPointer DataB = MakePolyData(SphereTriangles(5));
  LocatorPointer A = MakeLocator(DataA);
  LocatorPointer B = MakeLocator(DataB);
};

TEST_F(OverlapOfTwo, SwappedGivesTheSwappedPairs)
{
  Pairs swapped;
  for (const auto& pair : FindPairs(this->B, this->A).Found)
  {
    swapped.emplace_back(pair.second, pair.first);
  }
  std::sort(swapped.begin(), swapped.end());
  EXPECT_EQ(swapped, FindPairs(this->A, this->B).Found);
  EXPECT_FALSE(swapped.empty());
}

TEST_F(OverlapOfTwo, ATranslationMovesTheBoxes)
{
  const Point shift = { 0.6, 0.3, 0.1 };
  vtkNew<vtkMatrix4x4> motion;
  for (int row = 0; row < 3; ++row)
  {
    motion->SetElement(row, 3, shift[row]);
  }
  const Pairs expected = AllPairs(this->A, this->B, shift);
  this->B->SetTransform(motion);
  EXPECT_EQ(FindPairs(this->A, this->B).Found, expected);
}

TEST_F(OverlapOfTwo, TheSameMotionOfBothChangesNothing)
{
  const Pairs expected = FindPairs(this->A, this->B).Found;
  const auto motion = RigidMatrix({ 3, 1, -2 });
  this->A->SetTransform(motion);
  this->B->SetTransform(motion);
  const Pairs found = FindPairs(this->A, this->B).Found;
  // Rounding of the motion may add a pair that only just misses.
  EXPECT_TRUE(std::includes(found.begin(), found.end(), expected.begin(), expected.end()));
  EXPECT_LE(found.size(), expected.size() + expected.size() / 100 + 2);
}

TEST_F(OverlapOfTwo, FarApartHasNoPairs)
{
  this->B->SetTransform(RigidMatrix({ 50, 0, 0 }));
  EXPECT_EQ(FindPairs(this->A, this->B).Number, 0);
}

TEST_F(OverlapOfTwo, TurnedBoxesThatShareAPointAreAPair)
{
  const auto motion = RigidMatrix({ 0.5, 0.2, 0.1 });
  const auto boxesA = BoxesOf(this->A);
  const auto boxesB = BoxesOf(this->B);
  this->B->SetTransform(motion);
  const PairQuery query = FindPairs(this->A, this->B);
  const std::set<Pairs::value_type> found(query.Found.begin(), query.Found.end());
  Random random(100);
  int shared = 0;
  for (std::size_t j = 0; j < boxesB.size(); ++j)
  {
    for (int sample = 0; sample < 20; ++sample)
    {
      const Point p = random.InBox(boxesB[j]);
      const Point moved = Rotated(p) + Point{ 0.5, 0.2, 0.1 };
      for (std::size_t i = 0; i < boxesA.size(); ++i)
      {
        if (Contains(boxesA[i], moved))
        {
          ++shared;
          ASSERT_EQ(found.count({ vtkIdType(i), vtkIdType(j) }), 1u) << i << " " << j;
        }
      }
    }
  }
  EXPECT_GT(shared, 10);
  // Boxes whose spheres are apart cannot overlap.
  for (const auto& pair : query.Found)
  {
    const Bounds& a = boxesA[pair.first];
    const Bounds& b = boxesB[pair.second];
    const Point center = Rotated(Center(b)) + Point{ 0.5, 0.2, 0.1 };
    ASSERT_LE(Distance(Center(a), center), 0.5001 * (Diagonal(a) + Diagonal(b)) * std::sqrt(3.0));
  }
}

TEST_F(OverlapOfTwo, WithAnEmptyOrNoLocatorThereAreNone)
{
  vtkNew<vtkPolyData> nothing;
  EXPECT_EQ(FindPairs(this->A, MakeLocator(nothing)).Number, 0);
  EXPECT_EQ(FindPairs(MakeLocator(nothing), this->A).Number, 0);
  EXPECT_EQ(FindPairs(this->A, nullptr).Number, 0);
}

}
