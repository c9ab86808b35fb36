// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeProbe as a filter: its options, composite data, bad input, progress.

#include "Support/EventCounter.h"
#include "Support/ProbeRun.h"
#include "Support/SurfaceMeshes.h"
#include "Support/VolumeMeshes.h"

#include "vtkImageData.h"
#include "vtkSMPTools.h"
#include "vtkStringArray.h"

#include <gtest/gtest.h>

#include <cstring>

using namespace skdtest;

namespace
{

TEST(Probe, ToleranceIsAPartOfTheNearestCellsOwnDiagonal)
{
  auto source = WithData(MakeGrid(Hexahedra(1))); // a diagonal of 1.732
  const std::vector<Point> points = { { 0.5, 0.5, 1.0 + 1.5e-3 }, { 0.5, 0.5, 1.0 + 1.9e-3 },
    { 0.5, 0.5, 1.1 } };
  ProbePointer probe = MakeProbe(MakeQueries(points), source);
  EXPECT_EQ(ProbeArray(probe, "SkdValid"), (std::vector<double>{ 1, 0, 0 }));
  EXPECT_NEAR(ProbeArray(probe, "SkdDistance")[0], 1.5e-3, 1e-12);
  EXPECT_NEAR(ProbeArray(probe, "Linear")[0], Linear({ 0.5, 0.5, 1.0 }), 1e-12);
  EXPECT_EQ(Reported(probe, "PointsOutside"), 1);
  probe->SetRelativeTolerance(0.0);
  EXPECT_EQ(ProbeArray(probe, "SkdValid"), (std::vector<double>{ 0, 0, 0 }));
  probe->SetAbsoluteTolerance(0.05);
  EXPECT_EQ(ProbeArray(probe, "SkdValid"), (std::vector<double>{ 1, 1, 0 }));
  probe->SetAbsoluteTolerance(0.0);
  EXPECT_EQ(ProbeArray(probe, "SkdValid"), (std::vector<double>{ 0, 0, 0 }));
}

TEST(Probe, ALargeCellReachesOverASmallOneThatIsNearer)
{
  Mesh mesh; // two cubes: 1e-3 wide and, a little farther off, 10 wide
  for (const auto& [low, size] : { std::pair(1.0, 1e-3), std::pair(-10.001, 10.0) })
  {
    const auto first = static_cast<vtkIdType>(mesh.Points.size());
    for (const Point& p : Hexahedra(1).Points)
    {
      mesh.Add(size * p + Point{ low - 0.9995, 0, 0 });
    }
    Ids ids = Hexahedra(1).Cells[0].Points;
    for (vtkIdType& id : ids)
    {
      id += first;
    }
    mesh.Add(VTK_HEXAHEDRON, ids);
  }
  // The small one begins at 0.0005, the large one ends at -1.0005.
  for (std::size_t i = 8; i < 16; ++i)
  {
    mesh.Points[i][0] += 0.999;
  }
  auto source = MakeGrid(mesh);
  ProbePointer probe = MakeProbe(MakeQueries({ { 0.0, 5e-4, 5e-4 } }), source);
  EXPECT_EQ(ProbeArray(probe, "SkdSourceCellId")[0], 1);
}

TEST(Probe, ManyCellsAtAPointTheLowestWins)
{
  auto grid = WithData(MakeGrid(Hexahedra(4)));
  ProbePointer probe = MakeProbe(MakeQueries(Hexahedra(4).Points), grid);
  const std::vector<double> cells = ProbeArray(probe, "SkdSourceCellId");
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    vtkNew<vtkIdList> all;
    grid->GetPointCells(static_cast<vtkIdType>(i), all);
    ASSERT_EQ(cells[i], *std::min_element(all->begin(), all->end()));
  }
}

TEST(Probe, OfBlocksTheLowestThatHoldsThePoint)
{
  const Mesh cubes = Hexahedra(3);
  const auto part = [&](std::size_t k)
  { return WithData(MakeGrid(Part(cubes, [=](std::size_t cell) { return cell % 3 == k; }))); };
  auto blocks = MakeBlocks({ part(0), nullptr, MakeBlocks({ part(1), part(2) }) });
  const PointsInCells requested = MakePointsInCells(MakeGrid(cubes), 300);
  ProbePointer probe = MakeProbe(MakeQueries(requested.Points), blocks);
  const std::vector<double> index = ProbeArray(probe, "SkdSourceBlockIndex");
  const std::vector<double> cells = ProbeArray(probe, "SkdSourceCellId");
  const std::vector<double> field = ProbeArray(probe, "Linear");
  const double flat[3] = { 1, 4, 5 };
  for (std::size_t i = 0; i < requested.Points.size(); ++i)
  {
    ASSERT_EQ(index[i], flat[requested.Cells[i] % 3]);
    ASSERT_EQ(cells[i], requested.Cells[i] / 3);
    ASSERT_NEAR(field[i], Linear(requested.Points[i]), 1e-11);
  }
  EXPECT_EQ(Reported(probe, "TreesBuilt"), 3);
}

