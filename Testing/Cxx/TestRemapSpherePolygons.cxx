// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeRemap of polygons on a sphere that are large, have many corners, or wind about it: any
// simple one up to a hemisphere.

#include "Support/CurveRun.h"
#include "Support/EventCounter.h"
#include "Support/RemapRun.h"
#include "Support/SphereMeshes.h"

#include "vtkStringArray.h"

#include <gtest/gtest.h>

using namespace skdtest;

namespace
{
using Remap = vtkSkdTreeRemap;

const double HalfTurn = std::acos(-1.0);

Point OnSphere(const Point& p)
{
  return (1.0 / Length(p)) * p;
}

/// Two directions across one.
std::array<Point, 2> AxesOf(const Point& n)
{
  const Point aside = std::abs(n[2]) < 0.9 ? Point{ 0, 0, 1 } : Point{ 1, 0, 0 };
  const Point first = OnSphere(Cross(aside, n));
  return { first, Cross(n, first) };
}

Point At(const Point& n, double distance, double angle)
{
  const auto axes = AxesOf(n);
  return std::cos(distance) * n +
    std::sin(distance) * (std::cos(angle) * axes[0] + std::sin(angle) * axes[1]);
}

double TriangleArea(const Point& a, const Point& b, const Point& c)
{
  return 2.0 * std::atan2(Dot(a, Cross(b, c)), 1.0 + Dot(a, b) + Dot(b, c) + Dot(c, a));
}

GridPointer PolygonOf(const std::vector<Point>& corners)
{
  return MakeGrid(OneCell(VTK_POLYGON, corners));
}

/// What of each cell of a sphere a mesh covers, and the sums by cell data and by point data.
struct Covered
{
  std::vector<double> Coverage;
  double OfCells = 0.0;
  double OfPoints = 0.0;
};

Covered Cover(const GridPointer& source)
{
  WithCellArray(
    source, "c", std::vector<double>(static_cast<std::size_t>(source->GetNumberOfCells()), 1.0));
  source->GetPointData()->AddArray(
    MakeArray("p", source->GetNumberOfPoints(), [](vtkIdType) { return 1.0; }));
  const GridPointer sphere = MakeGrid(CubedSphere(4));
  const RemapPointer remap = MakeRemap(sphere, source, Remap::CONSERVATIVE_FIRST_ORDER);
  remap->SetGeometry(Remap::SPHERE);
  Covered covered{ RemappedCells(remap, "SkdCoverage") };
  vtkFieldData* report = remap->GetOutputDataObject(0)->GetFieldData();
  auto* names = vtkStringArray::SafeDownCast(report->GetAbstractArray("SkdReportArray"));
  for (const char* what : { "SkdReportSourceIntegral", "SkdReportTargetIntegral" })
  {
    covered.OfCells = report->GetArray(what)->GetTuple1(names->LookupValue("c"));
    covered.OfPoints = report->GetArray(what)->GetTuple1(names->LookupValue("p"));
    EXPECT_NEAR(covered.OfCells, covered.OfPoints, 1e-12);
  }
  return covered;
}

/// A band of a width along a path on the sphere, as one polygon and as quadrilaterals.
struct Band
{
  std::vector<Point> Outline;
  Mesh Quads;

