// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreePointInOut as a voxeliser: by rows, with the results of single points.

#include "Support/InOutRun.h"
#include "Support/StructuredMeshes.h"

#include "vtkImageData.h"
#include "vtkRectilinearGrid.h"
#include "vtkSMPTools.h"

#include <gtest/gtest.h>

using namespace skdtest;

namespace
{

/// Of n points a side, a little larger than the box times `part`.
vtkSmartPointer<vtkImageData> ImageAround(const Bounds& box, int n, double part = 1.1)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(n + 3, n, n - 1);
  const Point middle = Center(box);
  Point size, origin;
  for (int axis = 0; axis < 3; ++axis)
  {
    size[axis] = part * (box[2 * axis + 1] - box[2 * axis]);
    origin[axis] = middle[axis] - 0.5 * size[axis];
  }
  image->SetOrigin(origin.data());
  image->SetSpacing(size[0] / (n + 2), size[1] / (n - 1), size[2] / (n - 2));
  return image;
}

/// The same points as scattered ones.
PolyDataPointer PointsOf(vtkDataSet* mesh)
{
  std::vector<Point> points(mesh->GetNumberOfPoints());
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    mesh->GetPoint(i, points[i].data());
  }
  return MakeQueries(points);
}

/// Points at a surface, where either answer is right.
std::vector<bool> AtSurface(vtkDataSet* points, vtkDataObject* source)
{
  InOutPointer filter = MakeInOut(points, source);
  filter->SetBoundaryBand(1e-12);
  const std::vector<double> band = RunFor(filter, "SkdOnBoundary");
  return { band.begin(), band.end() };
}

/// Rows answer as single points do, in all arrays.
void ExpectSame(vtkDataSet* rows, vtkDataObject* source, int parts = InOut::BLOCKS)
{
  const PolyDataPointer points = PointsOf(rows);
  const std::vector<bool> isFree = AtSurface(points, source);
  for (int method : { InOut::AXIS_RAYS, InOut::RANDOM_RAYS })
  {
    InOutPointer byRows = MakeInOut(rows, source, method);
    InOutPointer byPoints = MakeInOut(points, source, method);
    byRows->SetParts(parts);
    byPoints->SetParts(parts);
    for (const char* name : { "SkdInside", "SkdPartId", "SkdDepth", "SkdConfidence" })
    {
      const std::vector<double> a = RunFor(byRows, name);
      const std::vector<double> b = RunFor(byPoints, name);
      ASSERT_EQ(a.size(), b.size());
      for (std::size_t i = 0; i < a.size(); ++i)
      {
        ASSERT_TRUE(a[i] == b[i] || isFree[i]) << name << " " << i << ": " << a[i] << " " << b[i];
      }
    }
  }
}

Bounds BoundsOf(vtkDataSet* mesh)
{
  Bounds box;
  mesh->GetBounds(box.data());
  return box;
}

TEST(PointInOutRows, OfSurfacesThatAreCurved)
{
  for (const Mesh& mesh :
    { Sphere(16, 1.0), TorusTriangles(24, 12), Together({ Sphere(24, 1.0), Sphere(24, 0.9999) }) })
  {
    auto source = MakePolyData(mesh);
    ExpectSame(ImageAround(BoundsOf(source), 30), source);
    ExpectSame(ImageAround(BoundsOf(source), 17, 0.6), source); // rows begin and end within
    ExpectSame(ImageAround(BoundsOf(source), 9, 3.0), source);
  }
}

TEST(PointInOutRows, FillTheVolumeOfABall)
{
  auto image = ImageAround({ -1, 1, -1, 1, -1, 1 }, 40);
  InOutPointer filter = MakeInOut(image, MakePolyData(Sphere(40, 1.0)));
  filter->Update();
  const double* h = image->GetSpacing();
  EXPECT_NEAR(Reported(filter, "PointsInside") * h[0] * h[1] * h[2], 4.1888, 0.03);
}

TEST(PointInOutRows, RunningInFacesAndEdges)
{
  auto cube = MakePolyData(CubeTriangles(4));
  const Bounds box = BoundsOf(cube);
  vtkNew<vtkImageData> image; // has points in all faces, edges and corners
  image->SetDimensions(11, 11, 11);
  const double step = (box[1] - box[0]) / 8;
  image->SetSpacing(step, step, step);
  image->SetOrigin(box[0] - step, box[2] - step, box[4] - step);
  ExpectSame(image, cube);
}

