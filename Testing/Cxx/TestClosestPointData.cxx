// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeClosestPoint: the source's data at the nearest points.

#include "Support/ClosestPointRun.h"
#include "Support/EventCounter.h"
#include "Support/NamedMeshes.h"
#include "Support/VolumeMeshes.h"

#include "vtkBitArray.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkStringArray.h"

#include <gtest/gtest.h>

using namespace skdtest;

namespace
{

FilterPointer MakeInterpolation(vtkDataObject* input, vtkDataObject* source)
{
  FilterPointer filter = MakeFilter(input, source);
  filter->InterpolateSourceDataOn();
  return filter;
}

vtkPointData* RunPointData(vtkSkdTreeClosestPoint* filter)
{
  filter->Update();
  return vtkDataSet::SafeDownCast(filter->GetOutput())->GetPointData();
}

/// Linear fields are exact at the nearest points, cell data are those of the cell found.
void ExpectSourceData(vtkSkdTreeClosestPoint* filter, double tolerance)
{
  const std::vector<double> field = RunArray(filter, "Linear");
  const std::vector<double> closest = RunArray(filter, "SkdClosestPoint");
  const std::vector<double> cells = RunArray(filter, "SkdClosestCellId");
  const std::vector<double> numbers = RunArray(filter, "Number");
  ASSERT_GT(field.size(), 0u);
  ASSERT_EQ(numbers.size(), field.size());
  for (std::size_t i = 0; i < field.size(); ++i)
  {
    const Point at = { closest[3 * i], closest[3 * i + 1], closest[3 * i + 2] };
    ASSERT_NEAR(field[i], Linear(at), tolerance) << i;
    ASSERT_EQ(numbers[i], 10 * cells[i]) << i;
  }
}

class DataOnMesh : public testing::TestWithParam<NamedMesh>
{
};

std::vector<NamedMesh> LinearMeshes()
{
  return { { "Vertices", [] { return MakePolyData(Cloud(300, VTK_VERTEX)); } },
    { "PolyLines", [] { return MakePolyData(Helix(200, VTK_POLY_LINE)); } },
    { "Triangles", [] { return MakePolyData(SphereTriangles(8)); } },
    { "Strips", [] { return MakePolyData(Strips(8)); } },
    { "WarpedQuads", [] { return MakePolyData(SphereQuads(6)); } },
    { "Polygons", [] { return MakePolyData(Hexagons(4)); } },
    { "PlanarQuads", [] { return MakePolyData(TorusQuads(24, 12)); } },
    { "Tetrahedra", [] { return MakeGrid(Tetrahedra(4).Map(Bent)); } },
    { "Hexahedra", [] { return MakeGrid(Hexahedra(4).Map(Bent)); } },
    { "Wedges", [] { return MakeGrid(Wedges(4).Map(Bent)); } },
    { "Pyramids", [] { return MakeGrid(Pyramids(3)); } },
    { "Polyhedra", [] { return MakeGrid(Polyhedra(3).Map(Rotated)); } },
    { "Voxels", [] { return MakeGrid(Voxels(4)); } }, { "Image", [] { return MakeImage(5); } },
    { "Rectilinear", [] { return MakeRectilinear(5); } },
    { "Structured", [] { return MakeStructured(5); } } };
}

INSTANTIATE_TEST_SUITE_P(Linear, DataOnMesh, testing::ValuesIn(LinearMeshes()), NameOfMesh());

TEST_P(DataOnMesh, LinearFieldsAreExactAndCellDataTaken)
{
  DataSetPointer source = WithData(GetParam().Make());
  auto queries = MakeQueries(RandomQueries(source, 300));
  ExpectSourceData(MakeInterpolation(queries, source), 1e-12);
}

TEST_P(DataOnMesh, TheSameWithASign)
{
  DataSetPointer source = WithData(GetParam().Make());
  vtkNew<vtkGenericCell> cell;
  source->GetCell(0, cell);
  if (cell->GetCellDimension() < 2 || std::string(GetParam().Name) == "WarpedQuads")
  {
    return; // no surface; or one of triangles beside the quads
  }
  auto queries = MakeQueries(RandomQueries(source, 300));
  FilterPointer filter = MakeInterpolation(queries, source);
  filter->SignedDistanceOn();
  ExpectSourceData(filter, 1e-12);
}

TEST(ClosestPointData, BlocksGiveTheArraysThatAnyOfThemHas)
{
  const Mesh sphere = SphereTriangles(6);
  auto even = WithData(MakePolyData(Part(sphere, [](std::size_t cell) { return cell % 2 == 0; })));
  auto odd = WithData(MakePolyData(Part(sphere, [](std::size_t cell) { return cell % 2 == 1; })));
  odd->GetPointData()->AddArray(
    MakeArray("OddAlone", odd->GetNumberOfPoints(), [](vtkIdType) { return 1.0; }));
  even->GetPointData()->AddArray(
    MakeArray("EvenAlone", odd->GetNumberOfPoints(), [](vtkIdType) { return 1.0; }));
  vtkNew<vtkPolyData> empty;
  FilterPointer filter =
    MakeInterpolation(MakeQueries(RandomQueries(even, 200)), MakeBlocks({ empty, even, odd }));

  ExpectSourceData(filter, 1e-12);
  vtkPointData* data = RunPointData(filter);
  vtkDataArray* blocks = data->GetArray("SkdClosestBlockIndex");
  for (const auto& [name, block] : { std::pair("EvenAlone", 2), std::pair("OddAlone", 3) })
  {
    const std::string mark = std::string("SkdValid_") + name;
    for (vtkIdType i = 0; i < blocks->GetNumberOfTuples(); ++i)
    {
      const bool has = blocks->GetTuple1(i) == block;
      EXPECT_FALSE(std::abs(data->GetArray(name)->GetTuple1(i) - 1.0) > 1e-12);
      EXPECT_EQ(std::isnan(data->GetArray(name)->GetTuple1(i)), !has);
      EXPECT_EQ(data->GetArray(mark.c_str())->GetTuple1(i), has ? 1.0 : 0.0);
    }
  }
}

TEST(ClosestPointData, TypesAreKeptAndNoneIsNaNOrZero)
{
  auto source = WithData(MakePolyData(Sheet(4, VTK_QUAD)));
  FilterPointer filter = MakeInterpolation(MakeQueries({ { 1.4, 2.2, 0.5 }, { 0, 0, 5 } }), source);
  filter->SetMaximumDistance(1.0);
  vtkPointData* data = RunPointData(filter);

  EXPECT_EQ(data->GetArray("LinearInt")->GetDataType(), VTK_INT);
  EXPECT_EQ(data->GetArray("LinearInt")->GetTuple1(0), 7); // of 6.8
  EXPECT_EQ(data->GetArray("LinearInt")->GetTuple1(1), 0);
  EXPECT_TRUE(std::isnan(data->GetArray("Linear")->GetTuple1(1)));
  EXPECT_EQ(data->GetArray("Number")->GetTuple1(1), 0);
}

TEST(ClosestPointData, NamesInUseKeepWhatTheyNameWithAWarning)
{
  auto source = WithData(MakePolyData(Sheet(4, VTK_QUAD)));
  source->GetCellData()->AddArray(
    MakeArray("Linear", source->GetNumberOfCells(), [](vtkIdType) { return -1.0; }));
  auto queries = MakeQueries({ { 1, 2, 3 } });
  queries->GetPointData()->AddArray(MakeArray("LinearInt", 1, [](vtkIdType) { return 42.0; }));
  FilterPointer filter = MakeInterpolation(queries, source);
  EventCounter events(filter);
  vtkPointData* data = RunPointData(filter);

  EXPECT_EQ(data->GetArray("LinearInt")->GetTuple1(0), 42.0);
  EXPECT_EQ(data->GetArray("Linear")->GetTuple1(0), Linear({ 1, 2, 0 }));
  EXPECT_EQ(events.Warnings, 2);
}

TEST(ClosestPointData, GhostMarksAndPointIdsAreNotPassed)
{
  auto source = WithData(MakePolyData(Sheet(4, VTK_QUAD)));
  source->AllocatePointGhostArray();
  MarkGhosts(source, { 0 }, vtkDataSetAttributes::DUPLICATECELL);
  auto ids = MakeArray<vtkIdTypeArray>(
    "Ids", source->GetNumberOfPoints(), [](vtkIdType i) { return double(i); });
  source->GetPointData()->SetGlobalIds(ids);
  FilterPointer filter = MakeInterpolation(MakeQueries({ { 0.5, 0.5, 0 } }), source);
  vtkPointData* data = RunPointData(filter);

  EXPECT_FALSE(data->HasArray(vtkDataSetAttributes::GhostArrayName()));
  EXPECT_FALSE(data->HasArray("Ids"));
  EXPECT_EQ(data->GetArray("SkdDistance")->GetTuple1(0), 0.5); // the ghost is not searched
}

TEST(ClosestPointData, StringsAndBitsAreTaken)
{
  auto source = MakePolyData(Sheet(2, VTK_QUAD));
  vtkNew<vtkStringArray> names;
  names->SetName("Names");
  for (const char* name : { "zero", "one", "two", "three" })
  {
    names->InsertNextValue(name);
  }
  source->GetCellData()->AddArray(names);
  source->GetCellData()->AddArray(
    MakeArray<vtkBitArray>("Bits", 4, [](vtkIdType i) { return double(i % 2); }));
  FilterPointer filter =
    MakeInterpolation(MakeQueries({ { 1.5, 0.5, 1 }, { 0.5, 1.5, 1 }, { NAN, 0, 0 } }), source);
  vtkPointData* data = RunPointData(filter);

  auto taken = vtkStringArray::SafeDownCast(data->GetAbstractArray("Names"));
  ASSERT_NE(taken, nullptr);
  EXPECT_EQ(taken->GetValue(0), "one");
  EXPECT_EQ(taken->GetValue(1), "two");
  EXPECT_EQ(taken->GetValue(2), "");
  EXPECT_EQ(RunArray(filter, "Bits"), (std::vector<double>{ 1, 0, 0 }));
}

TEST(ClosestPointData, BitsAreInterpolatedAsSmallNumbers)
{
  auto source = MakePolyData(Sheet(1, VTK_QUAD));
  source->GetPointData()->AddArray(
    MakeArray<vtkBitArray>("Bits", 4, [](vtkIdType i) { return double(i % 2); }));
  double corner[3];
  source->GetPoint(1, corner);
  FilterPointer filter = MakeInterpolation(
    MakeQueries({ { 0.2, 0.9 * corner[1] + 0.05, 1 }, { corner[0], corner[1], 1 } }), source);
  EXPECT_EQ(RunArray(filter, "Bits"), (std::vector<double>{ 0, 1 }));
}

TEST(ClosestPointData, ATriangleWithoutAreaInterpolatesAlongItself)
{
  Mesh mesh;
  mesh.Points = { { 0, 0, 0 }, { 1, 1, 0 }, { 4, 4, 0 } };
  mesh.Add(VTK_TRIANGLE, { 0, 1, 2 });
  FilterPointer filter = MakeInterpolation(
    MakeQueries({ { 2, 3, 1 }, { 0.5, 0.5, 2 }, { 9, 9, 9 } }), WithData(MakePolyData(mesh)));
  ExpectSourceData(filter, 1e-12);
}

TEST(ClosestPointData, ATriangleOfOnePointTakesItsData)
{
  Mesh mesh;
  mesh.Points = { { 1, 2, 3 } };
  mesh.Add(VTK_TRIANGLE, { 0, 0, 0 });
  ExpectSourceData(
    MakeInterpolation(MakeQueries({ { 2, 3, 1 } }), WithData(MakePolyData(mesh))), 1e-12);
}

TEST(ClosestPointData, LinesCarryItToo)
{
  auto source = WithData(MakePolyData(Sheet(2, VTK_QUAD)));
  FilterPointer filter = MakeInterpolation(MakeQueries({ { 1.5, 0.5, 1 } }), source);
  filter->GenerateLinesOn();
  filter->Update();
  auto lines = vtkPolyData::SafeDownCast(filter->GetOutput(1));
  EXPECT_EQ(lines->GetCellData()->GetArray("Number")->GetTuple1(0), 10);
}

}
