// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreePointInOut: which part holds a point, by every method.

#include "Bodies/SkdWinding.h"
#include "Support/EventCounter.h"
#include "Support/InOutRun.h"

#include "vtkSMPTools.h"

#include <gtest/gtest.h>

using namespace skdtest;
using namespace skdtree;

namespace
{

TEST(PointInOut, AnOctahedronIsDecidedExactlyByEveryMethod)
{
  const std::vector<Point> points = PointsAround(1.3, 4000);
  auto source = MakePolyData(Outward(Octahedron(1)));
  for (int method : AllMethods)
  {
    InOutPointer filter = MakeInOut(MakeQueries(points), source, method);
    EventCounter events(filter);
    const std::vector<double> inside = RunFor(filter, "SkdInside");
    const std::vector<double> parts = RunFor(filter, "SkdPartId");
    const std::vector<double> depths = RunFor(filter, "SkdDepth");
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      const double sum = std::abs(points[i][0]) + std::abs(points[i][1]) + std::abs(points[i][2]);
      if (std::abs(sum - 1.0) > 1e-9)
      {
        ASSERT_EQ(inside[i], sum < 1.0 ? 1 : 0) << method << " " << i;
        ASSERT_EQ(parts[i], sum < 1.0 ? 0 : -1);
        ASSERT_EQ(depths[i], inside[i]);
      }
    }
    EXPECT_EQ(events.Warnings, 0) << events.Warning;
    EXPECT_EQ(Reported(filter, "OpenEdges"), 0);
  }
}

TEST(PointInOut, AThinShellHasAnInsideAndACavity)
{
  const Mesh outer = Outward(Sphere(24, 1.0));
  Mesh inner = Outward(Sphere(24, 0.9999));
  for (CellSpec& cell : inner.Cells)
  {
    std::swap(cell.Points[1], cell.Points[2]); // normals out of the material
  }
  auto shell = MakePolyData(Together({ outer, inner }));
  // Points between a face and its inner copy, and below: on the rays through each face's middle.
  std::vector<Point> within, cavity;
  for (const CellSpec& cell : outer.Cells)
  {
    const Point middle = (1.0 / 3.0) *
      (outer.Points[cell.Points[0]] + outer.Points[cell.Points[1]] + outer.Points[cell.Points[2]]);
    within.push_back(0.99995 * middle);
    cavity.push_back(0.9995 * middle);
  }
  for (const Point& p : PointsAround(0.5, 2000))
  {
    cavity.push_back(p);
  }
  for (int method : AllMethods)
  {
    InOutPointer a = MakeInOut(MakeQueries(within), shell, method);
    InOutPointer b = MakeInOut(MakeQueries(cavity), shell, method);
    a->Update();
    b->Update();
    EXPECT_EQ(Reported(a, "PointsInside"), static_cast<double>(within.size())) << method;
    EXPECT_EQ(Reported(b, "PointsInside"), 0) << method;
  }
}

TEST(PointInOut, NestedSpheresGiveDepthsAndTheInnermostPart)
{
  const std::vector<double> radii = { 3.0, 1.0, 2.0 };
  std::vector<PolyDataPointer> spheres;
  std::vector<Mesh> meshes;
  for (double radius : radii)
  {
    meshes.push_back(Sphere(16, radius));
    spheres.push_back(MakePolyData(meshes.back()));
  }
  auto blocks = MakeBlocks({ spheres[0], spheres[1], spheres[2] });
  auto one = MakePolyData(Together(meshes));
  const auto perSphere = static_cast<vtkIdType>(meshes[0].Cells.size());
  one->GetCellData()->AddArray(MakeArray(
    "Part", one->GetNumberOfCells(), [=](vtkIdType cell) { return 100.0 + cell / perSphere; }));

  std::vector<Point> points;
  std::vector<int> depths;
  Random random(42);
  for (int i = 0; i < 3000; ++i)
  {
    const double radius = (i % 4) + 0.05 + 0.8 * random.InBox({ 0, 1, 0, 1, 0, 1 })[0];
    points.push_back(radius * random.Direction());
    depths.push_back(3 - i % 4);
  }
  const int innermost[4] = { -1, 0, 2, 1 }; // sphere by depth
  const auto check = [&](InOut* filter, const std::function<int(int)>& idOf)
  {
    const std::vector<double> found = RunFor(filter, "SkdDepth");
    const std::vector<double> parts = RunFor(filter, "SkdPartId");
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      ASSERT_EQ(found[i], depths[i]) << i;
      ASSERT_EQ(parts[i], depths[i] == 0 ? -1 : idOf(innermost[depths[i]])) << i;
    }
    EXPECT_EQ(Reported(filter, "Parts"), 3);
  };
  auto input = MakeQueries(points);
  InOutPointer byBlock = MakeInOut(input, blocks);
  check(byBlock, [](int sphere) { return sphere + 1; });
  InOutPointer byPiece = MakeInOut(input, one);
  byPiece->SetParts(InOut::CONNECTED_PIECES);
  check(byPiece, [](int sphere) { return sphere; });
  InOutPointer byArray = MakeInOut(input, one);
  byArray->SetParts(InOut::CELL_ARRAY);
  byArray->SetPartArray("Part");
  check(byArray, [](int sphere) { return 100 + sphere; });
}

