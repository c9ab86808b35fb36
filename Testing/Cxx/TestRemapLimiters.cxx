// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeRemap of second order: with a limiter no result is beyond the averages around, whatever
// the field and the meshes, and integrals are kept.

#include "Support/CurvedMeshes.h"
#include "Support/RemapRun.h"
#include "Support/SphereMeshes.h"
#include "Support/SurfaceMeshes.h"

#include <gtest/gtest.h>

#include <set>

using namespace skdtest;

namespace
{
using Remap = vtkSkdTreeRemap;

constexpr double Rounding = 1e-14;

/// What the values of each cell and of those that share a point with it are between.
std::vector<std::array<double, 2>> RangesAround(const Mesh& mesh, const std::vector<double>& values)
{
  std::vector<std::set<std::size_t>> cellsAt(mesh.Points.size());
  for (std::size_t i = 0; i < mesh.Cells.size(); ++i)
  {
    for (const vtkIdType id : mesh.Cells[i].Points)
    {
      cellsAt[static_cast<std::size_t>(id)].insert(i);
    }
  }
  std::vector<std::array<double, 2>> ranges;
  for (std::size_t i = 0; i < mesh.Cells.size(); ++i)
  {
    ranges.push_back({ values[i], values[i] });
    for (const vtkIdType id : mesh.Cells[i].Points)
    {
      for (const std::size_t other : cellsAt[static_cast<std::size_t>(id)])
      {
        ranges[i][0] = std::min(ranges[i][0], values[other]);
        ranges[i][1] = std::max(ranges[i][1], values[other]);
      }
    }
  }
  return ranges;
}

/// Every result is within the ranges of the source cells that it is made of.
void ExpectWithin(const Mesh& from, const GridPointer& to, const std::vector<double>& values)
{
  const GridPointer source = WithCellArray(MakeGrid(from), "f", values);
  const auto ranges = RangesAround(from, values);
  for (const int limiter : { Remap::BARTH_JESPERSEN, Remap::CLIP_AND_ASSURED_SUM })
  {
    SCOPED_TRACE(limiter);
    const RemapPointer remap = MakeRemap(to, source, Remap::CONSERVATIVE_SECOND_ORDER);
    remap->SetLimiter(limiter);
    remap->GenerateWeightsOn();
    const std::vector<double> results = RemappedCells(remap, "f");
    std::vector<std::array<double, 2>> around(results.size(), { 1e300, -1e300 });
    auto* table = vtkTable::SafeDownCast(remap->GetOutputDataObject(1));
    for (vtkIdType i = 0; i < table->GetNumberOfRows(); ++i)
    {
      auto& range = around[table->GetValueByName(i, "Row").ToUnsignedInt()];
      const auto& own = ranges[table->GetValueByName(i, "Column").ToUnsignedInt()];
      range = { std::min(range[0], own[0]), std::max(range[1], own[1]) };
    }
    for (std::size_t i = 0; i < results.size(); ++i)
    {
      if (!std::isnan(results[i]))
      {
        ASSERT_GE(results[i], around[i][0]) << i;
        ASSERT_LE(results[i], around[i][1]) << i;
      }
    }
    EXPECT_LT(Reported(remap, "ConservationError"), Rounding);
  }
}

/// Values between 0 and 1, some of them only these.
std::vector<double> RandomField(std::size_t size, int seed)
{
  Random random(seed);
  std::vector<double> values;
  for (std::size_t i = 0; i < size; ++i)
  {
    const double value = random.Between(0.0, 1.0);
    values.push_back(seed % 2 == 0 ? value : std::round(value));
  }
  return values;
}

}

TEST(RemapLimiters, OnASphere)
{
  for (int seed = 0; seed < 12; ++seed)
  {
    SCOPED_TRACE(seed);
    const Mesh from = seed % 3 == 0 ? IcosahedralDual(2 + seed / 2) : CubedSphere(2 + seed / 2);
    const GridPointer to = MakeGrid(seed % 3 == 0 ? CubedSphere(7) : IcosahedralDual(1 + seed / 2));
    ExpectWithin(from, to, RandomField(from.Cells.size(), seed));
  }
}

