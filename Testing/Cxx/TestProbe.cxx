// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeProbe on every kind of mesh: which cell, where in it, and the data there.

#include "Support/BruteForce.h"
#include "Support/NamedMeshes.h"
#include "Support/ProbeRun.h"

#include "vtkIdList.h"
#include "vtkProbeFilter.h"
#include "vtkSMPTools.h"

#include <gtest/gtest.h>

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
  const PointsInCells requested = MakePointsInCells(this->Source, 500);
  ProbePointer probe = MakeProbe(MakeQueries(requested.Points), this->Source);
  const std::vector<double> valid = ProbeArray(probe, "SkdValid");
  const std::vector<double> field = ProbeArray(probe, "Linear");
  const std::vector<double> number = ProbeArray(probe, "Number");
  const std::vector<double> cells = ProbeArray(probe, "SkdSourceCellId");
  const std::vector<double> distances = ProbeArray(probe, "SkdDistance");
  ASSERT_EQ(field.size(), requested.Points.size());
  BruteForce reference(this->Source);
  for (std::size_t i = 0; i < field.size(); ++i)
  {
    ASSERT_EQ(valid[i], 1) << i;
    ASSERT_LT(distances[i], 1e-12 * this->Scale()) << i;
    ASSERT_NEAR(field[i], Linear(requested.Points[i]), 1e-12 * this->Scale() * 10) << i;
    ASSERT_EQ(number[i], 10.0 * cells[i]);
    ASSERT_LT(reference.DistanceTo(static_cast<vtkIdType>(cells[i]), requested.Points[i]),
      2 * reference.Tolerance());
  }
  EXPECT_EQ(Reported(probe, "PointsFound"), 500);
  EXPECT_EQ(Reported(probe, "PointsOutside"), 0);
}

TEST_P(ProbeInVolume, GradientsOfLinearFieldsAreExact)
{
  const PointsInCells requested = MakePointsInCells(this->Source, 200);
  ProbePointer probe = MakeProbe(MakeQueries(requested.Points), this->Source);
  probe->AddGradientArray("Linear");
  const std::vector<double> cells = ProbeArray(probe, "SkdSourceCellId");
  const std::vector<double> gradients = ProbeArray(probe, "Linear_Gradient");
  ASSERT_EQ(gradients.size(), 3 * requested.Points.size());
  for (std::size_t i = 0; i < requested.Points.size(); ++i)
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
  // VTK makes the cells of points at the first call, without a lock, and its filter has threads.
  vtkNew<vtkIdList> ofFirst;
  this->Source->GetPointCells(0, ofFirst);
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

}
