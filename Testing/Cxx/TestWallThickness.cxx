// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeWallThickness: bodies of known thickness, and bad input.

#include "Search/Rays/SkdTiedNearest.h"
#include "Support/CurveRun.h"
#include "Support/EventCounter.h"
#include "Support/FilterRun.h"
#include "Support/IntegerBodies.h"
#include "Support/SurfaceMeshes.h"

#include "vtkCellData.h"
#include "vtkHigherOrderHexahedron.h"
#include "vtkSMPTools.h"
#include "vtkSkdTreeWallThickness.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace skdtest;
using namespace skdtree;

namespace
{

using Filter = vtkSkdTreeWallThickness;
using FilterPointer = vtkSmartPointer<Filter>;

FilterPointer MakeFilter(vtkDataObject* input, int method)
{
  auto filter = FilterPointer::New();
  filter->SetInputDataObject(0, input);
  filter->SetMethod(method);
  return filter;
}

std::vector<double> Thickness(Filter* filter)
{
  filter->Update();
  auto* output = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  auto* data = filter->GetStart() == Filter::POINTS
    ? static_cast<vtkDataSetAttributes*>(output->GetPointData())
    : output->GetCellData();
  std::vector<double> values;
  vtkDataArray* array = data->GetArray("SkdThickness");
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    values.push_back(array->GetTuple1(i));
  }
  return values;
}

void ExpectAll(Filter* filter, double thickness, double tolerance)
{
  const std::vector<double> values = Thickness(filter);
  ASSERT_FALSE(values.empty());
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  EXPECT_NEAR(*low, thickness, tolerance);
  EXPECT_NEAR(*high, thickness, tolerance);
  EXPECT_EQ(Reported(filter, "PointsFound"), values.size());
}

/// A cube about the origin, of half the size 1, whose sides face outwards.
Mesh Cube(int n)
{
  Mesh cube = CubeQuads(n);
  Bounds box;
  MakePolyData(cube)->GetBounds(box.data());
  cube.Map(
    [&](const Point& p)
    {
      Point moved;
      for (int axis = 0; axis < 3; ++axis)
      {
        moved[axis] = 2.0 * (p[axis] - box[2 * axis]) / (box[2 * axis + 1] - box[2 * axis]) - 1.0;
      }
      return moved;
    });
  for (auto& cell : cube.Cells)
  {
    const auto at = [&](int i) { return cube.Points[cell.Points[i]]; };
    if (Dot(Cross(at(1) - at(0), at(2) - at(0)), at(0)) < 0.0)
    {
      std::reverse(cell.Points.begin(), cell.Points.end());
    }
  }
  return cube;
}

/// The outside of a body, and the wall of a cavity in it that is similar about the origin.
Mesh Hollow(const Mesh& outer, double factor)
{
  Mesh hollow = outer;
  const auto n = static_cast<vtkIdType>(outer.Points.size());
  for (const Point& p : outer.Points)
  {
    hollow.Add(factor * p);
  }
  for (const auto& cell : outer.Cells)
  {
    Ids ids(cell.Points.rbegin(), cell.Points.rend());
    for (vtkIdType& id : ids)
    {
      id += n;
    }
    hollow.Add(cell.Type, ids);
  }
  return hollow;
}

TEST(WallThickness, OfASphereIsItsDiameter)
{
  for (const double offset : { 0.0, 1e6 })
  {
    const auto sphere = MakePolyData(Transformed(SphereTriangles(12), 1.0, { offset, 0, -offset }));
    for (const int method : { Filter::RAYS, Filter::SPHERES })
    {
      auto filter = MakeFilter(sphere, method);
      ExpectAll(filter, 2.0, 0.1);
      filter->SetStartToCellCenters();
      ExpectAll(filter, 2.0, 0.15); // the facets around leave spheres less room
    }
  }
}

TEST(WallThickness, OfATorusIsTheTubesDiameter)
{
  const Mesh torus = TorusTriangles(96, 48);
  double high = 0.0;
  for (const Point& p : torus.Points)
  {
    high = std::max(high, std::abs(p[2]));
  }
  for (const int method : { Filter::RAYS, Filter::SPHERES })
  {
    ExpectAll(MakeFilter(MakePolyData(torus), method), 2.0 * high, 0.04 * high);
  }
}

