// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeAMR: its points and cells as an unstructured grid, conforming or not.

#include "Support/AMRRun.h"
#include "Support/NamedMeshes.h"

#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <map>

using namespace skdtest;

namespace
{

/// A closed curve in the plane z = 0.25.
PolyDataPointer MakeCircle()
{
  Mesh circle;
  for (int i = 0; i < 40; ++i)
  {
    circle.Add(Point{ std::cos(0.1571 * i), std::sin(0.1571 * i), 0.25 });
  }
  for (int i = 0; i < 40; ++i)
  {
    circle.Add(VTK_LINE, { i, (i + 1) % 40 });
  }
  return MakePolyData(circle);
}

TEST(AMRUnstructured, ACurveInAPlaneHasAQuadtreeInThatPlane)
{
  AMRPointer filter = MakeAMR(MakeCircle(), 6);
  const std::vector<Leaf> leaves = RunLeaves(filter);
  auto grid = vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(0));
  EXPECT_EQ(grid->GetCellType(0), VTK_PIXEL);
  double area = 0.0;
  for (const Leaf& leaf : leaves)
  {
    EXPECT_EQ(leaf.Box[4], 0.25);
    EXPECT_EQ(leaf.Box[5], 0.25);
    area += (leaf.Box[1] - leaf.Box[0]) * (leaf.Box[3] - leaf.Box[2]);
  }
  EXPECT_NEAR(area, 2.4 * 2.4, 0.01);
}

/// How many cells each edge belongs to.
std::map<std::pair<vtkIdType, vtkIdType>, int> EdgesOf(vtkDataSet* grid)
{
  std::map<std::pair<vtkIdType, vtkIdType>, int> edges;
  for (vtkIdType id = 0; id < grid->GetNumberOfCells(); ++id)
  {
    vtkCell* cell = grid->GetCell(id);
    for (int i = 0; i < cell->GetNumberOfEdges(); ++i)
    {
      vtkIdList* ends = cell->GetEdge(i)->PointIds;
      ++edges[std::minmax(ends->GetId(0), ends->GetId(1))];
    }
  }
  return edges;
}

/// Inner edges have two cells, those on the grid's border one.
void ExpectNoHangingPoint(vtkDataSet* grid)
{
  Bounds box;
  grid->GetBounds(box.data());
  for (const auto& [ends, cells] : EdgesOf(grid))
  {
    Point p;
    Point q;
    grid->GetPoint(ends.first, p.data());
    grid->GetPoint(ends.second, q.data());
    const auto isOn = [&](int side)
    { return p[side / 2] == box[side] && q[side / 2] == box[side]; };
    EXPECT_EQ(cells, isOn(0) || isOn(1) || isOn(2) || isOn(3) ? 1 : 2);
  }
}

struct AreaAndAngle
{
  double Area = 0.0;
  double LeastAngle = 90.0; // degrees
};

/// Of convex cells in a plane of constant z.
AreaAndAngle MeasureOf(vtkDataSet* grid)
{
  AreaAndAngle all;
  for (vtkIdType id = 0; id < grid->GetNumberOfCells(); ++id)
  {
    vtkPoints* points = grid->GetCell(id)->Points;
    const vtkIdType size = points->GetNumberOfPoints();
    const auto at = [&](vtkIdType i)
    {
      Point x;
      points->GetPoint(i % size, x.data());
      return x;
    };
    for (vtkIdType i = 0; i < size; ++i)
    {
      const Point next = at(i + 1) - at(i);
      const Point last = at(i + size - 1) - at(i);
      const double sine = Cross(next, last)[2];
      EXPECT_GT(sine, 0.0) << "turned the wrong way around";
      all.LeastAngle =
        std::min(all.LeastAngle, std::atan2(sine, Dot(next, last)) * 180.0 / 3.141593);
      all.Area += 0.5 * Cross(at(i), at(i + 1))[2];
    }
  }
  return all;
}

TEST(AMRUnstructured, AConformingGridInAPlaneHasNoHangingPoint)
{
  for (const int branch : { 2, 3 })
  {
    for (const int balance : { vtkSkdTreeAMR::NONE, vtkSkdTreeAMR::FACE })
    {
      AMRPointer filter = MakeAMR(MakeCircle(), branch == 2 ? 6 : 4);
      filter->SetBranchFactor(branch);
      filter->SetBalance(balance);
      const double leaves = static_cast<double>(RunLeaves(filter).size());
      filter->ConformingOn();
      filter->Update();
      auto grid = vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(0));
      EXPECT_GT(static_cast<double>(grid->GetNumberOfCells()), leaves);
      ExpectNoHangingPoint(grid);
      const AreaAndAngle measured = MeasureOf(grid);
      EXPECT_NEAR(measured.Area, 2.4 * 2.4, 0.01);
      const bool isGraded = branch == 2 && balance == vtkSkdTreeAMR::FACE;
      EXPECT_GT(measured.LeastAngle, isGraded ? 44.9 : 0.0);
    }
  }
}

TEST(AMRUnstructured, HangingPointsAreThoseThatAreNotCornersOfAllTheirCells)
{
  for (const bool isFlat : { false, true })
  {
    AMRPointer filter = isFlat ? MakeAMR(MakeCircle(), 4) : MakeAMR(MakeTorus(), 3);
    const std::vector<Leaf> leaves = RunLeaves(filter);
    auto grid = vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(0));
    const std::vector<double> hanging = ValuesOf(grid->GetPointData()->GetArray("SkdHanging"));
    ASSERT_EQ(hanging.size(), static_cast<std::size_t>(grid->GetNumberOfPoints()));
    int count = 0;
    for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
    {
      Point x;
      grid->GetPoint(i, x.data());
      bool isHanging = false;
      for (const Leaf& leaf : leaves)
      {
        bool isCorner = true;
        for (int axis = 0; axis < 3; ++axis)
        {
          isCorner &= x[axis] == leaf.Box[2 * axis] || x[axis] == leaf.Box[2 * axis + 1];
        }
        isHanging |= Contains(leaf.Box, x) && !isCorner;
      }
      ASSERT_EQ(hanging[static_cast<std::size_t>(i)], isHanging) << i;
      count += isHanging;
    }
    EXPECT_GT(count, 10);
  }
}

TEST(AMRUnstructured, PointsAreSharedAndCellsRightWayAround)
{
  AMRPointer filter = MakeAMR(MakeTorus(), 3);
  filter->Update();
  auto grid = vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(0));
  std::map<Point, int> positions;
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    Point x;
    grid->GetPoint(i, x.data());
    EXPECT_EQ(++positions[x], 1);
  }
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    ASSERT_EQ(grid->GetCellType(cell), VTK_VOXEL);
    Point first, last;
    grid->GetPoint(grid->GetCell(cell)->GetPointId(0), first.data());
    grid->GetPoint(grid->GetCell(cell)->GetPointId(7), last.data());
    EXPECT_TRUE(first[0] < last[0] && first[1] < last[1] && first[2] < last[2]);
  }
}

}
