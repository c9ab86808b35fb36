// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// Points that are NaN, infinite or so large that squares of their coordinates overflow: every
// filter warns of them once, on each port, and counts them in its report; distances are right or
// none.

#include "Support/AMRRun.h"
#include "Support/ClosestPointRun.h"
#include "Support/EachFilter.h"
#include "Support/LocatorCalls.h"
#include "Support/MessageCounter.h"
#include "Support/ProbeRun.h"
#include "Support/StructuredMeshes.h"
#include "Support/VolumeMeshes.h"

#include "vtkIdTypeArray.h"
#include "vtkRectilinearGrid.h"
#include "vtkSkdTreeCompareSurfaces.h"
#include "vtkSkdTreeRays.h"

#include <gtest/gtest.h>

using namespace skdtest;

namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

/// The messages about such points.
class PointsCounter : public MessageCounter
{
public:
  explicit PointsCounter(vtkObject* watched)
    : MessageCounter(watched, "Points that are not finite")
  {
  }
};

enum class Kind
{
  Surface,
  Volume,
  Points,
  Lines
};

/// Two points of it are not usable.
DataSetPointer MakeMesh(Kind kind, double bad)
{
  Mesh mesh = kind == Kind::Surface ? Transformed(SphereTriangles(3), 0.7, { 1.2, 1.2, 1.2 })
    : kind == Kind::Volume          ? Transformed(Hexahedra(2), 1.1, { 0.02, 0.02, 0.01 })
                                    : Mesh();
  Random random(5);
  while (mesh.Points.size() < 13)
  {
    mesh.Add(random.InBox({ 0, 2.5, 0, 2.5, 0, 2.5 }));
  }
  if (kind == Kind::Lines)
  {
    mesh.Add(VTK_POLY_LINE, { 0, 1, 2, 3 });
    mesh.Add(VTK_POLY_LINE, { 4, 5, 6, 7 });
    mesh.Add(VTK_LINE, { 8, 9 });
  }
  mesh.Points[5][1] = bad;
  mesh.Points[9][2] = -bad;
  return kind == Kind::Volume ? DataSetPointer(WithData(MakeGrid(mesh)))
                              : DataSetPointer(WithData(MakePolyData(mesh)));
}

class UnusablePoints : public EachFilter
{
};

INSTANTIATE_TEST_SUITE_P(Filters, UnusablePoints,
  testing::Range<std::size_t>(0, AllFilterSetups().size()),
  [](const auto& info) { return AllFilterSetups()[info.param].Name; });

TEST_P(UnusablePoints, AreNamedOnceAndCounted)
{
  const bool isBoth = this->Setup.Name == "QueryAdjacent"; // the same mesh is Input and Source
  const std::string& name = this->Setup.Name;
  const bool anyMagnitude = name.find("Boolean") == 0 || name == "Imprint" ||
    name == "SurfaceIntersection" || name == "SurfaceWithItself";
  for (const Kind kind : { Kind::Surface, Kind::Volume, Kind::Points, Kind::Lines })
  {
    for (const double bad : { std::nan(""), Infinity, 1e200, 1.5 })
    {
      if (anyMagnitude && bad == 1e200)
      {
        continue; // usable
      }
      SCOPED_TRACE(std::to_string(static_cast<int>(kind)) + " " + std::to_string(bad));
      const DataSetPointer mesh = MakeMesh(kind, bad);
      const auto filter = this->Setup.Make(mesh);
      PointsCounter counter(filter);
      filter->Update();
      vtkDataArray* report =
        filter->GetOutputDataObject(0)->GetFieldData()->GetArray("SkdReportPointsNotFinite");
      if (bad == 1.5)
      {
        EXPECT_EQ(counter.Messages, 0) << counter.Last;
        EXPECT_EQ(report, nullptr);
        continue;
      }
      ASSERT_EQ(counter.Messages, 1);
      const std::string expected = "2 of " + std::to_string(mesh->GetNumberOfPoints()) +
        " points are NaN" + (anyMagnitude ? " or infinite" : ", infinite or beyond 1e+152") +
        "; the first is point 5.";
      EXPECT_NE(counter.Last.find(expected), std::string::npos) << counter.Last;
      ASSERT_NE(report, nullptr);
      EXPECT_EQ(report->GetNumberOfTuples(), filter->GetNumberOfInputPorts());
      double sum = 0.0;
      for (vtkIdType port = 0; port < report->GetNumberOfTuples(); ++port)
      {
        sum += report->GetTuple1(port);
      }
      EXPECT_EQ(sum, isBoth ? 4.0 : 2.0);
    }
  }
}