TEST(RemapLimiters, InAPlaneAndInVolumes)
{
  const auto bent = [](const Point& p) {
    return Point{ p[0] + 0.1 * std::sin(2.0 * p[1]), p[1] + 0.1 * p[0] * p[0], 0.0 };
  };
  for (int seed = 0; seed < 4; ++seed)
  {
    SCOPED_TRACE(seed);
    const Mesh sheet = Sheet(5, seed % 2 == 0 ? VTK_QUAD : VTK_TRIANGLE).Map(bent);
    ExpectWithin(sheet, MakeGrid(Transformed(Sheet(9, VTK_QUAD), 0.61, { 0, 0, 0 })),
      RandomField(sheet.Cells.size(), seed));
    const Mesh curved = Elevated(Sheet(3, VTK_QUAD), VTK_QUADRATIC_QUAD).Map(bent);
    ExpectWithin(curved, MakeGrid(Transformed(Sheet(6, VTK_TRIANGLE), 0.6, { -0.1, 0, 0 })),
      RandomField(curved.Cells.size(), seed));
    const Mesh volume = (seed % 2 == 0 ? Hexahedra(3) : Tetrahedra(2)).Map(Bent);
    ExpectWithin(volume, MakeGrid(Transformed(Hexahedra(5), 0.7, { -0.1, -0.1, -0.1 })),
      RandomField(volume.Cells.size(), seed));
  }
}

/// Where source cells are covered in part their gradients have a part in the integral.
TEST(RemapLimiters, WhatIsCoveredInPart)
{
  for (int seed = 0; seed < 8; ++seed)
  {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Mesh whole = CubedSphere(5);
    const Mesh part = Part(whole, [&](std::size_t) { return random.Index(3) == 0; });
    ExpectWithin(whole, MakeGrid(part), RandomField(whole.Cells.size(), seed));
    const Mesh sheet = Sheet(4, VTK_QUAD);
    ExpectWithin(sheet,
      MakeGrid(Transformed(Sheet(2, VTK_TRIANGLE), 0.7, { random.Between(0.0, 3.0), 0.3, 0 })),
      RandomField(sheet.Cells.size(), seed));
  }
}

/// Where fields are smooth little is lost by it: less than a first-order remap by far.
TEST(RemapLimiters, SmoothFieldsStaySharp)
{
  const auto hill = [](const Point& x)
  {
    return 2.0 -
      std::cos(std::min(3.14159265358979, 3.0 * std::acos(std::clamp(-x[0], -1.0, 1.0))));
  };
  const Mesh from = CubedSphere(16), to = IcosahedralDual(18);
  const GridPointer source = WithCellArray(MakeGrid(from), "f", CellAverages(from, hill));
  const std::vector<double> exact = CellAverages(to, hill);
  const auto errorOf = [&](int method, int limiter)
  {
    const RemapPointer remap = MakeRemap(MakeGrid(to), source, method);
    remap->SetLimiter(limiter);
    const std::vector<double> values = RemappedCells(remap, "f");
    return L2Error(values, exact, std::vector<double>(values.size(), 1.0));
  };
  const double first = errorOf(Remap::CONSERVATIVE_FIRST_ORDER, Remap::NO_LIMITER);
  EXPECT_LT(3.0 * errorOf(Remap::CONSERVATIVE_SECOND_ORDER, Remap::BARTH_JESPERSEN), first);
  EXPECT_LT(5.0 * errorOf(Remap::CONSERVATIVE_SECOND_ORDER, Remap::CLIP_AND_ASSURED_SUM), first);
}

/// Amounts, and means over whole cells that are covered in part.
TEST(RemapLimiters, AssuredSumsOfAmountsAndOfPartlyCoveredCells)
{
  const Mesh from = Sheet(6, VTK_QUAD);
  const std::vector<double> values = RandomField(from.Cells.size(), 1);
  for (const bool isAmount : { false, true })
  {
    const RemapPointer remap =
      MakeRemap(MakeGrid(Transformed(Sheet(5, VTK_TRIANGLE), 1.3, { 0.2, 0.1, 0 })),
        WithCellArray(MakeGrid(from), "f", values), Remap::CONSERVATIVE_SECOND_ORDER);
    remap->SetLimiter(Remap::CLIP_AND_ASSURED_SUM);
    remap->SetNormalization(Remap::WHOLE);
    if (isAmount)
    {
      remap->AddExtensiveArray("f");
    }
    for (const double value : RemappedCells(remap, "f"))
    {
      EXPECT_TRUE(std::isnan(value) || (value >= -Rounding && value <= 1.0 + Rounding)) << value;
    }
    EXPECT_LT(Reported(remap, "ConservationError"), Rounding);
  }
}
