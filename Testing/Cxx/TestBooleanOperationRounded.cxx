// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeBooleanOperation: the output is closed as it is stored, when VTK triangulates it, and
// when equal points are merged; and no edge has the same coordinates at both ends.
//
// SKDTREE_FUZZ_PAIRS in the environment sets how many runs are tried, SKDTREE_FUZZ_FIRST which is
// the first; a failure names its run.

#include "Support/ClosedSurface.h"
#include "Support/SolidRun.h"
#include "Support/SurfaceMeshes.h"

#include <cmath>

using namespace skdtest;

namespace
{
using Filter = vtkSkdTreeBooleanOperation;
using Surface = vtkSmartPointer<vtkPolyData>;

/// By all ways of output. Returns the volume.
double ExpectClosedOutput(Filter* filter)
{
  double volumes[2];
  for (const int merges : { 0, 1 })
  {
    SCOPED_TRACE(merges ? "pieces merged" : "pieces");
    filter->SetMergePieces(merges);
    EventCounter events(filter);
    filter->Update();
    EXPECT_EQ(events.Errors + events.Warnings, 0) << events.Error << events.Warning;
    auto* output = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
    EXPECT_EQ(output->GetFieldData()->GetArray("SkdReportBadEdges")->GetTuple1(0), 0.0);
    ExpectClosed(output);
    const Measures measures(MeshOf(Triangulated(output)));
    volumes[merges] = measures.Volume;
  }
  EXPECT_NEAR(volumes[0], volumes[1], 1e-13 * std::max(1.0, volumes[0]));
  return volumes[0];
}

/// Cubes about one centre, each turned by an angle more.
Mesh TurnedCubes(int count, double degrees, const Point& axis)
{
  Mesh cubes;
  for (int i = 0; i < count; ++i)
  {
    const double angle = degrees * 0.017453292519943295 * i;
    const Point u = (1.0 / Length(axis)) * axis;
    Append(cubes,
      Transformed(CubeQuads(1), 1.0, { -0.5, -0.5, -0.5 })
        .Map(
          [&](const Point& p)
          {
            return std::cos(angle) * p + std::sin(angle) * Cross(u, p) +
              ((1.0 - std::cos(angle)) * Dot(u, p)) * u;
          }));
  }
  return cubes;
}

TEST(BooleanOperationRounded, CubesTurnedAboutAnAxis)
{
  const auto expectClosed = [](int count, double degrees, const Point& axis)
  {
    SCOPED_TRACE(count);
    vtkNew<Filter> filter;
    filter->SetInputData(MakePolyData(TurnedCubes(count, degrees, axis)));
    EXPECT_GT(ExpectClosedOutput(filter), 1.0);
  };
  expectClosed(3, 5.6, { 0, 0, 1 });
  expectClosed(3, 5.6, { 1, 1, 1 });
  expectClosed(8, 11.25, { 1, 2, 3 });
  expectClosed(9, 5.6, { 0, 0, 1 });
}

/// The faces of these are where the corners of others are.
TEST(BooleanOperationRounded, ManyCubesAtRandom)
{
  const int first = SetInEnvironment("SKDTREE_FUZZ_FIRST", 0);
  const int count = SetInEnvironment("SKDTREE_FUZZ_PAIRS", 8);
  for (int number = first; number < first + count; ++number)
  {
    SCOPED_TRACE(number);
    Random random(static_cast<std::uint64_t>(number));
    Mesh cubes;
    for (int i = 3 + random.Index(5); i > 0; --i)
    {
      const double tilt = std::pow(10.0, -random.Index(17));
      const Point axis = random.Direction();
      const double shift = 0.25 * random.Index(3);
      Append(cubes,
        Transformed(CubeQuads(1), 1.0, { shift, 0.0, 0.0 })
          .Map([&](const Point& p) { return p + tilt * Cross(axis, p); }));
    }
    vtkNew<Filter> filter;
    filter->SetInputData(MakePolyData(cubes));
    ExpectClosedOutput(filter);
    filter->SetOperation(Filter::AT_LEAST);
    ExpectClosedOutput(filter);
  }
}

/// What an operation makes goes into the next, together with something new.
TEST(BooleanOperationRounded, TreesOfOperations)
{
  const int first = SetInEnvironment("SKDTREE_FUZZ_FIRST", 0);
  const int count = SetInEnvironment("SKDTREE_FUZZ_PAIRS", 8);
  for (int number = first; number < first + count; ++number)
  {
    SCOPED_TRACE(number);
    Random random(static_cast<std::uint64_t>(number));
    std::string what;
    Surface made = MakePolyData(MovedAnywhere(random, AnySolid(random, what), what));
    for (int step = 0; step < 4 && made->GetNumberOfCells() > 0; ++step)
    {
      SCOPED_TRACE(what);
      vtkNew<Filter> filter;
      filter->SetInputData(made);
      filter->SetSourceData(MakePolyData(MovedAnywhere(random, AnySolid(random, what), what)));
      filter->SetOperation(std::array<int, 4>{ 0, 2, 3, 4 }[random.Index(4)]);
      ExpectClosedOutput(filter);
      made = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
    }
  }
}

/// Polygons that VTK cannot triangulate without losing an edge are given as triangles.
TEST(BooleanOperationRounded, PolygonsThatVtkWouldOpenBecomeTriangles)
{
  Mesh prism;
  Ids bottom, top;
  for (const Point& p : { Point{ 0, 0, 0 }, Point{ 1, 0, 0 }, Point{ 1, 1e-10, 0 },
         Point{ 1, 1, 0 }, Point{ 0, 1, 0 } })
  {
    bottom.insert(bottom.begin(), prism.Add(p));
    top.push_back(prism.Add(p + Point{ 0, 0, 1 }));
  }
  for (int i = 0; i < 5; ++i)
  {
    const vtkIdType a = 2 * i, b = 2 * ((i + 1) % 5);
    prism.Add(VTK_QUAD, { a, b, b + 1, a + 1 });
  }
  prism.Add(VTK_POLYGON, bottom);
  prism.Add(VTK_POLYGON, top);
  vtkNew<Filter> filter;
  filter->SetInputData(MakePolyData(prism));
  filter->SetSourceData(MakePolyData(Transformed(CubeQuads(1), 1.0, { 3, 0, 0 })));
  EXPECT_NEAR(ExpectClosedOutput(filter), 2.0, 1e-13);
}
}
