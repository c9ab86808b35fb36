// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreePointInOut as a filter: its options, volume meshes, bad input, progress.

#include "Support/EventCounter.h"
#include "Support/InOutRun.h"
#include "Support/VolumeMeshes.h"

#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"

#include <gtest/gtest.h>

using namespace skdtest;

namespace
{

TEST(PointInOut, OfVolumeCellsTheOuterFacesOrTheCellsThemselves)
{
  auto grid = MakeGrid(Hexahedra(3).Map(Rotated));
  grid->GetCellData()->AddArray(
    MakeArray<vtkIntArray>("Material", 27, [](vtkIdType cell) { return cell % 3; }));
  std::vector<Point> points;
  std::vector<int> materials;
  Random random(43);
  for (int i = 0; i < 2000; ++i)
  {
    const Point p = random.InBox({ -1, 4, -1, 4, -1, 4 });
    const bool within = Contains(Bounds{ 0, 3, 0, 3, 0, 3 }, p);
    points.push_back(Rotated(p));
    materials.push_back(within ? static_cast<int>(p[0]) % 3 : -1);
  }
  auto input = MakeQueries(points);
  for (int model : { InOut::BOUNDARIES, InOut::BODY_FITTED_MESH })
  {
    InOutPointer filter = MakeInOut(input, grid);
    filter->SetModel(model);
    filter->SetParts(InOut::CELL_ARRAY);
    filter->SetPartArray("Material");
    const std::vector<double> parts = RunFor(filter, "SkdPartId");
    const std::vector<double> depths = RunFor(filter, "SkdDepth");
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      ASSERT_EQ(parts[i], materials[i]) << model << " " << i;
      ASSERT_EQ(depths[i], materials[i] < 0 ? 0 : 1);
    }
    filter->Modified();
    filter->Update();
    EXPECT_EQ(Reported(filter, "TreesBuilt"), 0);
    EXPECT_EQ(Reported(filter, "OuterFaces"), model == InOut::BOUNDARIES ? 1 : 0);
  }
  InOutPointer strict = MakeInOut(input, grid);
  strict->UseOuterFacesOff();
  EventCounter events(strict);
  strict->Update();
  EXPECT_EQ(events.Errors, 1);
  EXPECT_NE(events.Error.find("UseOuterFaces"), std::string::npos);
}

TEST(PointInOut, CellsByCentreAllPointsOrAnyPoint)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(5, 2, 2);
  image->SetOrigin(-2, -0.5, -0.5); // cells [-2, -1], [-1, 0], [0, 1], [1, 2]
  auto ball = MakePolyData(Sphere(16, 1.3, { -0.3, 0, 0 })); // from -1.6 to 1
  const auto inside = [&](int ask)
  {
    InOutPointer filter = MakeInOut(image, ball);
    filter->SetAsk(ask);
    filter->Update();
    auto* output = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
    EXPECT_STREQ(output->GetCellData()->GetScalars()->GetName(), "SkdInside");
    EXPECT_FALSE(output->GetPointData()->HasArray("SkdInside"));
    std::vector<double> values;
    for (vtkIdType i = 0; i < 4; ++i)
    {
      values.push_back(output->GetCellData()->GetArray("SkdInside")->GetTuple1(i));
    }
    return values;
  };
  EXPECT_EQ(inside(InOut::CELL_CENTERS), (std::vector<double>{ 1, 1, 1, 0 }));
  EXPECT_EQ(inside(InOut::CELLS_ALL_POINTS), (std::vector<double>{ 0, 1, 0, 0 }));
  EXPECT_EQ(inside(InOut::CELLS_ANY_POINT), (std::vector<double>{ 1, 1, 1, 0 }));
}

TEST(PointInOut, TheBandIsOnBothSidesOfTheBoundary)
{
  auto cube = MakePolyData(CubeTriangles(2));
  Bounds box;
  cube->GetBounds(box.data());
  const Point middle = Center(box);
  std::vector<Point> points;
  for (double x : { -0.2, -0.05, 0.05, 0.2 })
  {
    points.push_back({ box[1] + x, middle[1] + 0.1, middle[2] + 0.2 });
  }
  points.push_back({ box[1], middle[1] + 0.1, middle[2] + 0.2 });
  InOutPointer filter = MakeInOut(MakeQueries(points), cube);
  EXPECT_EQ(RunFor(filter, "SkdOnBoundary"), (std::vector<double>{ 0, 0, 0, 0, 0 }));
  filter->SetBoundaryBand(0.1);
  EXPECT_EQ(RunFor(filter, "SkdOnBoundary"), (std::vector<double>{ 0, 1, 1, 0, 1 }));
  EXPECT_EQ(RunFor(filter, "SkdInside")[0], 1);
  EXPECT_EQ(RunFor(filter, "SkdInside")[3], 0);
}

