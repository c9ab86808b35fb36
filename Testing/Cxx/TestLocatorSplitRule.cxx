// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// Where the tree's nodes are divided: which rule is taken, and that results never depend on it.

#include "Support/LocatorCalls.h"
#include "Support/NamedMeshes.h"
#include "Support/SameAnswers.h"
#include "Support/VolumeMeshes.h"

#include "vtkSMPTools.h"

#include <gtest/gtest.h>

using namespace skdtest;

namespace
{

using Locator = vtkSkdTreeCellLocator;

LocatorPointer MakeLocatorBy(int rule, vtkDataSet* data, bool isLazy = false)
{
  const auto locator = LocatorPointer::New();
  locator->SetDataSet(data);
  locator->SetSplitRule(rule);
  locator->SetLazyBuild(isLazy);
  locator->BuildLocator();
  return locator;
}

/// Cells a hundred times as large at one corner as at the other.
DataSetPointer Graded(Mesh mesh, double n)
{
  mesh.Map(
    [n](const Point& p)
    {
      const auto grow = [n](double s) { return std::expm1(std::log(100.0) * s / n); };
      return Point{ grow(p[0]), grow(p[1]), grow(p[2]) };
    });
  return MakeGrid(mesh);
}

int RuleTakenFor(vtkDataSet* data)
{
  return MakeLocatorBy(Locator::SPLIT_AUTOMATICALLY, data)->GetSplitRuleInUse();
}

TEST(SplitRule, AnswersDoNotDependOnIt)
{
  for (const NamedMesh& mesh : AllMeshes())
  {
    const auto data = mesh.Make();
    const auto byMedian = MakeLocatorBy(Locator::SPLIT_AT_MEDIAN, data);
    const auto byArea = MakeLocatorBy(Locator::SPLIT_BY_SURFACE_AREA, data);
    ExpectSameAnswers(byMedian, byArea, data, mesh.Name);
  }
}

/// Points on shared faces, edges and vertices are in several cells: the lowest id has it.
TEST(SplitRule, TiesGoToTheLowestIdByEither)
{
  const int n = 6;
  const auto data = MakeGrid(Tetrahedra(n));
  const auto byMedian = MakeLocatorBy(Locator::SPLIT_AT_MEDIAN, data);
  const auto byArea = MakeLocatorBy(Locator::SPLIT_BY_SURFACE_AREA, data);
  for (int i = 0; i <= 2 * n; ++i)
  {
    for (int j = 0; j <= 2 * n; ++j)
    {
      const Point x{ 0.5 * i, 0.5 * j, 0.5 * ((i + j) % (2 * n)) };
      ASSERT_EQ(FindCell(byArea, x), FindCell(byMedian, x));
      ASSERT_EQ(FindClosest(byArea, x), FindClosest(byMedian, x));
    }
  }
}

TEST(SplitRule, AutomaticTakesTheAreaWhereCellsOverlapAndDiffer)
{
  EXPECT_EQ(RuleTakenFor(DelaunayTetrahedra(500)), Locator::SPLIT_BY_SURFACE_AREA);
  EXPECT_EQ(RuleTakenFor(Graded(Tetrahedra(8), 8)), Locator::SPLIT_BY_SURFACE_AREA);
  EXPECT_EQ(RuleTakenFor(Graded(MixedCells(8), 8)), Locator::SPLIT_BY_SURFACE_AREA);
}

TEST(SplitRule, AutomaticTakesTheMedianElsewhere)
{
  EXPECT_EQ(RuleTakenFor(MakeGrid(Tetrahedra(8))), Locator::SPLIT_AT_MEDIAN);
  EXPECT_EQ(RuleTakenFor(MakeGrid(Hexahedra(8))), Locator::SPLIT_AT_MEDIAN);
  EXPECT_EQ(RuleTakenFor(MakePolyData(SphereTriangles(20))), Locator::SPLIT_AT_MEDIAN);
  EXPECT_EQ(RuleTakenFor(nullptr), Locator::SPLIT_AT_MEDIAN);
}

TEST(SplitRule, TheRuleInUseIsTheTreesNotTheSetting)
{
  const auto data = DelaunayTetrahedra(200);
  const auto locator = LocatorPointer::New();
  locator->SetDataSet(data);
  EXPECT_EQ(locator->GetSplitRuleInUse(), Locator::SPLIT_AUTOMATICALLY);
  locator->SetSplitRuleToMedian();
  locator->BuildLocator();
  EXPECT_EQ(locator->GetSplitRuleInUse(), Locator::SPLIT_AT_MEDIAN);
  locator->SetSplitRuleToSurfaceArea();
  EXPECT_EQ(locator->GetSplitRuleInUse(), Locator::SPLIT_AT_MEDIAN);
  locator->BuildLocator();
  EXPECT_EQ(locator->GetSplitRuleInUse(), Locator::SPLIT_BY_SURFACE_AREA);
  locator->SetSplitRuleToAutomatic();
  EXPECT_EQ(locator->GetSplitRule(), Locator::SPLIT_AUTOMATICALLY);
}

TEST(SplitRule, BuildOnQueryKnowsTheMedianOnly)
{
  const auto data = DelaunayTetrahedra(200);
  const auto lazy = MakeLocatorBy(Locator::SPLIT_BY_SURFACE_AREA, data, true);
  EXPECT_EQ(lazy->GetSplitRuleInUse(), Locator::SPLIT_AT_MEDIAN);
  ExpectSameAnswers(lazy, MakeLocatorBy(Locator::SPLIT_BY_SURFACE_AREA, data), data, "lazy");
}

TEST(SplitRule, NumbersOutOfRangeAreClamped)
{
  const auto locator = LocatorPointer::New();
  locator->SetSplitRule(7);
  EXPECT_EQ(locator->GetSplitRule(), Locator::SPLIT_BY_SURFACE_AREA);
  locator->SetSplitRule(-1);
  EXPECT_EQ(locator->GetSplitRule(), Locator::SPLIT_AUTOMATICALLY);
}

/// Leaves that have inner nodes beside them, as trees by area have, are stored.
TEST(SplitRule, ByAreaTheTreeIsALevelHigherAtMostAndKeepsAtMost85Bytes)
{
  const auto data = DelaunayTetrahedra(3000);
  const auto byMedian = MakeLocatorBy(Locator::SPLIT_AT_MEDIAN, data);
  const auto byArea = MakeLocatorBy(Locator::SPLIT_BY_SURFACE_AREA, data);
  EXPECT_GE(byArea->GetDepth(), byMedian->GetDepth());
  EXPECT_LE(byArea->GetDepth(), byMedian->GetDepth() + 1);
  EXPECT_GE(byArea->GetNumberOfNodes(), byMedian->GetNumberOfNodes());
  EXPECT_LE(byMedian->GetBytesPerCell(), byArea->GetBytesPerCell());
  EXPECT_LE(byArea->GetBytesPerCell(), 85.0);
}

TEST(SplitRule, ACopySharesTheTreeAndTheSetting)
{
  const auto byArea = MakeLocatorBy(Locator::SPLIT_BY_SURFACE_AREA, DelaunayTetrahedra(200));
  const auto copy = LocatorPointer::New();
  copy->ShallowCopy(byArea);
  EXPECT_EQ(copy->GetSplitRule(), Locator::SPLIT_BY_SURFACE_AREA);
  EXPECT_EQ(copy->GetSplitRuleInUse(), Locator::SPLIT_BY_SURFACE_AREA);
}

TEST(SplitRule, ByAreaAnswersDoNotDependOnThreads)
{
  const auto data = DelaunayTetrahedra(2000);
  const std::string former = vtkSMPTools::GetBackend();
  vtkSMPTools::SetBackend("STDThread");
  std::vector<LocatorPointer> locators;
  for (int threads : { 1, 4 })
  {
    vtkSMPTools::Initialize(threads);
    locators.push_back(MakeLocatorBy(Locator::SPLIT_BY_SURFACE_AREA, data));
  }
  vtkSMPTools::Initialize(0);
  vtkSMPTools::SetBackend(former.c_str());
  EXPECT_EQ(locators[0]->GetNumberOfNodes(), locators[1]->GetNumberOfNodes());
  ExpectSameAnswers(locators[0], locators[1], data, "threads");
}

}
