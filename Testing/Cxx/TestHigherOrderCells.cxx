// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// Lagrange and Bezier cells queried by many threads: VTK evaluates all wedges in one static
// triangle, and its derivatives of some Bezier cells are written past their end. We must touch
// neither.

#include "Support/CellZoo.h"
#include "Support/ClosestPointRun.h"
#include "Support/CurveRun.h"
#include "Support/LocatorCalls.h"
#include "Support/ProbeRun.h"
#include "Support/TestAmount.h"

#include "vtkSMPTools.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

using namespace skdtest;

namespace
{

/// Enough for all threads to meet.
const int Many = FewerTests() ? 200 : 500;

struct Kind
{
  int Type;
  bool IsRational;
};

void PrintTo(const Kind& kind, std::ostream* os)
{
  *os << (kind.IsRational ? "Rational" : "") << NameOfType(kind.Type);
}

Point Bulged(const Point& p)
{
  return { p[0] + 0.05 * std::sin(1.3 * p[1]), p[1] + 0.04 * std::cos(1.1 * p[2]), p[2] };
}

std::vector<Kind> AllKinds()
{
  std::vector<Kind> kinds;
  for (const int type : AllCellTypes())
  {
    if (IsHigherOrder(type) && DimensionOf(type) > 1)
    {
      kinds.push_back({ type, false });
    }
    if (type > VTK_BEZIER_CURVE && IsHigherOrder(type))
    {
      kinds.push_back({ type, true });
    }
  }
  return kinds;
}

/// Cells of order 2 and of order 3: what is shared by both would change its size at each call.
/// Surfaces are flat, for the sake of their gradients.
GridPointer MakeCells(const Kind& kind)
{
  const bool isFlat = DimensionOf(kind.Type) == 2;
  const auto where = [=](const Point& p) { return isFlat ? p : Bulged(p); };
  Mesh mesh = Block(ReferenceCell(kind.Type, 2), where);
  const Mesh cubic = Block(ReferenceCell(kind.Type, 3),
    [&](const Point& p) {
      return where(p + Point{ 4, 0, 0 });
    });
  const auto first = static_cast<vtkIdType>(mesh.Points.size());
  for (const Point& p : cubic.Points)
  {
    mesh.Add(p);
  }
  for (const CellSpec& cell : cubic.Cells)
  {
    Ids ids = cell.Points;
    for (vtkIdType& id : ids)
    {
      id += first;
    }
    mesh.Add(cell.Type, ids);
  }
  GridPointer grid = MakeGrid(mesh);
  if (kind.IsRational)
  {
    Random random(7);
    std::vector<double> weights(mesh.Points.size());
    std::generate(weights.begin(), weights.end(), [&] { return random.Between(0.5, 2.0); });
    SetRationalWeights(grid, weights);
  }
  return WithData(grid);
}

class HigherOrderCells : public testing::TestWithParam<Kind>
{
protected:
  void SetUp() override
  {
    this->Former = vtkSMPTools::GetBackend();
    vtkSMPTools::SetBackend("STDThread");
    vtkSMPTools::Initialize(4);
    this->Grid = MakeCells(GetParam());
    this->Points = RandomQueries(this->Grid, FewerTests() ? 50 : 100);
  }

  void TearDown() override
  {
    vtkSMPTools::Initialize(0);
    vtkSMPTools::SetBackend(this->Former.c_str());
  }

