// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// Lines aimed at the edges and vertices of closed surfaces: none slips through, and parity holds.

#include "Support/LocatorCalls.h"
#include "Support/NamedMeshes.h"

#include <gtest/gtest.h>

using namespace skdtest;

namespace
{

Mesh Oriented(Mesh mesh, bool atRandom)
{
  Random random(50);
  for (CellSpec& cell : mesh.Cells)
  {
    if (atRandom && random.Index(2))
    {
      std::reverse(cell.Points.begin(), cell.Points.end());
    }
  }
  return mesh;
}

/// A closed surface, and how to draw points that are surely inside of it.
struct ClosedSurface
{
  const char* Name;
  std::function<Mesh()> Make;
  std::function<Point(Random&)> Inside;
  friend void PrintTo(const ClosedSurface& surface, std::ostream* os) { *os << surface.Name; }
};

Point InBall(Random& random, double radius)
{
  return random.Between(0, radius) * random.Direction();
}

// The tube of a torus of 24 x 12 facets has an inner radius of about 0.33.
Point InTorus(Random& random)
{
  const double u = random.Between(0, 6.28);
  return Point{ std::cos(u), std::sin(u), 0 } + InBall(random, 0.25);
}

std::vector<ClosedSurface> ClosedSurfaces()
{
  const auto inBall = [](Random& random) { return InBall(random, 0.7); };
  const auto inCube = [](Random& random) { return random.InBox({ 1, 5, 1, 5, 1, 5 }); };
  const Point offset = { 1e7, -3e6, 2e7 };
  return { { "CubeTriangles", [] { return CubeTriangles(6); }, inCube },
    { "CubeQuads", [] { return CubeQuads(6); }, inCube },
    { "SphereTriangles", [] { return SphereTriangles(12); }, inBall },
    { "SphereWarpedQuads", [] { return SphereQuads(12); }, inBall },
    { "TorusTriangles", [] { return TorusTriangles(24, 12); }, InTorus },
    { "TorusQuads", [] { return TorusQuads(24, 12); }, InTorus },
    { "SphereSoup", [] { return Soup(SphereTriangles(12)); }, inBall },
    { "SphereQuadSoup", [] { return Soup(SphereQuads(12)); }, inBall },
    { "SphereRandomlyOriented", [] { return Oriented(SphereTriangles(12), true); }, inBall },
    { "QuadsRandomlyOriented", [] { return Oriented(SphereQuads(12), true); }, inBall },
    { "SphereFarOff", [offset] { return Transformed(SphereTriangles(12), 1, offset); },
      [offset](Random& random) { return offset + InBall(random, 0.7); } } };
}

class Watertight : public testing::TestWithParam<ClosedSurface>
{
protected:
  Watertight()
    : Surface(GetParam().Make())
    , Data(MakePolyData(this->Surface))
    , Locator(MakeLocator(this->Data))
  {
  }

  const Point& Corner(const CellSpec& cell, int i) const
  {
    return this->Surface.Points[cell.Points[i % cell.Points.size()]];
  }

  /// A vertex (a third of them), a point of an edge, or an edge's middle.
  Point Target(Random& random) const
  {
    const CellSpec& cell = this->Surface.Cells[random.Index(int(this->Surface.Cells.size()))];
    const int i = random.Index(4);
    const double s[3] = { 0.0, random.Between(0, 1), 0.5 };
    return Lerp(this->Corner(cell, i), this->Corner(cell, i + 1), s[random.Index(3)]);
  }

  Point Inside(Random& random) const { return GetParam().Inside(random); }

  /// From inside through the target, well out of the surface.
  Point Beyond(const Point& inside, const Point& target) const
  {
    const double* bounds = this->Data->GetBounds();
    const double size = bounds[1] - bounds[0] + bounds[3] - bounds[2];
    return target + (3 * size / Distance(inside, target)) * (target - inside);
  }

  /// A line through a target: from a point inside, out of the surface on both sides.
  struct Line
  {
    Point Inside;
    Point Beyond;
    Point Opposite;
  };

