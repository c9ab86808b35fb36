// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// Cells of thousands of pieces, or of many facets: as right as their pieces are.
// Testing/Instructions counts what searching them costs.

#include "Support/LocatorCalls.h"
#include "Support/LongCells.h"
#include "Support/NamedMeshes.h"
#include "Support/SpatialQueryRun.h"

#include <gtest/gtest.h>

using namespace skdtest;

namespace
{

/// The same pieces in one cell, and in a cell each.
std::pair<Mesh, Mesh> InOneAndInPieces(int type, int n)
{
  const Mesh one = LongCell(type, n);
  Mesh pieces;
  pieces.Points = one.Points;
  const auto size = static_cast<vtkIdType>(one.Points.size());
  for (vtkIdType i = 0; i < size; ++i)
  {
    type == VTK_POLY_VERTEX ? pieces.Add(VTK_VERTEX, { i }) : void();
    type == VTK_POLY_LINE&& i + 1 < size ? pieces.Add(VTK_LINE, { i, i + 1 }) : void();
    type == VTK_TRIANGLE_STRIP&& i + 2 < size ? pieces.Add(VTK_TRIANGLE, { i, i + 1, i + 2 })
                                              : void();
  }
  return { one, pieces };
}

class LongCells : public testing::TestWithParam<int>
{
};

INSTANTIATE_TEST_SUITE_P(
  Types, LongCells, testing::Values(VTK_POLY_VERTEX, VTK_POLY_LINE, VTK_TRIANGLE_STRIP));

TEST_P(LongCells, HaveTheNearestPointOfTheirPieces)
{
  for (const int n : { 10, 63, 64, 65, 66, 257, 5000 })
  {
    const auto [one, pieces] = InOneAndInPieces(GetParam(), n);
    const auto whole = MakeGrid(one);
    const auto cut = MakeGrid(pieces);
    const auto locator = MakeLocator(whole);
    const auto reference = MakeLocator(cut);
    Random random(3);
    for (int i = 0; i < 300; ++i)
    {
      Point x = random.InBox({ -2, 2, -2, 2, -1, 7 });
      if (i % 5 == 0)
      {
        x = one.Points[static_cast<std::size_t>(i) % one.Points.size()]; // ties of two pieces
      }
      const Closest found = FindClosest(locator, x);
      const Closest expected = FindClosest(reference, x);
      ASSERT_EQ(found.Cell, 0);
      ASSERT_EQ(found.Dist2, expected.Dist2) << n;
      ASSERT_EQ(found.X, expected.X) << n;
      ASSERT_EQ(found.SubId, expected.Cell) << n << ": the first of the nearest pieces";
    }
  }
}

TEST(CurvedNeighbours, AreFoundByTheirCommonPoints)
{
  constexpr int n = 5;
  const auto mesh = MakeGrid(SeparateQuadraticHexahedra(n));
  QueryPointer query = MakeQuery(mesh, SpatialQuery::ADJACENCY);
  query->SetShape(SpatialQuery::SOURCE_CELLS);
  query->SetSourceData(mesh);
  const auto rows = RunQuery(query);
  EXPECT_EQ(rows.size(), 13u * 13u * 13u - 125u); // (5 + 4 + 4)^3 pairs, itself left out
  auto* table = vtkTable::SafeDownCast(query->GetOutputDataObject(2));
  for (vtkIdType i = 0; i < table->GetNumberOfRows(); ++i)
  {
    const vtkIdType step = std::abs(rows[i].Cell - rows[i].Query);
    const double common = step == 1 || step == n || step == n * n ? 6.0 : 0.0;
    EXPECT_EQ(table->GetValueByName(i, "SkdMinimumDistance").ToDouble(), 0.0);
    const double farthest = table->GetValueByName(i, "SkdMaximumDistance").ToDouble();
    EXPECT_TRUE(common == 0.0 || std::abs(farthest - std::sqrt(common)) < 1e-12) << farthest;
  }
}

}
