// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// SkdWinding, which Point In Out and others use where surfaces have gaps: against the plain sum of
// solid angles.

#include "Bodies/SkdWinding.h"
#include "Support/InOutRun.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace skdtest;
using namespace skdtree;

namespace
{

/// By Eriksson's formula.
double SumOfAngles(const Mesh& mesh, const std::vector<bool>& isTurned, const Point& x)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < mesh.Cells.size(); ++i)
  {
    Point unit[3];
    for (int k = 0; k < 3; ++k)
    {
      const Point to = mesh.Points[mesh.Cells[i].Points[k]] - x;
      unit[k] = (1.0 / Length(to)) * to;
    }
    const double above = Dot(unit[0], Cross(unit[1], unit[2]));
    const double below =
      1.0 + Dot(unit[0], unit[1]) + Dot(unit[1], unit[2]) + Dot(unit[2], unit[0]);
    sum += (!isTurned.empty() && isTurned[i] ? -2.0 : 2.0) * std::atan2(above, below);
  }
  return sum / (4.0 * vtkMath::Pi());
}

Mesh OpenSphere()
{
  const Mesh sphere = Outward(Sphere(16, 1.0));
  return Part(sphere, [](std::size_t cell) { return cell % 11 != 0; });
}

void ExpectSums(const Mesh& mesh, const std::vector<bool>& isTurned)
{
  const SkdWinding winding(MakePolyData(mesh), isTurned);
  for (const Point& x : PointsAround(1.5, 500))
  {
    const double expected = SumOfAngles(mesh, isTurned, x);
    ASSERT_NEAR(winding.At(x.data()), expected, 5e-3);
    if (std::abs(std::abs(expected) - 0.5) > 5e-3)
    {
      ASSERT_EQ(winding.IsInside(x.data()), std::abs(expected) > 0.5);
    }
  }
}

TEST(Winding, OfASurfaceWithGapsItIsTheSumOfAngles)
{
  ExpectSums(OpenSphere(), {});
}

TEST(Winding, TurnedTrianglesCountTheOtherWay)
{
  const Mesh mesh = OpenSphere();
  std::vector<bool> isTurned(mesh.Cells.size());
  for (std::size_t i = 0; i < isTurned.size(); ++i)
  {
    isTurned[i] = i % 3 == 0;
  }
  ExpectSums(mesh, isTurned);
}

TEST(Winding, ASurfaceThatIsInsideOutHasItsInsideToo)
{
  const Mesh sphere = Outward(Sphere(12, 1.0));
  const SkdWinding winding(MakePolyData(sphere), std::vector<bool>(sphere.Cells.size(), true));
  const Point within{ 0.2, -0.3, 0.4 }, beyond{ 0.2, -1.3, 0.4 };
  EXPECT_NEAR(winding.At(within.data()), -1.0, 5e-3);
  EXPECT_TRUE(winding.IsInside(within.data()));
  EXPECT_FALSE(winding.IsInside(beyond.data()));
}

TEST(Winding, TheSurfaceMayGoAndTheAnswerStays)
{
  PolyDataPointer surface = MakePolyData(Outward(Sphere(12, 1.0)));
  const SkdWinding winding(surface);
  surface->Initialize();
  surface = nullptr;
  const Point middle{ 0.0, 0.0, 0.0 };
  EXPECT_NEAR(winding.At(middle.data()), 1.0, 5e-3);
}

TEST(Winding, OfNothingItIsZeroAndOfNoPointNoNumber)
{
  const SkdWinding none(PolyDataPointer::New());
  const Point middle{ 0.0, 0.0, 0.0 };
  EXPECT_EQ(none.At(middle.data()), 0.0);
  EXPECT_FALSE(none.IsInside(middle.data()));
  const SkdWinding winding(MakePolyData(Outward(Octahedron(1))));
  const Point nowhere{ 0.0, std::numeric_limits<double>::quiet_NaN(), 0.0 };
  EXPECT_TRUE(std::isnan(winding.At(nowhere.data())));
  EXPECT_FALSE(winding.IsInside(nowhere.data()));
}

}