  std::string Former;
  GridPointer Grid;
  std::vector<Point> Points;
};

INSTANTIATE_TEST_SUITE_P(All, HigherOrderCells, testing::ValuesIn(AllKinds()),
  [](const auto& info) { return testing::PrintToString(info.param); });

/// To the last bit, but where VTK's take too long.
TEST_P(HigherOrderCells, WeightsAreThoseOfVtk)
{
  const int type = GetParam().Type;
  const bool isTensor = type == VTK_LAGRANGE_QUADRILATERAL || type == VTK_LAGRANGE_HEXAHEDRON ||
    type == VTK_BEZIER_QUADRILATERAL || type == VTK_BEZIER_HEXAHEDRON;
  const LocatorPointer locator = MakeLocator(this->Grid);
  vtkNew<vtkGenericCell> cell;
  int found = 0;
  for (const Point& x : MakePointsInCells(this->Grid, 100).Points)
  {
    const Found in = FindCell(locator, x, 1e-6);
    if (in.Cell >= 0) // points among those of a Bezier cell need not be in it
    {
      ++found;
      this->Grid->GetCell(in.Cell, cell);
      std::vector<double> weights(cell->GetNumberOfPoints());
      cell->InterpolateFunctions(in.Pcoords.data(), weights.data());
      for (std::size_t i = 0; i < weights.size(); ++i)
      {
        ASSERT_NEAR(in.Weights[i], weights[i], isTensor ? 0.0 : 1e-14);
      }
    }
  }
  EXPECT_GT(found, 50);
}

TEST_P(HigherOrderCells, ThreadsGetTheAnswersOfOne)
{
  const LocatorPointer locator = MakeLocator(this->Grid);
  std::vector<Closest> nearest;
  std::vector<Found> inCells;
  for (const Point& x : this->Points)
  {
    nearest.push_back(FindClosest(locator, x));
    inCells.push_back(FindCell(locator, x));
  }
  std::atomic<int> wrong(0);
  std::vector<std::thread> threads;
  for (int thread = 0; thread < 4; ++thread)
  {
    threads.emplace_back(
      [&, thread]
      {
        for (std::size_t k = 0; k < this->Points.size(); ++k)
        {
          const std::size_t i = (k + 50 * thread) % this->Points.size();
          wrong += !(FindClosest(locator, this->Points[i]) == nearest[i]);
          wrong += !(FindCell(locator, this->Points[i]) == inCells[i]);
        }
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  EXPECT_EQ(wrong, 0);
}

TEST_P(HigherOrderCells, DataAtClosestPointsAreInterpolatedByThreads)
{
  FilterPointer filter = MakeFilter(MakeQueries(RandomQueries(this->Grid, Many)), this->Grid);
  filter->InterpolateSourceDataOn();
  const std::vector<double> field = RunArray(filter, "Linear");
  const std::vector<double> closest = RunArray(filter, "SkdClosestPoint");
  ASSERT_EQ(field.size(), static_cast<std::size_t>(Many));
  for (std::size_t i = 0; i < field.size(); ++i)
  {
    ASSERT_NEAR(field[i], Linear({ closest[3 * i], closest[3 * i + 1], closest[3 * i + 2] }), 1e-9);
  }
}

TEST_P(HigherOrderCells, GradientsOfLinearFieldsAreRightByThreads)
{
  const PointsInCells requested = MakePointsInCells(this->Grid, Many);
  ProbePointer probe = MakeProbe(MakeQueries(requested.Points), this->Grid);
  probe->AddGradientArray("Linear");
  const std::vector<double> field = ProbeArray(probe, "Linear");
  const std::vector<double> cells = ProbeArray(probe, "SkdSourceCellId");
  const std::vector<double> gradients = ProbeArray(probe, "Linear_Gradient");
  ASSERT_EQ(gradients.size(), 3 * requested.Points.size());
  const double origin = Linear({ 0, 0, 0 });
  const bool isFlat = DimensionOf(GetParam().Type) == 2; // then there is none across
  const Point expected = { Linear({ 1, 0, 0 }) - origin, Linear({ 0, 1, 0 }) - origin,
    isFlat ? 0.0 : Linear({ 0, 0, 1 }) - origin };
  std::size_t found = 0;
  for (std::size_t i = 0; i < field.size(); ++i)
  {
    const Point gradient = { gradients[3 * i], gradients[3 * i + 1], gradients[3 * i + 2] };
    if (cells[i] >= 0)
    {
      ++found;
      ASSERT_NEAR(field[i], Linear(requested.Points[i]), 1e-9);
      ASSERT_LT(Distance(gradient, expected), 1e-7) << i;
    }
  }
  EXPECT_GT(found, field.size() / 2);
}

}
