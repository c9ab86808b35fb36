// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeCurveSurfaceIntersection on surfaces that other people made: lines hit what a look at
// all triangles says.

#include "Support/CurveRun.h"
#include "Support/OnFile.h"

#include "vtkSkdTreeCurveSurfaceIntersection.h"
#include "vtkTriangleFilter.h"

#include <gtest/gtest.h>

using namespace skdtest;

namespace
{

enum class Intersection
{
  No,
  Yes,
  Unsure ///< to within rounding
};

/// The sign of the volume that three vectors span; 0 if rounding may have made it.
int SignOf(const Point& a, const Point& b, const Point& c)
{
  const double volume = Dot(a, Cross(b, c));
  const double rounding = 1e-14 * Length(a) * Length(b) * Length(c);
  return volume > rounding ? 1 : (volume < -rounding ? -1 : 0);
}

using Triangle = std::array<Point, 3>;

/// A line from `start` along `direction` and a triangle; where, from 0 to 1.
Intersection Meet(const Point& start, const Point& direction, const Triangle& triangle, double& at)
{
  const Point a = triangle[0] - start;
  const Point b = triangle[1] - start;
  const Point c = triangle[2] - start;
  const int sides[3] = { SignOf(direction, a, b), SignOf(direction, b, c),
    SignOf(direction, c, a) };
  const auto [least, most] = std::minmax_element(sides, sides + 3);
  if (*least < 0 && *most > 0)
  {
    return Intersection::No;
  }
  const Point normal = Cross(b - a, c - a);
  at = Dot(normal, a) / Dot(normal, direction);
  const bool isWithin = at > 1e-9 && at < 1.0 - 1e-9; // both ends are beyond the surface's box
  return *least * *most == 1 && isWithin ? Intersection::Yes : Intersection::Unsure;
}

PolyDataPointer ReadTriangles(const std::string& file)
{
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(ReadMesh(file));
  triangles->PassLinesOff();
  triangles->PassVertsOff();
  triangles->Update();
  return triangles->GetOutput();
}

std::vector<Triangle> TrianglesOf(vtkPolyData* surface)
{
  std::vector<Triangle> triangles(static_cast<std::size_t>(surface->GetNumberOfCells()));
  vtkNew<vtkIdList> ids;
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    surface->GetCellPoints(static_cast<vtkIdType>(i), ids);
    for (int k = 0; k < 3; ++k)
    {
      surface->GetPoint(ids->GetId(k), triangles[i][k].data());
    }
  }
  return triangles;
}

struct Line
{
  Point Start;
  Point Way;
};

/// From beyond the bounds to beyond them, every other through a vertex.
std::vector<Line> LinesThrough(const std::vector<Triangle>& triangles, const Bounds& box, int count)
{
  Random random(31);
  std::vector<Line> lines;
  for (int i = 0; i < count; ++i)
  {
    const Point vertex = triangles[random.Index(int(triangles.size()))][0];
    const Point through = i % 2 ? vertex : random.InBox(box);
    const Point half = (1.5 * Diagonal(box)) * random.Direction();
    lines.push_back({ through - half, 2.0 * half });
  }
  return lines;
}

PolyDataPointer MakeLines(const std::vector<Line>& lines)
{
  Mesh mesh;
  for (const Line& line : lines)
  {
    mesh.Add(VTK_LINE, { mesh.Add(line.Start), mesh.Add(line.Start + line.Way) });
  }
  return MakePolyData(mesh);
}

/// All triangles that the line meets are met at one of the places.
void ExpectAllMet(
  const Line& line, const std::vector<Triangle>& triangles, const std::vector<double>& positions)
{
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    double at = 0.0;
    const auto isThere = [&](double position) { return std::abs(position - at) < 1e-9; };
    if (Meet(line.Start, line.Way, triangles[i], at) == Intersection::Yes)
    {
      ASSERT_TRUE(std::any_of(positions.begin(), positions.end(), isThere))
        << "cell " << i << " is met at " << at;
    }
  }
}

class CurveSurfaceReal : public OnFile
{
};

INSTANTIATE_TEST_SUITE_P(
  Shipped, CurveSurfaceReal, testing::ValuesIn(SurfaceFiles(DataFolder())), NameOfFile());
INSTANTIATE_TEST_SUITE_P(
  Extra, CurveSurfaceReal, testing::ValuesIn(SurfaceFiles(ExtraDataFolder())), NameOfFile());

TEST_P(CurveSurfaceReal, HitsAreThoseOfALookAtAllTriangles)
{
  const PolyDataPointer surface = ReadTriangles(GetParam());
  const std::vector<Triangle> triangles = TrianglesOf(surface);
  if (triangles.empty())
  {
    GTEST_SKIP() << "no surface";
  }
  Bounds box;
  surface->GetBounds(box.data());
  const int count = std::clamp(3000000 / static_cast<int>(triangles.size()), 20, 300);
  const std::vector<Line> lines = LinesThrough(triangles, box, count);
  vtkNew<vtkSkdTreeCurveSurfaceIntersection> filter;
  filter->SetInputData(MakeLines(lines));
  filter->SetSourceData(surface);
  filter->InterpolateDataOff();
  const std::vector<double> curves = OutputArray(filter, "SkdCurveId");
  const std::vector<double> cells = OutputArray(filter, "SkdCellId");
  const std::vector<double> positions = OutputArray(filter, "SkdCurveParameter");
  EXPECT_GT(curves.size(), lines.size() / 4);
  std::size_t told = 0;
  for (std::size_t line = 0; line < lines.size(); ++line)
  {
    const std::size_t first = told;
    double at = 0.0;
    for (; told < curves.size() && curves[told] == static_cast<double>(line); ++told)
    {
      const Triangle& hit = triangles[static_cast<std::size_t>(cells[told])];
      EXPECT_NE(Meet(lines[line].Start, lines[line].Way, hit, at), Intersection::No)
        << "line " << line << " misses cell " << cells[told];
    }
    ExpectAllMet(lines[line], triangles, { positions.begin() + first, positions.begin() + told });
  }
  EXPECT_EQ(told, curves.size());
}

}
