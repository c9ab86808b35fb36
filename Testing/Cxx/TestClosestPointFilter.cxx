// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeClosestPoint: its results, of any data set and of composite ones.

#include "Support/BruteForce.h"
#include "Support/ClosestPointRun.h"
#include "Support/EventCounter.h"
#include "Support/NamedMeshes.h"
#include "Support/OneAndFourThreads.h"

#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkPartitionedDataSet.h"
#include "vtkTable.h"

#include <gtest/gtest.h>

#include <cstring>

using namespace skdtest;

namespace
{

class FilterOnMesh : public testing::TestWithParam<NamedMesh>
{
};

INSTANTIATE_TEST_SUITE_P(All, FilterOnMesh, testing::ValuesIn(AllMeshes()), NameOfMesh());

TEST_P(FilterOnMesh, AnswersAreThoseOfBruteForce)
{
  DataSetPointer source = GetParam().Make();
  BruteForce reference(source);
  const std::vector<Point> points = RandomQueries(source, 100);
  FilterPointer filter = MakeFilter(MakeQueries(points), source);

  const std::vector<double> distances = RunDistances(filter);
  const std::vector<double> closest = RunArray(filter, "SkdClosestPoint");
  const std::vector<double> cells = RunArray(filter, "SkdClosestCellId");

  ASSERT_EQ(distances.size(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const Point at = { closest[3 * i], closest[3 * i + 1], closest[3 * i + 2] };
    const double tolerance = reference.Tolerance();
    EXPECT_NEAR(distances[i], reference.FindNearest(points[i]).Distance, tolerance) << i;
    EXPECT_NEAR(Distance(points[i], at), distances[i], tolerance) << i;
    EXPECT_NEAR(reference.DistanceTo(static_cast<vtkIdType>(cells[i]), at), 0.0, 1e3 * tolerance)
      << i;
  }
}

TEST(ClosestPointFilter, KeepsTheInputsDataAndMakesTheDistanceActive)
{
  vtkNew<vtkImageData> input;
  input->SetDimensions(4, 3, 2);
  input->AllocateScalars(VTK_FLOAT, 1);
  input->GetPointData()->GetScalars()->SetName("Mine");
  FilterPointer filter = MakeFilter(input, MakePolyData(Octahedron(1)));
  filter->Update();

  auto output = vtkImageData::SafeDownCast(filter->GetOutput());
  ASSERT_NE(output, nullptr);
  EXPECT_EQ(output->GetNumberOfPoints(), 24);
  EXPECT_TRUE(output->GetPointData()->HasArray("Mine"));
  EXPECT_STREQ(output->GetPointData()->GetScalars()->GetName(), "SkdDistance");
  EXPECT_FALSE(output->GetPointData()->HasArray("SkdClosestBlockIndex"));
  EXPECT_FALSE(input->GetPointData()->HasArray("SkdDistance"));
  EXPECT_EQ(filter->GetOutputDataObject(1)->GetNumberOfElements(vtkDataObject::CELL), 0);
}

TEST(ClosestPointFilter, OfBlocksTheNearestWins)
{
  const Mesh sphere = SphereTriangles(8);
  const auto third = [&](std::size_t k)
  { return MakePolyData(Part(sphere, [=](std::size_t cell) { return cell % 3 == k; })); };
  auto inner = MakeBlocks({ third(1), nullptr, third(2) });
  auto blocks = MakeBlocks({ third(0), PolyDataPointer::New(), inner });
  auto whole = MakePolyData(sphere);
  auto queries = MakeQueries(RandomQueries(whole, 200));

  FilterPointer filter = MakeFilter(queries, blocks);
  const std::vector<double> found = RunDistances(filter);
  const std::vector<double> indices = RunArray(filter, "SkdClosestBlockIndex");
  const std::vector<double> cells = RunArray(filter, "SkdClosestCellId");
  FilterPointer reference = MakeFilter(queries, whole);
  const std::vector<double> expected = RunDistances(reference);
  const std::vector<double> wholeCells = RunArray(reference, "SkdClosestCellId");

  // 0 the root, 1 the first third, 2 empty, 3 the inner blocks, 4 and 6 the others' thirds.
  const int flatIndex[3] = { 1, 4, 6 };
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    EXPECT_EQ(found[i], expected[i]);
    const int cell = static_cast<int>(wholeCells[i]);
    if (indices[i] != flatIndex[cell % 3])
    {
      continue; // a tie on an edge, which goes to another block
    }
    EXPECT_EQ(cells[i], cell / 3);
  }
  EXPECT_EQ(Reported(filter, "TreesBuilt"), 3);
}

TEST(ClosestPointFilter, TiesGoToTheLowestBlockAndCell)
{
  auto sphere = MakePolyData(SphereTriangles(4));
  auto again = MakePolyData(SphereTriangles(4));
  auto queries = MakeQueries(SphereTriangles(4).Map([](const Point& p) { return 1.7 * p; }).Points);
  FilterPointer one = MakeFilter(queries, sphere);
  FilterPointer two = MakeFilter(queries, MakeBlocks({ sphere, again }));

  EXPECT_EQ(RunArray(two, "SkdClosestCellId"), RunArray(one, "SkdClosestCellId"));
  for (double index : RunArray(two, "SkdClosestBlockIndex"))
  {
    EXPECT_EQ(index, 1);
  }
  const std::vector<double> cells = RunArray(one, "SkdClosestCellId");
  for (vtkIdType i = 0; i < sphere->GetNumberOfPoints(); ++i)
  {
    vtkNew<vtkIdList> all;
    sphere->GetPointCells(i, all);
    EXPECT_EQ(cells[i], *std::min_element(all->begin(), all->end()));
  }
}

TEST(ClosestPointFilter, ACompositeInputIsMirrored)
{
  auto source = MakePolyData(TorusTriangles(12, 8));
  auto a = MakeQueries(RandomQueries(source, 50, 1));
  auto b = MakeQueries(RandomQueries(source, 70, 2));
  vtkNew<vtkTable> table;
  auto input = MakeBlocks({ a, nullptr, table, MakeBlocks({ b }) });
  input->GetMetaData(0u)->Set(vtkCompositeDataSet::NAME(), "first");
  FilterPointer filter = MakeFilter(input, source);
  filter->Update();

  auto output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutput());
  ASSERT_NE(output, nullptr);
  ASSERT_EQ(output->GetNumberOfBlocks(), 4u);
  EXPECT_STREQ(output->GetMetaData(0u)->Get(vtkCompositeDataSet::NAME()), "first");
  EXPECT_EQ(output->GetBlock(1), nullptr);
  EXPECT_NE(vtkTable::SafeDownCast(output->GetBlock(2)), nullptr);
  auto inner = vtkMultiBlockDataSet::SafeDownCast(output->GetBlock(3));
  EXPECT_EQ(PointArray(output->GetBlock(0), "SkdDistance"), RunDistances(MakeFilter(a, source)));
  EXPECT_EQ(PointArray(inner->GetBlock(0), "SkdDistance"), RunDistances(MakeFilter(b, source)));
  EXPECT_EQ(Reported(filter, "Points"), 120);
  EXPECT_FALSE(a->GetPointData()->HasArray("SkdDistance"));
}