// Rays at an angle a to the axis travel 2 cos a, and cos a is spread evenly over the solid angle.
TEST(WallThickness, ConesGiveTheirMedian)
{
  auto filter = MakeFilter(MakePolyData(SphereTriangles(24)), Filter::RAYS);
  filter->SetNumberOfRays(9);
  filter->SetConeAngle(60.0);
  ExpectAll(filter, 2.0 * 0.75, 0.03);
  filter->SetConeAngle(0.0);
  ExpectAll(filter, 2.0, 0.03);
}

TEST(WallThickness, OfShellsDownToAMillionth)
{
  for (const double thickness : { 0.1, 1e-3, 1e-6 })
  {
    for (const double offset : { 0.0, 100.0 })
    {
      const auto shell = MakePolyData(
        Transformed(Hollow(Cube(4), 1.0 - thickness), 1.0, { offset, offset, offset }));
      for (const int method : { Filter::RAYS, Filter::SPHERES })
      {
        auto filter = MakeFilter(shell, method);
        filter->SetStartToCellCenters();
        ExpectAll(filter, thickness, 1e-14 + 1e-15 * offset);
      }
    }
  }
}

TEST(WallThickness, SpheresTouchTheNearerOfTwoSides)
{
  // A box of 4 x 4 x 1: at the large faces it is 1 thick unless a side is nearer, and at the small
  // ones a sphere has a diameter of 1 at most, but a ray goes 4.
  Mesh mesh = Cube(8);
  mesh.Map(
    [](const Point& p) {
      return Point{ 2.0 * (p[0] + 1.0), 2.0 * (p[1] + 1.0), 0.5 * (p[2] + 1.0) };
    });
  auto filter = MakeFilter(MakePolyData(mesh), Filter::SPHERES);
  filter->SetStartToCellCenters();
  const std::vector<double> spheres = Thickness(filter);
  filter->SetMethod(Filter::RAYS);
  const std::vector<double> rays = Thickness(filter);
  auto* output = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  for (std::size_t i = 0; i < rays.size(); ++i)
  {
    double b[6];
    output->GetCellBounds(static_cast<vtkIdType>(i), b);
    const double c[3] = { (b[0] + b[1]) / 2, (b[2] + b[3]) / 2, (b[4] + b[5]) / 2 };
    const bool isLarge = b[5] - b[4] < 1e-9;
    EXPECT_NEAR(rays[i], isLarge ? 1.0 : 4.0, 1e-12);
    // The nearest of the sides that the point is not on bounds the sphere's radius.
    double room = isLarge ? 0.5 : 2.0;
    const double sizes[3] = { 4, 4, 1 };
    for (int axis = 0; axis < 3; ++axis)
    {
      if (b[2 * axis + 1] - b[2 * axis] > 1e-9)
      {
        room = std::min({ room, c[axis], sizes[axis] - c[axis] });
      }
    }
    EXPECT_NEAR(spheres[i], 2.0 * room, 1e-6);
  }
}

TEST(WallThickness, AgainstASourceAndBlocks)
{
  const auto inner = MakePolyData(SphereTriangles(16));
  const auto outer = MakePolyData(SphereTriangles(16).Map([](const Point& p) { return 3.0 * p; }));
  auto filter = MakeFilter(outer, Filter::RAYS);
  filter->SetSourceData(inner);
  ExpectAll(filter, 2.0, 2e-3);
  filter->SetSourceData(nullptr);
  const auto other = MakePolyData(Transformed(SphereTriangles(16), 1.0, { 10, 0, 0 }));
  filter->SetInputDataObject(0, MakeBlocks({ inner, other }));
  filter->Update();
  EXPECT_EQ(Reported(filter, "PointsFound"), inner->GetNumberOfPoints() * 2);
  EXPECT_EQ(Reported(filter, "TreesBuilt"), 1) << "that of the former Source is kept";
}

