// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// Many equal cells in one place: queries for one of them look at each group of equal cells once
// (see Testing/Instructions for what that costs), and answer as if they looked at all. The same
// tree built on query knows no groups.

#include "Support/LocatorCalls.h"
#include "Support/SurfaceMeshes.h"
#include "Support/VolumeMeshes.h"

#include "Cells/Search/SkdCellTree.h"

#include <gtest/gtest.h>

using namespace skdtest;
using namespace skdtree;

namespace
{

/// Cells of all shapes of our own around the middle; then copies of them, some of shared points and
/// some of others in the same places, in any order.
Mesh Copies(int copies, int seed)
{
  Mesh mesh;
  Random random(seed);
  const Point shift = { 0.1, 0.2, 0.3 };
  const std::pair<int, Ids> shapes[] = { { VTK_VERTEX, { 0 } }, { VTK_LINE, { 0, 6 } },
    { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_TRIANGLE, { 1, 2, 0 } }, { VTK_QUAD, { 0, 1, 2, 3 } },
    { VTK_TETRA, { 0, 1, 2, 4 } }, { VTK_PYRAMID, { 0, 1, 2, 3, 4 } },
    { VTK_HEXAHEDRON, { 0, 1, 2, 3, 4, 5, 6, 7 } }, { VTK_POLYGON, { 4, 5, 6, 7 } },
    { VTK_POLY_LINE, { 0, 2, 5 } }, { VTK_TRIANGLE_STRIP, { 0, 1, 3, 2 } } };
  const Point corners[8] = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
    { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } };
  for (int copy = 0; copy < copies; ++copy)
  {
    const bool isShared = copy % 3 == 1;
    const auto first = isShared ? 0 : static_cast<vtkIdType>(mesh.Points.size());
    for (const Point& corner : corners)
    {
      if (!isShared)
      {
        mesh.Add(corner + shift);
      }
    }
    for (const auto& [type, ids] : shapes)
    {
      Ids moved = ids;
      for (vtkIdType& id : moved)
      {
        id += first;
      }
      mesh.Add(type, moved);
    }
  }
  for (int i = 0; i < 40; ++i) // and others between
  {
    const Point x = random.InBox({ -1, 2, -1, 2, -1, 2 });
    mesh.Add(VTK_TRIANGLE,
      { mesh.Add(x), mesh.Add(x + 0.2 * random.Direction()),
        mesh.Add(x + 0.2 * random.Direction()) });
  }
  for (std::size_t i = mesh.Cells.size(); i > 1; --i)
  {
    std::swap(mesh.Cells[i - 1],
      mesh.Cells[static_cast<std::size_t>(random.Between(0.0, 1.0) * double(i)) % i]);
  }
  return mesh;
}

/// The lowest cell with the same type and coordinates.
Ids FirstsOf(const Mesh& mesh)
{
  std::map<std::pair<int, std::vector<Point>>, vtkIdType> firsts;
  Ids found;
  for (const CellSpec& cell : mesh.Cells)
  {
    std::vector<Point> points;
    for (const vtkIdType id : cell.Points)
    {
      points.push_back(mesh.Points[static_cast<std::size_t>(id)]);
    }
    const auto next = static_cast<vtkIdType>(found.size());
    found.push_back(firsts.emplace(std::make_pair(cell.Type, points), next).first->second);
  }
  return found;
}

vtkIdType CountGroups(const Mesh& mesh)
{
  Ids firsts = FirstsOf(mesh);
  std::sort(firsts.begin(), firsts.end());
  return std::unique(firsts.begin(), firsts.end()) - firsts.begin();
}

LocatorPointer MakeUngrouped(vtkDataSet* data)
{
  auto locator = LocatorPointer::New();
  locator->SetDataSet(data);
  locator->LazyBuildOn();
  locator->BuildLocator();
  return locator;
}

