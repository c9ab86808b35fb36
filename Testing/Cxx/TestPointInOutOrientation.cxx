// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreePointInOut on surfaces whose triangles are turned any way.

#include "Support/InOutRun.h"

#include <gtest/gtest.h>

using namespace skdtest;

namespace
{

constexpr int ByNormals[] = { InOut::WINDING_NUMBER, InOut::NEAREST_FEATURE };

/// Some triangles reversed.
Mesh Shuffled(Mesh mesh)
{
  Random random(51);
  for (CellSpec& cell : mesh.Cells)
  {
    if (random.Index(2) == 0)
    {
      std::swap(cell.Points[0], cell.Points[1]);
    }
  }
  return mesh;
}

InOutPointer MakeRepaired(vtkDataObject* input, vtkDataObject* source, int method)
{
  InOutPointer filter = MakeInOut(input, source, method);
  filter->RepairOrientationOn();
  return filter;
}

int CountDifferent(const std::vector<double>& a, const std::vector<double>& b)
{
  int different = a.size() == b.size() ? 0 : -1;
  for (std::size_t i = 0; i < a.size() && different >= 0; ++i)
  {
    different += a[i] != b[i];
  }
  return different;
}

class Orientation : public testing::TestWithParam<int>
{
};

INSTANTIATE_TEST_SUITE_P(ByNormals, Orientation, testing::ValuesIn(ByNormals));

TEST_P(Orientation, TrianglesTurnedAtRandomAreRepaired)
{
  const Mesh torus = Triangulated(TorusTriangles(24, 12));
  auto input = MakeQueries(RandomQueries(MakePolyData(torus), 3000));
  auto shuffled = MakePolyData(Shuffled(torus));
  const std::vector<double> right =
    RunFor(MakeInOut(input, MakePolyData(torus), InOut::AXIS_RAYS), "SkdInside");
  EXPECT_GT(CountDifferent(RunFor(MakeInOut(input, shuffled, GetParam()), "SkdInside"), right), 50);
  EXPECT_EQ(
    CountDifferent(RunFor(MakeRepaired(input, shuffled, GetParam()), "SkdInside"), right), 0);
}

TEST_P(Orientation, ACavityIsTurnedAgainstWhatItIsIn)
{
  const Mesh shell = Together({ Outward(Sphere(12, 1.0)), Outward(Sphere(12, 0.5)) });
  auto input = MakeQueries(PointsAround(1.2, 3000));
  auto source = MakePolyData(Shuffled(shell));
  const std::vector<double> right = RunFor(MakeInOut(input, source), "SkdInside");
  EXPECT_EQ(CountDifferent(RunFor(MakeRepaired(input, source, GetParam()), "SkdInside"), right), 0);
}

TEST_P(Orientation, OfAnOpenSurfaceTheNormalsPointOutwardToo)
{
  const Mesh sphere = Sphere(16, 1.0);
  const Mesh open = Part(
    sphere, [&](std::size_t cell) { return sphere.Points[sphere.Cells[cell].Points[0]][2] < 0.8; });
  std::vector<Point> points;
  std::vector<double> right;
  for (const Point& p : PointsAround(1.2, 3000))
  {
    const double radius = Length(p);
    if (p[2] < 0.3 && (radius < 0.95 || radius > 1.0))
    {
      points.push_back(p);
      right.push_back(radius < 1.0 ? 1 : 0);
    }
  }
  auto source = MakePolyData(Shuffled(open));
  const auto input = MakeQueries(points);
  EXPECT_EQ(CountDifferent(RunFor(MakeRepaired(input, source, GetParam()), "SkdInside"), right), 0);
}

TEST_P(Orientation, TurningTheSwitchMakesThePartsAnew)
{
  auto input = MakeQueries(PointsAround(1.2, 300));
  auto source = MakePolyData(Shuffled(Sphere(8, 1.0)));
  InOutPointer filter = MakeInOut(input, source, GetParam());
  filter->Update();
  EXPECT_EQ(Reported(filter, "TreesBuilt"), 1);
  filter->RepairOrientationOn();
  filter->Update();
  EXPECT_EQ(Reported(filter, "TreesBuilt"), 1);
  filter->Modified();
  filter->Update();
  EXPECT_EQ(Reported(filter, "TreesBuilt"), 0);
}

}
