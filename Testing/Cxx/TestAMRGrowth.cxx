// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeAMR: how cells grow with the level. Levels 3 to 7, or as far as the environment
// variable SKDTREE_TEST_LEVELS says (10 takes a minute and some gigabytes).

#include "Support/AMRRun.h"
#include "Support/BoxReference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

using namespace skdtest;

namespace
{

const Bounds UnitCube = { 0, 1, 0, 1, 0, 1 };

int DeepestLevel()
{
  const char* wanted = std::getenv("SKDTREE_TEST_LEVELS");
  return wanted ? std::atoi(wanted) : 7;
}

PolyDataPointer MakeQuad(const Point& a, const Point& b, const Point& c, const Point& d)
{
  Mesh mesh;
  mesh.Points = { a, b, c, d };
  mesh.Add(VTK_TRIANGLE, { 0, 1, 2 });
  mesh.Add(VTK_TRIANGLE, { 0, 2, 3 });
  return MakePolyData(mesh);
}

PolyDataPointer MakeSphere()
{
  return MakePolyData(Transformed(SphereTriangles(40), 0.3, { 0.5, 0.5, 0.5 }));
}

/// Cut cells of each level; leaves of each level must be those of recursion by brute force.
std::vector<double> CutCells(PolyDataPointer part, const Bounds& box)
{
  const int deepest = DeepestLevel();
  const std::vector<CellShape> shapes = ShapesOf(part);
  ReferenceOctree reference(shapes, deepest);
  reference.Refine(box, 0);
  for (int level = 3; level <= deepest; ++level)
  {
    AMRPointer filter = MakeAMRIn(part, level, box);
    filter->SetOutputType(vtkSkdTreeAMR::HYPER_TREE_GRID);
    filter->Update();
    std::vector<double> leaves(reference.Leaves.begin(), reference.Leaves.begin() + level);
    leaves.push_back(8 * (reference.Cut[level - 1]));
    EXPECT_EQ(ReportedRow(filter, "LeavesAtLevel"), leaves) << level;
    EXPECT_EQ(Reported(filter, "CutCells"), reference.Cut[level]) << level;
  }
  return reference.Cut;
}

void PrintGrowth(const char* what, const std::vector<double>& cut)
{
  for (std::size_t level = 3; level < cut.size(); ++level)
  {
    std::cout << what << ", level " << level << ": " << cut[level] << " cut cells, "
              << cut[level] / std::pow(4.0, level) << " * 4^level, " << cut[level] / cut[level - 1]
              << " times those of the level above\n";
  }
}

TEST(AMRGrowth, OfASphereTendsToItsProjectedAreas)
{
  const std::vector<double> cut = CutCells(MakeSphere(), UnitCube);
  PrintGrowth("sphere", cut);
  const double all = std::pow(4.0, static_cast<double>(cut.size() - 1));
  EXPECT_NEAR(cut.back() / all, 6 * 3.14159265 * 0.09, 0.03);
}

TEST(AMRGrowth, OfAPlaneAlongTheAxesIsOneLayerOfCells)
{
  const auto plane =
    MakeQuad({ 0.3, -1, -1 }, { 0.3, 2, -1 }, { 0.3, 2, 2 }, { 0.3, -1, 2 }); // off the grid
  const std::vector<double> cut = CutCells(plane, UnitCube);
  PrintGrowth("plane", cut);
  for (std::size_t level = 0; level < cut.size(); ++level)
  {
    EXPECT_EQ(cut[level], std::pow(4.0, static_cast<double>(level)));
  }
}

TEST(AMRGrowth, OfATiltedPlaneTendsToItsProjectedAreas)
{
  // z = 0.1234 + 0.37 x + 0.29 y, over the cube: 1, 0.37 and 0.29 along the axes.
  const auto height = [](double x, double y) { return 0.1234 + 0.37 * x + 0.29 * y; };
  const auto plane = MakeQuad({ -1, -1, height(-1, -1) }, { 2, -1, height(2, -1) },
    { 2, 2, height(2, 2) }, { -1, 2, height(-1, 2) });
  const std::vector<double> cut = CutCells(plane, UnitCube);
  PrintGrowth("tilted plane", cut);
  const double all = std::pow(4.0, static_cast<double>(cut.size() - 1));
  EXPECT_NEAR(cut.back() / all, 1.66, 0.02);
}

}
