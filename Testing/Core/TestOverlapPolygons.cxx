// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// What convex polygons have in common, in the plane and on the sphere, cells between meridians and
// parallels, and segments of one line: known measures, and parts that sum up to the whole.

#include "Core/Geometry/Overlap/LonLatOutline.h"
#include "Core/Geometry/Overlap/LonLatOverlap.h"
#include "Core/Geometry/Overlap/SegmentOverlap.h"
#include "CoreSolids.h"
#include "Dice.h"

#include <gtest/gtest.h>

using namespace coretest;

namespace
{

const double HalfTurn = std::acos(-1.0);

template <class Frame>
skd::Moments Common(const Frame& frame, const Polygon& one, const Polygon& other)
{
  skd::ConvexPolygon overlap;
  const auto result = skd::FindOverlap(frame, { one.data(), static_cast<int>(one.size()) },
    { other.data(), static_cast<int>(other.size()) }, overlap);
  return result == skd::ClipResult::Nothing ? skd::Moments() : frame.Moments(overlap);
}

Vector3 Unit(const Vector3& x)
{
  return (1.0 / Norm(x)) * x;
}

Vector3 MiddleOf(const Polygon& polygon)
{
  return Unit(std::accumulate(polygon.begin(), polygon.end(), Vector3{ { 0, 0, 0 } }));
}

/// About the sphere's centre.
skd::Moments OnSphere(const Polygon& one, const Polygon& other)
{
  const Vector3 middle = MiddleOf(one);
  return Common(skd::SphericalFrame(middle), one, other).Moved(-1.0 * middle);
}

/// The sphere as the sides of a cube, n x n a side, turned.
std::vector<Polygon> CubedSphere(int n, bool isTurned)
{
  std::vector<Polygon> cells;
  for (int i = 0; i < 6 * n * n; ++i)
  {
    const int side = i / (n * n);
    const double sign = side % 2 ? 1.0 : -1.0;
    Polygon cell;
    for (const auto& corner : { std::array<int, 2>{ 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } })
    {
      const int positions[2] = { i % n + corner[0], i / n % n + corner[1] };
      Vector3 x;
      x[side / 2] = sign;
      x[(side / 2 + 1) % 3] = sign * std::tan(HalfTurn / 4.0 * (2.0 * positions[0] / n - 1.0));
      x[(side / 2 + 2) % 3] = std::tan(HalfTurn / 4.0 * (2.0 * positions[1] / n - 1.0));
      cell.push_back(Unit(isTurned ? Rotated(x) : x));
    }
    cells.push_back(cell);
  }
  return cells;
}

TEST(OverlapPolygons, PlaneParts)
{
  Dice dice(3);
  for (const double factor : Factors())
  {
    for (int turn = 0; turn < 500; ++turn)
    {
      const double size = std::pow(10.0, -dice.Between(0.0, 5.0));
      const Vector3 at = dice.Point(1.0);
      const double flat = turn % 3 == 0 ? 1e-7 : 1.0;
      Polygon one;
      for (const Vector3& x : Regular(3 + turn % 9))
      {
        one.push_back(factor * Vector3{ { at[0] + size * x[0], at[1] + size * flat * x[1], 0.0 } });
      }
      const Vector3 middle = factor * Vector3{ { at[0], at[1], 0.0 } };
      const skd::PlanarFrame frame(middle);
      const auto scaled = [&](double x, double y) {
        return Vector3{ { factor * x, factor * y, 0.0 } };
      };
      const Polygon square{ scaled(-1, -1), scaled(1, -1), scaled(1, 1), scaled(-1, 1) };
      const Vector3 apex = scaled(dice.Between(-1, 1), dice.Between(-1, 1));
      const skd::Moments whole = Common(frame, one, square);
      skd::Moments sum;
      for (int i = 0; i < 4; ++i)
      {
        sum.Add(Common(frame, one, { apex, square[i], square[(i + 1) % 4] }), 1.0);
      }
      const double area = std::pow(factor * size, 2);
      ASSERT_NEAR(sum.Measure / area, whole.Measure / area, 1e-14 * flat / size);
      ASSERT_NEAR(Norm(sum.First - whole.First) / (area * factor * size), 0.0, 1e-14 / size);
    }
  }
}

TEST(OverlapPolygons, AnOctantOfTheSphere)
{
  const Polygon octant{ { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 1 } } };
  const skd::Moments moments = OnSphere(octant, octant);
  EXPECT_NEAR(moments.Measure, HalfTurn / 2.0, 1e-15);
  EXPECT_NEAR(Norm(moments.First - HalfTurn / 4.0 * Vector3{ { 1, 1, 1 } }), 0.0, 1e-15);
}