TEST(Probe, CategoricalArraysAreThoseOfTheNearestPoint)
{
  auto source = WithData(MakeGrid(Hexahedra(3).Map(Bent)));
  auto labels = MakeArray<vtkIntArray>(
    "Label", source->GetNumberOfPoints(), [](vtkIdType i) { return 100.0 * i; });
  source->GetPointData()->AddArray(labels);
  const PointsInCells requested = MakePointsInCells(source, 200);
  ProbePointer probe = MakeProbe(MakeQueries(requested.Points), source);
  probe->AddCategoricalArray("Label");
  const std::vector<double> found = ProbeArray(probe, "Label");
  const std::vector<double> cells = ProbeArray(probe, "SkdSourceCellId");
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    ASSERT_EQ(std::fmod(found[i], 100.0), 0.0);
    Point p;
    source->GetPoint(static_cast<vtkIdType>(found[i] / 100), p.data());
    vtkNew<vtkIdList> ids;
    source->GetCellPoints(static_cast<vtkIdType>(cells[i]), ids);
    for (vtkIdType id : *ids)
    {
      Point q;
      source->GetPoint(id, q.data());
      ASSERT_LE(Distance(p, requested.Points[i]), Distance(q, requested.Points[i]) + 1e-14);
    }
  }
}

TEST(Probe, GradientsAlongSurfacesAndOfVectors)
{
  auto sheet = MakeGrid(Sheet(4, VTK_QUAD).Map(Rotated));
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetName("V");
  vectors->SetNumberOfComponents(2);
  for (vtkIdType i = 0; i < sheet->GetNumberOfPoints(); ++i)
  {
    Point p;
    sheet->GetPoint(i, p.data());
    vectors->InsertNextTuple2(Linear(p), p[2]);
  }
  sheet->GetPointData()->AddArray(vectors);
  const PointsInCells requested = MakePointsInCells(sheet, 50);
  ProbePointer probe = MakeProbe(MakeQueries(requested.Points), sheet);
  probe->AddGradientArray("V");
  const std::vector<double> g = ProbeArray(probe, "V_Gradient");
  ASSERT_EQ(g.size(), 6 * requested.Points.size());
  const Point normal = Rotated({ 0, 0, 1 });
  for (std::size_t i = 0; i < requested.Points.size(); ++i)
  {
    for (const auto& [offset, whole] :
      { std::pair(0, Point{ 3, -2, 0.5 }), std::pair(3, Point{ 0, 0, 1 }) })
    {
      const Point along = whole - Dot(whole, normal) * normal;
      const Point found = { g[6 * i + offset], g[6 * i + offset + 1], g[6 * i + offset + 2] };
      ASSERT_LT(Distance(found, along), 1e-11);
    }
  }
}

TEST(Probe, FillsWhereThereIsNoAnswer)
{
  auto source = WithData(MakeGrid(Hexahedra(2)));
  ProbePointer probe = MakeProbe(MakeQueries({ { 1, 1, 1 }, { 9, 9, 9 }, { NAN, 0, 0 } }), source);
  EXPECT_TRUE(std::isnan(ProbeArray(probe, "Linear")[1]));
  EXPECT_EQ(ProbeArray(probe, "LinearInt")[1], 0);
  probe->SetFillValue(-99.6);
  probe->UseFillValueOn();
  EXPECT_EQ(ProbeArray(probe, "Linear")[2], -99.6);
  EXPECT_EQ(ProbeArray(probe, "Number")[2], -100);
  EXPECT_EQ(ProbeArray(probe, "SkdValid"), (std::vector<double>{ 1, 0, 0 }));
  EXPECT_EQ(ProbeArray(probe, "SkdSourceCellId")[1], -1);
  EXPECT_TRUE(std::isnan(ProbeArray(probe, "SkdDistance")[1]));
}

TEST(Probe, TheInputsDataArePassedOrNot)
{
  vtkNew<vtkImageData> input;
  input->SetDimensions(3, 3, 3);
  WithData(static_cast<vtkImageData*>(input));
  input->GetPointData()->GetArray("LinearInt")->SetName("Mine");
  auto source = WithData(MakeGrid(Hexahedra(2)));
  ProbePointer probe = MakeProbe(input, source);
  EventCounter events(probe);
  EXPECT_EQ(ProbeArray(probe, "Mine").size(), 27u);
  EXPECT_EQ(events.Warnings, 1) << events.Warning;
  EXPECT_NE(events.Warning.find("Linear"), std::string::npos);
  EXPECT_NE(vtkImageData::SafeDownCast(probe->GetOutput()), nullptr);

  probe->PassInputDataOff();
  EXPECT_TRUE(ProbeArray(probe, "Mine").empty());
  EXPECT_EQ(ProbeArray(probe, "Linear").size(), 27u);
  EXPECT_EQ(events.Warnings, 1);
  EXPECT_TRUE(input->GetPointData()->HasArray("Mine"));
}