TEST(WallThickness, ThreadsAndTheLimit)
{
  const auto torus = MakePolyData(TorusTriangles(60, 30));
  for (const int method : { Filter::RAYS, Filter::SPHERES })
  {
    auto filter = MakeFilter(torus, method);
    filter->SetNumberOfRays(7);
    std::vector<double> answers[2];
    for (const int threads : { 1, 3 })
    {
      vtkSMPTools::LocalScope(vtkSMPTools::Config(threads),
        [&]
        {
          filter->Modified();
          answers[threads / 3] = Thickness(filter);
        });
    }
    EXPECT_EQ(answers[0], answers[1]);
    filter->SetMaximumThickness(1e-3);
    EventCounter events(filter);
    for (double thickness : Thickness(filter))
    {
      EXPECT_TRUE(std::isnan(thickness));
    }
    EXPECT_EQ(events.Warnings, 1);
  }
}

// All of a sphere is equally far from its middle: the search for what is nearest is shared there,
// so that it does not look at all cells for each point.
TEST(WallThickness, SpheresInABallShareWhatIsNearest)
{
  const auto ball = MakePolyData(SphereTriangles(40)); // 10240 triangles or more
  SkdSourceTrees trees;
  trees.Update({ { ball, 0 } }, 1e-9);
  const SkdTiedNearest tied(trees, 1);
  Random random(12);
  for (int i = 0; i < 300; ++i)
  {
    const Point p = random.InBox({ -5e-4, 5e-4, -5e-4, 5e-4, -5e-4, 5e-4 });
    const skd::Vector3 centre{ { p[0], p[1], p[2] } };
    ASSERT_TRUE(tied.AreMany(centre, 1.1));
    const auto shared = tied.Find(centre, 1.1);
    const auto exact = tied.FindExact(centre, 1.1);
    ASSERT_TRUE(shared && exact);
    EXPECT_GE(shared->Distance2, exact->Distance2);
    EXPECT_LE(std::sqrt(shared->Distance2), std::sqrt(exact->Distance2) + 2.0 * 0.866 / 1024);
  }
  EXPECT_LE(tied.GetNumberShared(), 27u);
  EXPECT_FALSE(tied.AreMany({ { 0.5, 0.0, 0.0 } }, 1.0));
  auto filter = MakeFilter(ball, Filter::SPHERES);
  ExpectAll(filter, 2.0, 0.01);
  const std::vector<double> values = Thickness(filter);
  vtkSMPTools::LocalScope(vtkSMPTools::Config(3),
    [&]
    {
      filter->Modified();
      filter->Update();
    });
  EXPECT_EQ(Thickness(filter), values);
}

// Several processes have the points and cells of a mesh in another order than one alone.
TEST(WallThickness, OfTiedSpheresDoesNotDependOnIds)
{
  const Mesh ball = SphereTriangles(40);
  Mesh reversed = ball;
  std::reverse(reversed.Points.begin(), reversed.Points.end());
  std::reverse(reversed.Cells.begin(), reversed.Cells.end());
  const auto last = static_cast<vtkIdType>(ball.Points.size()) - 1;
  for (CellSpec& cell : reversed.Cells)
  {
    for (vtkIdType& id : cell.Points)
    {
      id = last - id;
    }
  }
  const auto first = Thickness(MakeFilter(MakePolyData(ball), Filter::SPHERES));
  auto second = Thickness(MakeFilter(MakePolyData(reversed), Filter::SPHERES));
  std::reverse(second.begin(), second.end());
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t i = 0; i < first.size(); ++i)
  {
    ASSERT_NEAR(first[i], second[i], 1e-12) << i;
  }
}

// Bezier cells have control points, which are not on the surface: places on it stand for them.
TEST(WallThickness, OfRationalSurfacesIsThatOfTheTrueOnes)
{
  for (const int start : { Filter::POINTS, Filter::CELL_CENTERS })
  {
    for (const int method : { Filter::RAYS, Filter::SPHERES })
    {
      auto sphere = MakeFilter(BezierSphere(1.0), method);
      sphere->SetStart(start);
      ExpectAll(sphere, 2.0, 1e-6);
    }
    auto torus = MakeFilter(BezierTorus(3.0, 1.0), Filter::RAYS);
    torus->SetStart(start);
    ExpectAll(torus, 2.0, 1e-6);
  }
}