TEST(UnusablePointsOf, HiddenCellsAreNotNamed)
{
  QuietWindow quiet;
  for (const Kind kind : { Kind::Surface, Kind::Volume })
  {
    const DataSetPointer mesh = MakeMesh(kind, std::nan(""));
    Ids hidden;
    vtkIdType shown = -1; // of the cells that have point 9, one
    vtkNew<vtkIdList> ids;
    for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
    {
      mesh->GetCellPoints(cell, ids);
      if (ids->IsId(5) >= 0 || ids->IsId(9) >= 0)
      {
        hidden.push_back(cell);
        shown = ids->IsId(5) < 0 ? cell : shown;
      }
    }
    MarkGhosts(mesh, hidden, vtkDataSetAttributes::HIDDENCELL);
    FilterPointer filter = MakeFilter(mesh, MakePolyData(SphereTriangles(3)));
    PointsCounter counter(filter);
    filter->Update();
    EXPECT_EQ(counter.Messages, 0) << counter.Last;
    vtkFieldData* reports = filter->GetOutputDataObject(0)->GetFieldData();
    EXPECT_FALSE(reports->HasArray("SkdReportPointsNotFinite"));
    vtkNew<vtkSkdTreeCellLocator> locator;
    EventCounter events(locator);
    locator->SetDataSet(mesh);
    locator->BuildLocator();
    EXPECT_EQ(events.Warnings, 0) << events.Warning;
    ASSERT_GE(shown, 0);
    mesh->GetCellGhostArray()->SetValue(shown, 0);
    mesh->Modified();
    filter->Update();
    EXPECT_NE(counter.Last.find("1 of "), std::string::npos) << counter.Last;
    EXPECT_NE(counter.Last.find("the first is point 9"), std::string::npos) << counter.Last;
  }
}

TEST(UnusablePointsOf, HiddenPointsAreNotNamed)
{
  QuietWindow quiet;
  const auto grid = MakeStructured(3);
  grid->GetPoints()->SetPoint(21, std::nan(""), 0, 0);
  FilterPointer filter = MakeFilter(grid, MakePolyData(SphereTriangles(3)));
  PointsCounter counter(filter);
  filter->Update();
  EXPECT_EQ(counter.Messages, 1);
  grid->BlankPoint(21);
  grid->Modified();
  filter->Update();
  EXPECT_EQ(counter.Messages, 1);
}

TEST(UnusablePointsOf, RectilinearGridsAreThoseOfWholePlanes)
{
  QuietWindow quiet;
  vtkSmartPointer<vtkRectilinearGrid> grid = MakeRectilinear(5);
  grid->GetYCoordinates()->SetTuple1(2, std::nan(""));
  FilterPointer filter = MakeFilter(grid, MakePolyData(SphereTriangles(3)));
  PointsCounter counter(filter);
  filter->Update();
  EXPECT_EQ(counter.Messages, 1);
  const int* n = grid->GetDimensions();
  const std::string expected = std::to_string(n[0] * n[2]) + " of ";
  EXPECT_NE(counter.Last.find(expected), std::string::npos) << counter.Last;
  EXPECT_NE(counter.Last.find("point " + std::to_string(2 * n[0])), std::string::npos);
}