  Band(const std::function<Point(double)>& path, double length, double width, int steps)
  {
    std::vector<Point> left, right;
    for (int i = 0; i <= steps; ++i)
    {
      const double t = length * i / steps;
      const Point at = OnSphere(path(t));
      const Point along = OnSphere(path(t + 1e-6) - path(t - 1e-6));
      const Point aside = OnSphere(Cross(at, along));
      left.push_back(OnSphere(at + (0.5 * width) * aside));
      right.push_back(OnSphere(at - (0.5 * width) * aside));
      this->Quads.Add(left.back());
      this->Quads.Add(right.back());
    }
    for (vtkIdType i = 0; i < steps; ++i)
    {
      this->Quads.Add(VTK_QUAD, { 2 * i, 2 * i + 1, 2 * i + 3, 2 * i + 2 });
    }
    this->Outline = right;
    this->Outline.insert(this->Outline.end(), left.rbegin(), left.rend());
  }
};

/// The warning of a remap from a mesh to a sphere, all of whose cells are NaN if there is nothing.
std::string WarningOf(const GridPointer& source, double expectedArea)
{
  WithCellArray(
    source, "c", std::vector<double>(static_cast<std::size_t>(source->GetNumberOfCells()), 1.0));
  const RemapPointer remap =
    MakeRemap(MakeGrid(CubedSphere(4)), source, Remap::CONSERVATIVE_FIRST_ORDER);
  remap->SetGeometry(Remap::SPHERE);
  const EventCounter events(remap);
  const std::vector<double> values = RemappedCells(remap, "c");
  EXPECT_NEAR(Reported(remap, "TargetIntegral"), expectedArea, 1e-12);
  EXPECT_EQ(expectedArea == 0.0,
    std::all_of(values.begin(), values.end(), [](double x) { return std::isnan(x); }));
  return events.Warning;
}
}

TEST(RemapSpherePolygons, RegularOnesUpToAHemisphere)
{
  Random random(3);
  for (const int corners : { 3, 4, 5, 12, 30, 31, 36, 72, 100, 128 })
  {
    for (const double radius : { 0.2, 1.0, HalfTurn / 3.0, 1.3, 1.5 })
    {
      SCOPED_TRACE(testing::Message() << corners << " corners, radius " << radius);
      const Point middle = random.Direction();
      std::vector<Point> outline;
      double area = 0.0;
      for (int i = 0; i < corners; ++i)
      {
        outline.push_back(At(middle, radius, 2.0 * HalfTurn * i / corners));
        area += TriangleArea(
          middle, outline.back(), At(middle, radius, 2.0 * HalfTurn * (i + 1) / corners));
      }
      if (corners % 2 == 1 && radius < 0.5)
      {
        std::reverse(outline.begin(), outline.end());
      }
      const Covered covered = Cover(PolygonOf(outline));
      EXPECT_NEAR(covered.OfCells, area, 1e-12);
      for (const double share : covered.Coverage)
      {
        EXPECT_LE(share, 1.0 + 1e-12);
      }
    }
  }
}

/// The order of corners tells that more than a hemisphere is meant.
TEST(RemapSpherePolygons, LargerOnesAreNamed)
{
  for (const double radius : { 1.6, 1.8, 2.2, 2.4 })
  {
    std::vector<Point> outline;
    for (int i = 0; i < 40; ++i)
    {
      outline.push_back(At({ 0.6, 0, 0.8 }, radius, 2.0 * HalfTurn * i / 40));
    }
    const std::string warning = WarningOf(PolygonOf(outline), 0.0);
    EXPECT_NE(warning.find("cell 0) are larger than a hemisphere"), std::string::npos) << warning;
  }
  Mesh halves = CubedSphere(1); // all of it large, and ordered the other way round
  for (auto& cell : halves.Cells)
  {
    std::reverse(cell.Points.begin(), cell.Points.end());
  }
  EXPECT_EQ(WarningOf(MakeGrid(halves), 4.0 * HalfTurn), "");
  std::reverse(halves.Cells[3].Points.begin(), halves.Cells[3].Points.end());
  const std::string warning = WarningOf(MakeGrid(halves), 10.0 / 3.0 * HalfTurn);
  EXPECT_NE(warning.find("cell 3) are larger than a hemisphere"), std::string::npos) << warning;
}