TEST(EqualCells, AreOneForQueriesOfOne)
{
  const Mesh mesh = Copies(60, 3);
  const GridPointer grid = MakeGrid(mesh);
  const SkdCellTree tree(grid, SkdTreeSettings());
  EXPECT_EQ(tree.NumberOfDistinctCells(), CountGroups(mesh));
  EXPECT_LT(tree.NumberOfDistinctCells(), 60u);
  EXPECT_EQ(tree.Cells().NumberOfCells(), mesh.Cells.size());
}

TEST(EqualCells, OfAnyNumberAreFoundAmongOthers)
{
  for (const int copies : { 40, 1000, 20000 })
  {
    Mesh mesh = SphereTriangles(30);
    const auto others = static_cast<std::uint32_t>(mesh.Cells.size());
    for (int copy = 0; copy < copies; ++copy)
    {
      mesh.Add(VTK_TRIANGLE, mesh.Cells[7].Points);
    }
    const GridPointer grid = MakeGrid(mesh);
    EXPECT_EQ(SkdCellTree(grid, SkdTreeSettings()).NumberOfDistinctCells(), others) << copies;
  }
}

TEST(EqualCells, DoNotConcernOtherMeshes)
{
  const GridPointer grid = MakeGrid(TorusTriangles(40, 30));
  const SkdCellTree tree(grid, SkdTreeSettings());
  EXPECT_EQ(tree.NumberOfDistinctCells(), tree.Cells().NumberOfCells());
}

TEST(EqualCells, GiveTheAnswersOfAll)
{
  for (const int seed : { 1, 2, 3 })
  {
    const Mesh mesh = Copies(30, seed);
    const Ids firsts = FirstsOf(mesh);
    const GridPointer grid = MakeGrid(mesh);
    const LocatorPointer locator = MakeLocator(grid);
    const LocatorPointer all = MakeUngrouped(grid);
    Random random(seed);
    const Bounds box = { -0.5, 1.7, -0.5, 1.7, -0.5, 1.7 };
    for (int i = 0; i < 200; ++i)
    {
      const Point a = random.InBox(box);
      const Point b = random.InBox(box);
      const Closest closest = FindClosest(locator, a);
      EXPECT_EQ(closest, FindClosest(all, a));
      EXPECT_EQ(closest.Cell, firsts[static_cast<std::size_t>(closest.Cell)]);
      EXPECT_EQ(FindFirstHit(locator, a, b), FindFirstHit(all, a, b));
      EXPECT_EQ(FindCell(locator, a), FindCell(all, a));
      EXPECT_EQ(FindCell(locator, a, 0.04), FindCell(all, a, 0.04));
      EXPECT_EQ(FindWithinRadius(locator, a, 0.2).Cells, FindWithinRadius(all, a, 0.2).Cells);
      for (const int k : { 1, 7, 30, 45 })
      {
        const Ranked some = FindClosestCells(locator, a, k);
        const Ranked expected = FindClosestCells(all, a, k);
        EXPECT_EQ(some.Cells, expected.Cells);
        EXPECT_EQ(some.Distances, expected.Distances);
      }
    }
  }
}

TEST(EqualCells, LeaveOutWhatIsLeftOut)
{
  Mesh mesh = Copies(30, 5);
  const GridPointer grid = MakeGrid(mesh);
  Ids ghosts;
  for (vtkIdType cell = 0; cell < 100; ++cell)
  {
    ghosts.push_back(cell);
  }
  MarkGhosts(grid, ghosts, vtkDataSetAttributes::DUPLICATECELL);
  const LocatorPointer locator = MakeLocator(grid);
  const LocatorPointer all = MakeUngrouped(grid);
  Random random(5);
  for (int i = 0; i < 100; ++i)
  {
    const Point a = random.InBox({ -0.5, 1.7, -0.5, 1.7, -0.5, 1.7 });
    EXPECT_EQ(FindClosest(locator, a), FindClosest(all, a));
    EXPECT_GE(FindClosest(locator, a).Cell, 100);
  }
}

}
