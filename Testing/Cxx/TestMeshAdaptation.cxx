// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeMeshAdaptation: what it does with VTK's meshes and data. Where points go is a matter of
// the core's tests.

#include "Support/EventCounter.h"
#include "Support/FilterRun.h"
#include "Support/Folders.h"

#include "vtkCellData.h"
#include "vtkCubeSource.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSkdTreeMeshAdaptation.h"
#include "vtkSkdTreeMeshRefinement.h"
#include "vtkSphereSource.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTable.h"
#include "vtkXMLImageDataReader.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>

using namespace skdtest;

namespace
{

using Filter = vtkSkdTreeMeshAdaptation;
using FilterPointer = vtkSmartPointer<Filter>;

/// n x n quads of the unit square.
PolyDataPointer MakeSheet(int n)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(0, 0, 0);
  plane->SetPoint1(1, 0, 0);
  plane->SetPoint2(0, 1, 0);
  plane->SetResolution(n, n);
  plane->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  plane->Update();
  return plane->GetOutput();
}

/// A fine sheet with a ridge at x = 0.3.
PolyDataPointer MakeRidge()
{
  PolyDataPointer sheet = MakeSheet(100);
  const auto ridge = [&](vtkIdType i)
  {
    Point p;
    sheet->GetPoint(i, p.data());
    return std::exp(-100.0 * (p[0] - 0.3) * (p[0] - 0.3));
  };
  sheet->GetPointData()->Initialize();
  sheet->GetPointData()->AddArray(MakeArray("Ridge", sheet->GetNumberOfPoints(), ridge));
  return sheet;
}

FilterPointer MakeFilter(vtkDataObject* input, vtkDataObject* source)
{
  auto filter = FilterPointer::New();
  filter->SetInputDataObject(0, input);
  filter->SetSourceData(source);
  return filter;
}

double Reported(Filter* filter, const char* what)
{
  vtkFieldData* field = filter->GetOutputDataObject(0)->GetFieldData();
  vtkDataArray* array = field->GetArray((std::string("SkdReport") + what).c_str());
  return array ? array->GetComponent(0, 0) : -1.0;
}

vtkPointSet* MeshOf(Filter* filter)
{
  return vtkPointSet::SafeDownCast(filter->GetOutputDataObject(0));
}

bool HasMoved(vtkPointSet* now, vtkPointSet* before)
{
  double most = 0.0;
  for (vtkIdType i = 0; i < now->GetNumberOfPoints(); ++i)
  {
    Point a, b;
    now->GetPoint(i, a.data());
    before->GetPoint(i, b.data());
    most = std::max(most, Length(a - b));
  }
  return most > 1e-3;
}

TEST(MeshAdaptation, CellsBecomeSmallWhereTheFieldVaries)
{
  PolyDataPointer input = MakeSheet(24);
  FilterPointer filter = MakeFilter(input, MakeRidge());
  filter->Update();
  EXPECT_LT(
    Reported(filter, "EquidistributionAfter"), Reported(filter, "EquidistributionBefore") / 3.0);
  vtkPointSet* output = MeshOf(filter);
  vtkDataArray* moves = output->GetPointData()->GetArray("SkdDisplacement");
  vtkDataArray* ratios = output->GetCellData()->GetArray("SkdAreaRatio");
  vtkDataArray* areas = output->GetCellData()->GetArray("SkdArea");
  ASSERT_TRUE(moves && ratios && areas && output->GetCellData()->GetArray("SkdMonitor") &&
    output->GetCellData()->GetArray("SkdFieldMean"));
  double total = 0.0;
  for (vtkIdType i = 0; i < output->GetNumberOfCells(); ++i)
  {
    total += areas->GetComponent(i, 0);
  }
  EXPECT_NEAR(total, 1.0, 1e-12);
  EXPECT_LT(ratios->GetRange()[0], 0.6);
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    Point was, is, move;
    input->GetPoint(i, was.data());
    output->GetPoint(i, is.data());
    moves->GetTuple(i, move.data());
    ASSERT_LT(Length(is - was - move), 1e-15);
    ASSERT_EQ(is[2], 0.0);
  }
}