TEST(RemapSpherePolygons, ThatCrossThemselvesAreNamed)
{
  const double s = std::sqrt(0.5);
  const auto isNamed = [](const std::string& warning)
  { return warning.find("cell 0) cross themselves") != std::string::npos; };
  const Covered twist = Cover(PolygonOf({ { 1, 0, 0 }, { 0, 1, 0 }, { s, 0, s }, { 0, s, s } }));
  EXPECT_LT(twist.OfCells, 1.0);
  std::vector<Point> star, large; // twice around, small and near a great circle
  for (int i = 0; i < 5; ++i)
  {
    star.push_back(At({ 0, 0.6, 0.8 }, 0.3, 0.8 * HalfTurn * i));
    large.push_back(At({ 0, 0.6, 0.8 }, 1.5, 0.8 * HalfTurn * i));
  }
  for (const GridPointer& mesh : { PolygonOf(star), PolygonOf(large) })
  {
    WithCellArray(mesh, "c", { 1.0 });
    const RemapPointer remap =
      MakeRemap(MakeGrid(CubedSphere(4)), mesh, Remap::CONSERVATIVE_FIRST_ORDER);
    remap->SetGeometry(Remap::SPHERE);
    const EventCounter events(remap);
    remap->Update();
    EXPECT_TRUE(isNamed(events.Warning)) << events.Warning;
  }
  // Opposite corners next to each other have no edge.
  EXPECT_TRUE(
    isNamed(WarningOf(PolygonOf({ { 1, 0, 0 }, { -1, 0, 0 }, { 0, -s, s }, { 0, -1, 0 } }), 0.0)));
}

/// Concave ones, seen from a point within.
TEST(RemapSpherePolygons, RandomStars)
{
  Random random(5);
  for (int run = 0; run < 25; ++run)
  {
    SCOPED_TRACE(run);
    const Point middle = random.Direction();
    const int corners = 5 + random.Index(80);
    std::vector<Point> outline;
    for (int i = 0; i < corners; ++i)
    {
      outline.push_back(At(middle, random.Between(0.3, 1.55), 2.0 * HalfTurn * i / corners));
    }
    double area = 0.0;
    Mesh fan;
    for (const Point& p : outline)
    {
      fan.Add(p);
    }
    const vtkIdType tip = fan.Add(middle);
    for (int i = 0; i < corners; ++i)
    {
      const int next = (i + 1) % corners;
      area += TriangleArea(
        middle, outline[static_cast<std::size_t>(i)], outline[static_cast<std::size_t>(next)]);
      fan.Add(VTK_TRIANGLE, { tip, i, next });
    }
    const Covered covered = Cover(PolygonOf(outline));
    const Covered expected = Cover(MakeGrid(fan));
    EXPECT_NEAR(covered.OfCells, area, 1e-12);
    for (std::size_t i = 0; i < covered.Coverage.size(); ++i)
    {
      ASSERT_NEAR(covered.Coverage[i], expected.Coverage[i], 1e-11) << i;
    }
  }
}

/// Bands that go around the sphere, and none of whose points sees all of them.
TEST(RemapSpherePolygons, BandsAlongPaths)
{
  const auto equator = [](double t) { return Point{ std::cos(t), std::sin(t), 0.0 }; };
  const auto spiral = [](double t) { return Point{ std::cos(t), std::sin(t), 0.25 * (t - 4.0) }; };
  const auto seam = [](double t) // of a tennis ball
  {
    return Point{ std::cos(t) + 0.4 * std::cos(3.0 * t), std::sin(t) - 0.4 * std::sin(3.0 * t),
      1.2 * std::sin(2.0 * t) };
  };
  for (const double width : { 0.02, 0.2 })
  {
    for (const Band& band : { Band(equator, 5.8, width, 40), Band(spiral, 8.0, width, 60),
           Band(seam, 5.8, width, 70), Band(equator, 3.0, 5.0 * width, 9) })
    {
      const Covered covered = Cover(PolygonOf(band.Outline));
      const Covered expected = Cover(MakeGrid(band.Quads));
      EXPECT_NEAR(covered.OfCells, expected.OfCells, 1e-12);
      for (std::size_t i = 0; i < covered.Coverage.size(); ++i)
      {
        ASSERT_NEAR(covered.Coverage[i], expected.Coverage[i], 1e-11) << i;
      }
    }
  }
}