TEST(PointInOut, BadInputSaysWhy)
{
  auto points = MakeQueries({ { 0, 0, 0 }, { NAN, 0, 0 } });
  vtkNew<vtkPolyData> empty;
  auto lines = MakePolyData(Helix(10, VTK_LINE));
  for (vtkDataObject* source : std::vector<vtkDataObject*>{ empty, lines })
  {
    for (int method : AllMethods)
    {
      InOutPointer filter = MakeInOut(points, source, method);
      EventCounter events(filter);
      EXPECT_EQ(RunFor(filter, "SkdInside"), (std::vector<double>{ 0, 0 }));
      EXPECT_EQ(events.Warnings, 2) << events.Warning; // no surface; a point that is not finite
      EXPECT_EQ(events.Errors, 0);
    }
  }
  auto ball = MakePolyData(Sphere(6, 1.0));
  InOutPointer filter = MakeInOut(points, ball);
  EXPECT_EQ(RunFor(filter, "SkdInside"), (std::vector<double>{ 1, 0 }));
  EXPECT_EQ(RunFor(filter, "SkdConfidence"), (std::vector<double>{ 1, 0 }));
  EventCounter events(filter);
  filter->SetParts(InOut::CELL_ARRAY);
  filter->SetPartArray("Nothing");
  filter->Update();
  EXPECT_EQ(events.Errors, 1);
  EXPECT_NE(events.Error.find("Nothing"), std::string::npos);
}

TEST(PointInOut, MixedBlocksAreEachAPartOfItsKind)
{
  auto ball = MakePolyData(Sphere(8, 1.0));
  ball->GetCellData()->AddArray(
    MakeArray<vtkIntArray>("Part", ball->GetNumberOfCells(), [](vtkIdType) { return 7.0; }));
  auto bricks = MakeGrid(Transformed(Hexahedra(2), 1.0, { 5, 0, 0 }));
  vtkNew<vtkPolyData> empty;
  auto blocks = MakeBlocks({ ball, nullptr, bricks, empty });
  auto points = MakeQueries({ { 0, 0, 0 }, { 6, 1, 1 }, { 3, 1, 1 }, { NAN, 1, 1 } });
  InOutPointer filter = MakeInOut(points, blocks);
  EventCounter events(filter);
  EXPECT_EQ(RunFor(filter, "SkdPartId"), (std::vector<double>{ 1, 3, -1, -1 }));
  EXPECT_EQ(events.Errors, 0) << events.Error;
  filter->SetParts(InOut::CELL_ARRAY);
  filter->SetPartArray("Part");
  filter->Update();
  EXPECT_EQ(events.Errors, 1);
  EXPECT_NE(events.Error.find("Part"), std::string::npos) << events.Error;
  filter->SetParts(InOut::BLOCKS);
  filter->UseOuterFacesOff();
  filter->Update();
  EXPECT_EQ(events.Errors, 2);
  EXPECT_NE(events.Error.find("UseOuterFaces"), std::string::npos) << events.Error;
}

TEST(PointInOut, ABandThatIsNegativeOrNoNumberIsNone)
{
  auto points = MakeQueries({ { 0, 0, 0 }, { 1, 0, 0 } });
  auto ball = MakePolyData(Sphere(8, 1.0));
  for (const double band : { -1.0, double(NAN) })
  {
    InOutPointer filter = MakeInOut(points, ball);
    filter->SetBoundaryBand(band);
    EventCounter events(filter);
    EXPECT_EQ(RunFor(filter, "SkdOnBoundary"), (std::vector<double>{ 0, 0 })) << band;
    EXPECT_EQ(events.Errors + events.Warnings, 0);
  }
}

TEST(PointInOut, ProgressRisesAndAnAbortLeavesNone)
{
  auto ball = MakePolyData(Sphere(8, 3.0));
  InOutPointer filter = MakeInOut(MakeQueries(PointsAround(1.0, 50000)), ball);
  const std::vector<double> progress = AbortAt(filter, 0.5);
  EXPECT_TRUE(std::is_sorted(progress.begin(), progress.end()));
  const std::vector<double> left = PointArray(filter->GetOutput(), "SkdInside");
  EXPECT_TRUE(left.empty() || std::count(left.begin(), left.end(), 0) > 0);
  filter->Update();
  EXPECT_EQ(Reported(filter, "PointsInside"), 50000);
}

Point PointOf(vtkDataSet* mesh, vtkIdType i)
{
  Point x;
  mesh->GetPoint(i, x.data());
  return x;
}