TEST(MeshAdaptation, TheTableHasARowAnIteration)
{
  FilterPointer filter = MakeFilter(MakeSheet(16), MakeRidge());
  filter->SetMaximumIterations(5);
  filter->SetTolerance(0.0);
  filter->Update();
  auto* table = vtkTable::SafeDownCast(filter->GetOutputDataObject(1));
  ASSERT_EQ(table->GetNumberOfRows(), 6);
  const auto best = static_cast<vtkIdType>(Reported(filter, "BestIteration"));
  EXPECT_EQ(table->GetValueByName(best, "SkdEquidistributionError").ToDouble(),
    Reported(filter, "EquidistributionAfter"));
  for (vtkIdType row = 0; row < 6; ++row)
  {
    EXPECT_EQ(table->GetValueByName(row, "SkdIteration").ToInt(), row);
    EXPECT_GT(table->GetValueByName(row, "SkdSmallestQuality").ToDouble(), 0.1);
    EXPECT_GE(table->GetValueByName(row, "SkdEquidistributionError").ToDouble(),
      Reported(filter, "EquidistributionAfter"));
    EXPECT_EQ(table->GetValueByName(row, "SkdLargestDisplacement").ToDouble() > 0.0, row > 0);
  }
}

TEST(MeshAdaptation, IterationsAreTimeSteps)
{
  PolyDataPointer input = MakeSheet(12);
  FilterPointer filter = MakeFilter(input, MakeRidge());
  filter->AnimateIterationsOn();
  filter->SetMaximumIterations(4);
  filter->UpdateInformation();
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  EXPECT_EQ(filter->GetOutputInformation(0)->Length(Pipeline::TIME_STEPS()), 5);
  filter->UpdateTimeStep(0.0);
  EXPECT_FALSE(HasMoved(MeshOf(filter), input));
  filter->UpdateTimeStep(4.0);
  EXPECT_TRUE(HasMoved(MeshOf(filter), input));
  const double seconds = Reported(filter, "Seconds");
  filter->UpdateTimeStep(1.0);
  EXPECT_TRUE(HasMoved(MeshOf(filter), input));
  EXPECT_EQ(Reported(filter, "Seconds"), seconds); // nothing was done again
}

// Blocks that share points stay together, and cells that are no surface hold theirs.
TEST(MeshAdaptation, CompositeInputsStayTogether)
{
  PolyDataPointer left = MakeSheet(10);
  PolyDataPointer right = MakeSheet(10);
  for (vtkIdType i = 0; i < right->GetNumberOfPoints(); ++i)
  {
    Point p;
    right->GetPoint(i, p.data());
    right->GetPoints()->SetPoint(i, p[0] + 1.0, p[1], p[2]);
  }
  FilterPointer filter = MakeFilter(MakeBlocks({ left, right }), MakeRidge());
  filter->Update();
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  auto* a = vtkPointSet::SafeDownCast(blocks->GetBlock(0));
  auto* b = vtkPointSet::SafeDownCast(blocks->GetBlock(1));
  for (vtkIdType row = 0; row <= 10; ++row)
  {
    Point p, q;
    a->GetPoint(11 * row + 10, p.data());
    b->GetPoint(11 * row, q.data());
    EXPECT_EQ(p, q);
    EXPECT_NE(p[0], 1.0); // the seam is no border
  }
}

/// An ellipsoid of half axes 1.5, 1 and 0.5.
PolyDataPointer MakeEllipsoid(int n)
{
  vtkNew<vtkSphereSource> source;
  source->SetThetaResolution(3 * n);
  source->SetPhiResolution(2 * n);
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->Update();
  PolyDataPointer made = source->GetOutput();
  made->GetPointData()->Initialize();
  for (vtkIdType i = 0; i < made->GetNumberOfPoints(); ++i)
  {
    Point p;
    made->GetPoint(i, p.data());
    made->GetPoints()->SetPoint(i, 3.0 * p[0], 2.0 * p[1], p[2]);
  }
  return made;
}

