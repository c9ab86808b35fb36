// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeRays: hits known by formula or by trying every triangle, and bad input.

#include "Support/BruteForce.h"
#include "Support/EventCounter.h"
#include "Support/FilterRun.h"
#include "Support/MakeOf.h"
#include "Support/StructuredMeshes.h"
#include "Support/SurfaceMeshes.h"

#include "Search/Rays/SkdSurfaceNormals.h"

#include "vtkCellData.h"
#include "vtkSMPTools.h"
#include "vtkSkdTreeRays.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace skdtest;

namespace
{

using Filter = vtkSkdTreeRays;

constexpr auto MakeFilter = MakeOf<Filter>;

std::vector<double> ValuesOf(Filter* filter, const char* name)
{
  filter->Update();
  return PointArray(filter->GetOutputDataObject(0), name);
}

PolyDataPointer Hits(Filter* filter)
{
  return vtkPolyData::SafeDownCast(filter->GetOutputDataObject(1));
}

/// Queries with an array of random vectors.
PolyDataPointer RandomRays(vtkDataSet* source, int count)
{
  auto rays = MakeQueries(RandomQueries(source, count));
  Random random(11);
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetName("Vectors");
  vectors->SetNumberOfComponents(3);
  for (int i = 0; i < count; ++i)
  {
    const Point v = random.InBox({ -1, 1, -1, 1, -1, 1 });
    vectors->InsertNextTuple(v.data());
  }
  rays->GetPointData()->AddArray(vectors);
  return rays;
}

/// The distances of all triangles hit by a ray, ascending.
std::vector<double> TryAll(const Mesh& mesh, const Point& start, const Point& direction)
{
  const double far = 100.0;
  const double length = std::sqrt(Dot(direction, direction));
  const Point end = start + (far / length) * direction;
  std::vector<double> distances;
  for (const auto& cell : mesh.Cells)
  {
    const std::array<Point, 3> triangle{ mesh.Points[cell.Points[0]], mesh.Points[cell.Points[1]],
      mesh.Points[cell.Points[2]] };
    if (const auto t = HitTriangle(start, end, triangle))
    {
      distances.push_back(far * *t);
    }
  }
  std::sort(distances.begin(), distances.end());
  return distances;
}

// Processes have the cells of a mesh in another order than one alone.
TEST(Rays, NormalsDoNotDependOnTheOrderOfCells)
{
  Random random(4);
  Mesh torus = TorusTriangles(30, 20);
  for (Point& x : torus.Points)
  {
    x = x + random.InBox({ -0.02, 0.02, -0.02, 0.02, -0.02, 0.02 });
  }
  Mesh reversed = torus;
  std::reverse(reversed.Cells.begin(), reversed.Cells.end());
  const auto first = skdtree::SkdNormalsOfPoints(MakePolyData(torus));
  const auto second = skdtree::SkdNormalsOfPoints(MakePolyData(reversed));
  ASSERT_EQ(first.size(), torus.Points.size());
  EXPECT_EQ(first, second);
}

// A point that has nothing but slivers has a normal, too; normals of both sides of a sheet cancel.
TEST(Rays, NormalsOfSmallAngles)
{
  Mesh mesh;
  mesh.Points = { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 1, 1e-12, 0 } }, { { 1, 2e-12, 1e-12 } } };
  mesh.Add(VTK_TRIANGLE, { 0, 1, 2 });
  mesh.Add(VTK_TRIANGLE, { 0, 2, 3 });
  const skd::Vector3 normal = skdtree::SkdNormalsOfPoints(MakePolyData(mesh))[0];
  const double slope = std::sqrt(0.5); // of the second triangle, whose angle is larger by sqrt(2)
  const double length = std::hypot(1.0 + std::sqrt(2.0) * slope, std::sqrt(2.0) * slope);
  EXPECT_NEAR(normal[1], -std::sqrt(2.0) * slope / length, 1e-12);
  EXPECT_NEAR(normal[2], (1.0 + std::sqrt(2.0) * slope) / length, 1e-12);
  mesh.Cells.clear();
  mesh.Add(VTK_TRIANGLE, { 0, 1, 3 });
  mesh.Add(VTK_TRIANGLE, { 3, 1, 0 });
  EXPECT_EQ(skd::Norm(skdtree::SkdNormalsOfPoints(MakePolyData(mesh))[0]), 0.0);
}

