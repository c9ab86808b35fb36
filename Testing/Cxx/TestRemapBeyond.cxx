// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeRemap: targets of longitudes and latitudes, values where the source is not, and what of
// a cell the source's mask lets count.

#include "Support/EventCounter.h"
#include "Support/RemapRun.h"
#include "Support/SphereMeshes.h"
#include "Support/SurfaceMeshes.h"

#include "vtkImageData.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredGrid.h"

#include <gtest/gtest.h>

#include <numeric>

using namespace skdtest;

namespace
{
using Remap = vtkSkdTreeRemap;

/// Cells of 30 degrees, between meridians and parallels.
vtkSmartPointer<vtkImageData> LonLatImage()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(13, 7, 1);
  image->SetSpacing(30, 30, 1);
  image->SetOrigin(-180, -90, 0);
  return image;
}

std::vector<vtkSmartPointer<vtkDataSet>> LonLatGrids()
{
  const auto image = LonLatImage();
  auto rectilinear = vtkSmartPointer<vtkRectilinearGrid>::New();
  rectilinear->SetDimensions(13, 7, 1);
  rectilinear->SetXCoordinates(MakeArray("x", 13, [](vtkIdType i) { return 30.0 * i - 180.0; }));
  rectilinear->SetYCoordinates(MakeArray("y", 7, [](vtkIdType i) { return 30.0 * i - 90.0; }));
  rectilinear->SetZCoordinates(MakeArray("z", 1, [](vtkIdType) { return 0.0; }));
  auto structured = vtkSmartPointer<vtkStructuredGrid>::New();
  structured->SetDimensions(13, 7, 1);
  std::vector<Point> points(static_cast<std::size_t>(image->GetNumberOfPoints()));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    image->GetPoint(static_cast<vtkIdType>(i), points[i].data());
  }
  structured->SetPoints(MakePoints(points));
  return { image, rectilinear, structured };
}

double Field(const Point& x)
{
  return 2.0 + x[0] * x[0] + 0.5 * x[2];
}
}

TEST(RemapBeyond, TargetsOfLongitudesAndLatitudes)
{
  const Mesh from = CubedSphere(6);
  const auto source = WithCellArray(MakePolyData(from), "f", CellAverages(from, Field));
  for (const auto& grid : LonLatGrids())
  {
    for (const int method : { Remap::CONSERVATIVE_FIRST_ORDER, Remap::CONSERVATIVE_SECOND_ORDER,
           Remap::CONTAINED, Remap::INTERPOLATION })
    {
      SCOPED_TRACE(testing::Message() << grid->GetClassName() << " " << method);
      const RemapPointer remap = MakeRemap(grid, source, method);
      remap->SetInputCoordinates(Remap::LONGITUDE_LATITUDE);
      remap->SetInputEdgesAlongParallels(true);
      remap->SetResultsOn(Remap::CELLS);
      const EventCounter events(remap);
      const std::vector<double> values = RemappedCells(remap, "f");
      EXPECT_EQ(events.Warnings, 0) << events.Warning;
      auto* output = vtkDataSet::SafeDownCast(remap->GetOutputDataObject(0));
      EXPECT_STREQ(output->GetClassName(), grid->GetClassName());
      EXPECT_EQ(output->GetPoint(14)[0], -150.0);
      ASSERT_EQ(values.size(), 72u);
      for (std::size_t i = 0; i < values.size(); ++i)
      {
        const double longitude = (30.0 * (i % 12) - 165.0) * std::acos(-1.0) / 180.0;
        const double latitude = (30.0 * (i / 12) - 75.0) * std::acos(-1.0) / 180.0;
        const Point middle{ std::cos(latitude) * std::cos(longitude),
          std::cos(latitude) * std::sin(longitude), std::sin(latitude) };
        ASSERT_NEAR(values[i], Field(middle), 0.2) << i;
      }
      if (method >= Remap::CONSERVATIVE_FIRST_ORDER)
      {
        EXPECT_LT(Reported(remap, "ConservationError"), 1e-14);
        EXPECT_NEAR(Reported(remap, "TargetIntegral"), Reported(remap, "SourceIntegral"), 1e-12);
        EXPECT_NEAR(RemappedCells(remap, "SkdCoverage")[40], 1.0, 1e-13);
      }
    }
  }
}

TEST(RemapBeyond, BothOfLongitudesAndLatitudes)
{
  const auto input = LonLatImage();
  const auto source = LonLatImage();
  source->SetOrigin(-165, -90, 0);
  source->GetCellData()->AddArray(MakeArray("f", 72, [](vtkIdType i) { return 1.0 * (i % 12); }));
  const RemapPointer remap = MakeRemap(input, source, Remap::CONSERVATIVE_FIRST_ORDER);
  remap->SetInputCoordinates(Remap::LONGITUDE_LATITUDE);
  remap->SetSourceCoordinates(Remap::LONGITUDE_LATITUDE);
  remap->SetInputEdgesAlongParallels(true);
  remap->SetSourceEdgesAlongParallels(true);
  const std::vector<double> values = RemappedCells(remap, "f");
  for (std::size_t i = 0; i < 72; ++i) // across the date line, too
  {
    ASSERT_NEAR(values[i], i % 12 == 0 ? 5.5 : static_cast<double>(i % 12) - 0.5, 1e-13);
  }
}