  Line Draw(Random& random) const
  {
    const Point inside = this->Inside(random);
    const Point target = this->Target(random);
    const Point beyond = this->Beyond(inside, target);
    return { inside, beyond, this->Beyond(beyond, target) };
  }

  /// The sum of `test(line)` of so many lines.
  template <class Test>
  int CountWrong(int seed, int lines, const Test& test) const
  {
    Random random(seed);
    int wrong = 0;
    for (int i = 0; i < lines; ++i)
    {
      wrong += test(this->Draw(random));
    }
    return wrong;
  }

  bool IsOdd(const Point& a, const Point& b) const
  {
    return this->Locator->CountCrossings(a.data(), b.data()) % 2 != 0;
  }

  Mesh Surface;
  PolyDataPointer Data;
  LocatorPointer Locator;
};

INSTANTIATE_TEST_SUITE_P(Closed, Watertight, testing::ValuesIn(ClosedSurfaces()), NameOfMesh());

TEST_P(Watertight, NoLineFromInsideGetsOut)
{
  const int lost = this->CountWrong(51, 20000,
    [&](const Line& line)
    {
      return (FindFirstHit(this->Locator, line.Inside, line.Beyond).Found == 0) +
        (FindFirstHit(this->Locator, line.Beyond, line.Inside).Found == 0);
    });
  EXPECT_EQ(lost, 0);
}

TEST_P(Watertight, BetweenInsideAndOutsideTheCrossingsAreOdd)
{
  const int wrong = this->CountWrong(
    52, 20000, [&](const Line& line) { return !this->IsOdd(line.Inside, line.Beyond); });
  EXPECT_EQ(wrong, 0);
}

TEST_P(Watertight, BetweenOutsideAndOutsideTheCrossingsAreEven)
{
  const int wrong = this->CountWrong(53, 20000,
    [&](const Line& line)
    { return this->IsOdd(line.Beyond, line.Opposite) + this->IsOdd(line.Opposite, line.Beyond); });
  EXPECT_EQ(wrong, 0);
}

TEST_P(Watertight, BetweenInsideAndInsideTheCrossingsAreEven)
{
  Random random(54);
  int wrong = 0;
  for (int i = 0; i < 5000; ++i)
  {
    const Point a = this->Inside(random);
    const Point b = this->Inside(random);
    wrong += this->IsOdd(a, b);
  }
  EXPECT_EQ(wrong, 0);
}

TEST_P(Watertight, GrazingLinesCrossEvenTimes)
{
  Random random(55);
  int wrong = 0;
  for (int i = 0; i < 10000; ++i)
  {
    const Point from = this->Target(random);
    const Point along = this->Target(random) - from; // two targets often share a facet
    if (Length(along) > 0)
    {
      const double* bounds = this->Data->GetBounds();
      const double far = 3 * (bounds[1] - bounds[0] + bounds[3] - bounds[2]) / Length(along);
      const Point p1 = from - far * along;
      const Point p2 = from + far * along;
      wrong += this->IsOdd(p1, p2);
    }
  }
  EXPECT_EQ(wrong, 0);
}

TEST_P(Watertight, CountCrossingsCountsThePassingCrossings)
{
  Random random(56);
  for (int i = 0; i < 1000; ++i)
  {
    const Line line = this->Draw(random);
    const Crossings c = FindCrossings(this->Locator, line.Opposite, line.Beyond);
    ASSERT_EQ(
      c.NumberPassing(), this->Locator->CountCrossings(line.Opposite.data(), line.Beyond.data()));
  }
}

TEST_P(Watertight, CrossingsAreSortedAndTheirCellsAscend)
{
  Random random(57);
  const double size = Diagonal(
    Bounds{ this->Data->GetBounds()[0], this->Data->GetBounds()[1], this->Data->GetBounds()[2],
      this->Data->GetBounds()[3], this->Data->GetBounds()[4], this->Data->GetBounds()[5] });
  for (int i = 0; i < 1000; ++i)
  {
    const Line line = this->Draw(random);
    const Crossings c = FindCrossings(this->Locator, line.Opposite, line.Beyond);
    ASSERT_EQ(c.Parameters.size(), std::size_t(c.Number));
    ASSERT_EQ(c.Points.size(), std::size_t(c.Number));
    ASSERT_EQ(c.Cells.size(), std::size_t(c.Number));
    ASSERT_EQ(c.Kinds.size(), std::size_t(c.Number));
    ASSERT_TRUE(std::is_sorted(c.Parameters.begin(), c.Parameters.end()));
    for (std::size_t k = 0; k < c.Cells.size(); ++k)
    {
      ASSERT_FALSE(c.Cells[k].empty());
      ASSERT_TRUE(std::is_sorted(c.Cells[k].begin(), c.Cells[k].end()));
      const Point expected = Lerp(line.Opposite, line.Beyond, c.Parameters[k]);
      ASSERT_LE(Distance(c.Points[k], expected), 1e-9 * (size + Length(expected)));
    }
  }
}

TEST_P(Watertight, CellsOfAllCrossingsAreAllHits)
{
  Random random(58);
  vtkNew<vtkGenericCell> cell;
  for (int i = 0; i < 1000; ++i)
  {
    const Line line = this->Draw(random);
    Ids crossed;
    for (const Ids& cells : FindCrossings(this->Locator, line.Inside, line.Beyond).Cells)
    {
      crossed.insert(crossed.end(), cells.begin(), cells.end());
    }
    std::sort(crossed.begin(), crossed.end());
    crossed.erase(std::unique(crossed.begin(), crossed.end()), crossed.end());
    Ids hit = FindAllHits(this->Locator, line.Inside, line.Beyond, 0.0, cell).Cells;
    std::sort(hit.begin(), hit.end());
    ASSERT_EQ(crossed, hit) << "line " << i;
  }
}

bool StrictlyInside(const Point& p, double n)
{
  return std::min({ p[0], p[1], p[2] }) > 0 && std::max({ p[0], p[1], p[2] }) < n;
}

bool OnCube(const Point& p, double n)
{
  return Contains(Bounds{ 0, n, 0, n, 0, n }, p) && !StrictlyInside(p, n);
}

/// Lines between lattice points go exactly through vertices, edges and planes of facets.
void ExpectParityOfLatticeLines(const Mesh& mesh, int n)
{
  const auto data = MakePolyData(mesh);
  const auto locator = MakeLocator(data);
  Random random(59);
  int wrong = 0;
  const auto lattice = [&]
  {
    return Point{ random.Index(3 * n) - n + 0.0, random.Index(3 * n) - n + 0.0,
      random.Index(3 * n) - n + 0.0 };
  };
  for (int i = 0; i < 60000; ++i)
  {
    const Point a = lattice();
    const Point b = lattice();
    if (OnCube(a, n) || OnCube(b, n) || a == b)
    {
      continue;
    }
    const int expected = StrictlyInside(a, n) != StrictlyInside(b, n);
    wrong += locator->CountCrossings(a.data(), b.data()) % 2 != expected;
  }
  EXPECT_EQ(wrong, 0);
}

TEST(WatertightLattice, TrianglesKeepParity)
{
  ExpectParityOfLatticeLines(CubeTriangles(6), 6);
}

TEST(WatertightLattice, QuadsKeepParity)
{
  ExpectParityOfLatticeLines(CubeQuads(6), 6);
}

TEST(WatertightLattice, SoupKeepsParity)
{
  ExpectParityOfLatticeLines(Soup(CubeTriangles(6)), 6);
}

class CrossingsOfCube : public testing::TestWithParam<bool>
{
protected:
  PolyDataPointer Data = MakePolyData(GetParam() ? CubeQuads(4) : CubeTriangles(4));
  LocatorPointer Locator = MakeLocator(this->Data);
};

INSTANTIATE_TEST_SUITE_P(TrianglesAndQuads, CrossingsOfCube, testing::Bool());

TEST_P(CrossingsOfCube, AVertexIsOneCrossingWithAllItsCells)
{
  this->Data->BuildLinks();
  vtkNew<vtkIdList> around;
  for (vtkIdType point = 0; point < this->Data->GetNumberOfPoints(); ++point)
  {
    Point p;
    this->Data->GetPoint(point, p.data());
    const bool within = p[0] > 0 && p[0] < 4 && p[1] > 0 && p[1] < 4;
    if (!within || p[2] != 4)
    {
      continue;
    }
    this->Data->GetPointCells(point, around);
    Ids expected = ToVector(around);
    std::sort(expected.begin(), expected.end());
    const Crossings c =
      FindCrossings(this->Locator, p + Point{ 0.5, 0.25, 1 }, p - Point{ 0.5, 0.25, 1 });
    ASSERT_GE(c.Number, 1);
    ASSERT_EQ(c.Cells[0], expected);
    ASSERT_EQ(c.Kinds[0], 1);
    ASSERT_EQ(c.Parameters[0], 0.5);
    ASSERT_EQ(c.Points[0], p);
  }
}

TEST_P(CrossingsOfCube, AnEdgeIsOneCrossingWithBothItsCells)
{
  const Crossings c = FindCrossings(this->Locator, { 1, 1.5, 6 }, { 1, 1.5, 2 });
  ASSERT_EQ(c.Number, 1);
  EXPECT_EQ(c.Cells[0].size(), 2u);
  EXPECT_EQ(c.Kinds[0], 1);
}

TEST_P(CrossingsOfCube, ThroughAndOutAreTwoCrossings)
{
  const Crossings c = FindCrossings(this->Locator, { 1.3, 1.6, 6 }, { 1.3, 1.6, -2 });
  EXPECT_EQ(c.Number, 2);
  EXPECT_EQ(c.Kinds, (Ids{ 1, 1 }));
  EXPECT_DOUBLE_EQ(c.Parameters[0], 0.25);
  EXPECT_DOUBLE_EQ(c.Parameters[1], 0.75);
}

TEST_P(CrossingsOfCube, AMissHasNoCrossing)
{
  EXPECT_EQ(FindCrossings(this->Locator, { 5, 5, 6 }, { 5, 5, -2 }).Number, 0);
  const Point p = { 2, 2, 6 };
  EXPECT_EQ(FindCrossings(this->Locator, p, p).Number, 0);
}

TEST_P(CrossingsOfCube, EveryOutputMayBeNull)
{
  const Point p1 = { 1.3, 1.6, 6 };
  const Point p2 = { 1.3, 1.6, -2 };
  EXPECT_EQ(
    this->Locator->FindCrossings(p1.data(), p2.data(), nullptr, nullptr, nullptr, nullptr), 2);
}

TEST(Crossings, AtATouchedVertexOrEdgeDoNotPass)
{
  const auto data = MakePolyData(Octahedron(1));
  const auto locator = MakeLocator(data);
  const Crossings apex = FindCrossings(locator, { -3, -1, 1 }, { 3, 1, 1 });
  EXPECT_EQ(apex.NumberPassing(), 0);
  ASSERT_EQ(apex.Number, 1);
  EXPECT_EQ(apex.Cells[0], (Ids{ 0, 1, 2, 3 }));
  const Crossings edge = FindCrossings(locator, { 0.5, 0.5, -1 }, { 0.5, 0.5, 1 });
  EXPECT_EQ(edge.NumberPassing(), 0);
  ASSERT_EQ(edge.Number, 1);
  EXPECT_EQ(edge.Cells[0].size(), 2u);
}

TEST(Crossings, FromApexToApexArePassing)
{
  const auto data = MakePolyData(Octahedron(1));
  const auto locator = MakeLocator(data);
  const Crossings c = FindCrossings(locator, { 0, 0, 3 }, { 0, 0, -3 });
  ASSERT_EQ(c.Number, 2);
  EXPECT_EQ(c.Kinds, (Ids{ 1, 1 }));
  EXPECT_EQ(c.Cells[0].size(), 4u);
  EXPECT_EQ(c.Cells[1].size(), 4u);
}

}