TEST(UnusablePointsOf, ImagesFollowFromOriginAndSpacing)
{
  QuietWindow quiet;
  struct
  {
    Point Origin;
    Point Spacing;
    const char* Expected; // nothing: all can be used
  } const cases[] = { { { 0, 0, 0 }, { 1, 1, 1 }, "" },
    { { 0, std::nan(""), 0 }, { 1, 1, 1 }, "60 of 60 points are NaN" },
    { { 0, 0, -Infinity }, { 1, 1, 1 }, "60 of 60" }, { { 0, 1e200, 0 }, { 1, 1, 1 }, "60 of 60" },
    { { 0, 0, 0 }, { 1, std::nan(""), 1 }, "60 of 60" },
    { { 0, 0, 0 }, { 1, 0.4e152, 1 }, "15 of 60 points" }, // the last of four rows
    { { -2e151, 0, 0 }, { 1e151, 1, 1 }, "" } };
  for (const auto& one : cases)
  {
    vtkNew<vtkImageData> image;
    image->SetDimensions(5, 4, 3);
    image->SetOrigin(one.Origin.data());
    image->SetSpacing(one.Spacing.data());
    FilterPointer filter = MakeFilter(image, MakePolyData(SphereTriangles(3)));
    PointsCounter counter(filter);
    filter->Update();
    const bool isUsable = std::string(one.Expected).empty();
    EXPECT_EQ(counter.Messages, isUsable ? 0 : 1) << one.Expected << counter.Last;
    EXPECT_NE(counter.Last.find(one.Expected), std::string::npos) << counter.Last;
    EXPECT_EQ(filter->GetOutputDataObject(0)->GetFieldData()->HasArray("SkdReportPointsNotFinite"),
      isUsable ? 0 : 1);
  }
}

TEST(UnusablePointsOf, BlocksAreToldOneByOne)
{
  QuietWindow quiet;
  const auto blocks = MakeBlocks({ MakeMesh(Kind::Surface, 1.5), MakeMesh(Kind::Volume, 1e300) });
  FilterPointer filter = MakeFilter(blocks, MakeMesh(Kind::Surface, std::nan("")));
  PointsCounter counter(filter);
  filter->Update();
  EXPECT_EQ(counter.Messages, 1);
  EXPECT_NE(counter.Last.find("Input port 0: Block 2: 2 of 27"), std::string::npos) << counter.Last;
  EXPECT_NE(counter.Last.find("Input port 1: 2 of 56"), std::string::npos) << counter.Last;
  EXPECT_EQ(counter.Last.find("Block 1"), std::string::npos) << counter.Last;
  filter->Modified();
  filter->Update();
  EXPECT_EQ(counter.Messages, 2) << "each execution";
}

/// Far away in all directions, and how far from the origin: in extended precision.
struct FarPoint
{
  Point X;
  double Distance;
};

std::vector<FarPoint> FarPoints()
{
  std::vector<FarPoint> points;
  Random random(3);
  for (int exponent = 40; exponent <= 308; exponent += exponent > 148 && exponent < 156 ? 1 : 12)
  {
    for (int i = 0; i < 5; ++i)
    {
      const Point x = std::pow(10.0, exponent) * (i == 0 ? Point{ 1, 0, 0 } : random.Direction());
      long double sum = 0.0L;
      for (const double c : x)
      {
        sum += static_cast<long double>(c) * c;
      }
      points.push_back({ x, static_cast<double>(std::sqrt(sum)) });
    }
  }
  return points;
}

void ExpectRightOrNone(double distance, vtkIdType cell, const FarPoint& far)
{
  SCOPED_TRACE(far.Distance);
  if (cell >= 0)
  {
    EXPECT_NEAR(distance / far.Distance, 1.0, 1e-12);
  }
  else
  {
    EXPECT_GT(far.Distance, 1e152);
  }
}