TEST(ClosestPointFilter, PartitionsAreCompositeToo)
{
  auto source = MakePolyData(TorusTriangles(12, 8));
  vtkNew<vtkPartitionedDataSet> parts;
  parts->SetPartition(0, MakeQueries(RandomQueries(source, 50, 1)));
  parts->SetPartition(1, MakeQueries(RandomQueries(source, 10, 2)));
  FilterPointer filter = MakeFilter(parts, source);
  filter->Update();
  auto output = vtkPartitionedDataSet::SafeDownCast(filter->GetOutput());
  ASSERT_NE(output, nullptr);
  EXPECT_EQ(PointArray(output->GetPartition(1), "SkdDistance").size(), 10u);
}

TEST(ClosestPointFilter, MaximumDistanceIsIncludedAndBeyondThereIsNone)
{
  auto plane = MakePolyData(Sheet(4, VTK_QUAD));
  FilterPointer filter =
    MakeFilter(MakeQueries({ { 1, 1, 0.5 }, { 1, 1, 0.75 }, { 1, 1, 0.7500001 }, { 2, 2, 9 } }),
      MakeBlocks({ plane }));
  filter->SetMaximumDistance(0.75);
  filter->GenerateLinesOn();

  const std::vector<double> distances = RunDistances(filter);
  EXPECT_EQ(distances[0], 0.5);
  EXPECT_EQ(distances[1], 0.75);
  for (int far : { 2, 3 })
  {
    EXPECT_TRUE(std::isnan(distances[far]));
    EXPECT_TRUE(std::isnan(RunArray(filter, "SkdClosestPoint")[3 * far]));
    EXPECT_EQ(RunArray(filter, "SkdClosestCellId")[far], -1);
    EXPECT_EQ(RunArray(filter, "SkdClosestBlockIndex")[far], -1);
  }
  EXPECT_EQ(Reported(filter, "PointsFound"), 2);
  EXPECT_EQ(filter->GetOutputDataObject(1)->GetNumberOfElements(vtkDataObject::CELL), 2);
}