/// A ring about z, of quarters that are rational Bezier hexahedra of degree 2: from radius 1 to 2.
GridPointer BezierRing()
{
  Mesh mesh;
  std::vector<double> weights;
  const int order[3] = { 2, 2, 2 };
  for (int quarter = 0; quarter < 4; ++quarter)
  {
    Ids ids(27);
    for (int n = 0; n < 27; ++n)
    {
      const int i = n % 3, j = n / 3 % 3, k = n / 9;
      const auto [c, s, w] = QuarterCircle(j, quarter);
      const double r = 1.0 + 0.5 * i;
      const int position = vtkHigherOrderHexahedron::PointIndexFromIJK(i, j, k, order);
      ids[static_cast<std::size_t>(position)] = mesh.Add({ r * c, r * s, 0.5 * k });
      weights.push_back(w);
    }
    mesh.Add(VTK_BEZIER_HEXAHEDRON, ids);
  }
  GridPointer grid = MakeGrid(mesh);
  SetRationalWeights(grid, weights);
  return grid;
}

TEST(WallThickness, OfRationalBodiesIsThatOfTheTrueOnes)
{
  const auto ring = BezierRing();
  auto filter = MakeFilter(ring, Filter::RAYS);
  const std::vector<double> values = Thickness(filter);
  const double chord = 1e-4 * std::sqrt(16.0 + 16.0 + 1.0);
  int checked = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const double* p = ring->GetPoint(static_cast<vtkIdType>(i));
    const double z = p[2];
    const std::size_t radius = i % 3;       // 1, 1.5 and 2
    const bool isInMiddle = i / 3 % 3 == 1; // of a quarter: quarters do not share their ends
    if (isInMiddle && z == 0.5 && radius != 1)
    {
      EXPECT_NEAR(values[i], 1.0, 2.0 * chord) << i;
      ++checked;
    }
    if (isInMiddle && z != 0.5 && radius == 1)
    {
      EXPECT_NEAR(values[i], 1.0, 1e-12) << i;
      ++checked;
    }
  }
  EXPECT_EQ(checked, 4 * (2 + 2));
}

// Quadratic cells go through their points: normals are those of the surface, not of its corners.
TEST(WallThickness, OfQuadraticSurfacesNormalsAreTheSurfaces)
{
  Mesh sphere = Outward(SphereTriangles(6));
  Mesh quadratic;
  for (const CellSpec& cell : sphere.Cells)
  {
    Ids ids;
    for (int i = 0; i < 6; ++i)
    {
      const Point& a = sphere.Points[cell.Points[static_cast<std::size_t>(i % 3)]];
      const Point& b = sphere.Points[cell.Points[static_cast<std::size_t>((i + 1) % 3)]];
      const Point p = i < 3 ? a : a + b;
      ids.push_back(quadratic.Add((1.0 / Length(p)) * p));
    }
    quadratic.Add(VTK_QUADRATIC_TRIANGLE, ids);
  }
  for (const int start : { Filter::POINTS, Filter::CELL_CENTERS })
  {
    auto filter = MakeFilter(MakeGrid(quadratic), Filter::RAYS);
    filter->SetStart(start);
    ExpectAll(filter, 2.0, 2e-3);
  }
}

using Boxes = std::vector<std::pair<Point, Point>>; // low and high corners

/// How far a ray along an axis goes within some of the boxes, from a place on the side of one.
double ThicknessOfUnion(const Boxes& boxes, const Point& x, int axis, double direction)
{
  double end = 0.0; // the ray is within something until there
  for (std::size_t pass = 0; pass <= boxes.size(); ++pass)
  {
    for (const auto& [low, high] : boxes)
    {
      const int b = (axis + 1) % 3, c = (axis + 2) % 3;
      const bool isMet = x[b] > low[b] && x[b] < high[b] && x[c] > low[c] && x[c] < high[c];
      const double from = direction * ((direction > 0.0 ? low : high)[axis] - x[axis]);
      const double to = direction * ((direction > 0.0 ? high : low)[axis] - x[axis]);
      end = isMet && from <= end + 1e-9 ? std::max(end, to) : end;
    }
  }
  return end;
}

