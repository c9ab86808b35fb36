// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// The nearest point of a curved cell is the nearest of all its points, not of those around it:
// against dense samples of cells that are bent so much that distances have several minima.

#include "Support/BentCells.h"

#include <gtest/gtest.h>

using namespace skdtest;

namespace
{

/// Points of a cell on a lattice of its parameters.
std::vector<Point> SamplesOf(vtkDataSet* grid)
{
  vtkNew<vtkGenericCell> cell;
  grid->GetCell(0, cell);
  ParametricCell map(cell);
  const int dimension = map.Dimension();
  const bool isSlow = IsSlow(cell->GetCellType());
  const int n = dimension == 1 ? 1000 : dimension == 2 ? (isSlow ? 20 : 60) : (isSlow ? 7 : 14);
  const double low = cell->GetCellType() == VTK_CUBIC_LINE ? -1.0 : 0.0;
  std::vector<Point> samples;
  for (int i = 0; i <= n; ++i)
  {
    for (int j = 0; j <= (dimension > 1 ? n : 0); ++j)
    {
      for (int k = 0; k <= (dimension > 2 ? n : 0); ++k)
      {
        const Point p = { low + (1 - low) * i / n, double(j) / n, double(k) / n };
        if (map.Contains(p))
        {
          samples.push_back(map.At(p));
        }
      }
    }
  }
  return samples;
}

double LeastDistance(const std::vector<Point>& samples, const Point& x)
{
  double least = std::numeric_limits<double>::infinity();
  for (const Point& sample : samples)
  {
    least = std::min(least, Distance(sample, x));
  }
  return least;
}

class NearestOnCurved : public testing::TestWithParam<BentCell>
{
};

std::vector<BentCell> AllCases()
{
  std::vector<BentCell> cases = {
    { VTK_LAGRANGE_TRIANGLE, 3, 0.1 },
    { VTK_LAGRANGE_TRIANGLE, 4, 0.03 },
    { VTK_LAGRANGE_TRIANGLE, 4, 0.2 },
    { VTK_LAGRANGE_TRIANGLE, 6, 0.03 },
    { VTK_LAGRANGE_QUADRILATERAL, 3, 0.1 },
    { VTK_LAGRANGE_QUADRILATERAL, 4, 0.03 },
    { VTK_LAGRANGE_QUADRILATERAL, 4, 0.2 },
    { VTK_LAGRANGE_QUADRILATERAL, 4, 0.05, 100 },
    { VTK_LAGRANGE_QUADRILATERAL, 4, 0.1, 1, 1e-9, 0 },
    { VTK_LAGRANGE_QUADRILATERAL, 4, 0.1, 1, 1, 1e6 },
    { VTK_LAGRANGE_QUADRILATERAL, 6, 0.03 },
    { VTK_LAGRANGE_CURVE, 6, 0.1 },
    { VTK_BEZIER_CURVE, 6, 0.3 },
    { VTK_LAGRANGE_TETRAHEDRON, 4, 0.05 },
    { VTK_LAGRANGE_HEXAHEDRON, 3, 0.1 },
    { VTK_LAGRANGE_WEDGE, 3, 0.1 },
    { VTK_QUADRATIC_PYRAMID, 2, 0.1 },
  };
  for (const int type : AllCellTypes())
  {
    if (DomainOf(type) != Domain::None && type < VTK_LAGRANGE_CURVE)
    {
      cases.push_back({ type, 2, 0.2 });
      cases.push_back({ type, 2, 0.1, 1, 1, 0, true });
    }
  }
  for (const int type : { VTK_BEZIER_CURVE, VTK_BEZIER_TRIANGLE, VTK_BEZIER_QUADRILATERAL,
         VTK_BEZIER_TETRAHEDRON, VTK_BEZIER_HEXAHEDRON, VTK_BEZIER_WEDGE })
  {
    cases.push_back({ type, 3, 0.2, 1, 1, 0, false, true });
    cases.push_back({ type, 2, 0.1, 1, 1, 0, true, true });
  }
  return cases;
}

INSTANTIATE_TEST_SUITE_P(Bent, NearestOnCurved, testing::ValuesIn(AllCases()));

void ExpectNoSampleIsNearer(const BentCell& c)
{
  Random random(1 + c.Type);
  for (int cell = 0; cell < (IsSlow(c.Type) ? 1 : 4); ++cell)
  {
    const auto grid = MakeCell(c, random);
    const auto samples = SamplesOf(grid);
    const auto locator = MakeLocator(grid);
    for (int query = 0; query < (IsSlow(c.Type) ? 10 : 30); ++query)
    {
      const double out = 0.5 * c.Far;
      const Point near = random.InBox({ -out, 1 + out, -out, 1 + out, -out, 1 + out });
      const Point x = c.Scale * (near + Point{ c.Offset, c.Offset, c.Offset });
      const double distance = std::sqrt(FindClosest(locator, x).Dist2);
      const double rounding = 1e-14 * (c.Far + c.Offset);
      ASSERT_LE(distance, LeastDistance(samples, x) + c.Scale * (1e-12 + rounding));
    }
  }
}

TEST_P(NearestOnCurved, NoSampleIsNearer)
{
  ExpectNoSampleIsNearer(GetParam());
}

/// What is known of a type and an order must not be learnt from a cell that has no points.
TEST(NearestOnRational, IsRightAfterACellWhoseWeightsAreZero)
{
  const BentCell c = { VTK_BEZIER_QUADRILATERAL, 7, 0.3, 1, 1, 0, false, true };
  Random random(1);
  const auto broken = MakeCell(c, random);
  broken->GetPointData()->GetRationalWeights()->Fill(0.0);
  FindClosest(MakeLocator(broken), { 0.5, 0.5, 2.0 });
  ExpectNoSampleIsNearer(c);
}

/// z = x^2 / 2: its evolute's cusp is at (0, 0, 1), and above that are two nearest points.
TEST(NearestOnParabola, PointsOnTheAxisHaveTheirDistance)
{
  const Mesh mesh = ReferenceCell(VTK_LAGRANGE_QUADRILATERAL, 4)
                      .Map(
                        [](const Point& p)
                        {
                          const double x = 4 * p[0] - 2;
                          return Point{ x, 4 * p[1] - 2, 0.5 * x * x };
                        });
  const auto grid = MakeGrid(mesh);
  const auto locator = MakeLocator(grid);
  for (const double z : { 0.5, 0.999, 1.0, 1.0 + 1e-9, 1.001, 1.5, 2.5 })
  {
    const double expected = z <= 1 ? z : std::sqrt(2 * z - 1);
    EXPECT_NEAR(std::sqrt(FindClosest(locator, { 0, 0.3, z }).Dist2), expected, 1e-12);
  }
}

/// The inner quarter of a quarter of a torus around z, of radii 2 and 1: all of a circle on it is
/// as near to a point of the axis.
TEST(NearestOnTorus, PointsOfTheAxisHaveTheirDistance)
{
  Mesh mesh;
  mesh.Points = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 2, 1 }, { 2, 0, 1 }, { 1, 1, 0 }, { 0, 1, 1 },
    { 2, 2, 1 }, { 1, 0, 1 }, { 1, 1, 1 } };
  mesh.Add(VTK_BEZIER_QUADRILATERAL, { 0, 1, 2, 3, 4, 5, 6, 7, 8 });
  const auto grid = MakeGrid(mesh);
  const double w = std::sqrt(0.5);
  vtkNew<vtkDoubleArray> rational;
  rational->SetName("RationalWeights");
  for (const double weight : { 1.0, 1.0, 1.0, 1.0, w, w, w, w, w * w })
  {
    rational->InsertNextValue(weight);
  }
  grid->GetPointData()->SetRationalWeights(rational);
  const auto locator = MakeLocator(grid);
  for (const double z : { 0.0, 0.1, 0.5, 1.0, 3.0 })
  {
    const double expected = std::hypot(2, z) - 1;
    EXPECT_NEAR(std::sqrt(FindClosest(locator, { 0, 0, z }).Dist2), expected, 1e-12);
  }
}

}
