// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeProbe at points: which cell, where in it, and the data there.

#include "Support/BruteForce.h"
#include "Support/EventCounter.h"
#include "Support/NamedMeshes.h"
#include "Support/ProbeRun.h"

#include "vtkImageData.h"
#include "vtkProbeFilter.h"
#include "vtkSMPTools.h"
#include "vtkStringArray.h"

#include <gtest/gtest.h>

#include <cstring>

using namespace skdtest;

namespace
{

class ProbeOnMesh : public testing::TestWithParam<NamedMesh>
{
protected:
  void SetUp() override { this->Source = WithData(GetParam().Make()); }

  double Scale() const
  {
    Bounds box;
    this->Source->GetBounds(box.data());
    return 1.0 + Diagonal(box);
  }

  DataSetPointer Source;
};

class ProbeInVolume : public ProbeOnMesh
{
};

INSTANTIATE_TEST_SUITE_P(All, ProbeOnMesh, testing::ValuesIn(AllMeshes()), NameOfMesh());
INSTANTIATE_TEST_SUITE_P(All, ProbeInVolume, testing::ValuesIn(VolumeMeshes()), NameOfMesh());

TEST_P(ProbeInVolume, NoPointWithinACellIsMissedAndLinearFieldsAreExact)
{
  const PointsInCells asked = MakePointsInCells(this->Source, 500);
  ProbePointer probe = MakeProbe(MakeQueries(asked.Points), this->Source);
  const std::vector<double> valid = ProbeArray(probe, "SkdValid");
  const std::vector<double> field = ProbeArray(probe, "Linear");
  const std::vector<double> number = ProbeArray(probe, "Number");
  const std::vector<double> cells = ProbeArray(probe, "SkdSourceCellId");
  const std::vector<double> distances = ProbeArray(probe, "SkdDistance");
  ASSERT_EQ(field.size(), asked.Points.size());
  BruteForce reference(this->Source);
  for (std::size_t i = 0; i < field.size(); ++i)
  {
    ASSERT_EQ(valid[i], 1) << i;
    ASSERT_LT(distances[i], 1e-12 * this->Scale()) << i;
    ASSERT_NEAR(field[i], Linear(asked.Points[i]), 1e-12 * this->Scale() * 10) << i;
    ASSERT_EQ(number[i], 10.0 * cells[i]);
    ASSERT_LT(reference.DistanceTo(static_cast<vtkIdType>(cells[i]), asked.Points[i]),
      2 * reference.Tolerance());
  }
  EXPECT_EQ(Reported(probe, "PointsFound"), 500);
  EXPECT_EQ(Reported(probe, "PointsOutside"), 0);
}

TEST_P(ProbeInVolume, GradientsOfLinearFieldsAreExact)
{
  const PointsInCells asked = MakePointsInCells(this->Source, 200);
  ProbePointer probe = MakeProbe(MakeQueries(asked.Points), this->Source);
  probe->AddGradientArray("Linear");
  const std::vector<double> cells = ProbeArray(probe, "SkdSourceCellId");
  const std::vector<double> gradients = ProbeArray(probe, "Linear_Gradient");
  ASSERT_EQ(gradients.size(), 3 * asked.Points.size());
  for (std::size_t i = 0; i < asked.Points.size(); ++i)
  {
    if (this->Source->GetCell(static_cast<vtkIdType>(cells[i]))->GetCellDimension() == 3)
    {
      ASSERT_NEAR(gradients[3 * i], 3.0, 1e-10) << i;
      ASSERT_NEAR(gradients[3 * i + 1], -2.0, 1e-10) << i;
      ASSERT_NEAR(gradients[3 * i + 2], 0.5, 1e-10) << i;
    }
  }
}

TEST_P(ProbeOnMesh, AtAllPointsOfTheMeshTheDataAreTheMeshsOwn)
{
  ProbePointer probe = MakeProbe(this->Source, this->Source);
  probe->PassInputDataOff();
  const std::vector<double> field = ProbeArray(probe, "Linear");
  const std::vector<double> valid = ProbeArray(probe, "SkdValid");
  const std::vector<double> own = PointArray(this->Source, "Linear");
  ASSERT_EQ(field.size(), own.size());
  std::vector<bool> isUsed(own.size(), false);
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < this->Source->GetNumberOfCells(); ++cell)
  {
    this->Source->GetCellPoints(cell, ids);
    for (vtkIdType id : *ids)
    {
      isUsed[id] = true;
    }
  }
  for (std::size_t i = 0; i < own.size(); ++i)
  {
    if (isUsed[i])
    {
      ASSERT_EQ(valid[i], 1) << i;
      ASSERT_NEAR(field[i], own[i], 1e-11 * this->Scale()) << i;
    }
  }
}