TEST(MeshAdaptation, OtherSurfacesAreKept)
{
  PolyDataPointer input = MakeEllipsoid(8);
  PolyDataPointer data = MakeEllipsoid(40);
  const auto field = [&](vtkIdType i) { return std::exp(2.0 * data->GetPoint(i)[0]); };
  data->GetPointData()->AddArray(MakeArray("Field", data->GetNumberOfPoints(), field));
  FilterPointer filter = MakeFilter(input, data);
  filter->Update();
  EXPECT_TRUE(HasMoved(MeshOf(filter), input));
  EXPECT_LT(
    Reported(filter, "EquidistributionAfter"), 0.6 * Reported(filter, "EquidistributionBefore"));
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    Point p;
    MeshOf(filter)->GetPoint(i, p.data());
    const double at = p[0] * p[0] / 2.25 + p[1] * p[1] + 4.0 * p[2] * p[2];
    EXPECT_GT(at, 0.93); // on facets of the ellipsoid
    EXPECT_LT(at, 1.0001);
  }
}

TEST(MeshAdaptation, ReliefOfTheEarthIsFollowed)
{
  vtkNew<vtkXMLImageDataReader> reader;
  reader->SetFileName((DataFolder() + "/earth_relief.vti").c_str());
  reader->Update();
  vtkNew<vtkCubeSource> cube;
  vtkNew<vtkSkdTreeMeshRefinement> globe; // 1536 quads
  globe->SetInputConnection(cube->GetOutputPort());
  globe->SetMethod(vtkSkdTreeMeshRefinement::REGULAR);
  globe->SetMinimumLevel(4);
  globe->SetMaximumLevel(4);
  globe->SetPointPlacement(vtkSkdTreeMeshRefinement::SPHERE);
  globe->Update();
  FilterPointer filter = MakeFilter(globe->GetOutputDataObject(0), reader->GetOutput());
  filter->SetSourceCoordinates(Filter::LONGITUDE_LATITUDE);
  filter->Update();
  EXPECT_LT(
    Reported(filter, "EquidistributionAfter"), Reported(filter, "EquidistributionBefore") / 3.0);
  EXPECT_GT(Reported(filter, "SmallestQuality"), 0.0);
  for (vtkIdType i = 0; i < MeshOf(filter)->GetNumberOfPoints(); ++i)
  {
    Point p;
    MeshOf(filter)->GetPoint(i, p.data());
    EXPECT_NEAR(Length(p), std::sqrt(0.75), 1e-6);
  }
}

/// What the filter complained of, the mesh being as it was.
std::string Complaint(
  vtkDataObject* input, vtkDataObject* source, const std::function<void(Filter*)>& set = {})
{
  FilterPointer filter = MakeFilter(input, source);
  EventCounter counter(filter);
  if (set)
  {
    set(filter);
  }
  filter->Update();
  EXPECT_EQ(filter->GetOutputDataObject(0)->GetDataObjectType(), input->GetDataObjectType());
  if (MeshOf(filter) && MeshOf(filter)->GetNumberOfPoints() > 0)
  {
    EXPECT_FALSE(HasMoved(MeshOf(filter), vtkPointSet::SafeDownCast(input)));
  }
  return counter.Error + counter.Warning;
}