TEST(ClosestPointFilter, AMaximumDistanceOfZeroFindsPointsOnTheSource)
{
  auto plane = MakePolyData(Sheet(4, VTK_TRIANGLE));
  FilterPointer filter = MakeFilter(MakeQueries({ { 1.25, 1.5, 0 }, { 1, 1, 1e-9 } }), plane);
  filter->SetMaximumDistance(0.0);
  EXPECT_EQ(RunDistances(filter)[0], 0.0);
  EXPECT_TRUE(std::isnan(RunDistances(filter)[1]));
}

TEST(ClosestPointFilter, LinesGoFromEachPointToItsNearestAndCarryItsData)
{
  auto source = MakePolyData(SphereTriangles(6));
  const std::vector<Point> points = RandomQueries(source, 40);
  auto first = MakeQueries(points);
  first->AllocatePointGhostArray(); // which says nothing of lines
  auto second = MakeQueries({ { 3, 0, 0 }, { NAN, 0, 0 }, { 0, 3, 0 } });
  FilterPointer filter = MakeFilter(MakeBlocks({ first, second }), source);
  filter->GenerateLinesOn();
  filter->Update();

  auto lines = vtkPolyData::SafeDownCast(filter->GetOutput(1));
  ASSERT_EQ(lines->GetNumberOfLines(), 42);
  ASSERT_EQ(lines->GetNumberOfCells(), 42);
  vtkDataArray* distances = lines->GetCellData()->GetScalars();
  ASSERT_STREQ(distances->GetName(), "SkdDistance");
  EXPECT_FALSE(lines->GetCellData()->HasArray(vtkDataSetAttributes::GhostArrayName()));
  for (vtkIdType i = 0; i < 42; ++i)
  {
    Point ends[2];
    vtkCell* line = lines->GetCell(i);
    line->GetPoints()->GetPoint(0, ends[0].data());
    line->GetPoints()->GetPoint(1, ends[1].data());
    EXPECT_NEAR(Distance(ends[0], ends[1]), distances->GetTuple1(i), 1e-15);
    EXPECT_EQ(ends[0], i < 40 ? points[i] : i == 40 ? Point({ 3, 0, 0 }) : Point({ 0, 3, 0 }));
  }
}

TEST(ClosestPointFilter, BitsAreTheSameForAnyNumberOfThreads)
{
  auto source = MakePolyData(TorusTriangles(40, 20));
  FilterPointer filter = MakeFilter(MakeQueries(RandomQueries(source, 20000)), source);
  filter->SignedDistanceOn();
  const auto run = [&]
  {
    filter->Modified();
    return std::array<std::vector<double>, 3>{ RunDistances(filter),
      RunArray(filter, "SkdClosestPoint"), RunArray(filter, "SkdClosestCellId") };
  };
  const auto [one, four] = OneAndFourThreads(run);
  for (int array = 0; array < 3; ++array)
  {
    ASSERT_EQ(one[array].size(), four[array].size());
    EXPECT_EQ(std::memcmp(one[array].data(), four[array].data(), 8 * one[array].size()), 0);
  }
}

TEST(ClosestPointFilter, ProgressRisesToOne)
{
  auto source = MakePolyData(SphereTriangles(4));
  FilterPointer filter = MakeFilter(MakeQueries(RandomQueries(source, 20000)), source);
  filter->InterpolateSourceDataOn();
  ProgressWatch watch(filter);
  filter->Update();
  EXPECT_GT(watch.Seen.size(), 8u);
  EXPECT_TRUE(std::is_sorted(watch.Seen.begin(), watch.Seen.end()));
  EXPECT_EQ(watch.Seen.back(), 1.0);
}