TEST(RemapBeyond, MeshesThatMayBeOfLongitudesAndLatitudesAreTold)
{
  const Mesh mesh = CubedSphere(3);
  const auto sphere = WithCellArray(MakePolyData(mesh), "f", CellAverages(mesh, Field));
  const auto image = LonLatImage();
  image->GetCellData()->AddArray(MakeArray("f", 72, [](vtkIdType) { return 1.0; }));
  const auto warning = [](vtkDataObject* input, vtkDataObject* source)
  {
    const RemapPointer remap = MakeRemap(input, source, Remap::CONSERVATIVE_FIRST_ORDER);
    const EventCounter events(remap);
    remap->Update();
    return events.Warning;
  };
  EXPECT_NE(warning(image, sphere).find("set InputCoordinates"), std::string::npos);
  EXPECT_NE(warning(sphere, image).find("set SourceCoordinates"), std::string::npos);
  EXPECT_EQ(warning(sphere, sphere), "");
}

namespace
{
/// Two rows of three squares as the source, and nine by nine smaller ones as the target, of which
/// five by three are covered.
struct Beyond
{
  Mesh From = Part(Sheet(3, VTK_QUAD), [](std::size_t i) { return i < 6; });
  GridPointer Source = WithCellArray(MakeGrid(From), "f", { 1, 5, -2, 4, 0.5, 3 });
  Mesh To = Transformed(Sheet(9, VTK_QUAD), 0.7, { 0.05, 0.05, 0 });
  GridPointer Input = MakeGrid(To);

  /// The mean of the nearest by the inverse squares of distances, by brute force.
  double Expected(std::size_t cell, std::size_t most) const
  {
    const std::vector<double> values{ 1, 5, -2, 4, 0.5, 3 };
    const auto middle = [](const Mesh& mesh, std::size_t i)
    {
      const auto& ids = mesh.Cells[i].Points;
      return 0.5 *
        (mesh.Points[static_cast<std::size_t>(ids[0])] +
          mesh.Points[static_cast<std::size_t>(ids[2])]);
    };
    std::vector<std::pair<double, std::size_t>> near;
    for (std::size_t i = 0; i < 6; ++i)
    {
      const Point direction = middle(this->From, i) - middle(this->To, cell);
      near.emplace_back(Dot(direction, direction), i);
    }
    std::sort(near.begin(), near.end());
    double sum = 0.0, weights = 0.0;
    for (std::size_t k = 0; k < most; ++k)
    {
      sum += values[near[k].second] / near[k].first;
      weights += 1.0 / near[k].first;
    }
    return sum / weights;
  }
};
}

TEST(RemapBeyond, ExtrapolatesByChoice)
{
  const Beyond beyond;
  const RemapPointer remap =
    MakeRemap(beyond.Input, beyond.Source, Remap::CONSERVATIVE_FIRST_ORDER);
  const std::vector<double> none = RemappedCells(remap, "f");
  const std::vector<double> valid = RemappedCells(remap, "SkdValid");
  const double integral = Reported(remap, "TargetIntegral");
  EXPECT_EQ(std::count(valid.begin(), valid.end(), 0.0), 66);
  remap->SetExtrapolationConstant(-9.0);
  for (const int method : { Remap::NEAREST_VALUE, Remap::CONSTANT_VALUE, Remap::INVERSE_DISTANCE })
  {
    SCOPED_TRACE(method);
    remap->SetExtrapolation(method);
    remap->SetExtrapolationNeighbors(4);
    const std::vector<double> values = RemappedCells(remap, "f");
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      const double expected = valid[i] != 0.0 ? none[i]
        : method == Remap::CONSTANT_VALUE     ? -9.0
                                              : beyond.Expected(i, method == 1 ? 1 : 4);
      ASSERT_NEAR(values[i], expected, 1e-13) << i;
    }
    EXPECT_EQ(RemappedCells(remap, "SkdValid"), valid);
    EXPECT_EQ(Reported(remap, "TargetIntegral"), integral);
  }
  remap->SetExtrapolationNeighbors(100); // more than there are
  EXPECT_NEAR(RemappedCells(remap, "f")[80], beyond.Expected(80, 6), 1e-13);
  remap->AddExtensiveArray("f");
  EXPECT_TRUE(std::isnan(RemappedCells(remap, "f")[80]));
}

TEST(RemapBeyond, WhatIsMaskedIsExtrapolatedAndIsNoFraction)
{
  const auto source = MakeGrid(Sheet(2, VTK_QUAD));
  WithCellArray(source, "f", { 1, 2, 3, 4 });
  WithCellArray(source, "mask", { 1, 0, 1, 0 });
  const auto input = MakeGrid(Transformed(Sheet(1, VTK_QUAD), 1.0, { 0.75, 0, 0 }));
  RemapPointer remap = MakeRemap(input, source, Remap::CONSERVATIVE_FIRST_ORDER);
  EXPECT_EQ(RemappedCells(remap, "SkdFraction"), (std::vector<double>{ 1 }));
  remap->SetMaskArray("mask");
  EXPECT_EQ(RemappedCells(remap, "SkdCoverage"), (std::vector<double>{ 1 }));
  EXPECT_EQ(RemappedCells(remap, "SkdFraction"), (std::vector<double>{ 0.25 }));
  EXPECT_EQ(RemappedCells(remap, "f"), (std::vector<double>{ 1 }));
  remap = MakeRemap(MakeGrid(Transformed(Sheet(1, VTK_QUAD), 0.5, { 1.25, 1.25, 0 })), source,
    Remap::CONSERVATIVE_SECOND_ORDER);
  remap->SetMaskArray("mask");
  remap->SetExtrapolation(Remap::NEAREST_VALUE);
  EXPECT_EQ(RemappedCells(remap, "f"), (std::vector<double>{ 3 }));
}
