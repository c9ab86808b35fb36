// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// Curved cells of every type as the Source of filters that look at its boundary.

#include "Support/ClosestPointRun.h"
#include "Support/CurvedMeshes.h"
#include "Support/EventCounter.h"
#include "Support/InOutRun.h"

#include "Bodies/SkdBoundary.h"
#include "Cells/Curved/SkdCurvedFaces.h"

#include <gtest/gtest.h>

#include <set>

using namespace skdtest;
using namespace skdtree;

namespace
{

class CurvedVolume : public testing::TestWithParam<int>
{
};

INSTANTIATE_TEST_SUITE_P(EveryType, CurvedVolume, testing::ValuesIn(CurvedVolumeTypes()),
  [](const auto& info) { return NameOfType(info.param); });

class CurvedSurface : public testing::TestWithParam<int>
{
};

INSTANTIATE_TEST_SUITE_P(EveryType, CurvedSurface, testing::ValuesIn(CurvedSurfaceTypes()),
  [](const auto& info) { return NameOfType(info.param); });

/// To the surface of [0, size]^3; negative inside.
double SignedToCube(const Point& x, double size)
{
  double outside2 = 0.0;
  double nearest = -std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis)
  {
    const double beyond = std::max(-x[axis], x[axis] - size);
    outside2 += beyond > 0.0 ? beyond * beyond : 0.0;
    nearest = std::max(nearest, beyond);
  }
  return outside2 > 0.0 ? std::sqrt(outside2) : nearest;
}

std::vector<Point> LatticeAround(double size, int n)
{
  std::vector<Point> points;
  for (int i = 0; i < n * n * n; ++i)
  {
    const auto at = [&](int k) { return -0.37 + (size + 0.71) * k / (n - 1); };
    points.push_back({ at(i % n), at(i / n % n), at(i / n / n) });
  }
  return points;
}

void ExpectCube(const Mesh& mesh, double size)
{
  const std::vector<Point> points = LatticeAround(size, 11);
  auto source = MakeGrid(mesh);
  FilterPointer distances = MakeSignedFilter(MakeQueries(points), source);
  const std::vector<double> found = RunDistances(distances);
  EXPECT_EQ(Reported(distances, "OpenEdges"), 0);
  for (int method : AllMethods)
  {
    InOutPointer filter = MakeInOut(MakeQueries(points), source, method);
    EventCounter events(filter);
    const std::vector<double> inside = RunFor(filter, "SkdInside");
    ASSERT_EQ(inside.size(), points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      const double expected = SignedToCube(points[i], size);
      ASSERT_EQ(inside[i], expected < 0.0 ? 1 : 0) << "method " << method << " point " << i;
      ASSERT_NEAR(found[i], expected, 1e-12 * (1.0 + size)) << i;
    }
    EXPECT_EQ(events.Warnings, 0) << events.Warning;
  }
}

TEST_P(CurvedVolume, StraightBlocksAreTheCubeThatTheyAre)
{
  ExpectCube(CurvedBlock(GetParam(), 3), 3.0);
  ExpectCube(CurvedBlock(GetParam(), 1), 1.0);
  if (IsHigherOrder(GetParam()) && HighestOrder() > 2)
  {
    ExpectCube(CurvedBlock(GetParam(), 2, 3), 2.0);
  }
}

// The distance without a sign is to the curved cells themselves, the one with a sign to facets.
void ExpectWithin(const Mesh& mesh, double deviation)
{
  auto source = MakeGrid(mesh);
  Bounds box;
  source->GetBounds(box.data());
  const double length = deviation * Diagonal(box);
  // VTK evaluates Bezier tetrahedra some twenty times as slowly as others.
  const bool isSlow = mesh.Cells[0].Type == VTK_BEZIER_TETRAHEDRON;
  const std::vector<Point> points = RandomQueries(source, isSlow ? 24 : 90);
  FilterPointer facets = MakeSignedFilter(MakeQueries(points), source);
  const std::vector<double> found = RunDistances(facets);
  const std::vector<double> exact = RunDistances(MakeFilter(MakeQueries(points), source));
  const std::vector<double> inside = RunFor(MakeInOut(MakeQueries(points), source), "SkdInside");
  EXPECT_EQ(Reported(facets, "OpenEdges"), 0);
  int within = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    within += exact[i] == 0.0 ? 1 : 0;
    if (std::abs(found[i]) > length)
    {
      ASSERT_EQ(found[i] < 0.0, exact[i] == 0.0) << i << " " << found[i] << " " << exact[i];
      ASSERT_EQ(inside[i], exact[i] == 0.0 ? 1 : 0) << i;
    }
    ASSERT_NEAR(std::max(found[i], 0.0), exact[i], length) << i;
  }
  EXPECT_GT(within, isSlow ? 1 : 9);
}

TEST_P(CurvedVolume, BowedBlocksAreWithinTheChordalDeviation)
{
  ExpectWithin(CurvedBlock(GetParam(), 1).Map(Bowed), SkdDefaultChordalDeviation);
}

/// Surfaces by their facets, of a data object of one mesh or several.
SkdBoundary BoundaryOf(const std::vector<Mesh>& meshes, double deviation)
{
  std::vector<SkdBlock> leaves;
  for (const Mesh& mesh : meshes)
  {
    leaves.push_back({ MakeGrid(mesh), static_cast<int>(leaves.size()) + 1 });
  }
  return SkdBoundaryOf(leaves, SkdChordalLength(leaves, deviation));
}