TEST(Rays, HitsAreThoseOfEveryTriangleTried)
{
  const Mesh torus = TorusTriangles(14, 9);
  const auto source = MakePolyData(torus);
  const auto rays = RandomRays(source, 300);
  auto filter = MakeFilter(rays, source);
  filter->SetAlongToArray();
  filter->SetDirectionArray("Vectors");
  filter->SetHitsToAllHits();
  const std::vector<double> counts = ValuesOf(filter, "SkdRayHits");
  const std::vector<double> first = ValuesOf(filter, "SkdRayDistance");
  const std::vector<double> sides = ValuesOf(filter, "SkdRaySide");
  const std::vector<double> all = PointArray(Hits(filter), "SkdRayDistance");
  std::size_t next = 0;
  int found = 0;
  for (vtkIdType i = 0; i < rays->GetNumberOfPoints(); ++i)
  {
    Point start;
    Point direction;
    rays->GetPoint(i, start.data());
    rays->GetPointData()->GetArray("Vectors")->GetTuple(i, direction.data());
    const std::vector<double> expected = TryAll(torus, start, direction);
    ASSERT_EQ(counts[i], expected.size()) << i;
    EXPECT_EQ(std::isnan(first[i]), expected.empty());
    // Outside a closed surface that is oriented outwards fronts are hit first, inside backs.
    EXPECT_EQ(sides[i], expected.empty() ? 0 : expected.size() % 2 ? -1 : 1);
    for (double distance : expected)
    {
      EXPECT_NEAR(all.at(next++), distance, 1e-9);
      ++found;
    }
  }
  EXPECT_EQ(next, all.size());
  EXPECT_GT(found, 100);
  EXPECT_EQ(Reported(filter, "Hits"), found);

  filter->SetHitsToFirstHit();
  const std::vector<double> alone = ValuesOf(filter, "SkdRayDistance");
  for (std::size_t i = 0; i < first.size(); ++i)
  {
    EXPECT_TRUE(alone[i] == first[i] || std::isnan(first[i])) << i;
  }
  EXPECT_TRUE(ValuesOf(filter, "SkdRayHits").empty());
  filter->SetHitsToCounts();
  EXPECT_EQ(ValuesOf(filter, "SkdRayHits"), counts);
  EXPECT_EQ(Hits(filter)->GetNumberOfPoints(), 0);
}

TEST(Rays, NormalsOfASurfaceAcrossItself)
{
  for (const double offset : { 0.0, 1e6 })
  {
    const auto sphere = MakePolyData(Transformed(SphereTriangles(12), 1.0, { offset, -offset, 0 }));
    auto filter = MakeFilter(sphere, sphere);
    filter->ReversedOn();
    for (double distance : ValuesOf(filter, "SkdRayDistance"))
    {
      EXPECT_NEAR(distance, 2.0, 0.05) << "the start is not a hit";
    }
    filter->ReversedOff();
    for (double distance : ValuesOf(filter, "SkdRayDistance"))
    {
      EXPECT_TRUE(std::isnan(distance));
    }
    filter->BothWaysOn();
    for (double distance : ValuesOf(filter, "SkdRayDistance"))
    {
      EXPECT_NEAR(distance, -2.0, 0.05);
    }
    filter->IncludeStartOn();
    for (double distance : ValuesOf(filter, "SkdRayDistance"))
    {
      EXPECT_NEAR(distance, 0.0, 1e-8);
    }
  }
}