TEST(PointInOut, FacesOfPartsThatTouchDoNotCancel)
{
  auto left = MakePolyData(CubeTriangles(3));
  Bounds box;
  left->GetBounds(box.data());
  const Point across = { box[1] - box[0], 0, 0 };
  auto right = MakePolyData(CubeTriangles(3).Map([&](const Point& p) { return p + across; }));
  std::vector<Point> points;
  for (const Point& p : PointsAround(0.4999 * across[0], 2000))
  {
    points.push_back(p + Center(box));
    points.push_back(p + Center(box) + across);
  }
  for (int method : { InOut::AXIS_RAYS, InOut::RANDOM_RAYS })
  {
    InOutPointer filter = MakeInOut(MakeQueries(points), MakeBlocks({ left, right }), method);
    const std::vector<double> parts = RunFor(filter, "SkdPartId");
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
      ASSERT_EQ(parts[i], 1 + i % 2) << i;
    }
  }
}

TEST(PointInOut, RaysThroughEdgesAndCornersOnPurpose)
{
  // All points of a lattice that the cube's own vertices belong to: axis rays would run in faces.
  auto cube = MakePolyData(CubeQuads(4));
  Bounds box;
  cube->GetBounds(box.data());
  std::vector<Point> points;
  std::vector<bool> isInside;
  for (int i = 0; i < 11 * 11 * 11; ++i)
  {
    const int index[3] = { i % 11 - 1, i / 11 % 11 - 1, i / 121 - 1 };
    Point p;
    bool within = true, onFace = false;
    for (int axis = 0; axis < 3; ++axis)
    {
      p[axis] = box[0] + (box[1] - box[0]) * index[axis] / 8.0;
      within = within && index[axis] >= 0 && index[axis] <= 8;
      onFace = onFace || index[axis] == 0 || index[axis] == 8;
    }
    if (!(within && onFace))
    {
      points.push_back(p);
      isInside.push_back(within);
    }
  }
  for (int method : AllMethods)
  {
    InOutPointer filter = MakeInOut(MakeQueries(points), cube, method);
    const std::vector<double> found = RunFor(filter, "SkdInside");
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      ASSERT_EQ(found[i] == 1, isInside[i]) << method << " " << i;
    }
  }
}

TEST(PointInOut, ARemovedCapIsReportedAndWrongOnlyWithLowConfidence)
{
  const Mesh sphere = Outward(Sphere(20, 1.0));
  const Mesh open = Part(
    sphere, [&](std::size_t cell) { return sphere.Points[sphere.Cells[cell].Points[0]][2] < 0.9; });
  const std::vector<Point> points = PointsAround(1.1, 6000);
  for (int method : AllMethods)
  {
    InOutPointer filter = MakeInOut(MakeQueries(points), MakePolyData(open), method);
    EventCounter events(filter);
    const std::vector<double> inside = RunFor(filter, "SkdInside");
    const std::vector<double> confidence = RunFor(filter, "SkdConfidence");
    EXPECT_EQ(events.Warnings, 1);
    EXPECT_NE(events.Warning.find("open edges"), std::string::npos);
    EXPECT_GT(Reported(filter, "OpenEdges"), 10);
    int wrong = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      const double radius = Length(points[i]);
      const bool isClear = points[i][2] < 0.75 && (radius < 0.97 || radius > 1.01);
      const bool isRight = (inside[i] == 1) == (radius < 0.99);
      if (isClear)
      {
        wrong += !isRight;
        ASSERT_TRUE(isRight || confidence[i] < 0.9) << method << " " << i;
      }
    }
    EXPECT_LE(wrong, 30) << method;
  }
}

