// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// Which donor points the cells of a mesh hold, and what is made of their values.

#include "Remap/SkdContainedMean.h"
#include "Support/BruteForce.h"
#include "Support/FilterRun.h"
#include "Support/StructuredMeshes.h"
#include "Support/SurfaceMeshes.h"
#include "Support/VolumeMeshes.h"

#include "vtkSMPTools.h"
#include "vtkTrivialProducer.h"

#include <gtest/gtest.h>

using namespace skdtest;
using namespace skdtree;

namespace
{
using Lists = std::vector<std::vector<std::uint32_t>>;

std::vector<skd::Vector3> RandomPoints(int count, const Bounds& box)
{
  Random random(3);
  std::vector<skd::Vector3> points;
  for (int i = 0; i < count; ++i)
  {
    const Point p = random.InBox(box);
    points.push_back({ { p[0], p[1], p[2] } });
  }
  return points;
}

struct MeanRun
{
  MeanRun(vtkDataSet* mesh, bool isOnSphere, std::vector<skd::Vector3> points,
    std::vector<double> weights = {})
    : Cells(mesh, isOnSphere)
    , Mean(points, std::move(weights), isOnSphere)
    , Points(std::move(points))
  {
  }

  Lists Contained()
  {
    Lists lists(static_cast<std::size_t>(Cells.GetNumberOfCells()));
    SkdLoop loop(this->Algorithm, Cells.GetNumberOfCells(), 0.0, 1.0);
    this->Mean.ForEachCell(this->Cells, loop,
      [&](const SkdTargetCells::Cell&, vtkIdType id, const std::vector<std::uint32_t>& points)
      { lists[static_cast<std::size_t>(id)] = points; });
    return lists;
  }

  std::vector<double> Means(
    const std::vector<double>& values, SkdEmptyCells empty = SkdEmptyCells::Leave)
  {
    SkdLoop loop(this->Algorithm, Cells.GetNumberOfCells(), 0.0, 1.0);
    return this->Mean.GetMeans(this->Cells, values, empty, loop);
  }

  vtkNew<vtkTrivialProducer> Algorithm;
  SkdTargetCells Cells;
  SkdContainedMean Mean;
  std::vector<skd::Vector3> Points;
};

/// Whether a direction is within a convex polygon on the sphere that turns left.
bool IsWithin(vtkCell* cell, const skd::Vector3& x)
{
  const int n = static_cast<int>(cell->GetNumberOfPoints());
  for (int i = 0; i < n; ++i)
  {
    double a[3], b[3];
    cell->GetPoints()->GetPoint(i, a);
    cell->GetPoints()->GetPoint((i + 1) % n, b);
    const auto minor = [&](int u, int v)
    { return (long double)a[u] * b[v] - (long double)a[v] * b[u]; };
    if (minor(1, 2) * x[0] + minor(2, 0) * x[1] + minor(0, 1) * x[2] < 0)
    {
      return false;
    }
  }
  return true;
}

skd::Vector3 Direction(double longitude, double latitude)
{
  const double degree = std::acos(-1.0) / 180.0;
  return { { std::cos(latitude * degree) * std::cos(longitude * degree),
    std::cos(latitude * degree) * std::sin(longitude * degree), std::sin(latitude * degree) } };
}

PolyDataPointer MakePolygon(const std::vector<skd::Vector3>& corners)
{
  Mesh mesh;
  Ids ids;
  for (const skd::Vector3& x : corners)
  {
    ids.push_back(mesh.Add({ x[0], x[1], x[2] }));
  }
  mesh.Add(VTK_POLYGON, ids);
  return MakePolyData(mesh);
}
}

TEST(ContainedMean, CellsOfASphereHoldWhatIsBetweenTheirGreatCircles)
{
  const auto mesh = MakePolyData(SphereQuads(3));
  MeanRun run(mesh, true, RandomPoints(2000, { -2, 2, -2, 2, -2, 2 }));
  const Lists lists = run.Contained();
  std::size_t sum = 0;
  for (vtkIdType id = 0; id < mesh->GetNumberOfCells(); ++id)
  {
    std::vector<std::uint32_t> expected;
    for (std::uint32_t i = 0; i < run.Points.size(); ++i)
    {
      if (IsWithin(mesh->GetCell(id), run.Points[i]))
      {
        expected.push_back(i);
      }
    }
    ASSERT_EQ(lists[static_cast<std::size_t>(id)], expected) << id;
    sum += expected.size();
  }
  EXPECT_EQ(sum, run.Points.size());
}

TEST(ContainedMean, RimsAreInBothCells)
{
  const auto mesh = MakePolyData(Sheet(4, VTK_QUAD));
  MeanRun run(mesh, false, { { { 1, 0.5, 0 } }, { { 2, 2, 0 } }, { { 0.5, 0.5, 0.1 } } });
  std::vector<int> cells(3);
  for (const auto& list : run.Contained())
  {
    for (const std::uint32_t i : list)
    {
      ++cells[i];
    }
  }
  EXPECT_EQ(cells, (std::vector<int>{ 2, 4, 0 }));
}