TEST(OverlapPolygons, CoversTheSphere)
{
  for (const bool isTurned : { false, true })
  {
    const auto ones = CubedSphere(7, false);
    const auto others = CubedSphere(4, isTurned);
    double total = 0.0;
    for (const Polygon& one : ones)
    {
      const skd::Moments whole = OnSphere(one, one);
      skd::Moments sum;
      for (const Polygon& other : others)
      {
        if (Dot(MiddleOf(one), MiddleOf(other)) > 0.2)
        {
          sum.Add(OnSphere(one, other), 1.0);
        }
      }
      ASSERT_NEAR(sum.Measure / whole.Measure, 1.0, 1e-14);
      ASSERT_NEAR(Norm(sum.First - whole.First) / whole.Measure, 0.0, 1e-14);
      total += sum.Measure;
    }
    EXPECT_NEAR(total, 4.0 * HalfTurn, 1e-13);
  }
}

/// Cells that are as small as they come keep all digits.
TEST(OverlapPolygons, TinyCellsOfTheSphere)
{
  const Vector3 middle = Unit({ { 0.3, -0.5, 0.7 } });
  const skd::SphericalFrame frame(middle);
  for (const double size : { 1e-2, 1e-4, 1e-6 })
  {
    const auto at = [&](double x, double y) { return frame.FromFrame({ { size * x, size * y } }); };
    const Polygon one{ at(-1.1, -1), at(1, -1.2), at(0.8, 1), at(-0.9, 1.3) };
    const Polygon far{ at(5, 0.3), at(0.2, 7), at(-6, 0.1), at(0.3, -9) };
    const skd::Moments whole = Common(frame, one, one);
    skd::Moments sum;
    for (int i = 0; i < 4; ++i)
    {
      sum.Add(Common(frame, one, { at(0.1, -0.05), far[i], far[(i + 1) % 4] }), 1.0);
    }
    EXPECT_NEAR(sum.Measure / whole.Measure, 1.0, 1e-14);
    EXPECT_NEAR(Norm(sum.First - whole.First) / whole.Measure, 0.0, 4e-16);
    // As in the plane; points of the unit sphere are rounded, and cells of this size with them.
    EXPECT_NEAR(whole.Measure / (size * size), 4.275, 10.0 * size * size + 1e-15 / size);
  }
}

skd::LonLatCell CellOf(int i, int columns, int rows)
{
  const double width = 2.0 * HalfTurn / columns;
  const double height = HalfTurn / rows;
  const int column = i % columns;
  const int row = i / columns;
  return { column * width - 0.3, (column + 1) * width - 0.3, row * height - 0.5 * HalfTurn,
    (row + 1) * height - 0.5 * HalfTurn };
}

TEST(OverlapPolygons, LonLatCellsCoverEachOther)
{
  double total = 0.0;
  for (int i = 0; i < 9 * 5; ++i)
  {
    const skd::LonLatCell one = CellOf(i, 9, 5);
    const skd::Moments whole = skd::MomentsOf(one, one.Centre());
    skd::Moments sum;
    for (int k = 0; k < 16 * 8; ++k)
    {
      skd::LonLatCell other = CellOf(k, 16, 8);
      other.West += 2.0 * HalfTurn; // the same place
      other.East += 2.0 * HalfTurn;
      if (const auto common = skd::CommonCell(one, other))
      {
        sum.Add(skd::MomentsOf(*common, one.Centre()), 1.0);
      }
    }
    ASSERT_NEAR(sum.Measure / whole.Measure, 1.0, 1e-14);
    ASSERT_NEAR(Norm(sum.First - whole.First), 0.0, 1e-15);
    total += sum.Measure;
  }
  EXPECT_NEAR(total, 4.0 * HalfTurn, 1e-13);
}