TEST(PointInOut, OutsideOfTheBoundsOfAnOpenPartTheConfidenceIsThatOfTheNumber)
{
  // Half a sphere; points just below its opening and farther off.
  const Mesh half = Part(Outward(Sphere(20, 1.0)),
    [sphere = Outward(Sphere(20, 1.0))](std::size_t cell)
    {
      const Ids& ids = sphere.Cells[cell].Points;
      return sphere.Points[ids[0]][2] + sphere.Points[ids[1]][2] + sphere.Points[ids[2]][2] > 0.0;
    });
  const SkdWinding winding(MakePolyData(half));
  std::vector<Point> points;
  for (int i = 0; i < 200; ++i)
  {
    points.push_back({ 0.003 * (i - 100), 0.1, -0.002 - 0.01 * i });
  }
  for (int method : { InOut::WINDING_NUMBER, InOut::AUTOMATIC })
  {
    InOutPointer filter = MakeInOut(MakeQueries(points), MakePolyData(half), method);
    const std::vector<double> inside = RunFor(filter, "SkdInside");
    const std::vector<double> confidence = RunFor(filter, "SkdConfidence");
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      const double number = std::abs(winding.Ask(points[i].data(), 0.25).Number);
      EXPECT_EQ(inside[i], 0);
      EXPECT_NEAR(confidence[i], number < 0.5 ? 1.0 - number : 0.5, 1e-6) << method << " " << i;
    }
    EXPECT_LT(confidence.front(), 0.6);
    EXPECT_GT(confidence.back(), 0.9);
  }
}

TEST(PointInOut, TheWindingNumbersBoundIsWithinTheTolerance)
{
  const Mesh sphere = Outward(Sphere(20, 1.0));
  auto open = MakePolyData(Part(sphere, [](std::size_t cell) { return cell % 9 != 0; }));
  const std::vector<Point> points = PointsAround(1.3, 500);
  InOutPointer filter = MakeInOut(MakeQueries(points), open, InOut::WINDING_NUMBER);
  EXPECT_EQ(filter->GetWindingTolerance(), 0.25);
  filter->SetWindingTolerance(0.0);
  const std::vector<double> exact = RunFor(filter, "SkdWindingNumber");
  EXPECT_EQ(RunFor(filter, "SkdWindingBound"), std::vector<double>(points.size(), 0.0));
  for (const double tolerance : { 0.25, 0.01 })
  {
    filter->SetWindingTolerance(tolerance);
    const std::vector<double> numbers = RunFor(filter, "SkdWindingNumber");
    const std::vector<double> bounds = RunFor(filter, "SkdWindingBound");
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      ASSERT_LE(bounds[i], tolerance);
      ASSERT_LE(std::abs(numbers[i] - exact[i]), bounds[i] + 1e-12);
    }
  }
  EventCounter events(filter);
  filter->SetWindingTolerance(double(NAN));
  EXPECT_EQ(filter->GetWindingTolerance(), 0.01);
  EXPECT_EQ(events.Errors, 1);
}

TEST(PointInOut, OrientationDoesNotMatterToRays)
{
  Mesh mesh = Sphere(10, 1.0);
  for (std::size_t cell = 0; cell < mesh.Cells.size(); cell += 3)
  {
    std::swap(mesh.Cells[cell].Points[0], mesh.Cells[cell].Points[1]);
  }
  const std::vector<Point> points = PointsAround(1.2, 2000);
  for (int method : { InOut::AXIS_RAYS, InOut::RANDOM_RAYS })
  {
    const std::vector<double> a =
      RunFor(MakeInOut(MakeQueries(points), MakePolyData(mesh), method), "SkdInside");
    const std::vector<double> b =
      RunFor(MakeInOut(MakeQueries(points), MakePolyData(Sphere(10, 1.0)), method), "SkdInside");
    EXPECT_EQ(a, b);
  }
}

TEST(PointInOut, TheSeedChangesDirectionsOnly)
{
  const Mesh sphere = Sphere(12, 1.0);
  const Mesh open = Part(sphere, [](std::size_t cell) { return cell % 9 != 0; });
  auto input = MakeQueries(PointsAround(1.0, 3000));
  std::vector<std::vector<double>> answers;
  for (int seed : { 0, 0, 1 })
  {
    InOutPointer filter = MakeInOut(input, MakePolyData(open), InOut::RANDOM_RAYS);
    filter->SetSeed(seed);
    answers.push_back(RunFor(filter, "SkdConfidence"));
  }
  EXPECT_EQ(answers[0], answers[1]);
  EXPECT_NE(answers[0], answers[2]);
}

TEST(PointInOut, BitsAreTheSameForAnyNumberOfThreads)
{
  const Mesh sphere = Outward(Sphere(12, 1.0));
  auto open = MakePolyData(Part(sphere, [](std::size_t cell) { return cell % 9 != 0; }));
  auto input = MakeQueries(PointsAround(1.1, 9000));
  for (int method : AllMethods)
  {
    std::vector<std::vector<double>> answers;
    for (int threads : { 1, 2, 4 })
    {
      vtkSMPTools::Initialize(threads);
      InOutPointer filter = MakeInOut(input, open, method);
      answers.push_back(RunFor(filter, "SkdInside"));
      const std::vector<double> confidence = RunFor(filter, "SkdConfidence");
      answers.back().insert(answers.back().end(), confidence.begin(), confidence.end());
    }
    vtkSMPTools::Initialize();
    EXPECT_EQ(answers[0], answers[1]) << method;
    EXPECT_EQ(answers[0], answers[2]) << method;
  }
}

}
