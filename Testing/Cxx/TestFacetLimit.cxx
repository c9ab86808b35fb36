// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// Curved faces for which the most facets that there are do not keep the ChordalDeviation.

#include "Support/ClosestPointRun.h"
#include "Support/EventCounter.h"
#include "Support/InOutRun.h"

#include "vtkSkdTreeAMR.h"
#include "vtkSkdTreeSurfaceIntersection.h"

#include <gtest/gtest.h>

using namespace skdtest;

namespace
{

/// A quadratic tetrahedron one of whose edges is bent, and so the two faces that have it.
vtkSmartPointer<vtkUnstructuredGrid> BentTetrahedron(double shift = 0.0)
{
  Mesh mesh;
  mesh.Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 0.5, 0, 0 },
    { 0.5, 0.5, 0 }, { 0, 0.5, 0 }, { 0, 0, 0.5 }, { 0.5, 0, 0.5 }, { 0, 0.6, 0.6 } };
  mesh.Cells = { { VTK_QUADRATIC_TETRA, { 0, 1, 2, 3, 4, 5, 6, 7, 8, 9 } } };
  mesh.Map([&](const Point& p) { return p + Point{ shift, shift, shift }; });
  return MakeGrid(mesh);
}

/// With a large deviation there is nothing to warn of; with the least one there is one warning, and
/// one again when the filter runs again.
template <class Filter>
void ExpectWarningOf(Filter* filter, const std::string& faces)
{
  EventCounter events(filter);
  filter->SetChordalDeviation(1e-2);
  filter->Update();
  EXPECT_EQ(events.Warnings, 0) << events.Warning;
  filter->SetChordalDeviation(1e-7);
  for (int run = 1; run < 3; ++run)
  {
    filter->Modified();
    filter->Update();
    EXPECT_EQ(events.Warnings, run);
    EXPECT_NE(events.Warning.find("ChordalDeviation 1e-07"), std::string::npos) << events.Warning;
    EXPECT_NE(events.Warning.find(faces + " curved faces"), std::string::npos) << events.Warning;
  }
  EXPECT_EQ(events.Errors, 0);
}

const std::vector<Point> Queries = { { 0.1, 0.1, 0.1 }, { 2, 2, 2 } };

TEST(FacetLimit, IsReportedOfSignedDistances)
{
  ExpectWarningOf(MakeSignedFilter(MakeQueries(Queries), BentTetrahedron()).Get(), "2");
}

TEST(FacetLimit, DoesNotMatterWithoutASide)
{
  FilterPointer filter = MakeFilter(MakeQueries(Queries), BentTetrahedron());
  filter->SetChordalDeviation(1e-7);
  EventCounter events(filter);
  filter->Update();
  EXPECT_EQ(events.Warnings, 0) << events.Warning;
}

TEST(FacetLimit, IsReportedOfPartsThatHoldPoints)
{
  ExpectWarningOf(MakeInOut(MakeQueries(Queries), BentTetrahedron()).Get(), "2");
}

TEST(FacetLimit, IsReportedOnceOfBothSurfaces)
{
  vtkNew<vtkSkdTreeSurfaceIntersection> filter;
  filter->SetInputData(BentTetrahedron());
  filter->SetSourceData(BentTetrahedron(0.9));
  ExpectWarningOf(filter.Get(), "4");
}

TEST(FacetLimit, IsReportedOfPartsWhoseInsideIsRefined)
{
  vtkNew<vtkSkdTreeAMR> filter;
  filter->SetInputData(BentTetrahedron());
  filter->SetMaximumLevel(1);
  filter->SetInsideLevel(1);
  ExpectWarningOf(filter.Get(), "2");
}

}
