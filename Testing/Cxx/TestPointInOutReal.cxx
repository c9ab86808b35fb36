// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreePointInOut on surfaces that other people made: those of Data/, and of the folder
// SKDTREE_EXTRA_DATA_DIR if it is there.

#include "Support/CellShape.h"
#include "Support/InOutRun.h"
#include "Support/OnFile.h"

#include <gtest/gtest.h>

using namespace skdtest;

namespace
{

using Corners = std::vector<std::array<Point, 3>>;

Corners TrianglesOf(const Mesh& mesh)
{
  Corners triangles;
  for (const CellSpec& cell : mesh.Cells)
  {
    triangles.push_back(
      { mesh.Points[cell.Points[0]], mesh.Points[cell.Points[1]], mesh.Points[cell.Points[2]] });
  }
  return triangles;
}

/// By a look at every triangle along three lines; nullopt where these do not agree, or pass an
/// edge.
std::optional<bool> IsWithin(const Corners& triangles, const Point& x, double far, Random& random)
{
  int inside = 0;
  for (int line = 0; line < 3; ++line)
  {
    const Point end = x + far * random.Direction();
    int crossings = 0;
    for (const auto& triangle : triangles)
    {
      crossings += HitTriangle(x, end, triangle).has_value();
    }
    inside += crossings % 2;
  }
  return inside == 0 ? std::optional(false) : inside == 3 ? std::optional(true) : std::nullopt;
}

/// Anywhere in a box that is a little larger, and close to the surface.
std::vector<Point> PointsNear(const Mesh& mesh, const Bounds& box, int count)
{
  Random random(71);
  std::vector<Point> points;
  for (int i = 0; i < count; ++i)
  {
    const Point& vertex = mesh.Points[random.Index(static_cast<int>(mesh.Points.size()))];
    const double away = Diagonal(box) * std::pow(10.0, -2.0 - i % 4);
    points.push_back(i % 2 == 0 ? vertex + away * random.Direction()
                                : random.InBox(Grown(box, 0.02 * Diagonal(box))));
  }
  return points;
}

Bounds BoundsOf(vtkDataSet* mesh)
{
  Bounds box;
  mesh->GetBounds(box.data());
  return box;
}

class PointInOutOfFile : public OnFile
{
protected:
  void SetUp() override
  {
    OnFile::SetUp();
    if (IsSkipped())
    {
      return;
    }
    this->Surface = Triangulated(SurfaceOf(ReadMesh(GetParam())));
    if (!IsClosed(this->Surface))
    {
      GTEST_SKIP() << "not a closed surface of triangles and quads";
    }
  }

  Mesh Surface;
};

INSTANTIATE_TEST_SUITE_P(
  Shipped, PointInOutOfFile, testing::ValuesIn(SurfaceFiles(DataFolder())), NameOfFile());
INSTANTIATE_TEST_SUITE_P(Extra, PointInOutOfFile,
  testing::ValuesIn(SurfaceFiles(ExtraDataFolder() + "/A_surface")), NameOfFile());

TEST_P(PointInOutOfFile, RaysAreRightAtEveryPoint)
{
  const PolyDataPointer source = MakePolyData(this->Surface);
  const Bounds box = BoundsOf(source);
  const std::vector<Point> points = PointsNear(this->Surface, box, 60);
  const Corners triangles = TrianglesOf(this->Surface);
  Random random(72);
  std::vector<std::optional<bool>> right;
  for (const Point& x : points)
  {
    right.push_back(IsWithin(triangles, x, 3 * Diagonal(box), random));
  }
  for (int method : { InOut::AXIS_RAYS, InOut::RANDOM_RAYS })
  {
    InOutPointer filter = MakeInOut(MakeQueries(points), source, method);
    const std::vector<double> inside = RunFor(filter, "SkdInside");
    const std::vector<double> confidence = RunFor(filter, "SkdConfidence");
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      ASSERT_TRUE(!right[i] || (inside[i] == 1) == *right[i]) << method << " point " << i;
      ASSERT_EQ(confidence[i], 1);
    }
    EXPECT_EQ(Reported(filter, "OpenEdges"), 0);
  }
}

}