TEST(Rays, FromCellsAndToAPoint)
{
  const auto inner = MakePolyData(CubeQuads(3));
  const auto outer = MakePolyData(CubeQuads(5).Map(
    [](const Point& p) {
      return p - Point{ 1, 1, 1 };
    }));
  Point centre;
  inner->GetCenter(centre.data());
  auto filter = MakeFilter(inner, outer);
  filter->SetStartToCellCenters();
  filter->Update();
  auto* output = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  vtkDataArray* distances = output->GetCellData()->GetArray("SkdRayDistance");
  ASSERT_NE(distances, nullptr);
  EXPECT_EQ(Hits(filter)->GetNumberOfPoints(), inner->GetNumberOfCells());
  for (vtkIdType i = 0; i < distances->GetNumberOfTuples(); ++i)
  {
    EXPECT_NEAR(distances->GetTuple1(i), 1.0, 1e-12);
  }

  filter->SetAlongToPoint();
  filter->SetTargetPoint(centre.data());
  filter->SetInputDataObject(1, inner);
  filter->GenerateLinesOn();
  filter->SetHitsToAllHits();
  filter->Update();
  output = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  vtkDataArray* counts = output->GetCellData()->GetArray("SkdRayHits");
  EXPECT_EQ(counts->GetRange()[0], 1.0) << "the opposite face, once also on its edges";
  EXPECT_EQ(counts->GetRange()[1], 1.0);
  EXPECT_EQ(Hits(filter)->GetNumberOfLines(), inner->GetNumberOfCells());
  EXPECT_NE(Hits(filter)->GetCellData()->GetArray("SkdRayStartId"), nullptr);
}

TEST(Rays, ShellsOfAMillionthAreTwoHits)
{
  for (const double thickness : { 1e-2, 1e-6 })
  {
    const auto low = MakePolyData(Sheet(4, VTK_QUAD));
    const auto high = MakePolyData(Sheet(4, VTK_QUAD)
                                     .Map(
                                       [&](const Point& p) {
                                         return p + Point{ 0, 0, thickness };
                                       }));
    const auto blocks = MakeBlocks({ low, high });
    auto filter = MakeFilter(low, blocks);
    filter->SetAlongToDirection();
    filter->SetHitsToAllHits();
    for (double count : ValuesOf(filter, "SkdRayHits"))
    {
      EXPECT_EQ(count, 1);
    }
    for (double distance : ValuesOf(filter, "SkdRayDistance"))
    {
      EXPECT_NEAR(distance, thickness, 1e-15);
    }
    for (double block : ValuesOf(filter, "SkdRayBlockIndex"))
    {
      EXPECT_EQ(block, 2);
    }
    filter->IncludeStartOn();
    for (double count : ValuesOf(filter, "SkdRayHits"))
    {
      EXPECT_EQ(count, 2);
    }
    filter->SetMaximumLength(0.5 * thickness);
    for (double count : ValuesOf(filter, "SkdRayHits"))
    {
      EXPECT_EQ(count, 1);
    }
  }
}

TEST(Rays, DataAtTheHitAndThreads)
{
  const auto source = WithData(MakePolyData(TorusTriangles(20, 12)));
  auto filter = MakeFilter(RandomRays(source, 2000), source);
  filter->SetAlongToArray();
  filter->SetDirectionArray("Vectors");
  filter->InterpolateSourceDataOn();
  filter->SetHitsToAllHits();
  std::vector<double> reference;
  for (const int threads : { 1, 3 })
  {
    vtkSMPTools::LocalScope(vtkSMPTools::Config(threads),
      [&]
      {
        filter->Modified();
        filter->Update();
      });
    std::vector<double> answers = ValuesOf(filter, "SkdRayHitPoint");
    const std::vector<double> linear = ValuesOf(filter, "Linear");
    for (std::size_t i = 0; i < linear.size(); ++i)
    {
      const Point x{ answers[3 * i], answers[3 * i + 1], answers[3 * i + 2] };
      EXPECT_EQ(std::isnan(linear[i]), std::isnan(x[0]));
      EXPECT_FALSE(std::abs(linear[i] - Linear(x)) > 1e-9);
    }
    const std::vector<double> hits = PointArray(Hits(filter), "SkdRayDistance");
    answers = hits;
    EXPECT_TRUE(reference.empty() || reference == answers);
    reference = answers;
  }
}

