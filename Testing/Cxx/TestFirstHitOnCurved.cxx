// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// The first hit of a line with a curved cell is the first one of all: against roots found from each
// of a dense lattice of samples, of cells that are bent so much that lines meet them many times,
// and of lines that nearly touch them.

#include "Support/BentCells.h"

#include <gtest/gtest.h>

using namespace skdtest;

namespace
{

/// What bounds a cell, in its parameters: all of a surface, a side of a volume.
struct Side
{
  bool IsTriangle;
  Point Origin;
  Point Axes[2];

  Point At(double r, double s) const
  {
    return this->Origin + r * this->Axes[0] + s * this->Axes[1];
  }
};

std::vector<Side> SidesOf(int type)
{
  const Point o = { 0, 0, 0 };
  const Point x = { 1, 0, 0 };
  const Point y = { 0, 1, 0 };
  const Point z = { 0, 0, 1 };
  const Point xToY = { -1, 1, 0 };
  const Point xToZ = { -1, 0, 1 };
  const Domain domain = DomainOf(type);
  const bool isSimplex = domain == Domain::Simplex;
  if (DimensionOf(type) == 2)
  {
    return { { isSimplex, o, { x, y } } };
  }
  if (isSimplex)
  {
    return { { true, o, { x, y } }, { true, o, { x, z } }, { true, o, { y, z } },
      { true, x, { xToY, xToZ } } };
  }
  if (domain == Domain::Prism)
  {
    return { { true, o, { x, y } }, { true, z, { x, y } }, { false, o, { x, z } },
      { false, o, { y, z } }, { false, x, { xToY, z } } };
  }
  return { { false, o, { x, y } }, { false, z, { x, y } }, { false, o, { x, z } },
    { false, y, { x, z } }, { false, o, { y, z } }, { false, x, { y, z } } };
}

/// Coordinates across a line, two, and along it.
struct LineAxes
{
  Point Start;
  Point Along;
  Point Across[2];

  LineAxes(const Point& a, const Point& b)
    : Start(a)
    , Along((1 / Distance(a, b)) * (b - a))
  {
    const Point side = std::abs(this->Along[0]) < 0.6 ? Point{ 1, 0, 0 } : Point{ 0, 1, 0 };
    const Point u = Cross(this->Along, side);
    this->Across[0] = (1 / Length(u)) * u;
    this->Across[1] = Cross(this->Along, this->Across[0]);
  }

  Point Of(const Point& x) const
  {
    const Point p = x - this->Start;
    return { Dot(p, this->Across[0]), Dot(p, this->Across[1]), Dot(p, this->Along) };
  }
};

/// The places where lines cross a side: Newton's method from each small triangle of samples that
/// lines pass near.
class SampledSide
{
public:
  SampledSide(ParametricCell& map, const Side& side, int n, double size)
    : Map(map)
    , TheSide(side)
    , N(n)
    , Size(size)
  {
    for (int j = 0; j <= n; ++j)
    {
      for (int i = 0; i <= n; ++i)
      {
        const bool isIn = !side.IsTriangle || i + j <= n;
        this->Samples.push_back(
          isIn ? map.At(side.At(double(i) / n, double(j) / n)) : Point{ 0, 0, 0 });
      }
    }
  }

  double FirstCrossing(const LineAxes& axes) const
  {
    double first = std::numeric_limits<double>::infinity();
    for (int j = 0; j < this->N; ++j)
    {
      for (int i = 0; i < (this->TheSide.IsTriangle ? this->N - j : this->N); ++i)
      {
        this->Try(axes, { { i, j }, { i + 1, j }, { i, j + 1 } }, first);
        if (!this->TheSide.IsTriangle || i + j + 1 < this->N)
        {
          this->Try(axes, { { i + 1, j + 1 }, { i, j + 1 }, { i + 1, j } }, first);
        }
      }
    }
    return first;
  }

