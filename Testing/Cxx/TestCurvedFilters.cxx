// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// Curved cells of every type in surfaces that meet, refined grids and meshes, and spatial queries.

#include "Support/AMRRun.h"
#include "Support/ClosestPointRun.h"
#include "Support/CurvedMeshes.h"
#include "Support/MeshRefinementRun.h"
#include "Support/SpatialQueryRun.h"
#include "Support/SurfaceIntersectionRun.h"

#include <gtest/gtest.h>

#include <numeric>

using namespace skdtest;

namespace
{

class CurvedCellsIn : public testing::TestWithParam<int>
{
};

INSTANTIATE_TEST_SUITE_P(EveryType, CurvedCellsIn, testing::ValuesIn(CurvedVolumeTypes()),
  [](const auto& info) { return NameOfType(info.param); });

PolyDataPointer MakePlane(double z)
{
  Mesh mesh;
  mesh.Points = { { -9, -8, z - 0.3 }, { 11, -8, z + 0.1 }, { 11, 13, z + 0.4 }, { -9, 13, z } };
  mesh.Add(VTK_TRIANGLE, { 0, 1, 2 });
  mesh.Add(VTK_TRIANGLE, { 0, 2, 3 });
  return MakePolyData(mesh);
}

TEST_P(CurvedCellsIn, SurfacesMeetOthersInClosedCurves)
{
  auto grid = MakeGrid(CurvedBlock(GetParam(), 2).Map(Bowed));
  IntersectionPointer filter = MakeIntersection(grid, MakePlane(0.77));
  for (const CellPair& pair : RunPairs(filter))
  {
    ASSERT_GE(pair.First, 0);
    ASSERT_LT(pair.First, grid->GetNumberOfCells());
  }
  vtkPolyData* curves = OutputOf(filter, 0);
  ASSERT_GT(curves->GetNumberOfLines(), 0);
  vtkDataArray* closed = curves->GetCellData()->GetArray("SkdCurveClosed");
  for (vtkIdType i = 0; i < closed->GetNumberOfTuples(); ++i)
  {
    EXPECT_EQ(closed->GetTuple1(i), 1.0) << i;
  }
  EXPECT_EQ(Reported(filter, "FacesLeftOut"), 0);
  const double length = Reported(filter, "ChordalLength");
  std::vector<Point> points;
  for (vtkIdType i = 0; i < curves->GetNumberOfPoints(); i += 1 + curves->GetNumberOfPoints() / 40)
  {
    points.emplace_back();
    curves->GetPoint(i, points.back().data());
  }
  for (const double distance : RunDistances(MakeFilter(MakeQueries(points), grid)))
  {
    ASSERT_LE(distance, length);
  }
  for (const double distance : RunDistances(MakeSignedFilter(MakeQueries(points), grid)))
  {
    ASSERT_NEAR(distance, 0.0, 1e-9);
  }
}

/// What a grid of trees has of a part.
std::vector<double> CellsAround(const Mesh& part)
{
  AMRPointer filter = MakeAMRIn(MakeGrid(part), 4, { -0.313, 2.471, -0.277, 2.519, -0.351, 2.443 });
  filter->SetInsideLevel(2);
  filter->ComputeInsideOn();
  filter->Update();
  auto* cells = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  const std::vector<double> inside = ValuesOf(cells->GetCellData()->GetArray("SkdInside"));
  return { static_cast<double>(cells->GetNumberOfCells()),
    std::accumulate(inside.begin(), inside.end(), 0.0) };
}

TEST_P(CurvedCellsIn, GridsAreRefinedAroundThemAsAroundLinearOnes)
{
  const Mesh linear = LinearBlock(LinearTypeOf(GetParam()), 2);
  EXPECT_EQ(CellsAround(Elevated(linear, GetParam())), CellsAround(linear));
}

TEST_P(CurvedCellsIn, MeshesAreRefinedAroundThemAsAroundLinearOnes)
{
  const Mesh linear = LinearBlock(LinearTypeOf(GetParam()), 1);
  const Mesh around = Hexahedra(3).Map(
    [](const Point& p) {
      return 0.917 * p - Point{ 0.731, 0.693, 0.777 };
    });
  vtkIdType cells[2];
  for (const bool isCurved : { false, true })
  {
    RefinementPointer filter = MakeRefinement(
      MakeGrid(around), MakeGrid(isCurved ? Elevated(linear, GetParam()) : linear), 2);
    filter->SetInsideLevel(1);
    cells[isCurved] = RunRefinement(filter)->GetNumberOfCells();
  }
  EXPECT_EQ(cells[1], cells[0]);
}

TEST_P(CurvedCellsIn, NeighboursAreThoseOfLinearCells)
{
  const bool isSlow = GetParam() == VTK_BEZIER_TETRAHEDRON; // to be evaluated by VTK
  const Mesh linear = LinearBlock(LinearTypeOf(GetParam()), isSlow ? 1 : 2);
  std::vector<std::pair<vtkIdType, vtkIdType>> found[2];
  for (const bool isCurved : { false, true })
  {
    auto grid = MakeGrid(isCurved ? Elevated(linear, GetParam()) : linear);
    QueryPointer query = MakeQuery(grid, SpatialQuery::ADJACENCY);
    query->SetShape(SpatialQuery::SOURCE_CELLS);
    query->SetSourceData(grid);
    query->SetSharedPart(SpatialQuery::FACE);
    for (const PairRow& row : RunQuery(query))
    {
      found[isCurved].emplace_back(row.Query, row.Cell);
      EXPECT_EQ(row.Min, 0.0);
    }
  }
  EXPECT_GT(found[0].size(), 7u);
  EXPECT_EQ(found[1], found[0]);
}

}