TEST_P(ProbeOnMesh, NearestCellGivesEveryPointAnAnswer)
{
  const std::vector<Point> points = RandomQueries(this->Source, 100);
  BruteForce reference(this->Source);
  ProbePointer probe = MakeProbe(MakeQueries(points), this->Source);
  probe->SetOutsidePoints(vtkSkdTreeProbe::NEAREST_CELL);
  const std::vector<double> distances = ProbeArray(probe, "SkdDistance");
  const std::vector<double> valid = ProbeArray(probe, "SkdValid");
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    ASSERT_EQ(valid[i], 1);
    ASSERT_NEAR(distances[i], reference.FindNearest(points[i]).Distance, reference.Tolerance())
      << i;
  }

  Bounds box;
  this->Source->GetBounds(box.data());
  const double radius = 0.1 * Diagonal(box);
  probe->SetOutsidePoints(vtkSkdTreeProbe::NEAREST_CELL_WITHIN_DISTANCE);
  probe->SetMaximumDistance(radius);
  const std::vector<double> within = ProbeArray(probe, "SkdValid");
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    ASSERT_EQ(within[i] == 1, distances[i] <= radius) << i;
  }
}

TEST_P(ProbeOnMesh, HasNeverFewerPointsThanVtksProbe)
{
  std::vector<Point> points = RandomQueries(this->Source, 400);
  const PointsInCells inside = MakePointsInCells(this->Source, 100);
  points.insert(points.end(), inside.Points.begin(), inside.Points.end());
  auto input = MakeQueries(points);
  vtkNew<vtkProbeFilter> other;
  other->SetInputData(input);
  other->SetSourceData(this->Source);
  other->Update();
  const std::vector<double> theirs = PointArray(other->GetOutput(), "vtkValidPointMask");
  ProbePointer probe = MakeProbe(input, this->Source);
  const std::vector<double> ours = ProbeArray(probe, "SkdValid");
  ASSERT_EQ(theirs.size(), ours.size());
  BruteForce reference(this->Source);
  for (std::size_t i = 0; i < ours.size(); ++i)
  {
    // vtkPolyhedron takes some points for its own that are outside.
    const auto nearest = reference.FindNearest(points[i]);
    const double tolerance = 1e-3 * std::sqrt(this->Source->GetCell(nearest.Cell)->GetLength2());
    const bool isWrong = nearest.Distance > tolerance;
    ASSERT_TRUE(ours[i] == 1 || theirs[i] == 0 || isWrong) << i;
  }
}

TEST_P(ProbeOnMesh, BitsAreTheSameForAnyNumberOfThreads)
{
  auto input = MakeQueries(RandomQueries(this->Source, 5000));
  std::vector<std::vector<double>> answers;
  for (int threads : { 1, 2, 4 })
  {
    vtkSMPTools::Initialize(threads);
    ProbePointer probe = MakeProbe(input, this->Source);
    probe->SetOutsidePoints(vtkSkdTreeProbe::NEAREST_CELL);
    answers.push_back(ProbeArray(probe, "Linear"));
    const std::vector<double> cells = ProbeArray(probe, "SkdSourceCellId");
    answers.back().insert(answers.back().end(), cells.begin(), cells.end());
  }
  vtkSMPTools::Initialize();
  EXPECT_EQ(answers[0], answers[1]);
  EXPECT_EQ(answers[0], answers[2]);
}

