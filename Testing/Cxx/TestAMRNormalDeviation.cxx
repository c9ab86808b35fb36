// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeAMR: fewer cells where a surface is flat.

#include "Support/AMRRun.h"
#include "Support/BoxReference.h"
#include "Support/NamedMeshes.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace skdtest;

namespace
{

/// By how many degrees a normal of the shapes' triangles is off the mean of them all.
double NormalDeviationOf(const ReferenceOctree::Met& shapes)
{
  std::vector<Point> normals;
  Point sum = { 0, 0, 0 };
  for (const CellShape* shape : shapes)
  {
    for (const auto& t : SeenTriangles(*shape))
    {
      const Point across = Cross(t[1] - t[0], t[2] - t[0]);
      normals.push_back((1.0 / std::sqrt(Dot(across, across))) * across);
      sum = sum + normals.back();
    }
  }
  double deviation = 0.0;
  for (const Point& normal : normals)
  {
    const double cosine = Dot(normal, sum) / std::sqrt(Dot(sum, sum));
    deviation = std::max(deviation, std::acos(std::min(1.0, std::max(-1.0, cosine))));
  }
  return deviation * 180.0 / 3.14159265358979323846;
}

/// The row without the zeros at its end: levels that no cell reached.
std::vector<double> Trimmed(std::vector<double> row)
{
  while (!row.empty() && row.back() == 0.0)
  {
    row.pop_back();
  }
  return row;
}

AMRPointer MakeBent(vtkDataSet* part, int levels, double angle, int minimumSurfaceLevel)
{
  AMRPointer filter = MakeAMRIn(part, levels, OddBounds(part));
  filter->RefineByNormalDeviationOn();
  filter->SetNormalDeviation(angle);
  filter->SetMinimumSurfaceLevel(minimumSurfaceLevel);
  return filter;
}

TEST(AMRNormalDeviation, CellsAreThoseOfRecursionWithAllNormals)
{
  for (const Mesh& mesh :
    { CubeTriangles(3), CubeQuads(2), SphereTriangles(10), TorusTriangles(24, 12) })
  {
    auto part = MakePolyData(mesh);
    const std::vector<CellShape> shapes = ShapesOf(part);
    for (const double angle : { 0.5, 12.3, 40.0 })
    {
      const int minimumSurfaceLevel = 2;
      ReferenceOctree reference(shapes, 5,
        [&](int level, const ReferenceOctree::Met& met)
        { return level < minimumSurfaceLevel || NormalDeviationOf(met) > angle; });
      reference.Refine(OddBounds(part), 0);
      AMRPointer filter = MakeBent(part, 5, angle, minimumSurfaceLevel);
      filter->Update();
      EXPECT_EQ(Trimmed(ReportedRow(filter, "CutAtLevel")), Trimmed(reference.Cut));
      EXPECT_EQ(Trimmed(ReportedRow(filter, "LeavesAtLevel")), Trimmed(reference.Leaves));
    }
  }
}

TEST(AMRNormalDeviation, ACubeIsRefinedAlongItsEdgesOnly)
{
  auto cube = MakePolyData(CubeTriangles(1));
  AMRPointer filter = MakeBent(cube, 6, 20.0, 2);
  Bounds box;
  cube->GetBounds(box.data());
  std::size_t finest = 0;
  for (const Leaf& leaf : RunLeaves(filter))
  {
    int faces = 0;
    for (int side = 0; side < 6; ++side)
    {
      const int axis = side / 2;
      faces += leaf.Box[2 * axis] <= box[side] && box[side] <= leaf.Box[2 * axis + 1];
    }
    EXPECT_TRUE(!leaf.IsCut || faces < 2 || leaf.Level == 6);
    finest += leaf.IsCut && leaf.Level == 6;
  }
  AMRPointer everywhere = MakeAMRIn(cube, 6, OddBounds(cube));
  everywhere->Update();
  EXPECT_LT(5.0 * static_cast<double>(finest), Reported(everywhere, "CutCells"));
}

TEST(AMRNormalDeviation, TurnedCellsAndWhatIsNoSurfaceCountAsDeviating)
{
  Mesh plane;
  plane.Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0.1 }, { 0, 1, 0.1 } };
  plane.Add(VTK_TRIANGLE, { 0, 1, 2 });
  plane.Add(VTK_TRIANGLE, { 0, 2, 3 });
  const Bounds box = { -0.1, 1.17, -0.13, 1.19, -0.6, 0.6 };
  const auto cutCells = [&](const Mesh& mesh)
  {
    AMRPointer filter = MakeAMRIn(MakePolyData(mesh), 5, box);
    filter->RefineByNormalDeviationOn();
    filter->Update();
    return Reported(filter, "CutCells");
  };
  const double flat = cutCells(plane);
  Mesh rotated = plane;
  rotated.Cells[1].Points = { 0, 3, 2 };
  Mesh withLine = plane;
  withLine.Add(VTK_LINE, { 0, 2 });
  EXPECT_GT(cutCells(rotated), 1.5 * flat);
  EXPECT_GT(cutCells(withLine), 1.5 * flat);
}

}