TEST(MeshAdaptation, BadInputGivesOneClearMessage)
{
  PolyDataPointer sheet = MakeSheet(4);
  PolyDataPointer ridge = MakeRidge();
  const auto named = [](Filter* filter) { filter->SetFieldArray("None"); };
  EXPECT_NE(Complaint(sheet, ridge, named).find("no array \"None\""), std::string::npos);
  EXPECT_NE(Complaint(PolyDataPointer::New(), ridge).find("no triangles"), std::string::npos);
  const auto onSphere = [](Filter* filter) { filter->SetSurface(Filter::SPHERE); };
  EXPECT_NE(Complaint(sheet, ridge, onSphere).find("not on a sphere"), std::string::npos);
  const auto lonLat = [](Filter* f) { f->SetSourceCoordinates(Filter::LONGITUDE_LATITUDE); };
  EXPECT_NE(Complaint(sheet, ridge, lonLat).find("not on a sphere"), std::string::npos);
  PolyDataPointer nans = MakeRidge();
  nans->GetPointData()->GetArray(0)->Fill(vtkMath::Nan());
  EXPECT_NE(Complaint(sheet, nans).find("finite value"), std::string::npos);
  nans->GetPointData()->GetArray(0)->Fill(-1.0);
  const auto value = [](Filter* filter) { filter->SetMonitor(Filter::VALUE); };
  EXPECT_NE(Complaint(sheet, nans, value).find("nowhere greater than 0"), std::string::npos);
  EXPECT_EQ(Complaint(MakeSheet(1), ridge), "");
}

TEST(MeshAdaptation, ValuesTooLargeToBeSquaredCountAsNone)
{
  PolyDataPointer sheet = MakeSheet(8);
  for (const double value : { 1e160, 1e300, 1.7e308, HUGE_VAL })
  {
    PolyDataPointer ridge = MakeRidge();
    vtkDataArray* field = ridge->GetPointData()->GetArray(0);
    field->Fill(value);
    const std::string complaint = Complaint(sheet, ridge);
    EXPECT_NE(complaint.find("finite value"), std::string::npos) << complaint;
    EXPECT_NE(complaint.find("10201 values"), std::string::npos) << complaint;
    EXPECT_NE(complaint.find("1e+152, the first that of point 0"), std::string::npos) << complaint;
  }
  for (const double value : { 1.7e308, double(vtkMath::Nan()) }) // as if they had none
  {
    PolyDataPointer ridge = MakeRidge();
    PolyDataPointer holes = MakeRidge();
    for (vtkIdType i = 0; i < 300; i += 3)
    {
      ridge->GetPointData()->GetArray(0)->SetTuple1(i, value);
      holes->GetPointData()->GetArray(0)->SetTuple1(i, vtkMath::Nan());
    }
    FilterPointer filter = MakeFilter(sheet, ridge);
    FilterPointer expected = MakeFilter(sheet, holes);
    EventCounter events(filter);
    filter->Update();
    expected->Update();
    EXPECT_EQ(events.Errors, 0);
    EXPECT_EQ(events.Warnings, vtkMath::IsNan(value) ? 0 : 1);
    EXPECT_EQ(Reported(filter, "ValuesIgnored"), vtkMath::IsNan(value) ? -1.0 : 100.0);
    EXPECT_FALSE(HasMoved(MeshOf(filter), MeshOf(expected)));
    EXPECT_TRUE(HasMoved(MeshOf(filter), sheet));
  }
}

// Lines only; three cells at an edge; a tetrahedron; a quad that crosses itself.
TEST(MeshAdaptation, CellsThatCannotMoveHoldTheirPoints)
{
  PolyDataPointer ridge = MakeRidge();
  Mesh mesh;
  const Ids ids = { mesh.Add({ 0, 0, 0 }), mesh.Add({ 1, 0, 0 }), mesh.Add({ 1, 1, 0 }),
    mesh.Add({ 0, 1, 0 }), mesh.Add({ 0.5, 0.5, 1 }), mesh.Add({ 0.3, 0.8, 0 }) };
  mesh.Add(VTK_LINE, { ids[0], ids[1] });
  EXPECT_NE(Complaint(MakeGrid(mesh), ridge).find("no triangles"), std::string::npos);
  mesh.Add(VTK_TRIANGLE, { ids[0], ids[1], ids[2] });
  mesh.Add(VTK_TRIANGLE, { ids[0], ids[2], ids[3] });
  mesh.Add(VTK_TRIANGLE, { ids[0], ids[2], ids[5] });
  const std::string complaint = Complaint(MakeGrid(mesh), ridge);
  EXPECT_NE(complaint.find("more than two cells"), std::string::npos) << complaint;
  Mesh solid;
  solid.Points = mesh.Points;
  solid.Add(VTK_TRIANGLE, { ids[0], ids[1], ids[2] });
  solid.Add(VTK_TETRA, { ids[0], ids[1], ids[2], ids[4] });
  EXPECT_NE(
    Complaint(MakeGrid(solid), ridge).find("no triangles, quads or polygons"), std::string::npos);
  Mesh crossed;
  crossed.Points = mesh.Points;
  crossed.Add(VTK_QUAD, { ids[0], ids[2], ids[1], ids[3] });
  EXPECT_NE(
    Complaint(MakeGrid(crossed), ridge).find("cross themselves or have no area, the first cell 0:"),
    std::string::npos);
}