//------------------------------------------------------------------------------
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
  probe->SetAbsoluteTolerance(NAN);
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
  const PointsInCells asked = MakePointsInCells(MakeGrid(cubes), 300);
  ProbePointer probe = MakeProbe(MakeQueries(asked.Points), blocks);
  const std::vector<double> index = ProbeArray(probe, "SkdSourceBlockIndex");
  const std::vector<double> cells = ProbeArray(probe, "SkdSourceCellId");
  const std::vector<double> field = ProbeArray(probe, "Linear");
  const double flat[3] = { 1, 4, 5 };
  for (std::size_t i = 0; i < asked.Points.size(); ++i)
  {
    ASSERT_EQ(index[i], flat[asked.Cells[i] % 3]);
    ASSERT_EQ(cells[i], asked.Cells[i] / 3);
    ASSERT_NEAR(field[i], Linear(asked.Points[i]), 1e-11);
  }
  EXPECT_EQ(Reported(probe, "TreesBuilt"), 3);
}

TEST(Probe, CategoricalArraysAreThoseOfTheNearestPoint)
{
  auto source = WithData(MakeGrid(Hexahedra(3).Map(Bent)));
  auto labels = MakeArray<vtkIntArray>(
    "Label", source->GetNumberOfPoints(), [](vtkIdType i) { return 100.0 * i; });
  source->GetPointData()->AddArray(labels);
  const PointsInCells asked = MakePointsInCells(source, 200);
  ProbePointer probe = MakeProbe(MakeQueries(asked.Points), source);
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
      ASSERT_LE(Distance(p, asked.Points[i]), Distance(q, asked.Points[i]) + 1e-14);
    }
  }
}

TEST(Probe, GradientsAlongSurfacesAndOfVectors)
{
  auto sheet = MakeGrid(Sheet(4, VTK_QUAD).Map(Turned));
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
  const PointsInCells asked = MakePointsInCells(sheet, 50);
  ProbePointer probe = MakeProbe(MakeQueries(asked.Points), sheet);
  probe->AddGradientArray("V");
  const std::vector<double> g = ProbeArray(probe, "V_Gradient");
  ASSERT_EQ(g.size(), 6 * asked.Points.size());
  const Point normal = Turned({ 0, 0, 1 });
  for (std::size_t i = 0; i < asked.Points.size(); ++i)
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

TEST(Probe, ProgressRisesAndAnAbortLeavesNone)
{
  auto source = WithData(MakeGrid(Hexahedra(4)));
  auto input = MakeQueries(RandomQueries(source, 50000));
  ProbePointer probe = MakeProbe(input, source);
  probe->SetOutsidePoints(vtkSkdTreeProbe::NEAREST_CELL);
  {
    ProgressWatch watch(probe, 0.5);
    probe->Update();
    EXPECT_TRUE(std::is_sorted(watch.Seen.begin(), watch.Seen.end()));
    probe->RemoveAllObservers();
  }
  const std::vector<double> left = PointArray(probe->GetOutput(), "SkdValid");
  EXPECT_TRUE(left.empty() || std::count(left.begin(), left.end(), 0) > 0);
  probe->SetAbortExecute(0);
  probe->Modified();
  ProbeArray(probe, "SkdValid");
  EXPECT_EQ(Reported(probe, "PointsFound"), 50000);
}

TEST(Probe, BadInputGivesOneWarningAndNoAnswers)
{
  vtkNew<vtkPolyData> empty;
  auto broken = MakePolyData(Octahedron(1).Map([](const Point&) { return Point{ NAN, 0, 0 }; }));
  auto blocks = MakeBlocks({ nullptr, empty });
  for (vtkDataObject* source : std::vector<vtkDataObject*>{ empty, broken, blocks })
  {
    ProbePointer probe = MakeProbe(MakeLine({ { 0, 0, 0 }, { 1, 2, 3 } }), source);
    probe->SetOutsidePoints(vtkSkdTreeProbe::NEAREST_CELL);
    probe->ProbeLinesOn();
    EventCounter events(probe);
    EXPECT_EQ(ProbeArray(probe, "SkdValid"), (std::vector<double>{ 0, 0 }));
    EXPECT_EQ(events.Warnings, 1) << events.Warning;
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