  Point At(double r, double s) const { return this->Map.At(this->TheSide.At(r, s)); }

private:
  void Try(const LineAxes& axes, const int (&corners)[3][2], double& first) const
  {
    Point at[3];
    double r = 0;
    double s = 0;
    for (int k = 0; k < 3; ++k)
    {
      at[k] = axes.Of(
        this->Samples[static_cast<std::size_t>(corners[k][1] * (this->N + 1) + corners[k][0])]);
      r += corners[k][0] / (3.0 * this->N);
      s += corners[k][1] / (3.0 * this->N);
    }
    double beside = 0;
    for (int axis = 0; axis < 2; ++axis)
    {
      const double low = std::min({ at[0][axis], at[1][axis], at[2][axis] });
      const double high = std::max({ at[0][axis], at[1][axis], at[2][axis] });
      beside = std::max(beside, std::abs(low + high) / (high - low));
    }
    if (beside < 1.5 && std::min({ at[0][2], at[1][2], at[2][2] }) < first)
    {
      first = std::min(first, this->CrossingNear(axes, r, s));
    }
  }

  double CrossingNear(const LineAxes& axes, double r, double s) const
  {
    constexpr double none = std::numeric_limits<double>::infinity();
    constexpr double h = 1e-5;
    Point x = axes.Of(this->At(r, s));
    for (int i = 0; i < 12; ++i)
    {
      const Point ofR = (0.5 / h) * (axes.Of(this->At(r + h, s)) - axes.Of(this->At(r - h, s)));
      const Point ofS = (0.5 / h) * (axes.Of(this->At(r, s + h)) - axes.Of(this->At(r, s - h)));
      const double determinant = ofR[0] * ofS[1] - ofR[1] * ofS[0];
      r -= (x[0] * ofS[1] - x[1] * ofS[0]) / determinant;
      s -= (ofR[0] * x[1] - ofR[1] * x[0]) / determinant;
      if (!(std::abs(r - 0.5) < 0.6 && std::abs(s - 0.5) < 0.6))
      {
        return none;
      }
      x = axes.Of(this->At(r, s));
    }
    const bool isIn =
      std::min(r, s) >= 0 && (this->TheSide.IsTriangle ? r + s : std::max(r, s)) <= 1;
    return isIn && std::hypot(x[0], x[1]) < 1e-12 * this->Size ? x[2] : none;
  }