TEST(ContainedMean, VolumesHoldWhatIsInThemNotInTheirBoxes)
{
  const auto mesh = MakeGrid(Tetrahedra(3));
  Bounds box;
  mesh->GetBounds(box.data());
  MeanRun run(mesh, false, RandomPoints(500, box));
  const Lists lists = run.Contained();
  BruteForce reference(mesh);
  for (vtkIdType id = 0; id < mesh->GetNumberOfCells(); ++id)
  {
    std::vector<std::uint32_t> expected;
    for (std::uint32_t i = 0; i < run.Points.size(); ++i)
    {
      const skd::Vector3& x = run.Points[i];
      if (reference.DistanceTo(id, { x[0], x[1], x[2] }) <= reference.Tolerance())
      {
        expected.push_back(i);
      }
    }
    ASSERT_EQ(lists[static_cast<std::size_t>(id)], expected) << id;
  }
}

TEST(ContainedMean, PolesDateLineAndConcaveCellsAreOrdinary)
{
  std::vector<skd::Vector3> requested = { Direction(0, 89), Direction(180, 89), Direction(180, 60),
    Direction(-179, 5), Direction(179, 5), Direction(0, 5), Direction(0, -89) };
  const auto contained = [&](const std::vector<skd::Vector3>& corners)
  { return MeanRun(MakePolygon(corners), true, requested).Contained()[0]; };
  using List = std::vector<std::uint32_t>;
  const std::vector<skd::Vector3> cap = { Direction(0, 80), Direction(120, 80),
    Direction(240, 80) };
  EXPECT_EQ(contained(cap), (List{ 0, 1 }));
  EXPECT_EQ(contained({ cap.rbegin(), cap.rend() }), (List{ 0, 1 }));
  EXPECT_EQ(contained({ Direction(170, 0), Direction(-170, 0), Direction(-170, 10),
              Direction(170, 10), Direction(170, 10) }),
    (List{ 3, 4 }));
  // An L around the date line: concave at (180, 3).
  EXPECT_EQ(contained({ Direction(170, 0), Direction(-170, 0), Direction(-170, 3),
              Direction(180, 3), Direction(180, 10), Direction(170, 10) }),
    (List{ 4 }));
  EXPECT_EQ(contained({ Direction(0, 0), Direction(0, 0), Direction(10, 0) }), List{});
}

TEST(ContainedMean, EmptyCellsTakeNothingTheNearestOrThoseAround)
{
  const auto mesh = MakePolyData(Sheet(4, VTK_TRIANGLE));
  MeanRun run(mesh, false, { { { 0.9, 0.1, 0 } }, { { 0.8, 0.2, 0 } } });
  const std::vector<double> values = { 1.0, 3.0 };
  const auto last = static_cast<std::size_t>(mesh->GetNumberOfCells() - 1);
  EXPECT_TRUE(std::isnan(run.Means(values)[last]));
  EXPECT_EQ(run.Means(values, SkdEmptyCells::Nearest)[last], 3.0);
  EXPECT_EQ(run.Means(values, SkdEmptyCells::EnclosingBox)[last], 2.0);
  EXPECT_EQ(run.Means({ 1.0, std::nan("") }, SkdEmptyCells::Nearest)[last], 1.0);
  EXPECT_TRUE(
    std::isnan(run.Means({ std::nan(""), std::nan("") }, SkdEmptyCells::EnclosingBox)[last]));
}

TEST(ContainedMean, WeightedMeansAreThoseOfBruteForceOnAnyNumberOfThreads)
{
  const auto mesh = MakePolyData(SphereTriangles(3));
  const std::vector<skd::Vector3> points = RandomPoints(3000, { -1, 1, -1, 1, -1, 1 });
  std::vector<double> weights, values;
  for (const skd::Vector3& x : points)
  {
    weights.push_back(1.0 + std::abs(x[2]));
    values.push_back(1.0 + x[0] + x[1] * x[2]);
  }
  MeanRun run(mesh, true, points, weights);
  const Lists lists = run.Contained();
  const std::vector<double> means = run.Means(values);
  for (std::size_t cell = 0; cell < lists.size(); ++cell)
  {
    double sum = 0.0, weight = 0.0;
    for (const std::uint32_t i : lists[cell])
    {
      sum += weights[i] * values[i];
      weight += weights[i];
    }
    ASSERT_NEAR(means[cell], sum / weight, 1e-14);
  }
  vtkSMPTools::LocalScope(vtkSMPTools::Config{ 1 }, [&] { EXPECT_EQ(run.Means(values), means); });
  const std::vector<double> constant(points.size(), 0.1);
  const std::vector<double> same(means.size(), 0.1);
  EXPECT_EQ(run.Means(constant), same); // to the last bit
}

TEST(ContainedMean, StatisticsAreThoseOfTheirNames)
{
  using Samples = std::vector<SkdWeightedValue>;
  const auto of = [](SkdStatistic statistic, Samples samples)
  { return SkdStatisticOf(statistic, samples); };
  const Samples some = { { 4, 1 }, { 1, 1 }, { 3, 2 } };
  EXPECT_EQ(of(SkdStatistic::Mean, some), 2.75);
  EXPECT_EQ(of(SkdStatistic::Minimum, some), 1);
  EXPECT_EQ(of(SkdStatistic::Maximum, some), 4);
  EXPECT_EQ(of(SkdStatistic::Sum, some), 8);
  EXPECT_DOUBLE_EQ(of(SkdStatistic::StandardDeviation, some), std::sqrt(4.75 / 4));
  EXPECT_EQ(of(SkdStatistic::Median, some), 3);
  EXPECT_EQ(of(SkdStatistic::Median, { { 4, 1 }, { 1, 1 } }), 2.5);
  EXPECT_EQ(of(SkdStatistic::Median, { { 7, 1 } }), 7);
}
