// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// Coordinates so large or small that products of them are no numbers: every filter ends, and says
// so where it has no answer.

#include "Support/AMRRun.h"
#include "Support/ClosestPointRun.h"
#include "Support/EventCounter.h"
#include "Support/InOutRun.h"
#include "Support/LocatorCalls.h"
#include "Support/MeshRefinementRun.h"
#include "Support/ProbeRun.h"
#include "Support/SpatialQueryRun.h"
#include "Support/VolumeMeshes.h"

#include "vtkSkdTreeCurveIntersection.h"
#include "vtkSkdTreeCurveSurfaceIntersection.h"
#include "vtkSkdTreeSurfaceIntersection.h"

#include <gtest/gtest.h>

using namespace skdtest;

namespace
{

constexpr double Extremes[] = { 1e300, 1e160, 1e-170, 1e-200, 1e-300 };

/// Four cubes, some tetrahedra, a polyline and a point.
DataSetPointer MakeScaled(double scale)
{
  Mesh mesh = Hexahedra(2);
  mesh.Add(VTK_TETRA, { 0, 1, 3, 9 });
  mesh.Add(VTK_POLY_LINE, { 0, 4, 13, 26 });
  mesh.Add(VTK_VERTEX, { 26 });
  mesh.Add(VTK_TRIANGLE, { 2, 11, 24 });
  return WithData(MakeGrid(Transformed(mesh, scale, { 0, 0, 0 })));
}

TEST(Extremes, NearestCellsAreNoneOrThoseOfTheSameMeshAtHome)
{
  const DataSetPointer home = MakeScaled(1.0);
  for (const bool isOfCells : { false, true })
  {
    const auto make = [&](double scale, double queryScale)
    {
      QueryPointer query = MakeQuery(MakeScaled(scale), SpatialQuery::NEAREST);
      query->SetShape(isOfCells ? SpatialQuery::SOURCE_CELLS : SpatialQuery::BOX);
      query->SetBoxPosition(3.1 * queryScale, 0.2 * queryScale, 0.3 * queryScale);
      query->SetBoxLength(queryScale, queryScale, queryScale);
      query->SetSourceData(
        MakePolyData(Transformed(SphereTriangles(2), queryScale, { 4 * queryScale, 0, 0 })));
      query->SetNumberOfNearestCells(3);
      return query;
    };
    const auto expected = RunQuery(make(1.0, 1.0));
    EXPECT_FALSE(expected.empty());
    for (const int exponent : { -160, 160 })
    {
      const double scale = std::ldexp(1.0, exponent);
      const auto rows = RunQuery(make(scale, scale));
      ASSERT_EQ(rows.size(), expected.size()) << exponent;
      for (std::size_t i = 0; i < rows.size(); ++i)
      {
        EXPECT_EQ(rows[i].Cell, expected[i].Cell);
      }
    }
    for (const double scale : Extremes)
    {
      const auto query = make(scale, scale);
      EventCounter events(query);
      EXPECT_TRUE(RunQuery(query).empty()) << scale;
      EXPECT_GE(events.Warnings, 1) << scale;
      EXPECT_EQ(events.Errors, 0);
    }
  }
}

TEST(Extremes, ShapesThatReachTooFarAreReported)
{
  for (const double far : { 1e60, 1e160, 1e300 })
  {
    QueryPointer query = MakeQuery(MakeBricks(), SpatialQuery::NEAREST);
    SetBox(query, { far, 2 * far, 0, 1, 0, 1 });
    EventCounter events(query);
    EXPECT_TRUE(RunQuery(query).empty());
    EXPECT_EQ(events.Warnings, 1);
    EXPECT_NE(events.Warning.find("1e+50"), std::string::npos) << events.Warning;
  }
}

TEST(Extremes, CellsThatAreTooFarAreLeftOutAndCounted)
{
  Mesh mesh = SphereTriangles(4);
  const vtkIdType good = static_cast<vtkIdType>(mesh.Cells.size());
  mesh.Add(VTK_TRIANGLE, { 0, 1, mesh.Add({ 2e50, 0, 0 }) });
  const auto data = MakePolyData(mesh);
  const auto locator = LocatorPointer::New();
  locator->SetDataSet(data);
  EventCounter events(locator);
  locator->BuildLocator();
  EXPECT_EQ(locator->GetNumberOfCellsInTree(), good);
  EXPECT_EQ(locator->GetNumberOfCellsLeftOut(), 1);
  EXPECT_EQ(events.Warnings, 1);
  EXPECT_NE(events.Warning.find("1 of"), std::string::npos) << events.Warning;
  EXPECT_NE(events.Warning.find("1e+50"), std::string::npos) << events.Warning;
  EXPECT_LT(FindClosest(locator, { 0, 0, 3 }).Cell, good);
}

// Of points so far away that squares overflow nothing is found, rather than a cell at an infinite
// distance.
TEST(Extremes, DistancesAreFiniteOrThereIsNone)
{
  const auto data = MakePolyData(SphereTriangles(4));
  const auto locator = LocatorPointer::New();
  locator->SetDataSet(data);
  locator->BuildLocator();
  for (const double far : { 1e10, 1e100, 1e152, 1.1e152, 1e154, 1e200, 1e308 })
  {
    const Closest closest = FindClosest(locator, { far, -far, 0.5 * far });
    EXPECT_EQ(closest.Cell >= 0, far <= 1e152) << far;
    EXPECT_TRUE(closest.Cell < 0 || std::isfinite(closest.Dist2)) << far;
    EXPECT_EQ(FindClosestCells(locator, { 0.0, far, 0.0 }, 3).Number > 0, far <= 1e152) << far;
  }
}

TEST(Extremes, DataOfAMeshThatIsTooLargeOrSmallAreNone)
{
  for (const double scale : Extremes)
  {
    const DataSetPointer source = MakeScaled(scale);
    const auto queries = MakeQueries({ { 0, 0, 0 }, { 0.3 * scale, 0.2 * scale, scale } });
    FilterPointer closest = MakeFilter(queries, source);
    closest->InterpolateSourceDataOn();
    for (const double value : RunArray(closest, "Linear"))
    {
      EXPECT_TRUE(std::isnan(value)) << scale;
    }
    EXPECT_EQ(RunArray(closest, "SkdClosestCellId"), (std::vector<double>{ -1, -1 }));
    ProbePointer probe = MakeProbe(queries, source);
    probe->SetOutsidePoints(vtkSkdTreeProbe::NEAREST_CELL);
    EXPECT_EQ(ProbeArray(probe, "SkdValid"), (std::vector<double>{ 0, 0 }));
  }
}

TEST(Extremes, FiltersThatAskForTheInsideEnd)
{
  for (const double scale : Extremes)
  {
    const auto ball = MakePolyData(Transformed(SphereTriangles(4), scale, { 0, 0, 0 }));
    const auto queries = MakeQueries({ { 0, 0, 0 }, { 3 * scale, 0, 0 } });
    FilterPointer signedFilter = MakeSignedFilter(queries, ball);
    EXPECT_EQ(RunDistances(signedFilter).size(), 2u);
    for (const int method : AllMethods)
    {
      InOutPointer filter = MakeInOut(queries, ball);
      filter->SetMethod(method);
      EXPECT_EQ(RunFor(filter, "SkdInside")[1], 0.0) << scale << " " << method;
    }
  }
}

TEST(Extremes, FiltersThatIntersectEnd)
{
  const auto run = [](auto filter, vtkDataObject* input, vtkDataObject* source)
  {
    filter->SetInputDataObject(0, input);
    filter->SetInputDataObject(1, source);
    EventCounter events(filter);
    filter->Update();
    EXPECT_EQ(events.Errors, 0);
  };
  for (const double scale : Extremes)
  {
    const auto ball = MakePolyData(Transformed(SphereTriangles(4), scale, { 0, 0, 0 }));
    const auto other = MakePolyData(Transformed(SphereTriangles(3), scale, { scale, 0, 0 }));
    const auto curve = MakePolyData(Transformed(Helix(30, VTK_POLY_LINE), scale, { 0, 0, 0 }));
    const auto across =
      MakePolyData(Transformed(Helix(30, VTK_POLY_LINE), scale, { 0.1 * scale, 0, 0 }));
    run(vtkSmartPointer<vtkSkdTreeSurfaceIntersection>::New(), ball, other);
    run(vtkSmartPointer<vtkSkdTreeCurveIntersection>::New(), curve, across);
    run(vtkSmartPointer<vtkSkdTreeCurveSurfaceIntersection>::New(), curve, ball);
  }
}

TEST(Extremes, FiltersThatRefineEnd)
{
  for (const double scale : Extremes)
  {
    const auto parts = MakePolyData(Transformed(TorusTriangles(12, 6), scale, { 0, 0, 0 }));
    AMRPointer amr = MakeAMR(parts, 4);
    amr->AddDistanceBand(0.1, 2);
    amr->ComputeInsideOn();
    amr->ComputeVolumeFractionOn();
    amr->ComputeDistanceOn();
    amr->Update();
    for (const int method : { 0, 1 })
    {
      RefinementPointer refinement = MakeRefinement(MakeScaled(scale), parts, 4, method);
      EXPECT_GE(RunRefinement(refinement)->GetNumberOfCells(), 12);
    }
  }
}

}
