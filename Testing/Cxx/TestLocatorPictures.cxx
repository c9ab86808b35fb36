// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// Hits of the rays of a picture, which a batch finds of several at once, are those of each ray.

#include "Support/LocatorOnMesh.h"
#include "Support/SurfaceMeshes.h"

#include "vtkDoubleArray.h"
#include "vtkGenericCell.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace skdtest;

namespace
{

/// The ends of the rays of a picture of n x n, row by row: from one point, or all the same way.
std::vector<Point> RaysOfPicture(const Bounds& box, bool isPerspective, int n)
{
  const double size = Diagonal(box);
  const Point eye = Center(box) + size * Point{ 0.3, -1.1, 0.7 };
  std::vector<Point> ends;
  for (int row = 0; row < n; ++row)
  {
    for (int column = 0; column < n; ++column)
    {
      const double u = (column + 0.5) / n - 0.5;
      const double v = (row + 0.5) / n - 0.5;
      const Point aside = size * Point{ u, 0.2 * v, v };
      ends.push_back(isPerspective ? eye : eye + aside);
      ends.push_back(Center(box) - 0.9 * (eye - Center(box)) + aside);
    }
  }
  return ends;
}

vtkSmartPointer<vtkDoubleArray> LinesOf(const std::vector<Point>& ends)
{
  auto lines = vtkSmartPointer<vtkDoubleArray>::New();
  lines->SetNumberOfComponents(6);
  lines->SetNumberOfTuples(static_cast<vtkIdType>(ends.size() / 2));
  std::copy_n(ends.data()->data(), 3 * ends.size(), lines->GetPointer(0));
  return lines;
}

void ExpectAllHitsOfEachRay(
  vtkSkdTreeCellLocator* locator, const std::vector<Point>& ends, double tolerance)
{
  const auto lines = LinesOf(ends);
  vtkNew<vtkIdTypeArray> offsets, ids;
  vtkNew<vtkDoubleArray> ts, xs;
  vtkNew<vtkGenericCell> cell;
  locator->FindAllHits(lines, offsets, ids, ts, xs, tolerance);
  vtkIdType at = 0;
  for (vtkIdType i = 0; i < lines->GetNumberOfTuples() && !testing::Test::HasFailure(); ++i)
  {
    const Point* end = ends.data() + 2 * i;
    const LineHits hits = FindAllHits(locator, end[0], end[1], tolerance, cell);
    ASSERT_EQ(offsets->GetValue(i), at);
    ASSERT_EQ(offsets->GetValue(i + 1) - at, static_cast<vtkIdType>(hits.Cells.size())) << i;
    for (std::size_t k = 0; k < hits.Cells.size(); ++k, ++at)
    {
      Point x;
      xs->GetTypedTuple(at, x.data());
      EXPECT_EQ(ids->GetValue(at), hits.Cells[k]) << i;
      EXPECT_EQ(x, hits.Points[k]) << i;
    }
  }
}

/// Returns the number of first hits.
vtkIdType ExpectHitsOfEachRay(
  vtkSkdTreeCellLocator* locator, const std::vector<Point>& ends, double tolerance)
{
  ExpectAllHitsOfEachRay(locator, ends, tolerance);
  const auto lines = LinesOf(ends);
  vtkNew<vtkIdTypeArray> ids;
  vtkNew<vtkDoubleArray> ts, xs;
  const vtkIdType number = locator->IntersectWithLines(lines, ids, ts, xs, tolerance);
  for (vtkIdType i = 0; i < lines->GetNumberOfTuples(); ++i)
  {
    const auto at = static_cast<std::size_t>(2 * i);
    const LineHit hit = FindFirstHit(locator, ends[at], ends[at + 1], tolerance);
    EXPECT_EQ(ids->GetValue(i), hit.Cell) << i;
    EXPECT_EQ(std::isnan(ts->GetValue(i)), !hit.Found) << i;
    if (hit.Found)
    {
      EXPECT_EQ(ts->GetValue(i), hit.T) << i;
      Point x;
      xs->GetTypedTuple(i, x.data());
      EXPECT_EQ(x, hit.X) << i;
    }
    if (testing::Test::HasFailure())
    {
      break;
    }
  }
  return number;
}

using Pictures = BuiltLocator;
INSTANTIATE_TEST_SUITE_P(All, Pictures, testing::ValuesIn(AllMeshes()), NameOfMesh());

TEST_P(Pictures, HaveTheHitsOfEachRay)
{
  for (const double tolerance : { 0.0, 0.01 })
  {
    ExpectHitsOfEachRay(this->Locator, RaysOfPicture(this->Box, true, 24), tolerance);
    ExpectHitsOfEachRay(this->Locator, RaysOfPicture(this->Box, false, 24), tolerance);
  }
}

/// So many triangles that some packets are too far apart and others not; all twice in the mesh, so
/// that a hit of two has the lower id; and far from the origin.
TEST(PictureOfASphere, HasTheHitsOfEachRay)
{
  const double offsets[] = { 0.0, 1e6 };
  for (const double offset : offsets)
  {
    const Mesh sphere = SphereTriangles(24).Map(
      [offset](const Point& p) {
        return p + Point{ offset, -offset, 0.5 * offset };
      });
    const Mesh twice = Together({ sphere, sphere });
    for (const Mesh& mesh : { sphere, twice })
    {
      const auto data = MakePolyData(mesh);
      const auto locator = MakeLocator(data);
      Bounds box;
      data->GetBounds(box.data());
      for (const int n : { 16, 64, 128 })
      {
        EXPECT_GT(ExpectHitsOfEachRay(locator, RaysOfPicture(box, true, n), 0.0), n * n / 20);
        EXPECT_GT(ExpectHitsOfEachRay(locator, RaysOfPicture(box, false, n), 0.0), n * n / 20);
      }
    }
  }
}

}