TEST_P(CurvedSurface, BowedSurfacesHaveNoOpenEdges)
{
  for (const double deviation : { 1e-2, 1e-3, 1e-4 })
  {
    const SkdBoundary boundary = BoundaryOf({ CurvedBlock(GetParam(), 2).Map(Bowed) }, deviation);
    if (GetParam() != VTK_QUADRATIC_LINEAR_QUAD) // whose straight sides meet curved ones
    {
      EXPECT_EQ(boundary.OpenEdges, 0) << deviation;
    }
    EXPECT_GE(boundary.Faces->GetNumberOfCells(), 24);
  }
}

TEST_P(CurvedSurface, AFacetIsOfTheCellThatItIsOn)
{
  const Mesh mesh = CurvedBlock(GetParam(), 2).Map(Bowed);
  auto source = MakeGrid(mesh);
  const SkdBoundary boundary = BoundaryOf({ mesh }, 1e-4);
  std::set<vtkIdType> cells;
  for (vtkIdType i = 0; i < boundary.Faces->GetNumberOfCells(); i += 7)
  {
    const SkdBoundary::Origin& origin = boundary.Origins[static_cast<std::size_t>(i)];
    ASSERT_LT(origin.CellId, source->GetNumberOfCells());
    Bounds box;
    boundary.Faces->GetCellBounds(i, box.data());
    Bounds of;
    source->GetCellBounds(origin.CellId, of.data());
    EXPECT_TRUE(Overlap(box, Grown(of, 0.05)));
    cells.insert(origin.CellId);
  }
  EXPECT_EQ(static_cast<vtkIdType>(cells.size()), source->GetNumberOfCells());
}

// Blocks of a data object whose faces meet: what is between them is inside, no boundary.
TEST_P(CurvedVolume, BlocksThatTouchAreOneBody)
{
  Mesh left = CurvedBlock(GetParam(), 1);
  Mesh right = left;
  right.Map([](const Point& p) { return Point{ 2.0 - p[0], p[1], p[2] }; }); // seen in a mirror
  left.Map(Bowed);
  right.Map(Bowed);
  const SkdBoundary both = BoundaryOf({ left, right }, 1e-3);
  EXPECT_EQ(both.OpenEdges, 0);
  EXPECT_EQ(both.Surface, both.Faces);
  auto source = MakeBlocks({ MakeGrid(left), MakeGrid(right) });
  const Point middle = Bowed({ 1.0, 0.5, 0.5 });
  const std::vector<double> found = RunDistances(MakeSignedFilter(MakeQueries({ middle }), source));
  EXPECT_LT(found[0], -0.3);
}

TEST(CurvedSources, OneCurvedCellFarAwayLeavesTheLinearOnesAsTheyAre)
{
  const Mesh far = CurvedBlock(VTK_QUADRATIC_TETRA, 1)
                     .Map(
                       [](const Point& p) {
                         return Bowed(p) + Point{ 40, 0, 0 };
                       });
  for (const Mesh& linear :
    { Hexahedra(3), Tetrahedra(2), Wedges(2), Pyramids(2), MixedCells(3), Polyhedra(2) })
  {
    const Mesh bowed = Mesh(linear).Map(Bowed);
    auto alone = MakeGrid(bowed);
    auto both = MakeGrid(Together({ bowed, far }));
    const std::vector<Point> points = RandomQueries(alone, 200);
    FilterPointer first = MakeSignedFilter(MakeQueries(points), alone);
    FilterPointer second = MakeSignedFilter(MakeQueries(points), both);
    EXPECT_EQ(RunDistances(first), RunDistances(second));
    EXPECT_EQ(RunArray(first, "SkdClosestPoint"), RunArray(second, "SkdClosestPoint"));
    EXPECT_EQ(RunArray(first, "SkdClosestCellId"), RunArray(second, "SkdClosestCellId"));
    EXPECT_EQ(RunFor(MakeInOut(MakeQueries(points), alone), "SkdInside"),
      RunFor(MakeInOut(MakeQueries(points), both), "SkdInside"));
  }
}

// Linear and curved cells that share a face: of degree one the faces are the same.
TEST(CurvedSources, LinearCellsAndLagrangeCellsOfDegreeOneJoin)
{
  Mesh mesh = Elevated(Hexahedra(1), VTK_LAGRANGE_HEXAHEDRON, 1);
  const Mesh linear = Hexahedra(2);
  Mesh joined = Welded(Together({ mesh, linear }));
  joined.Cells.erase(joined.Cells.begin() + 1); // the linear one in the same place
  const std::vector<Point> points = LatticeAround(2.0, 11);
  const std::vector<double> found =
    RunDistances(MakeSignedFilter(MakeQueries(points), MakeGrid(joined)));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    ASSERT_NEAR(found[i], SignedToCube(points[i], 2.0), 1e-13) << i;
  }
}

TEST(CurvedSources, FacesAreOuterWhenNoOtherCellHasThem)
{
  for (const int type : CurvedVolumeTypes())
  {
    auto grid = MakeGrid(CurvedBlock(type, 2));
    const auto faces = SkdFindCurvedFaces(grid);
    const int linear = LinearTypeOf(type); // of wedges, quadrilaterals on four sides of the cube
    EXPECT_EQ(faces.size(),
      linear == VTK_TETRA     ? 48u
        : linear == VTK_WEDGE ? 32u
                              : 24u)
      << NameOfType(type);
  }
}

}