TEST(Probe, TheActiveScalarsAreTheSourcesOrItsFirstNumbers)
{
  const auto activeOf = [](vtkDataObject* input, vtkDataObject* source)
  {
    ProbePointer probe = MakeProbe(input, source);
    probe->Update();
    vtkDataArray* active =
      vtkDataSet::SafeDownCast(probe->GetOutputDataObject(0))->GetPointData()->GetScalars();
    return std::string(active ? active->GetName() : "");
  };
  auto input = MakeQueries({ { 0.5, 0.5, 0.5 } });
  auto source = WithData(MakeGrid(Hexahedra(1)));
  EXPECT_EQ(activeOf(input, source), "Linear");
  source->GetPointData()->SetActiveScalars("LinearInt");
  EXPECT_EQ(activeOf(input, source), "LinearInt");
  input->GetPointData()->SetScalars(MakeArray("Own", 1, [](vtkIdType) { return 1.0; }));
  EXPECT_EQ(activeOf(input, source), "LinearInt");
  source->GetPointData()->Initialize();
  EXPECT_EQ(activeOf(input, source), "Number");
  source->GetCellData()->Initialize();
  EXPECT_EQ(activeOf(input, source), "Own");
}

TEST(Probe, TreesAreKeptWhileTheMeshIsTheSame)
{
  auto source = WithData(MakeGrid(Hexahedra(3)));
  ProbePointer probe = MakeProbe(MakeQueries({ { 1.5, 1, 1 } }), source);
  EXPECT_NEAR(ProbeArray(probe, "Linear")[0], Linear({ 1.5, 1, 1 }), 1e-12);
  EXPECT_EQ(Reported(probe, "TreesBuilt"), 1);
  auto later = GridPointer::New();
  later->DeepCopy(source);
  later->GetPointData()->GetArray("Linear")->Fill(5.0);
  probe->SetSourceData(later);
  EXPECT_EQ(ProbeArray(probe, "Linear")[0], 5.0);
  EXPECT_EQ(Reported(probe, "TreesBuilt"), 0);
}

TEST(Probe, AKeptTreeServesManyThreadsOnPolydataThatNobodyHasAsked)
{
  const Mesh sphere = Triangulated(SphereTriangles(24));
  auto input = MakeQueries(MakePointsInCells(MakePolyData(sphere), 20000).Points);
  vtkSMPTools::Initialize(4);
  ProbePointer probe = MakeProbe(input, WithData(MakePolyData(sphere)));
  const std::vector<double> first = ProbeArray(probe, "Linear");
  for (int step = 0; step < 5; ++step)
  {
    probe->SetSourceData(WithData(MakePolyData(sphere))); // its cells are not built yet
    EXPECT_EQ(ProbeArray(probe, "Linear"), first);
    EXPECT_EQ(Reported(probe, "TreesBuilt"), 0);
  }
  vtkSMPTools::Initialize();
  EXPECT_EQ(Reported(probe, "PointsFound"), 20000);
}

TEST(Probe, ProgressRisesAndAnAbortLeavesNone)
{
  auto source = WithData(MakeGrid(Hexahedra(4)));
  auto input = MakeQueries(RandomQueries(source, 50000));
  ProbePointer probe = MakeProbe(input, source);
  probe->SetOutsidePoints(vtkSkdTreeProbe::NEAREST_CELL);
  const std::vector<double> progress = AbortAt(probe, 0.5);
  EXPECT_TRUE(std::is_sorted(progress.begin(), progress.end()));
  const std::vector<double> left = PointArray(probe->GetOutput(), "SkdValid");
  EXPECT_TRUE(left.empty() || std::count(left.begin(), left.end(), 0) > 0);
  ProbeArray(probe, "SkdValid");
  EXPECT_EQ(Reported(probe, "PointsFound"), 50000);
}

TEST(Probe, BadInputGivesAWarningAndNoAnswers)
{
  const NoSources none;
  for (vtkDataObject* source : none.All())
  {
    ProbePointer probe = MakeProbe(MakeLine({ { 0, 0, 0 }, { 1, 2, 3 } }), source);
    probe->SetOutsidePoints(vtkSkdTreeProbe::NEAREST_CELL);
    probe->ProbeLinesOn();
    EventCounter events(probe);
    EXPECT_EQ(ProbeArray(probe, "SkdValid"), (std::vector<double>{ 0, 0 }));
    EXPECT_EQ(events.Warnings, source == none.NotFinite ? 2 : 1)
      << events.Warning; // one counts points
    EXPECT_EQ(events.Errors, 0) << events.Error;
  }
  auto source = WithData(MakeGrid(Hexahedra(1)));
  ProbePointer probe = MakeProbe(MakeQueries({ { 0.5, 0.5, 0.5 } }), source);
  probe->AddGradientArray("Nothing");
  EventCounter events(probe);
  EXPECT_EQ(ProbeArray(probe, "SkdValid")[0], 1);
  EXPECT_EQ(events.Warnings, 1);
  EXPECT_NE(events.Warning.find("Nothing"), std::string::npos);
  probe->ClearGradientArrays();
  ProbeArray(probe, "SkdValid");
  EXPECT_EQ(events.Warnings, 1);
}

}
