// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// S and L: the invariants of Algorithm 3.1, and their picture.

#include "Support/LocatorOnMesh.h"
#include "Support/PaperArrays.h"

#include <gtest/gtest.h>

#include <set>

using namespace skdtest;

namespace
{

int CeilLog2(vtkIdType n)
{
  int depth = 0;
  while ((vtkIdType(1) << depth) < n)
  {
    ++depth;
  }
  return depth;
}

class PaperTree : public BuiltLocator
{
protected:
  PaperTree()
    : Arrays(this->Locator)
  {
  }

  vtkIdType Size() const { return this->Data->GetNumberOfCells(); }

  PaperArrays Arrays;
};

std::vector<NamedMesh> Meshes()
{
  std::vector<NamedMesh> meshes = AllMeshes();
  meshes.push_back({ "OneCell", [] { return MakePolyData(Sheet(1, VTK_QUAD)); } });
  meshes.push_back({ "TwoCells", [] { return MakePolyData(Sheet(1, VTK_TRIANGLE)); } });
  meshes.push_back({ "ThreeCells", [] { return MakePolyData(TriangleSoup(3, 1)); } });
  meshes.push_back({ "PowerOfTwo", [] { return MakePolyData(TriangleSoup(256, 0.1)); } });
  meshes.push_back({ "OneMore", [] { return MakePolyData(TriangleSoup(257, 0.1)); } });
  meshes.push_back({ "Large", [] { return MakePolyData(TriangleSoup(20011, 0.01)); } });
  return meshes;
}

INSTANTIATE_TEST_SUITE_P(All, PaperTree, testing::ValuesIn(Meshes()), NameOfMesh());

TEST_P(PaperTree, HasTwiceNLessOneNodes)
{
  EXPECT_EQ(vtkIdType(this->Arrays.S.size()), 2 * this->Size() - 1);
  EXPECT_EQ(vtkIdType(this->Arrays.L.size()), 2 * this->Size() - 1);
}

TEST_P(PaperTree, EachNodeIsReachedOnceFromTheRoot)
{
  std::vector<int> visits(this->Arrays.L.size(), 0);
  this->Arrays.Visit([&](vtkIdType node, int) { ++visits.at(node); });
  EXPECT_EQ(visits, std::vector<int>(visits.size(), 1));
}

TEST_P(PaperTree, IsNoDeeperThanCeilLog2N)
{
  int deepest = 0;
  this->Arrays.Visit([&](vtkIdType, int depth) { deepest = std::max(deepest, depth); });
  EXPECT_EQ(deepest, CeilLog2(this->Size()));
}

TEST_P(PaperTree, EachCellIsOneLeaf)
{
  Ids cells = this->Arrays.CellsBelow(0);
  std::sort(cells.begin(), cells.end());
  Ids expected(this->Size());
  for (vtkIdType i = 0; i < this->Size(); ++i)
  {
    expected[i] = i;
  }
  EXPECT_EQ(cells, expected);
}

TEST_P(PaperTree, ChildrenDifferByAtMostOneCell)
{
  this->Arrays.Visit(
    [&](vtkIdType node, int)
    {
      if (!this->Arrays.IsLeaf(node))
      {
        const auto first = this->Arrays.CellsBelow(this->Arrays.L[node]).size();
        const auto second = this->Arrays.CellsBelow(this->Arrays.L[node] + 1).size();
        ASSERT_LE(std::max(first, second) - std::min(first, second), 1u);
      }
    });
}

TEST_P(PaperTree, ABoxIsTheUnionOfItsChildren)
{
  const auto& arrays = this->Arrays;
  arrays.Visit(
    [&](vtkIdType node, int)
    {
      if (!arrays.IsLeaf(node))
      {
        Bounds both = EmptyBounds();
        for (const Bounds& child : { arrays.S[arrays.L[node]], arrays.S[arrays.L[node] + 1] })
        {
          Extend(both, { child[0], child[2], child[4] });
          Extend(both, { child[1], child[3], child[5] });
        }
        ASSERT_EQ(arrays.S[node], both) << "node " << node;
      }
    });
}

TEST_P(PaperTree, ALeafIsTheCellsBoxGrownByTwiceEpsilon)
{
  BruteForce reference(this->Data);
  const double epsilon = this->Locator->GetAbsoluteEpsilon();
  EXPECT_GT(epsilon, 0.0);
  const auto boxes = this->Arrays.BoxesOfCells(this->Size());
  for (vtkIdType cell = 0; cell < this->Size(); ++cell)
  {
    const Bounds expected = Grown(reference.Box(cell), 2 * epsilon);
    for (int side = 0; side < 6; ++side)
    {
      ASSERT_NEAR(boxes[cell][side], expected[side], epsilon / 4);
    }
    ASSERT_TRUE(Contains(boxes[cell], Grown(reference.Box(cell), epsilon)));
  }
}

TEST_P(PaperTree, SplitsTheLongestAxisAtTheMedianOfCentroids)
{
  const auto& arrays = this->Arrays;
  const auto boxes = arrays.BoxesOfCells(this->Size());
  arrays.Visit(
    [&](vtkIdType node, int)
    {
      if (arrays.IsLeaf(node))
      {
        return;
      }
      const Bounds& box = arrays.S[node];
      int axis = 0;
      for (int other = 1; other < 3; ++other)
      {
        if (box[2 * other + 1] - box[2 * other] > box[2 * axis + 1] - box[2 * axis])
        {
          axis = other;
        }
      }
      double low = -std::numeric_limits<double>::infinity();
      for (vtkIdType cell : arrays.CellsBelow(arrays.L[node]))
      {
        low = std::max(low, Center(boxes[cell])[axis]);
      }
      const double slack = 1e-14 * Scale(arrays.S[0]);
      for (vtkIdType cell : arrays.CellsBelow(arrays.L[node] + 1))
      {
        ASSERT_GE(Center(boxes[cell])[axis], low - slack) << "node " << node;
      }
    });
}

TEST_P(PaperTree, IsTheSameOfALazyTree)
{
  const auto lazy = LocatorPointer::New();
  lazy->SetDataSet(this->Data);
  lazy->LazyBuildOn();
  lazy->BuildLocator();
  const PaperArrays arrays(lazy);
  EXPECT_EQ(arrays.S, this->Arrays.S);
  EXPECT_EQ(arrays.L, this->Arrays.L);
}

TEST_P(PaperTree, RepresentationOfALevelShowsItsBoxes)
{
  vtkNew<vtkPolyData> picture;
  const int deepest = CeilLog2(this->Size());
  for (int level : { 0, 1, deepest / 2 })
  {
    if ((vtkIdType(1) << level) > this->Size())
    {
      continue;
    }
    this->Locator->GenerateRepresentation(level, picture);
    ASSERT_EQ(picture->GetNumberOfCells(), 6 * (vtkIdType(1) << level)) << "level " << level;
    vtkDataArray* levels = picture->GetCellData()->GetArray("Level");
    ASSERT_NE(levels, nullptr);
    for (vtkIdType quad = 0; quad < picture->GetNumberOfCells(); ++quad)
    {
      ASSERT_EQ(picture->GetCellType(quad), VTK_QUAD);
      ASSERT_EQ(levels->GetComponent(quad, 0), level);
    }
    // The boxes of a level hold all cells, so together they have the bounds of the root.
    Bounds bounds;
    picture->GetBounds(bounds.data());
    for (int side = 0; side < 6; ++side)
    {
      ASSERT_NEAR(bounds[side], this->Arrays.S[0][side], 1e-6 * Scale(this->Arrays.S[0]));
    }
  }
}

TEST_P(PaperTree, RepresentationOfTheLeavesNamesEachCell)
{
  vtkNew<vtkPolyData> picture;
  for (int level : { -1, CeilLog2(this->Size()) + 5 })
  {
    this->Locator->GenerateRepresentation(level, picture);
    ASSERT_EQ(picture->GetNumberOfCells(), 6 * this->Size());
    vtkDataArray* ids = picture->GetCellData()->GetArray("CellId");
    ASSERT_NE(ids, nullptr);
    std::map<vtkIdType, int> quads;
    for (vtkIdType quad = 0; quad < picture->GetNumberOfCells(); ++quad)
    {
      ++quads[vtkIdType(ids->GetComponent(quad, 0))];
    }
    ASSERT_EQ(vtkIdType(quads.size()), this->Size());
    for (const auto& entry : quads)
    {
      ASSERT_GE(entry.first, 0);
      ASSERT_EQ(entry.second, 6);
    }
  }
}

TEST(PaperArraysOf, CellsThatAreLeftOutKeepTheIdsOfTheOthers)
{
  const auto data = MakePolyData(Sheet(4, VTK_QUAD));
  MarkGhosts(data, { 0, 5, 15 }, vtkDataSetAttributes::DUPLICATECELL);
  const PaperArrays arrays(MakeLocator(data));
  Ids cells = arrays.CellsBelow(0);
  std::sort(cells.begin(), cells.end());
  EXPECT_EQ(cells, (Ids{ 1, 2, 3, 4, 6, 7, 8, 9, 10, 11, 12, 13, 14 }));
}

TEST(PaperArraysOf, NoCellsAreEmpty)
{
  vtkNew<vtkPolyData> data;
  const PaperArrays arrays(MakeLocator(data));
  EXPECT_TRUE(arrays.S.empty());
  EXPECT_TRUE(arrays.L.empty());
}

TEST(PaperArraysOf, EpsilonIsRelativeToTheDiagonal)
{
  const auto data = MakePolyData(CubeTriangles(3));
  const auto locator = LocatorPointer::New();
  EXPECT_EQ(locator->GetEpsilon(), 1e-9);
  EXPECT_EQ(locator->GetAbsoluteEpsilon(), 0.0);
  locator->SetDataSet(data);
  locator->SetEpsilon(0.01);
  locator->BuildLocator();
  EXPECT_NEAR(locator->GetAbsoluteEpsilon(), 0.01 * 3 * std::sqrt(3.0), 1e-14);
  const auto boxes = PaperArrays(locator).BoxesOfCells(data->GetNumberOfCells());
  EXPECT_NEAR(boxes[0][0], -2 * locator->GetAbsoluteEpsilon(), 1e-6);
}

TEST(PaperArraysOf, EpsilonIsNeverBelowTheRoundingOfCoordinates)
{
  const double far = 1e9;
  const auto data = MakePolyData(Transformed(CubeTriangles(3), 1e-3, { far, far, far }));
  const auto locator = LocatorPointer::New();
  locator->SetDataSet(data);
  locator->SetEpsilon(0.0);
  locator->BuildLocator();
  const double ulp = std::nextafter(far, 2 * far) - far;
  EXPECT_GE(locator->GetAbsoluteEpsilon(), 8 * ulp);
  EXPECT_LE(locator->GetAbsoluteEpsilon(), 32 * ulp);
}

}