TEST(FarDistances, OfTheLocatorAreRightOrNone)
{
  const auto mesh = MakePolyData(SphereTriangles(3)); // small, seen from there
  const LocatorPointer locator = MakeLocator(mesh);
  for (const FarPoint& far : FarPoints())
  {
    const Closest closest = FindClosest(locator, far.X);
    ExpectRightOrNone(std::sqrt(closest.Dist2), closest.Cell, far);
    const Ranked ranked = FindClosestCells(locator, far.X, 3);
    EXPECT_EQ(ranked.Number, closest.Cell >= 0 ? 3 : 0);
    const Ranked within = FindWithinRadius(locator, far.X, 0.5 * far.Distance);
    EXPECT_TRUE(within.Cells.empty());
    vtkNew<vtkDoubleArray> points;
    points->SetNumberOfComponents(3);
    points->InsertNextTuple(far.X.data());
    vtkNew<vtkIdTypeArray> cells;
    vtkNew<vtkDoubleArray> distances;
    locator->FindClosestPoints(points, cells, nullptr, distances);
    EXPECT_EQ(cells->GetValue(0), closest.Cell);
  }
}

TEST(FarDistances, OfFiltersAreRightOrNone)
{
  QuietWindow quiet;
  const auto mesh = WithData(MakePolyData(SphereTriangles(3)));
  std::vector<Point> requested;
  const std::vector<FarPoint> points = FarPoints();
  for (const FarPoint& far : points)
  {
    requested.push_back(far.X);
  }
  for (const bool isSigned : { false, true })
  {
    FilterPointer filter = MakeFilter(MakeQueries(requested), mesh);
    filter->SetSignedDistance(isSigned);
    const std::vector<double> distances = RunArray(filter, "SkdDistance");
    const std::vector<double> cells = RunArray(filter, "SkdClosestCellId");
    ASSERT_EQ(distances.size(), points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      ExpectRightOrNone(distances[i], static_cast<vtkIdType>(cells[i]), points[i]);
      EXPECT_EQ(std::isnan(distances[i]), cells[i] < 0.0);
    }
  }
  ProbePointer probe = MakeProbe(MakeQueries(requested), mesh);
  probe->SetOutsidePoints(vtkSkdTreeProbe::NEAREST_CELL);
  const std::vector<double> valid = ProbeArray(probe, "SkdValid");
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    EXPECT_EQ(valid[i],
      points[i].Distance <= 1e152    ? 1.0
        : points[i].Distance > 2e152 ? 0.0
                                     : valid[i]);
  }
}

TEST(FarDistances, OfRaysAreFiniteOrThereIsNoHit)
{
  QuietWindow quiet;
  std::vector<Point> requested;
  for (const FarPoint& far : FarPoints())
  {
    requested.push_back(far.X);
  }
  vtkNew<vtkSkdTreeRays> rays;
  rays->SetInputDataObject(MakeQueries(requested));
  rays->SetSourceData(MakePolyData(SphereTriangles(3)));
  rays->SetAlongToDirection();
  rays->SetDirection(-1, 0, 0);
  rays->Update();
  auto* output = vtkDataSet::SafeDownCast(rays->GetOutputDataObject(0));
  for (int i = 0; i < output->GetPointData()->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = output->GetPointData()->GetArray(i);
    for (vtkIdType k = 0; k < array->GetNumberOfValues(); ++k)
    {
      EXPECT_FALSE(std::isinf(array->GetVariantValue(k).ToDouble())) << array->GetName();
    }
  }
}

TEST(FarDistances, OfComparedSurfacesAreOfUsablePoints)
{
  QuietWindow quiet;
  Mesh mesh = SphereTriangles(3);
  Mesh other = mesh;
  other.Add(VTK_TRIANGLE, { 0, 1, other.Add({ 1e160, 0, 0 }) });
  vtkNew<vtkSkdTreeCompareSurfaces> filter;
  filter->SetInputDataObject(MakePolyData(mesh));
  filter->SetSourceData(MakePolyData(other));
  filter->Update();
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    vtkFieldData* field = filter->GetOutputDataObject(port)->GetFieldData();
    for (int i = 0; i < field->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = field->GetArray(i);
      EXPECT_FALSE(array && array->GetNumberOfValues() > 0 && std::isinf(array->GetRange()[1]))
        << array->GetName();
    }
  }
}

}