// Boxes that overlap, in one mesh or in blocks; with a hole in a body apart, too.
TEST(WallThickness, WhereShellsOverlapTheRayEndsWhereItLeavesTheLast)
{
  for (int run = 0; run < 60; ++run)
  {
    Random random(9100 + static_cast<std::uint64_t>(run));
    Boxes boxes;
    std::vector<Mesh> meshes;
    const int number = 2 + random.Index(5);
    for (int i = 0; i < number; ++i)
    {
      const Point low = random.InBox({ -1, 1, -1, 1, -1, 1 });
      const Point size = random.InBox({ 0.2, 1.5, 0.2, 1.5, 0.2, 1.5 });
      boxes.emplace_back(low, low + size);
      meshes.push_back(BoxTriangles(low, low + size));
    }
    Mesh apart = BoxTriangles({ 20, 20, 20 }, { 21, 21, 21 });
    apart.Cells.pop_back();
    std::vector<PolyDataPointer> inputs{ MakePolyData(Together(meshes)) };
    inputs.push_back(MakePolyData(Together({ Together(meshes), apart })));
    for (const PolyDataPointer& input : inputs)
    {
      auto filter = MakeFilter(input, Filter::RAYS);
      filter->SetStartToCellCenters();
      const std::vector<double> values = Thickness(filter);
      for (std::size_t i = 0; i < 12 * boxes.size(); ++i)
      {
        const Mesh& mesh = meshes[i / 12];
        const Ids& ids = mesh.Cells[i % 12].Points;
        const Point& a = mesh.Points[ids[0]];
        const Point normal = Cross(mesh.Points[ids[1]] - a, mesh.Points[ids[2]] - a);
        const Point middle = (1.0 / 3.0) * (a + mesh.Points[ids[1]] + mesh.Points[ids[2]]);
        const int axis =
          static_cast<int>(std::max_element(normal.begin(), normal.end(),
                             [](double p, double q) { return std::abs(p) < std::abs(q); }) -
            normal.begin());
        const double direction = normal[axis] > 0.0 ? -1.0 : 1.0;
        ASSERT_NEAR(values[i], ThicknessOfUnion(boxes, middle, axis, direction), 1e-12)
          << run << " " << i;
      }
    }
  }
}

TEST(WallThickness, WhatHasNoneIsAWarning)
{
  const auto sheet = MakePolyData(Sheet(4, VTK_QUAD));
  const auto points = MakeQueries({ { 0, 0, 0 }, { NAN, 0, 0 } });
  const auto sphere = MakePolyData(SphereTriangles(8));
  for (const int method : { Filter::RAYS, Filter::SPHERES })
  {
    for (const auto& mesh : { sheet, points })
    {
      auto filter = MakeFilter(mesh, method);
      EventCounter events(filter);
      for (double thickness : Thickness(filter))
      {
        EXPECT_TRUE(std::isnan(thickness));
      }
      EXPECT_EQ(events.Warnings, mesh == points ? 2 : 1); // one counts points that are not finite
      EXPECT_EQ(events.Errors, 0);
      const std::string count = std::to_string(mesh->GetNumberOfPoints());
      const std::string wanted = count + " of " + count + " points have no thickness";
      EXPECT_NE(events.Warning.find(wanted), std::string::npos) << events.Warning;
    }
    auto filter = MakeFilter(sphere, method);
    EventCounter events(filter);
    filter->ReversedOn();
    filter->Update();
    EXPECT_EQ(events.Warnings, 1);
    EXPECT_EQ(Reported(filter, "PointsFound"), 0);
    filter->SetInputDataObject(0, PolyDataPointer::New());
    filter->Update();
    EXPECT_EQ(events.Warnings, 1);
    EXPECT_EQ(events.Errors, 0);
  }
}

}