std::vector<double> ColumnOf(vtkDataSetAttributes* data, const char* name)
{
  std::vector<double> values;
  vtkDataArray* array = data->GetArray(name);
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    values.push_back(array->GetTuple1(i));
  }
  return values;
}

TEST(PointInOut, ExtractsThePointsInsideOrOutside)
{
  const std::vector<Point> points = PointsAround(1.5, 500);
  auto input = WithData(MakeQueries(points));
  auto ball = MakePolyData(Sphere(10, 1.0));
  for (int side : { InOut::INSIDE, InOut::OUTSIDE })
  {
    InOutPointer filter = MakeInOut(input, ball);
    filter->SetExtract(side);
    const std::vector<double> inside = RunFor(filter, "SkdInside");
    auto* grid = vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(1));
    const double wanted = side == InOut::INSIDE ? 1 : 0;
    ASSERT_EQ(grid->GetNumberOfPoints(), std::count(inside.begin(), inside.end(), wanted));
    EXPECT_EQ(grid->GetNumberOfCells(), grid->GetNumberOfPoints());
    const std::vector<double> field = ColumnOf(grid->GetPointData(), "Linear");
    for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
    {
      ASSERT_EQ(field[i], Linear(PointOf(grid, i)));
    }
  }
  InOutPointer none = MakeInOut(input, ball);
  none->Update();
  EXPECT_EQ(vtkDataSet::SafeDownCast(none->GetOutputDataObject(1))->GetNumberOfPoints(), 0);
}

TEST(PointInOut, ExtractsCellsOfEveryKindWithTheirData)
{
  auto grid = WithData(MakeGrid(MixedCells(3)));
  auto ball = MakePolyData(Sphere(10, 1.4, { 1.5, 1.5, 1.5 }));
  InOutPointer filter = MakeInOut(grid, ball);
  filter->SetAsk(InOut::CELL_CENTERS);
  filter->SetExtract(InOut::INSIDE);
  filter->Update();
  auto* found = vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(1));
  ASSERT_EQ(found->GetNumberOfCells(), Reported(filter, "PointsInside"));
  ASSERT_GT(found->GetNumberOfCells(), 5);
  const std::vector<double> numbers = ColumnOf(found->GetCellData(), "Number");
  for (vtkIdType i = 0; i < found->GetNumberOfCells(); ++i)
  {
    const auto id = static_cast<vtkIdType>(numbers[i] / 10);
    ASSERT_EQ(found->GetCellType(i), grid->GetCellType(id));
    Bounds a, b;
    found->GetCellBounds(i, a.data());
    grid->GetCellBounds(id, b.data());
    ASSERT_EQ(a, b);
  }
}

TEST(PointInOut, OfCompositeDataExtractsABlockForEachLeaf)
{
  auto blocks = MakeBlocks({ MakeGrid(Hexahedra(2)), nullptr, MakeGrid(Tetrahedra(2)) });
  InOutPointer filter = MakeInOut(blocks, MakePolyData(Sphere(10, 9.0)));
  filter->SetExtract(InOut::INSIDE);
  filter->SetAsk(InOut::CELLS_ALL_POINTS);
  filter->Update();
  auto* found = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(1));
  ASSERT_NE(found, nullptr);
  ASSERT_EQ(found->GetNumberOfBlocks(), 3u);
  EXPECT_EQ(vtkDataSet::SafeDownCast(found->GetBlock(0))->GetNumberOfCells(), 8);
  EXPECT_EQ(found->GetBlock(1), nullptr);
  EXPECT_EQ(vtkDataSet::SafeDownCast(found->GetBlock(2))->GetNumberOfCells(), 48);
  filter->Modified();
  filter->Update();
  EXPECT_EQ(found->GetNumberOfBlocks(), 3u);
}

/// The id of a part is the index of its block, which may be another while its mesh is the same.
TEST(PointInOut, ABlockThatMovesHasItsNewIndexAsId)
{
  const auto ball = MakePolyData(Sphere(10, 9.0));
  for (const int parts : { InOut::BLOCKS, InOut::CONNECTED_PIECES })
  {
    InOutPointer filter = MakeInOut(MakeGrid(Hexahedra(2)), MakeBlocks({ ball, nullptr, nullptr }));
    filter->SetParts(parts);
    for (const unsigned int at : { 0u, 1u, 2u, 0u })
    {
      std::vector<vtkSmartPointer<vtkDataSet>> blocks(3);
      blocks[at] = ball;
      filter->SetInputDataObject(1, MakeBlocks({ blocks[0], blocks[1], blocks[2] }));
      filter->Update();
      auto* output = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
      const double id = output->GetPointData()->GetArray("SkdPartId")->GetTuple1(0);
      EXPECT_EQ(id, parts == InOut::BLOCKS ? at + 1.0 : 0.0);
    }
  }
}

}