  ParametricCell& Map;
  Side TheSide;
  int N;
  double Size; ///< of the cell
  std::vector<Point> Samples;
};

class FirstHitOnCurved : public testing::TestWithParam<BentCell>
{
};

std::vector<BentCell> AllCases()
{
  std::vector<BentCell> cases = {
    { VTK_LAGRANGE_TRIANGLE, 3, 0.1 },
    { VTK_LAGRANGE_TRIANGLE, 4, 0.2 },
    { VTK_LAGRANGE_TRIANGLE, 6, 0.03 },
    { VTK_LAGRANGE_QUADRILATERAL, 3, 0.1 },
    { VTK_LAGRANGE_QUADRILATERAL, 4, 0.03 },
    { VTK_LAGRANGE_QUADRILATERAL, 4, 0.2 },
    { VTK_LAGRANGE_QUADRILATERAL, 4, 0.1, 1, 1e-9, 0 },
    { VTK_LAGRANGE_QUADRILATERAL, 4, 0.1, 1, 1, 1e6 },
    { VTK_LAGRANGE_QUADRILATERAL, 6, 0.03 },
    { VTK_LAGRANGE_QUADRILATERAL, 6, 0.2 },
    { VTK_LAGRANGE_QUADRILATERAL, 10, 0.1, 50 },
    { VTK_LAGRANGE_TRIANGLE, 10, 0.1, 50 },
    { VTK_LAGRANGE_TETRAHEDRON, 4, 0.05 },
    { VTK_LAGRANGE_HEXAHEDRON, 3, 0.1 },
    { VTK_LAGRANGE_WEDGE, 3, 0.1 },
  };
  for (const int type : AllCellTypes())
  {
    const bool isPyramid = type == VTK_QUADRATIC_PYRAMID || DomainOf(type) == Domain::Pyramid;
    if (DomainOf(type) != Domain::None && type < VTK_LAGRANGE_CURVE && DimensionOf(type) > 1 &&
      !isPyramid)
    {
      cases.push_back({ type, 2, 0.2 });
      cases.push_back({ type, 2, 0.1, 1, 1, 0, true });
    }
  }
  for (const int type : { VTK_BEZIER_TRIANGLE, VTK_BEZIER_QUADRILATERAL, VTK_BEZIER_TETRAHEDRON,
         VTK_BEZIER_HEXAHEDRON, VTK_BEZIER_WEDGE })
  {
    cases.push_back({ type, 3, 0.2, 1, 1, 0, false, true });
    cases.push_back({ type, 2, 0.1, 1, 1, 0, true, true });
  }
  return cases;
}

INSTANTIATE_TEST_SUITE_P(Bent, FirstHitOnCurved, testing::ValuesIn(AllCases()));

/// Every other line is nearly tangent to a side.
LineAxes RandomLine(const BentCell& c, const SampledSide& side, bool isTangent, Random& random)
{
  const double halfLength = 2 * c.Far;
  if (!isTangent)
  {
    const double depth = DimensionOf(c.Type) == 2 ? 0.2 : 1;
    const Point p =
      random.InBox({ 0, 1, 0, 1, depth - 1, depth }) + Point{ c.Offset, c.Offset, c.Offset };
    const Point along = random.Direction();
    return { c.Scale * (p - halfLength * along), c.Scale * (p + halfLength * along) };
  }
  constexpr double h = 1e-4;
  const double r = random.Between(0.05, 0.9);
  const double s = random.Between(0.05, 0.95 - r);
  const Point x = side.At(r, s);
  const Point ofR = side.At(r + h, s) - x;
  const Point ofS = side.At(r, s + h) - x;
  const Point normal = Cross(ofR, ofS);
  const Point along = random.Between(-1, 1) * ofR + random.Between(-1, 1) * ofS;
  const double beside = (random.Index(2) == 0 ? 1e-3 : -1e-3) * random.Between(1, 10);
  const Point start = x + (c.Scale * beside / Length(normal)) * normal;
  const Point step = (halfLength * c.Scale / Length(along)) * along;
  return { start - step, start + step };
}

TEST_P(FirstHitOnCurved, NoCrossingIsBefore)
{
  const BentCell& c = GetParam();
  Random random(11 + c.Type);
  const bool isSlow = IsSlow(c.Type) || c.Type == VTK_LAGRANGE_WEDGE;
  const bool isVolume = DimensionOf(c.Type) == 3;
  const bool isHigh = c.Order > 6;
  const int samples = isSlow ? 12 : isVolume ? 20 : isHigh ? 48 : 32;
  const double length = 4 * c.Far * c.Scale;
  // Of high orders cells are far larger than what their points span, and steep.
  const double ofPoint = c.Scale * (1e-14 * c.Offset + (isHigh ? 2e-12 : 1e-14));
  for (int cell = 0; cell < (isSlow || isHigh ? 1 : isVolume ? 2 : 4); ++cell)
  {
    const auto grid = MakeCell(c, random);
    vtkNew<vtkGenericCell> loaded;
    grid->GetCell(0, loaded);
    ParametricCell map(loaded);
    std::vector<SampledSide> sides;
    for (const Side& side : SidesOf(c.Type))
    {
      sides.emplace_back(map, side, samples, c.Scale * (1 + c.Offset));
    }
    const auto locator = MakeLocator(grid);
    for (int line = 0; line < (isSlow ? 6 : isVolume ? 40 : isHigh ? 240 : 60); ++line)
    {
      const auto& aimedAt =
        sides[static_cast<std::size_t>(random.Index(static_cast<int>(sides.size())))];
      const LineAxes axes = RandomLine(c, aimedAt, line % 2 == 1, random);
      double expected = std::numeric_limits<double>::infinity();
      for (const SampledSide& side : sides)
      {
        expected = std::min(expected, side.FirstCrossing(axes));
      }
      const LineHit hit = FindFirstHit(locator, axes.Start, axes.Start + length * axes.Along);
      if (expected < length)
      {
        ASSERT_EQ(hit.Found, 1);
        ASSERT_LE(hit.T * length, expected + c.Scale * 1e-6 * (1 + 1e-3 * c.Offset));
      }
      if (hit.Found == 1)
      {
        const Point x = axes.Of(map.At(hit.Pcoords));
        ASSERT_LE(std::hypot(x[0], x[1]), ofPoint);
      }
    }
  }
}

/// z = T(x), Chebyshev's polynomial of degree 6: its tops are at cos(k pi / 3), between them are
/// troughs. A line along x just below the tops meets it shortly before the next one.
TEST(FirstHitOnWaves, IsBeforeTheNextTop)
{
  const Mesh mesh = ReferenceCell(VTK_LAGRANGE_QUADRILATERAL, 6)
                      .Map(
                        [](const Point& p)
                        {
                          const double x = 2 * p[0] - 1;
                          const double x2 = x * x;
                          return Point{ x, 2 * p[1] - 1, ((32 * x2 - 48) * x2 + 18) * x2 - 1 };
                        });
  const auto locator = MakeLocator(MakeGrid(mesh));
  const double pi = std::acos(-1.0);
  for (const double below : { 1e-12, 1e-9, 1e-6, 1e-3, 0.1 })
  {
    const double z = 1 - below;
    for (const int k : { 0, 1, 2 })
    {
      const double trough = std::cos((k + 0.5) * pi / 3);
      const LineHit hit = FindFirstHit(locator, { trough, 0.3, z }, { 2, 0.3, z });
      ASSERT_EQ(hit.Found, 1) << below << ' ' << k;
      EXPECT_NEAR(hit.X[0], std::cos(k * pi / 3 + std::acos(z) / 6), 1e-4 * std::sqrt(below));
    }
    const Point ends[2] = { { -0.9, 0.3, 1 + below }, { 0.9, 0.3, 1 + below } };
    EXPECT_EQ(FindFirstHit(locator, ends[0], ends[1]).Found, 0);
    EXPECT_EQ(FindFirstHit(locator, ends[0], ends[1], 2 * below).Found, 1);
  }
}

/// A line in the plane of a flat cell meets it where it comes in.
TEST(FirstHitInPlane, IsWhereTheLineComesIn)
{
  for (const int type :
    { VTK_QUADRATIC_TRIANGLE, VTK_BIQUADRATIC_QUAD, VTK_LAGRANGE_QUADRILATERAL })
  {
    const auto locator = MakeLocator(MakeGrid(ReferenceCell(type, 3)));
    const LineHit hit = FindFirstHit(locator, { -1, 0.1, 0 }, { 3, 0.5, 0 });
    ASSERT_EQ(hit.Found, 1);
    EXPECT_NEAR(hit.X[0], 0, 1e-6);
  }
}

/// Cells without a Bernstein form: of a degree that is too high, or with a weight of zero.
TEST(FirstHitOnOthers, IsFound)
{
  const auto high = MakeLocator(MakeGrid(ReferenceCell(VTK_LAGRANGE_QUADRILATERAL, 13)));
  const auto grid = MakeGrid(ReferenceCell(VTK_BEZIER_QUADRILATERAL, 2));
  vtkNew<vtkDoubleArray> rational;
  rational->SetName("RationalWeights");
  for (const double weight : { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 0.0 })
  {
    rational->InsertNextValue(weight);
  }
  grid->GetPointData()->SetRationalWeights(rational);
  for (const auto& locator : { high, MakeLocator(grid) })
  {
    const LineHit hit = FindFirstHit(locator, { 0.3, 0.6, 1 }, { 0.3, 0.6, -1 });
    ASSERT_EQ(hit.Found, 1);
    EXPECT_NEAR(hit.T, 0.5, 1e-14);
  }
}

/// A curve and a line across it: what is within the tolerance is hit, where it is nearest.
TEST(FirstHitOnCurve, IsWithinTheTolerance)
{
  const Mesh mesh = ReferenceCell(VTK_LAGRANGE_CURVE, 5)
                      .Map(
                        [](const Point& p) {
                          return Point{ p[0], std::pow(p[0] - 0.5, 5) - 0.0625 * (p[0] - 0.5), 0 };
                        });
  const auto locator = MakeLocator(MakeGrid(mesh));
  for (const double z : { 0.0, 1e-4 })
  {
    // Zeros are at 0, 0.5 and 1.
    const LineHit all = FindFirstHit(locator, { -1, 0, z }, { 2, 0, z }, 2e-4);
    ASSERT_EQ(all.Found, 1);
    EXPECT_NEAR(all.X[0], 0, 1e-8);
    const LineHit rest = FindFirstHit(locator, { 0.1, 0, z }, { 2, 0, z }, 2e-4);
    ASSERT_EQ(rest.Found, 1);
    EXPECT_NEAR(rest.X[0], 0.5, 1e-8);
    EXPECT_EQ(FindFirstHit(locator, { 0.1, 0, z }, { 0.4, 0, z }, 2e-4).Found, 0);
  }
}

}
