// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeAMR: which cells there are, against recursion that tests every cell of the parts.

#include "Support/AMRRun.h"
#include "Support/BoxReference.h"
#include "Support/Folders.h"
#include "Support/NamedMeshes.h"
#include "Support/RealMeshes.h"

#include "vtkMultiBlockDataSet.h"
#include "vtkSMPTools.h"

#include <gtest/gtest.h>

using namespace skdtest;

namespace
{

class AMROnMesh : public testing::TestWithParam<NamedMesh>
{
};

INSTANTIATE_TEST_SUITE_P(All, AMROnMesh, testing::ValuesIn(AllMeshes()), NameOfMesh());

TEST_P(AMROnMesh, LeavesAreThoseOfRecursionByBruteForce)
{
  DataSetPointer parts = GetParam().Make();
  const Bounds box = OddBounds(parts);
  const int levels = 4;
  const std::vector<CellShape> shapes = ShapesOf(parts);
  ReferenceOctree reference(shapes, levels);
  reference.Refine(box, 0);

  AMRPointer filter = MakeAMRIn(parts, levels, box);
  filter->Update();
  EXPECT_EQ(ReportedRow(filter, "CutAtLevel"), reference.Cut);
  EXPECT_EQ(ReportedRow(filter, "LeavesAtLevel"), reference.Leaves);
}

TEST_P(AMROnMesh, BlindRefinesAllThatExactDoes)
{
  DataSetPointer parts = GetParam().Make();
  AMRPointer exact = MakeAMRIn(parts, 4, OddBounds(parts));
  AMRPointer blind = MakeAMRIn(parts, 4, OddBounds(parts));
  blind->SetOverlapTest(vtkSkdTreeAMR::BLIND);
  const std::vector<Leaf> coarse = RunLeaves(exact);
  const std::vector<Leaf> fine = RunLeaves(blind);
  EXPECT_GE(fine.size(), coarse.size());
  Random random(3);
  for (int i = 0; i < 300; ++i)
  {
    const Point x = random.InBox(OddBounds(parts));
    EXPECT_GE(FindLeaf(fine, x)->Level, FindLeaf(coarse, x)->Level);
  }
}

TEST_P(AMROnMesh, LeavesFillTheBaseAndCandidatesAreWhereItIsCut)
{
  DataSetPointer parts = GetParam().Make();
  const Bounds box = OddBounds(parts);
  AMRPointer filter = MakeAMRIn(parts, 3, box);
  const std::vector<Leaf> leaves = RunLeaves(filter);
  const double volume = (box[1] - box[0]) * (box[3] - box[2]) * (box[5] - box[4]);
  EXPECT_NEAR(VolumeOf(leaves), volume, 1e-9 * volume);
  const std::vector<double> candidates = CellArray(filter, "SkdCandidates");
  const std::vector<double> part = CellArray(filter, "SkdPartIndex");
  for (std::size_t i = 0; i < leaves.size(); ++i)
  {
    EXPECT_EQ(leaves[i].IsCut, candidates[i] > 0);
    EXPECT_EQ(leaves[i].IsCut, part[i] == 0);
    EXPECT_TRUE(!leaves[i].IsCut || leaves[i].Level == 3);
  }
}

TEST(AMR, CandidatesAreTheCellsThatMeetALeaf)
{
  auto parts = MakePolyData(TorusTriangles(24, 12));
  AMRPointer filter = MakeAMRIn(parts, 3, OddBounds(parts));
  const std::vector<Leaf> leaves = RunLeaves(filter);
  const std::vector<double> candidates = CellArray(filter, "SkdCandidates");
  const std::vector<CellShape> shapes = ShapesOf(parts);
  for (std::size_t i = 0; i < leaves.size(); ++i)
  {
    int expected = 0;
    for (const CellShape& shape : shapes)
    {
      expected += MeetsBox(shape, leaves[i].Box);
    }
    ASSERT_EQ(candidates[i], expected) << i;
  }
}

Mesh PlaneAcross(const Point& a, const Point& b, const Point& c, const Point& d)
{
  Mesh mesh;
  mesh.Points = { a, b, c, d };
  mesh.Add(VTK_TRIANGLE, { 0, 1, 2 });
  mesh.Add(VTK_TRIANGLE, { 0, 2, 3 });
  return mesh;
}

const Bounds UnitCube = { 0, 1, 0, 1, 0, 1 };

/// 2 4^L cells on both sides of a plane that is on the faces of cells.
TEST(AMR, APlaneOnTheGridCutsTheCellsOfBothSides)
{
  auto plane =
    MakePolyData(PlaneAcross({ 0.5, 0, 0 }, { 0.5, 1, 0 }, { 0.5, 1, 1 }, { 0.5, 0, 1 }));
  for (int level = 3; level <= 8; ++level)
  {
    AMRPointer filter = MakeAMRIn(plane, level, UnitCube);
    filter->Update();
    EXPECT_EQ(Reported(filter, "CutCells"), 2 * std::pow(4, level));
  }
}

/// The plane x + y + z = 1 passes through corners of cells, at all levels.
TEST(AMR, ATiltedPlaneThroughCornersCutsAllThatTouchIt)
{
  auto plane =
    MakePolyData(PlaneAcross({ 3, -1, -1 }, { -1, 3, -1 }, { -1, -1, 3 }, { -1, -1, 3 }));
  for (int level = 3; level <= 7; ++level)
  {
    AMRPointer filter = MakeAMRIn(plane, level, UnitCube);
    filter->Update();
    const int n = 1 << level;
    double expected = 0; // cells with i + j + k <= n <= i + j + k + 3
    for (int i = 0; i < n; ++i)
    {
      for (int j = 0; j < n; ++j)
      {
        for (int k = std::max(0, n - 3 - i - j); k < n && i + j + k <= n; ++k)
        {
          ++expected;
        }
      }
    }
    EXPECT_EQ(Reported(filter, "CutCells"), expected);
  }
}

TEST(AMR, TheTessellatedSphereHasTheCountsOfTheSphere)
{
  auto sphere = MakePolyData(SphereTriangles(200).Map(
    [](const Point& p) {
      return 0.3 * p + Point{ 0.5, 0.5, 0.5 };
    }));
  AMRPointer filter = MakeAMRIn(sphere, 6, UnitCube);
  filter->Update();
  EXPECT_EQ(Reported(filter, "CutCells"), 6920);
  EXPECT_EQ(Reported(filter, "Cells"), 16416);
  const double expected[3] = { 19104, 20784, 21512 };
  for (int balance = 1; balance <= 3; ++balance)
  {
    filter->SetBalance(balance);
    filter->Update();
    EXPECT_EQ(Reported(filter, "Cells"), expected[balance - 1]);
    EXPECT_EQ(Reported(filter, "CutCells"), 6920);
  }
}

TEST(AMR, PlacesFarAwayAndTinyAndHugeScalesGiveTheSameCells)
{
  const Mesh torus = TorusTriangles(16, 8);
  AMRPointer reference = MakeAMRIn(MakePolyData(torus), 5, { -2, 2, -2, 2, -2, 2 });
  reference->Update();
  const std::pair<double, double> placings[] = { { 1e-150, 0.0 }, { 1e150, 0.0 }, { 1e-6, 0.0 },
    { 0x1p-10, 0x1p20 } };
  for (const auto& [scale, offset] : placings)
  {
    auto placed = MakePolyData(Transformed(torus, scale, { offset, offset, offset }));
    const double low = offset - 2 * scale;
    const double high = offset + 2 * scale;
    AMRPointer filter = MakeAMRIn(placed, 5, { low, high, low, high, low, high });
    filter->Update();
    EXPECT_EQ(ReportedRow(filter, "LeavesAtLevel"), ReportedRow(reference, "LeavesAtLevel"))
      << scale;
  }
}

TEST(AMR, TheSameCellsWhateverTheNumberOfThreads)
{
  auto parts = MakePolyData(TriangleSoup(500, 0.1));
  const std::string former = vtkSMPTools::GetBackend();
  vtkSMPTools::SetBackend("STDThread");
  std::vector<std::vector<double>> found;
  for (int threads : { 1, 4 })
  {
    vtkSMPTools::Initialize(threads);
    AMRPointer filter = MakeAMRIn(parts, 5, UnitCube);
    filter->SetBalance(vtkSkdTreeAMR::FACE);
    filter->ComputeInsideOn();
    EventCounter events(filter); // the soup is open
    filter->Update();
    found.emplace_back();
    for (const char* name : { "SkdLevel", "SkdCut", "SkdCandidates", "SkdInside" })
    {
      const std::vector<double> values = CellArray(filter, name);
      found.back().insert(found.back().end(), values.begin(), values.end());
    }
  }
  vtkSMPTools::Initialize(0);
  vtkSMPTools::SetBackend(former.c_str());
  EXPECT_EQ(found[0], found[1]);
}

class AMROnFile : public testing::TestWithParam<std::string>
{
};

INSTANTIATE_TEST_SUITE_P(Data, AMROnFile, testing::ValuesIn(MeshFiles(DataFolder())));

TEST_P(AMROnFile, LeavesAreThoseOfRecursionByBruteForce)
{
  DataSetPointer parts = ReadMesh(GetParam());
  if (!parts)
  {
    GTEST_SKIP() << "no file";
  }
  const Bounds box = OddBounds(parts);
  const std::vector<CellShape> shapes = ShapesOf(parts);
  ReferenceOctree reference(shapes, 4);
  reference.Refine(box, 0);
  AMRPointer filter = MakeAMRIn(parts, 4, box);
  filter->Update();
  EXPECT_EQ(ReportedRow(filter, "CutAtLevel"), reference.Cut);
  EXPECT_EQ(ReportedRow(filter, "LeavesAtLevel"), reference.Leaves);
}

}
