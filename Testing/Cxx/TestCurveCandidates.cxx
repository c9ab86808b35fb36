// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeCurveIntersection: the regions in which curves may meet.

#include "Support/CurveRun.h"

#include "vtkCellData.h"
#include "vtkMath.h"
#include "vtkPolyData.h"
#include "vtkSkdTreeCurveIntersection.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

using namespace skdtest;

namespace
{

using FilterPointer = vtkSmartPointer<vtkSkdTreeCurveIntersection>;

FilterPointer Crossing(vtkDataObject* curves, vtkDataObject* others, double clearance = 0.0)
{
  auto filter = FilterPointer::New();
  filter->SetInputDataObject(0, curves);
  if (others)
  {
    filter->SetSourceData(others);
  }
  filter->CandidateRegionsOn();
  filter->SetPolylineForm(vtkSkdTreeCurveIntersection::CARDINAL_SPLINE);
  filter->SetClearance(clearance);
  filter->Update();
  return filter;
}

vtkUnstructuredGrid* RegionsOf(vtkSkdTreeCurveIntersection* filter)
{
  return vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(2));
}

vtkPolyData* PointsOf(vtkSkdTreeCurveIntersection* filter)
{
  return vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
}

double ValueOf(vtkDataSet* regions, const char* name, vtkIdType region, int component = 0)
{
  return regions->GetCellData()->GetArray(name)->GetComponent(region, component);
}

PolyDataPointer Wave(double phase, double height)
{
  return MakePolyline(Sampled(
    [=](double t) {
      return Point{ t, std::sin(3.0 * t + phase), height * std::cos(t) };
    },
    0.0, 6.0, 90));
}

/// Whether the region's box has a point, and its parts the parameters there.
bool Holds(vtkUnstructuredGrid* regions, vtkIdType region, const double* x, double s, double t)
{
  const double* bounds = regions->GetCell(region)->GetBounds();
  const auto isWithin = [&](const char* name, double value)
  {
    return ValueOf(regions, name, region, 0) <= value && value <= ValueOf(regions, name, region, 1);
  };
  return bounds[0] <= x[0] && x[0] <= bounds[1] && bounds[2] <= x[1] && x[1] <= bounds[3] &&
    bounds[4] <= x[2] && x[2] <= bounds[5] && isWithin("SkdCurveParameterRange", s) &&
    isWithin("SkdOtherCurveParameterRange", t);
}

TEST(CurveCandidates, AreNoneUnlessAskedFor)
{
  auto filter = FilterPointer::New();
  filter->SetInputDataObject(0, Wave(0, 0));
  filter->SetSourceData(Wave(1, 0));
  filter->Update();
  EXPECT_EQ(RegionsOf(filter)->GetNumberOfCells(), 0);
}

TEST(CurveCandidates, EachIntersectionIsInARegionThatCountsIt)
{
  auto filter = Crossing(Wave(0, 0), Wave(1.3, 0));
  vtkUnstructuredGrid* regions = RegionsOf(filter);
  vtkPolyData* hits = PointsOf(filter);
  EXPECT_GE(hits->GetNumberOfPoints(), 5);
  double counted = 0.0;
  for (vtkIdType region = 0; region < regions->GetNumberOfCells(); ++region)
  {
    counted += ValueOf(regions, "SkdNumberOfHits", region);
  }
  EXPECT_GE(counted, hits->GetNumberOfPoints());
  for (vtkIdType hit = 0; hit < hits->GetNumberOfPoints(); ++hit)
  {
    const auto at = [&](const char* name)
    { return hits->GetPointData()->GetArray(name)->GetTuple1(hit); };
    int holding = 0;
    for (vtkIdType region = 0; region < regions->GetNumberOfCells(); ++region)
    {
      holding += ValueOf(regions, "SkdNumberOfHits", region) > 0 &&
        Holds(regions, region, hits->GetPoint(hit), at("SkdCurveParameter"),
          at("SkdOtherCurveParameter"));
    }
    EXPECT_GE(holding, 1) << "hit " << hit;
  }
}

// Two waves that come near, but do not meet: with a clearance, all places where they do are
// reported.
TEST(CurveCandidates, WithAClearanceAllNearPositionsAreInRegions)
{
  const double gap = 0.01;
  auto low = Wave(0, 0.2);
  auto high = Wave(0.5, 0.2);
  for (vtkIdType i = 0; i < high->GetNumberOfPoints(); ++i)
  {
    double x[3];
    high->GetPoint(i, x);
    x[2] += gap;
    high->GetPoints()->SetPoint(i, x);
  }
  EXPECT_EQ(PointsOf(Crossing(low, high))->GetNumberOfPoints(), 0);
  auto filter = Crossing(low, high, 2.0 * gap);
  EXPECT_EQ(PointsOf(filter)->GetNumberOfPoints(), 1);
  vtkUnstructuredGrid* regions = RegionsOf(filter);
  // sin(3 t) = sin(3 t + 0.5) at 3 t = (pi - 0.5) / 2 + k pi: six places in [0, 6]
  for (int k = 0; k < 6; ++k)
  {
    const double t = ((vtkMath::Pi() - 0.5) / 2.0 + k * vtkMath::Pi()) / 3.0;
    const double x[3] = { t, std::sin(3.0 * t), 0.2 * std::cos(t) + 0.5 * gap };
    int holding = 0;
    for (vtkIdType region = 0; region < regions->GetNumberOfCells(); ++region)
    {
      holding += Holds(regions, region, x, t / 6.0, t / 6.0);
      EXPECT_EQ(ValueOf(regions, "SkdNumberOfHits", region), 0.0);
    }
    EXPECT_GE(holding, 1) << "place " << k;
  }
}

TEST(CurveCandidates, CurvesFarApartHaveNone)
{
  auto filter = Crossing(Wave(0, 0), MakePolyline({ { 0, 5, 0 }, { 6, 5, 0 }, { 9, 6, 0 } }));
  EXPECT_EQ(RegionsOf(filter)->GetNumberOfCells(), 0);
}

}