/// The coefficient of variation of mean x area of cells, by their areas at first.
double VariationOf(Filter* filter, const std::function<double(vtkPointSet*, vtkIdType)>& meanIn)
{
  vtkDataArray* areas = MeshOf(filter)->GetCellData()->GetArray("SkdArea");
  vtkDataArray* ratios = MeshOf(filter)->GetCellData()->GetArray("SkdAreaRatio");
  double weight = 0.0, sum = 0.0, squares = 0.0;
  std::vector<double> integrals;
  for (vtkIdType i = 0; i < areas->GetNumberOfTuples(); ++i)
  {
    integrals.push_back(areas->GetTuple1(i) * meanIn(MeshOf(filter), i));
    sum += integrals.back();
    weight += areas->GetTuple1(i) / ratios->GetTuple1(i);
  }
  for (vtkIdType i = 0; i < areas->GetNumberOfTuples(); ++i)
  {
    const double own = areas->GetTuple1(i) / ratios->GetTuple1(i) / weight;
    const double off = integrals[static_cast<std::size_t>(i)] / (own * sum) - 1.0;
    squares += own * off * off;
  }
  return std::sqrt(squares);
}

/// Of a field f over a cell, by 256 points of each triangle around its middle.
double MeanIn(vtkPointSet* mesh, vtkIdType id, const std::function<double(const Point&)>& f)
{
  vtkCell* cell = mesh->GetCell(id);
  const int n = cell->GetNumberOfPoints();
  std::vector<Point> corners(static_cast<std::size_t>(n));
  Point middle{};
  for (int i = 0; i < n; ++i)
  {
    cell->GetPoints()->GetPoint(i, corners[static_cast<std::size_t>(i)].data());
    middle = middle + (1.0 / n) * corners[static_cast<std::size_t>(i)];
  }
  double sum = 0.0, area = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    const Point a = corners[i] - middle;
    const Point b = corners[(i + 1) % corners.size()] - middle;
    const double part = Length(Cross(a, b));
    for (int k = 0; k < 256; ++k)
    {
      const double u = std::sqrt((k / 16 + 0.5) / 16.0); // of equal parts of the triangle
      const double v = (k % 16 + 0.5) / 16.0;
      sum += part * f(middle + (u * (1.0 - v)) * a + (u * v) * b);
      area += part;
    }
  }
  return sum / area;
}

