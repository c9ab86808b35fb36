// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeCurveSurfaceIntersection on the Utah teapot's own patches, against a thousand triangles
// for each.

#include "Support/CurveRun.h"
#include "Support/Folders.h"

#include "vtkCell.h"
#include "vtkSkdTreeCurveSurfaceIntersection.h"

#include <gtest/gtest.h>

#include <fstream>

using namespace skdtest;

namespace
{

/// Bicubic patches, 16 control points each, rows of 4.
std::vector<std::array<Point, 16>> ReadTeapot(const std::string& file)
{
  std::ifstream in(file);
  std::string header;
  std::vector<std::array<Point, 16>> patches;
  in >> header;
  std::array<Point, 16> patch;
  for (int i = 0; in >> patch[i][0] >> patch[i][1] >> patch[i][2]; i = (i + 1) % 16)
  {
    if (i == 15)
    {
      patches.push_back(patch);
    }
  }
  return patches;
}

GridPointer AsBezier(const std::vector<std::array<Point, 16>>& patches)
{
  // VTK's order: corners, then the edges' points, then those inside.
  constexpr int order[16] = { 0, 3, 15, 12, 1, 2, 7, 11, 13, 14, 4, 8, 5, 6, 9, 10 };
  Mesh mesh;
  for (const auto& patch : patches)
  {
    Ids ids;
    for (int i : order)
    {
      ids.push_back(mesh.Add(patch[i]));
    }
    mesh.Add(VTK_BEZIER_QUADRILATERAL, ids);
  }
  return MakeGrid(mesh);
}

Point At(const std::array<Point, 16>& patch, double r, double s)
{
  const auto weights = [](double t)
  {
    const double u = 1.0 - t;
    return std::array<double, 4>{ u * u * u, 3 * t * u * u, 3 * t * t * u, t * t * t };
  };
  const auto across = weights(r);
  const auto along = weights(s);
  Point sum{ 0, 0, 0 };
  for (int j = 0; j < 4; ++j)
  {
    for (int i = 0; i < 4; ++i)
    {
      sum = sum + (across[i] * along[j]) * patch[4 * j + i];
    }
  }
  return sum;
}

/// Each patch as 2 n^2 triangles.
PolyDataPointer AsTriangles(const std::vector<std::array<Point, 16>>& patches, int n)
{
  Mesh mesh;
  for (const auto& patch : patches)
  {
    const auto first = static_cast<vtkIdType>(mesh.Points.size());
    for (int k = 0; k < (n + 1) * (n + 1); ++k)
    {
      mesh.Add(At(patch, double(k % (n + 1)) / n, double(k / (n + 1)) / n));
    }
    for (int k = 0; k < n * n; ++k)
    {
      const vtkIdType a = first + k % n + (k / n) * (n + 1);
      mesh.Add(VTK_TRIANGLE, { a, a + 1, a + n + 2 });
      mesh.Add(VTK_TRIANGLE, { a, a + n + 2, a + n + 1 });
    }
  }
  return MakePolyData(mesh);
}

struct Hits
{
  std::vector<double> Curves;
  std::vector<double> Lengths;
  std::vector<double> Angles;
  std::vector<double> Cells;
  std::vector<double> PCoords;
  std::vector<Point> Points;

  Hits(vtkDataSet* lines, vtkDataSet* surface)
  {
    vtkNew<vtkSkdTreeCurveSurfaceIntersection> filter;
    filter->SetInputDataObject(0, lines);
    filter->SetSourceData(surface);
    this->Curves = OutputArray(filter, "SkdCurveId");
    this->Lengths = OutputArray(filter, "SkdArcLength");
    this->Angles = OutputArray(filter, "SkdAngle");
    this->Cells = OutputArray(filter, "SkdCellId");
    this->PCoords = OutputArray(filter, "SkdPCoords");
    this->Points = OutputPoints(filter);
  }

  std::vector<double> Of(int curve, double& leastAngle) const
  {
    std::vector<double> lengths;
    for (std::size_t i = 0; i < this->Curves.size(); ++i)
    {
      if (this->Curves[i] == curve)
      {
        lengths.push_back(this->Lengths[i]);
        leastAngle = std::min(leastAngle, this->Angles[i]);
      }
    }
    return lengths;
  }
};

}

TEST(CurveSurfaceTeapot, LinesHitThePatchesWhereTheyHitAThousandTrianglesOfEach)
{
  const auto patches = ReadTeapot(ExtraDataFolder() + "/E_cad/teapot.bez");
  if (patches.empty())
  {
    GTEST_SKIP() << "skipped: " << ExtraDataFolder() << " has no teapot";
  }
  const int count = 400;
  Random random(12);
  Mesh mesh;
  for (int i = 0; i < count; ++i)
  {
    const Point through = random.InBox({ -0.2, 1.3, -0.4, 0.4, 0.35, 1.0 });
    const Point direction = random.Direction();
    mesh.Add(
      VTK_LINE, { mesh.Add(through - 3.0 * direction), mesh.Add(through + 3.0 * direction) });
  }
  const PolyDataPointer lines = MakePolyData(mesh);
  const GridPointer teapot = AsBezier(patches);
  const Hits exact(lines, teapot);
  const Hits fine(lines, AsTriangles(patches, 32));
  int compared = 0;
  for (int line = 0; line < count; ++line)
  {
    double leastAngle = 90.0;
    const std::vector<double> found = exact.Of(line, leastAngle);
    const std::vector<double> expected = fine.Of(line, leastAngle);
    if (leastAngle > 10.0) // triangles may miss what grazes, or hit it twice
    {
      ASSERT_EQ(found.size(), expected.size()) << "line " << line;
      for (std::size_t i = 0; i < found.size(); ++i)
      {
        EXPECT_NEAR(found[i], expected[i], 5e-3) << "line " << line;
      }
      ++compared;
    }
  }
  EXPECT_GT(compared, count / 2);
  // The arrays of a point are those of the patch itself.
  ASSERT_FALSE(exact.Points.empty());
  for (std::size_t i = 0; i < exact.Points.size(); ++i)
  {
    const Point at = At(patches[static_cast<std::size_t>(exact.Cells[i])], exact.PCoords[3 * i],
      exact.PCoords[3 * i + 1]);
    EXPECT_LT(Length(at - exact.Points[i]), 1e-12);
  }
}