TEST(ClosestPointFilter, AnAbortStopsTheQueriesAndTheNextRunIsWhole)
{
  auto source = MakePolyData(SphereTriangles(4));
  FilterPointer filter = MakeFilter(MakeQueries(RandomQueries(source, 50000)), source);
  {
    ProgressWatch watch(filter, 0.5);
    filter->Update();
    filter->RemoveAllObservers();
    for (double progress : watch.Seen)
    {
      EXPECT_TRUE(progress < 0.6 || progress == 1.0) << progress; // VTK's own end is at 1
    }
  }
  // VTK that knows CheckAbort empties the output, older VTK passes on what is there.
  const std::vector<double> left = PointArray(filter->GetOutput(), "SkdDistance");
  EXPECT_TRUE(left.empty() || std::isnan(left.back()));

  filter->SetAbortExecute(0);
  filter->Modified();
  for (double distance : RunDistances(filter))
  {
    ASSERT_FALSE(std::isnan(distance));
  }
  EXPECT_EQ(Reported(filter, "PointsFound"), 50000);
}

TEST(ClosestPointFilter, ASourceWithoutCellsGivesAWarningAndNone)
{
  const NoSources none;
  for (vtkDataObject* source : none.All())
  {
    for (bool isSigned : { false, true })
    {
      FilterPointer filter = MakeFilter(MakeQueries({ { 0, 0, 0 }, { 1, 2, 3 } }), source);
      filter->SetSignedDistance(isSigned);
      filter->InterpolateSourceDataOn();
      filter->GenerateLinesOn();
      EventCounter events(filter);
      const std::vector<double> distances = RunDistances(filter);
      ASSERT_EQ(distances.size(), 2u);
      EXPECT_TRUE(std::isnan(distances[0]) && std::isnan(distances[1]));
      EXPECT_EQ(RunArray(filter, "SkdClosestCellId"), std::vector<double>(2, -1));
      EXPECT_EQ(events.Errors, 0);
      EXPECT_EQ(events.Warnings, source == none.NotFinite ? 2 : 1); // one counts points
    }
  }
}

TEST(ClosestPointFilter, AnInputWithoutPointsGivesAnOutputWithoutPoints)
{
  vtkNew<vtkPolyData> empty;
  auto source = MakePolyData(Octahedron(1));
  FilterPointer filter = MakeFilter(empty, source);
  filter->InterpolateSourceDataOn();
  filter->GenerateLinesOn();
  EventCounter events(filter);
  EXPECT_TRUE(RunDistances(filter).empty());
  EXPECT_TRUE(
    vtkDataSet::SafeDownCast(filter->GetOutput())->GetPointData()->HasArray("SkdDistance"));
  EXPECT_EQ(events.Errors + events.Warnings, 0);
}

TEST(ClosestPointFilter, PointsThatAreNotFiniteGetNoAnswer)
{
  auto source = MakePolyData(Octahedron(1));
  for (bool isSigned : { false, true })
  {
    FilterPointer filter =
      MakeFilter(MakeQueries({ { NAN, 0, 0 }, { 0, INFINITY, 0 }, { 0, 0, 2 } }), source);
    filter->SetSignedDistance(isSigned);
    const std::vector<double> distances = RunDistances(filter);
    EXPECT_TRUE(std::isnan(distances[0]));
    EXPECT_TRUE(std::isnan(distances[1]));
    EXPECT_EQ(distances[2], 1.0);
  }
}

TEST(ClosestPointFilter, SettingsHaveTheirDefaultsAndRanges)
{
  auto filter = FilterPointer::New();
  EXPECT_EQ(filter->GetMaximumDistance(), VTK_DOUBLE_MAX);
  EXPECT_EQ(filter->GetEpsilon(), 1e-9);
  EXPECT_FALSE(filter->GetSignedDistance() || filter->GetInterpolateSourceData() ||
    filter->GetGenerateLines());
  EventCounter events(filter);
  filter->SetMaximumDistance(0.0);
  filter->SetMaximumDistance(-1.0);
  filter->SetEpsilon(2.0);
  EXPECT_EQ(filter->GetMaximumDistance(), 0.0);
  EXPECT_EQ(events.Errors, 2);
  EXPECT_EQ(filter->GetEpsilon(), 1e-9);
  std::ostringstream text;
  filter->Print(text);
  EXPECT_NE(text.str().find("MaximumDistance: 0"), std::string::npos);
}

}