// A coarse source says little by its values, and all by its mesh.
TEST(MeshAdaptation, TheErrorAgainstTheFieldItselfIsTold)
{
  const auto linear = [](const Point& p) { return 1.0 + 4.0 * p[0] + p[1]; };
  PolyDataPointer source = MakeSheet(10);
  const auto value = [&](vtkIdType i)
  {
    Point p;
    source->GetPoint(i, p.data());
    return linear(p);
  };
  source->GetPointData()->Initialize();
  source->GetPointData()->AddArray(MakeArray("Linear", source->GetNumberOfPoints(), value));
  FilterPointer filter = MakeFilter(MakeSheet(16), source);
  filter->SetMaximumIterations(8);
  filter->Update();
  EXPECT_EQ(Reported(filter, "EquidistributionOfField"), -1.0); // the monitor is another field
  filter->SetMonitor(Filter::VALUE);
  filter->Update();
  const double exact =
    VariationOf(filter, [&](vtkPointSet* mesh, vtkIdType i) { return MeanIn(mesh, i, linear); });
  EXPECT_GT(exact, 2.0 * Reported(filter, "EquidistributionAfter"));
  EXPECT_NEAR(Reported(filter, "EquidistributionOfField"), exact, 1e-3 * exact);
  source->GetPointData()->Initialize();
  const auto cellValue = [](vtkIdType i) { return 1.0 + i % 10; };
  source->GetCellData()->AddArray(MakeArray("Stairs", source->GetNumberOfCells(), cellValue));
  const auto stairs = [](const Point& p) { return 1.0 + std::floor(10.0 * std::min(p[0], 0.99)); };
  filter->Update();
  const double steps =
    VariationOf(filter, [&](vtkPointSet* mesh, vtkIdType i) { return MeanIn(mesh, i, stairs); });
  EXPECT_NEAR(Reported(filter, "EquidistributionOfField"), steps, 0.1 * steps);
}

// Longitudes of the source may be of any turn.
TEST(MeshAdaptation, TheErrorAgainstAFieldOfLongitudesAndLatitudesIsTold)
{
  const auto smooth = [](const Point& p)
  { return 2.0 + p[0] / Length(p) + 0.5 * p[2] / Length(p); };
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(3.0);
  sphere->SetThetaResolution(24);
  sphere->SetPhiResolution(14);
  sphere->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  sphere->Update();
  for (const double first : { 0.0, -180.0, 300.0 })
  {
    vtkNew<vtkImageData> image;
    image->SetDimensions(181, 91, 1);
    image->SetOrigin(first, -90.0, 0.0);
    image->SetSpacing(2.0, 2.0, 1.0);
    const auto value = [&](vtkIdType i)
    {
      Point p;
      image->GetPoint(i, p.data());
      const double longitude = vtkMath::RadiansFromDegrees(p[0]);
      const double latitude = vtkMath::RadiansFromDegrees(p[1]);
      return smooth({ { std::cos(latitude) * std::cos(longitude),
        std::cos(latitude) * std::sin(longitude), std::sin(latitude) } });
    };
    image->GetPointData()->AddArray(MakeArray("Smooth", image->GetNumberOfPoints(), value));
    FilterPointer filter = MakeFilter(sphere->GetOutput(), image);
    filter->SetSourceCoordinates(Filter::LONGITUDE_LATITUDE);
    filter->SetMonitor(Filter::VALUE);
    filter->SetMaximumIterations(4);
    filter->Update();
    const double exact =
      VariationOf(filter, [&](vtkPointSet* mesh, vtkIdType i) { return MeanIn(mesh, i, smooth); });
    EXPECT_NEAR(Reported(filter, "EquidistributionOfField"), exact, 0.02 * exact) << first;
  }
}

/// What the filter says of an input that it does move.
std::string WarningOf(Filter* filter)
{
  EventCounter events(filter);
  filter->Update();
  EXPECT_EQ(events.Errors, 0);
  return events.Warning;
}