TEST(PointInOutRows, TouchingCornersAndEdgesOnly)
{
  // Rows through corners that only touch there, and through edges: of one body and of two that have
  // a corner in common.
  const Mesh one = Octahedron(1);
  const Mesh two = Together({ one,
    Octahedron(1).Map(
      [](const Point& p) {
        return p + Point{ 2, 0, 0 };
      }) });
  vtkNew<vtkImageData> image;
  image->SetDimensions(21, 13, 13);
  image->SetSpacing(0.25, 0.25, 0.25);
  image->SetOrigin(-1.5, -1.5, -1.5);
  for (const Mesh& mesh : { one, two })
  {
    auto source = MakePolyData(mesh);
    ExpectSame(image, source);
    const std::vector<double> inside = RunFor(MakeInOut(image, source), "SkdInside");
    for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
    {
      Point x;
      image->GetPoint(i, x.data());
      const double first = std::abs(x[0]) + std::abs(x[1]) + std::abs(x[2]);
      const double second = std::abs(x[0] - 2) + std::abs(x[1]) + std::abs(x[2]);
      const double least = mesh.Cells.size() == one.Cells.size() ? first : std::min(first, second);
      ASSERT_TRUE(least == 1.0 || (inside[i] == 1) == (least < 1.0)) << i;
    }
  }
}

TEST(PointInOutRows, OfNestedAndSeparateParts)
{
  auto source =
    MakePolyData(Together({ Sphere(12, 1.0), Sphere(12, 0.5), Sphere(12, 0.4, { 1.8, 0, 0 }) }));
  const auto image = ImageAround(BoundsOf(source), 25);
  ExpectSame(image, source);
  ExpectSame(image, source, InOut::CONNECTED_PIECES);
}

TEST(PointInOutRows, OfOpenPartsPointsVote)
{
  const Mesh sphere = Sphere(12, 1.0);
  auto closed = MakePolyData(Sphere(12, 0.6));
  auto open = MakePolyData(Part(sphere, [](std::size_t cell) { return cell % 9 != 0; }));
  auto image = ImageAround(BoundsOf(open), 20);
  auto blocks = MakeBlocks({ open, closed });
  ExpectSame(image, closed);
  InOutPointer byRows = MakeInOut(image, blocks);
  InOutPointer byPoints = MakeInOut(PointsOf(image), blocks);
  EXPECT_EQ(RunFor(byRows, "SkdConfidence"), RunFor(byPoints, "SkdConfidence"));
  EXPECT_EQ(RunFor(byRows, "SkdDepth"), RunFor(byPoints, "SkdDepth"));
}

TEST(PointInOutRows, OfTurnedImagesAndRectilinearGrids)
{
  auto ball = MakePolyData(Sphere(12, 2.0, { 2.5, 2.5, 2.5 }));
  ExpectSame(MakeRotatedImage(8), ball);
  ExpectSame(MakeRectilinear(8), ball);
}

TEST(PointInOutRows, OfCellsByTheirMiddles)
{
  auto ball = MakePolyData(Sphere(12, 1.0));
  auto image = ImageAround(BoundsOf(ball), 14);
  InOutPointer filter = MakeInOut(image, ball);
  filter->SetAsk(InOut::CELL_CENTERS);
  filter->Update();
  auto* found = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  std::vector<Point> middles;
  for (vtkIdType cell = 0; cell < image->GetNumberOfCells(); ++cell)
  {
    Bounds box;
    image->GetCellBounds(cell, box.data());
    middles.push_back(Center(box));
  }
  const std::vector<double> right = RunFor(MakeInOut(MakeQueries(middles), ball), "SkdInside");
  vtkDataArray* inside = found->GetCellData()->GetArray("SkdInside");
  for (std::size_t i = 0; i < right.size(); ++i)
  {
    ASSERT_EQ(inside->GetTuple1(static_cast<vtkIdType>(i)), right[i]) << i;
  }
}

TEST(PointInOutRows, AreTheSameForAnyNumberOfThreads)
{
  auto ball = MakePolyData(Sphere(20, 1.0));
  auto image = ImageAround(BoundsOf(ball), 40);
  std::vector<std::vector<double>> answers;
  for (int threads : { 1, 2, 4 })
  {
    vtkSMPTools::Initialize(threads);
    answers.push_back(RunFor(MakeInOut(image, ball), "SkdInside"));
  }
  vtkSMPTools::Initialize();
  EXPECT_EQ(answers[0], answers[1]);
  EXPECT_EQ(answers[0], answers[2]);
}

TEST(PointInOutRows, OfOnePointOrOneRow)
{
  auto ball = MakePolyData(Sphere(8, 1.0));
  for (int length : { 1, 2, 7 })
  {
    vtkNew<vtkImageData> image;
    image->SetDimensions(length, 1, 1);
    image->SetOrigin(-0.5, 0.1, 0.2);
    image->SetSpacing(0.3, 0.3, 0.3);
    EXPECT_EQ(RunFor(MakeInOut(image, ball), "SkdInside"),
      RunFor(MakeInOut(PointsOf(image), ball), "SkdInside"));
  }
}

}
