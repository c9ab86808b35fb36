// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// Searches that a processor with AVX2 does eight lanes at once have the same results, to the last
// bit, as those that run anywhere.

#include "Support/LocatorCalls.h"
#include "Support/NamedMeshes.h"

#include "Cells/Search/SkdWideWalks.h"

#include "vtkIdTypeArray.h"
#include "vtkNew.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

using namespace skdtest;
using namespace skdtree;

namespace
{

/// The results of both kinds of walks.
struct Answers
{
  Closest Nearest;
  LineHit First;
  LineHits All;
  Ids NearestCells;
  std::vector<double> NearestDistances;
  std::vector<double> Crossings;
  Found Containing;
  Ids InBox;
};

Bounds BoxBetween(const Point& x, const Point& y)
{
  Bounds box;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    std::tie(box[2 * axis], box[2 * axis + 1]) = std::minmax(x[axis], y[axis]);
  }
  return box;
}

Answers Ask(vtkSkdTreeCellLocator* locator, const Point& x, const Point& y)
{
  Answers answers;
  answers.Nearest = FindClosest(locator, x);
  vtkNew<vtkGenericCell> cell;
  answers.First = FindFirstHit(locator, x, y, 0.01);
  answers.All = FindAllHits(locator, x, y, 0.01, cell);
  const Ranked ranked = FindClosestCells(locator, x, 5);
  answers.NearestCells = ranked.Cells;
  answers.NearestDistances = ranked.Distances;
  answers.Crossings = FindCrossings(locator, x, y).Parameters;
  answers.Containing = FindCell(locator, x);
  answers.InBox = FindWithinBounds(locator, BoxBetween(x, y));
  return answers;
}

void ExpectEqual(const Answers& a, const Answers& b)
{
  EXPECT_TRUE(a.Nearest == b.Nearest);
  EXPECT_TRUE(a.First == b.First);
  EXPECT_TRUE(a.All == b.All);
  EXPECT_EQ(a.NearestCells, b.NearestCells);
  EXPECT_EQ(a.NearestDistances, b.NearestDistances);
  EXPECT_EQ(a.Crossings, b.Crossings);
  EXPECT_TRUE(a.Containing == b.Containing);
  EXPECT_EQ(a.InBox, b.InBox);
}

class WideWalks : public testing::TestWithParam<NamedMesh>
{
protected:
  void SetUp() override
  {
    if (!SkdWideWalks::AreOn())
    {
      GTEST_SKIP() << "this build, this processor or SKDTREE_BASELINE leaves them out";
    }
  }
  void TearDown() override { SkdWideWalks::TurnOn(this->WereOn); }

  /// In and around the data set, at corners of cells, and far away.
  std::vector<Point> PositionsAbout(vtkDataSet* data)
  {
    Bounds box;
    data->GetBounds(box.data());
    Random random(177);
    std::vector<Point> positions = { Center(box) + Point{ 50.0, -20.0, 30.0 } };
    for (int i = 0; i < 100; ++i)
    {
      positions.push_back(random.InBox(Grown(box, 0.2 * Diagonal(box))));
      Point corner;
      data->GetPoint(random.Index(static_cast<int>(data->GetNumberOfPoints())), corner.data());
      positions.push_back(corner);
    }
    return positions;
  }

  const bool WereOn = SkdWideWalks::AreOn();
};

INSTANTIATE_TEST_SUITE_P(All, WideWalks, testing::ValuesIn(AllMeshes()), NameOfMesh());

TEST_P(WideWalks, GiveTheAnswersOfTheOthers)
{
  const auto data = GetParam().Make();
  const auto locator = MakeLocator(data);
  const std::vector<Point> positions = this->PositionsAbout(data);
  for (std::size_t i = 0; i + 1 < positions.size(); ++i)
  {
    SkdWideWalks::TurnOn(true);
    const Answers wide = Ask(locator, positions[i], positions[i + 1]);
    SkdWideWalks::TurnOn(false);
    ASSERT_NO_FATAL_FAILURE(ExpectEqual(wide, Ask(locator, positions[i], positions[i + 1]))) << i;
    ASSERT_FALSE(HasFailure()) << "between places " << i << " and " << i + 1;
  }
}

std::vector<vtkIdType> PairsOf(vtkSkdTreeCellLocator* locator, vtkSkdTreeCellLocator* other)
{
  vtkNew<vtkIdTypeArray> pairs;
  locator->FindPairs(other, pairs);
  return { pairs->GetPointer(0), pairs->GetPointer(0) + pairs->GetNumberOfValues() };
}

TEST_P(WideWalks, FindThePairsOfTheOthersInTheirOrder)
{
  const auto locator = MakeLocator(GetParam().Make());
  std::size_t found = 0;
  for (const NamedMesh& mesh : AllMeshes())
  {
    const auto other = MakeLocator(mesh.Make());
    SkdWideWalks::TurnOn(true);
    const std::vector<vtkIdType> wide = PairsOf(locator, other);
    SkdWideWalks::TurnOn(false);
    EXPECT_EQ(wide, PairsOf(locator, other)) << mesh.Name;
    found += wide.size();
  }
  EXPECT_GT(found, 0u);
}

TEST_P(WideWalks, BuildTheTreeOfTheOthers)
{
  const auto data = GetParam().Make();
  Bounds box;
  data->GetBounds(box.data());
  SkdWideWalks::TurnOn(true);
  const auto wide = MakeLocator(data);
  wide->BuildLocator();
  SkdWideWalks::TurnOn(false);
  const auto plain = MakeLocator(data);
  const auto cellsOf = [&box](vtkSkdTreeCellLocator* locator) // in the order of the tree
  {
    return FindAlongPlane(locator, Center(box), { 1.0, 0.0, 0.0 }, 2.0 * Diagonal(box));
  };
  const Ids cells = cellsOf(plain);
  EXPECT_FALSE(cells.empty());
  EXPECT_EQ(cellsOf(wide), cells);
}

TEST(WideWalksSwitch, TurnsThemOffAndOn)
{
  const bool areOn = SkdWideWalks::AreOn();
  SkdWideWalks::TurnOn(false);
  EXPECT_FALSE(SkdWideWalks::AreOn());
  SkdWideWalks::TurnOn(areOn);
  EXPECT_EQ(SkdWideWalks::AreOn(), areOn);
}

}