TEST(Rays, BadInputIsOneMessageEach)
{
  const auto sphere = MakePolyData(SphereTriangles(4));
  const auto odd = MakeQueries({ { NAN, 0, 0 }, { 0, INFINITY, 0 }, { 0, 0, -3 } });
  const auto empty = PolyDataPointer::New();
  struct
  {
    vtkDataObject* Input;
    vtkDataObject* Source;
    int Along;
    double Direction;
    const char* Message;
    bool IsError;
  } cases[] = {
    { sphere, sphere, Filter::ARRAY, 1, "no active vectors in its point data", true },
    { sphere, sphere, Filter::DIRECTION, 0, "26 points have no ray", false },
    { odd, sphere, Filter::DIRECTION, 1, "2 points have no ray", false },
    { odd, sphere, Filter::NORMALS, 1, "3 points have no ray", false },
    { sphere, empty, Filter::NORMALS, 1, "Source has no cells to hit", false },
    { empty, sphere, Filter::NORMALS, 1, "", false },
  };
  for (const auto& one : cases)
  {
    auto filter = MakeFilter(one.Input, one.Source);
    filter->SetAlong(one.Along);
    filter->SetDirection(0, 0, one.Direction);
    EventCounter events(filter);
    filter->Update();
    EXPECT_EQ(events.Errors, one.IsError ? 1 : 0) << one.Message;
    const int countsPoints = one.Input == odd ? 1 : 0;
    EXPECT_EQ(events.Warnings, (one.IsError || !*one.Message ? 0 : 1) + countsPoints)
      << one.Message;
    const std::string& said = one.IsError ? events.Error : events.Warning;
    std::string wanted = one.Message;
    if (wanted.rfind("26 ", 0) == 0)
    {
      wanted = std::to_string(sphere->GetNumberOfPoints()) + wanted.substr(2);
    }
    EXPECT_NE(said.find(wanted), std::string::npos) << said;
  }
  auto filter = MakeFilter(odd, sphere);
  filter->SetAlongToDirection();
  vtkObject::GlobalWarningDisplayOff();
  const std::vector<double> distances = ValuesOf(filter, "SkdRayDistance");
  vtkObject::GlobalWarningDisplayOn();
  EXPECT_TRUE(std::isnan(distances[0]) && std::isnan(distances[1]));
  EXPECT_NEAR(distances[2], 2.0, 1e-9);
}

}

// Of spacings that are no binary numbers, hits on faces are beyond the cell by rounding.
TEST(Rays, DataOfVoxelsAndPixelsAreExactOnTheirFaces)
{
  for (const int across : { -1, 0, 1, 2 })
  {
    const auto image = across < 0 ? MakeImage(5) : MakeFlatImage(5, across);
    image->SetOrigin(0.1, 0.7, -0.3);
    image->SetSpacing(0.9, 0.3, 0.7);
    const auto source = WithData(image);
    auto filter = MakeFilter(RandomRays(source, 2000), source);
    filter->SetAlongToArray();
    filter->SetDirectionArray("Vectors");
    filter->InterpolateSourceDataOn();
    const std::vector<double> values = ValuesOf(filter, "Linear");
    const std::vector<double> hits = ValuesOf(filter, "SkdRayHitPoint");
    ASSERT_EQ(values.size(), 2000u);
    int found = 0;
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      if (std::isfinite(values[i]))
      {
        ++found;
        EXPECT_NEAR(values[i], Linear({ hits[3 * i], hits[3 * i + 1], hits[3 * i + 2] }), 1e-12);
      }
    }
    EXPECT_GT(found, 50);
  }
}