TEST(MeshAdaptation, MonitorsThatAreNotPositiveNameTheFirstCell)
{
  PolyDataPointer ridge = MakeRidge();
  vtkDataArray* field = ridge->GetPointData()->GetArray(0);
  for (vtkIdType i = 0; i < field->GetNumberOfTuples(); ++i)
  {
    Point p;
    ridge->GetPoint(i, p.data());
    field->SetTuple1(i, p[0] < 0.5 || p[1] < 0.25 ? 1.0 : -1.0);
  }
  FilterPointer filter = MakeFilter(MakeSheet(8), ridge);
  filter->SetMonitor(Filter::VALUE);
  filter->SetMaximumIterations(0);
  const std::string warning = WarningOf(filter);
  EXPECT_NE(warning.find("in 24 cells, the first cell 20:"), std::string::npos) << warning;
  PolyDataPointer left = MakeSheet(8); // its cells are nearest to the border, where the field is 1
  for (vtkIdType i = 0; i < left->GetNumberOfPoints(); ++i)
  {
    Point p;
    left->GetPoint(i, p.data());
    left->GetPoints()->SetPoint(i, p[0] - 1.0, p[1], p[2]);
  }
  filter->SetInputDataObject(0, MakeBlocks({ left, MakeSheet(8) }));
  EXPECT_NE(WarningOf(filter).find("the first cell 20 of block 2:"), std::string::npos);
}

// Checkered: no mesh of these cells can follow that.
TEST(MeshAdaptation, AnErrorThatIsLeftNamesCellsAndWhatStopsThem)
{
  PolyDataPointer ridge = MakeRidge();
  vtkDataArray* field = ridge->GetPointData()->GetArray(0);
  for (vtkIdType i = 0; i < field->GetNumberOfTuples(); ++i)
  {
    field->SetTuple1(i, (i / 101 / 4 + i % 101 / 4) % 2 == 0 ? 1.0 : 50.0);
  }
  FilterPointer filter = MakeFilter(MakeSheet(24), ridge);
  filter->SetMonitor(Filter::VALUE);
  filter->SetSmoothing(0);
  filter->SetMinimumQuality(0.7);
  const std::string warning = WarningOf(filter);
  const auto after = [&](const char* text)
  {
    const std::size_t at = warning.find(text);
    EXPECT_NE(at, std::string::npos) << warning;
    return at == std::string::npos ? -1 : std::atoi(warning.c_str() + at + std::strlen(text));
  };
  EXPECT_GT(Reported(filter, "EquidistributionAfter"), 0.03);
  const int worst = after("largest in cell ");
  vtkCellData* cells = MeshOf(filter)->GetCellData();
  vtkDataArray* areas = cells->GetArray("SkdArea");
  vtkDataArray* monitor = cells->GetArray("SkdMonitor");
  double sum = 0.0, most = 0.0;
  vtkIdType expected = -1;
  for (vtkIdType i = 0; i < areas->GetNumberOfTuples(); ++i)
  {
    sum += areas->GetTuple1(i) * monitor->GetTuple1(i);
  }
  for (vtkIdType i = 0; i < areas->GetNumberOfTuples(); ++i)
  {
    const double off = std::abs(576.0 * areas->GetTuple1(i) * monitor->GetTuple1(i) / sum - 1.0);
    expected = off > most ? i : expected;
    most = std::max(most, off);
  }
  EXPECT_EQ(worst, expected);
  const int held = after("worse than MinimumQuality (the first is cell ");
  EXPECT_TRUE(held >= 0 && held < 576);
  EXPECT_GT(after("times its share; "), 0);
  filter->SetMaximumIterations(1);
  filter->SetMinimumQuality(0.0);
  filter->SetTolerance(0.0);
  EXPECT_NE(WarningOf(filter).find("The equidistribution error"), std::string::npos);
}

TEST(MeshAdaptation, ProgressIsReportedAndAbortEndsEarly)
{
  FilterPointer filter = MakeFilter(MakeSheet(24), MakeRidge());
  ProgressWatch watch(filter, 0.1);
  filter->Update();
  auto* table = vtkTable::SafeDownCast(filter->GetOutputDataObject(1));
  EXPECT_LT(table->GetNumberOfRows(), 10); // none where VTK empties outputs after an abort
  filter->RemoveAllObservers();
  filter->SetAbortExecute(0);
  filter->Modified();
  filter->Update();
  EXPECT_EQ(MeshOf(filter)->GetNumberOfPoints(), 625);
  EXPECT_GE(table->GetNumberOfRows(), 10);
}

}