/// Edges of two kinds: great circles against parallels. Poles are corners, insides, and on edges.
TEST(OverlapPolygons, LonLatCellsCoverPolygons)
{
  for (const auto& [n, columns, rows] :
    { std::array<int, 3>{ 1, 3, 2 }, { 2, 8, 4 }, { 5, 36, 18 } })
  {
    std::vector<double> covered(static_cast<std::size_t>(columns * rows), 0.0);
    for (const bool isTurned : { false, true })
    {
      for (const Polygon& one : CubedSphere(n, isTurned))
      {
        const Vector3 middle = MiddleOf(one);
        const skd::Moments whole = OnSphere(one, one).Moved(middle);
        skd::Moments sum;
        for (int i = 0; i < columns * rows; ++i)
        {
          const skd::Moments common =
            skd::FindOverlap(middle, { one.data(), 4 }, CellOf(i, columns, rows));
          ASSERT_GE(common.Measure, -1e-14);
          sum.Add(common, 1.0);
          covered[static_cast<std::size_t>(i)] += common.Measure;
        }
        ASSERT_NEAR(sum.Measure / whole.Measure, 1.0, 2e-14);
        ASSERT_NEAR(Norm(sum.First - whole.First) / whole.Measure, 0.0, 2e-14);
      }
    }
    for (int i = 0; i < columns * rows; ++i)
    {
      const skd::LonLatCell cell = CellOf(i, columns, rows);
      const double area = skd::MomentsOf(cell, cell.Centre()).Measure;
      ASSERT_NEAR(covered[static_cast<std::size_t>(i)] / area, 2.0, 2e-14);
    }
  }
}

TEST(OverlapPolygons, OutlinesOfLonLatCells)
{
  const skd::LonLatCell cell{ 3.0, 3.4, -0.2, 0.5 }; // across the date line
  const std::vector<Vector3> corners{ cell.At(3.0, -0.2), cell.At(3.2, -0.2), cell.At(3.4, -0.2),
    cell.At(3.4, 0.5), cell.At(3.0, 0.5) };
  const auto found = skd::LonLatOutline(corners).Find();
  ASSERT_TRUE(found);
  EXPECT_NEAR(skd::MomentsOf(*found, cell.Centre()).Measure,
    skd::MomentsOf(cell, cell.Centre()).Measure, 1e-15);
  const auto atPole = skd::LonLatOutline({ cell.At(1, 1), cell.At(2, 1), { { 0, 0, 1 } } }).Find();
  ASSERT_TRUE(atPole);
  EXPECT_NEAR(atPole->North, HalfTurn / 2.0, 1e-15);
  EXPECT_NEAR(atPole->Width(), 1.0, 1e-15);
  std::vector<Vector3> around;
  for (int i = 0; i < 8; ++i)
  {
    around.push_back(cell.At(HalfTurn / 4.0 * i, -1));
  }
  const auto cap = skd::LonLatOutline(around).Find();
  ASSERT_TRUE(cap);
  EXPECT_NEAR(
    skd::MomentsOf(*cap, { { 0, 0, 0 } }).Measure, 2.0 * HalfTurn * (1.0 - std::sin(1.0)), 1e-14);
  around.resize(4);
  EXPECT_FALSE(skd::LonLatOutline(around).Find());
  EXPECT_FALSE(skd::LonLatOutline({ cell.At(0, 0), cell.At(1, 0.2), cell.At(0, 1) }).Find());
}

TEST(OverlapPolygons, SegmentsOfOneLine)
{
  const Vector3 start{ { 0.1, 0.2, -0.3 } };
  const Vector3 direction{ { 0.3, -0.4, 1.2 } };
  const auto segment = [&](double from, double to) {
    return skd::Segment<3>{ start + from * direction, start + to * direction };
  };
  const auto lengthOf = [](const auto& common) {
    return common ? skd::MomentsOf(*common, { { 0, 0, 0 } }).Measure : 0.0;
  };
  EXPECT_NEAR(lengthOf(skd::CommonInterval(segment(0, 2), segment(3, 1))), 1.3, 1e-15);
  EXPECT_NEAR(lengthOf(skd::CommonInterval(segment(0, 9), segment(3, 1))), 2.6, 1e-15);
  EXPECT_FALSE(skd::CommonInterval(segment(0, 1), segment(1, 2)));
  EXPECT_FALSE(skd::CommonInterval(segment(0, 1), segment(2, 3)));
  EXPECT_FALSE(skd::CommonInterval(segment(0, 1), { start, start + Vector3{ { 1, 0, 0 } } }));
  EXPECT_FALSE(skd::CommonInterval(segment(0, 1), segment(0.5, 0.5)));
}

}
