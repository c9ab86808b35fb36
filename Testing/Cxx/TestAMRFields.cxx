// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeAMR: refinement by the normalised second difference of a field, and relative
// thresholds.

#include "Support/AMRRun.h"
#include "Support/FilterRun.h"
#include "Support/NamedMeshes.h"

#include "Core/Geometry/Box.h"
#include "Meshing/Refine/SkdSecondDifference.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

using namespace skdtest;
using namespace skdtree;

namespace
{

using Field = std::function<double(const Point&)>;

const Bounds Square = { 0, 1, 0, 1, 0, 1 };

/// Fields on n cells along each axis of the unit cube.
vtkSmartPointer<vtkImageData> MakeFields(
  int n, const std::vector<std::pair<const char*, Field>>& fields)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(n + 1, n + 1, n + 1);
  image->SetSpacing(1.0 / n, 1.0 / n, 1.0 / n);
  for (const auto& [name, field] : fields)
  {
    vtkNew<vtkDoubleArray> values;
    values->SetName(name);
    for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
    {
      Point x;
      image->GetPoint(i, x.data());
      values->InsertNextValue(field(x));
    }
    image->GetPointData()->AddArray(values);
  }
  return image;
}

/// A filter that refines by fields alone: its only part is a point in a corner.
AMRPointer MakeFieldAMR(vtkDataObject* field, int level)
{
  AMRPointer filter = MakeAMRIn(MakeQueries({ { 0, 0, 0 } }), level, Square);
  filter->SetBaseDimensions(4, 4, 4);
  filter->AddPartLevel(0, 0);
  filter->SetFieldData(field);
  return filter;
}

bool IsNearFront(const Bounds& box, double front)
{
  return box[0] <= front && front <= box[1];
}

double Step(double x)
{
  return std::tanh((x - 0.4) / 0.002);
}

std::vector<Leaf> RunWith(vtkDataObject* field, const char* name, double threshold)
{
  AMRPointer filter = MakeFieldAMR(field, 3);
  filter->AddFieldArray(name);
  filter->SetFieldTest(vtkSkdTreeAMR::SECOND_DIFFERENCE);
  filter->SetFieldThreshold(threshold);
  return RunLeaves(filter);
}

}

TEST(AMRFields, SecondDifferencesFindAFrontWhateverTheUnit)
{
  const auto field = MakeFields(64,
    { { "step", [](const Point& x) { return Step(x[0]); } },
      { "tiny", [](const Point& x) { return 1e-12 * Step(x[0]); } },
      { "slope", [](const Point& x) { return 100.0 * x[0] - 3.0 * x[1]; } },
      { "constant", [](const Point&) { return 7.0; } } });
  const std::vector<Leaf> leaves = RunWith(field, "step", 0.5);
  for (const Leaf& leaf : leaves)
  {
    EXPECT_TRUE(leaf.Level == 3 || !IsNearFront(leaf.Box, 0.4 + 1e-6)) << leaf.Box[0];
    EXPECT_TRUE(leaf.Level <= 1 || std::abs(0.5 * (leaf.Box[0] + leaf.Box[1]) - 0.4) < 0.25);
  }
  EXPECT_EQ(RunWith(field, "tiny", 0.5).size(), leaves.size());
  EXPECT_EQ(RunWith(field, "slope", 0.1).size(), 64u);
  EXPECT_EQ(RunWith(field, "constant", 0.0).size(), 64u);
}

TEST(AMRFields, SecondDifferencesAreThoseOfTheFormula)
{
  const skd::Box3 box({ { 1.0, 2.0, 3.0 } }, { { 2.0, 4.0, 4.0 } });
  const auto find = [&box](const auto& f) { return SkdSecondDifference(box, f).Find(); };
  EXPECT_EQ(find([](const skd::Vector3&) { return 3.0; }), 0.0);
  EXPECT_LT(find([](const skd::Vector3& x) { return x[0] - 2.0 * x[1] + 5.0 * x[2]; }), 1e-14);
  EXPECT_EQ(find([](const skd::Vector3&) { return std::nan(""); }), 0.0);
  // Along x alone: values 0, 0 and 1 at three points.
  const skd::Box3 line({ { -1.0, 0.0, 0.0 } }, { { 1.0, 0.0, 0.0 } });
  const auto corner = [](const skd::Vector3& x) { return std::max(x[0], 0.0); };
  EXPECT_DOUBLE_EQ(SkdSecondDifference(line, corner).Find(), 1.0 / (1.0 + 0.01));
  // x y in a square: no second difference along an axis, a mixed one of 1.
  const skd::Box3 square({ { -1.0, -1.0, 0.0 } }, { { 1.0, 1.0, 0.0 } });
  const auto saddle = [](const skd::Vector3& x) { return x[0] * x[1]; };
  EXPECT_DOUBLE_EQ(SkdSecondDifference(square, saddle).Find(),
    std::sqrt(2.0) * 1.0 / (std::sqrt(2.0) * (1.0 + 0.01)));
  // Where a side has no value the other axes count.
  const auto half = [](const skd::Vector3& x) { return x[1] > 0.5 ? NAN : std::max(x[0], 0.0); };
  EXPECT_DOUBLE_EQ(SkdSecondDifference(square, half).Find(), 1.0 / (1.0 + 0.01));
}

TEST(AMRFields, RelativeThresholdsFitArraysOfAnyUnit)
{
  const auto hill = [](const Point& x)
  { return std::exp(-20.0 * (std::pow(x[0] - 0.3, 2) + std::pow(x[1] - 0.6, 2))); };
  const auto field = MakeFields(
    32, { { "one", hill }, { "other", [&](const Point& x) { return 5e6 + 3e6 * hill(x); } } });
  for (const int test :
    { vtkSkdTreeAMR::DIFFERENCE, vtkSkdTreeAMR::GRADIENT, vtkSkdTreeAMR::VALUE })
  {
    std::size_t sizes[2];
    std::size_t k = 0;
    for (const char* name : { "one", "other" })
    {
      AMRPointer filter = MakeFieldAMR(field, 3);
      filter->AddFieldArray(name);
      filter->SetFieldTest(test);
      filter->SetFieldThreshold(test == vtkSkdTreeAMR::GRADIENT ? 4.0 : 0.1);
      filter->SetFieldRange(0.5, 1.0);
      filter->RelativeFieldThresholdOn();
      sizes[k++] = RunLeaves(filter).size();
    }
    EXPECT_GT(sizes[0], 200u);
    EXPECT_LT(sizes[0], 20000u);
    EXPECT_EQ(sizes[0], sizes[1]) << test;
  }
}

TEST(AMRFields, SeveralArraysRefineWhereAnyOfThemVaries)
{
  const auto field = MakeFields(64,
    { { "x", [](const Point& x) { return Step(x[0]); } },
      { "y", [](const Point& x) { return 1e9 * Step(x[1]); } } });
  AMRPointer filter = MakeFieldAMR(field, 2);
  filter->SetFieldTest(vtkSkdTreeAMR::SECOND_DIFFERENCE);
  filter->SetFieldThreshold(0.5);
  filter->AddFieldArray("x");
  filter->AddFieldArray("y");
  int found = 0;
  for (const Leaf& leaf : RunLeaves(filter))
  {
    const Bounds rotated = { leaf.Box[2], leaf.Box[3], 0, 0, 0, 0 };
    const bool isNear = IsNearFront(leaf.Box, 0.4 + 1e-6) || IsNearFront(rotated, 0.4 + 1e-6);
    EXPECT_TRUE(!isNear || leaf.Level == 2);
    found += isNear;
  }
  EXPECT_GT(found, 100);
}

TEST(AMRFields, ConstantAndEmptyArraysRefineNothing)
{
  const auto field = MakeFields(8,
    { { "constant", [](const Point&) { return 2.0; } },
      { "nan", [](const Point&) { return NAN; } } });
  for (const int test :
    { vtkSkdTreeAMR::DIFFERENCE, vtkSkdTreeAMR::GRADIENT, vtkSkdTreeAMR::SECOND_DIFFERENCE })
  {
    for (const char* name : { "constant", "nan" })
    {
      AMRPointer filter = MakeFieldAMR(field, 2);
      filter->AddFieldArray(name);
      filter->SetFieldTest(test);
      filter->RelativeFieldThresholdOn();
      EXPECT_EQ(RunLeaves(filter).size(), 64u) << test << name;
    }
  }
}

namespace
{

/// The sum of a cell array times volumes and coverages.
double IntegralOf(vtkDataSet* leaves, const char* name)
{
  double sum = 0.0;
  for (vtkIdType cell = 0; cell < leaves->GetNumberOfCells(); ++cell)
  {
    Bounds b;
    leaves->GetCellBounds(cell, b.data());
    double volume = 1.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double length = b[2 * axis + 1] - b[2 * axis];
      volume *= length > 0.0 ? length : 1.0;
    }
    const double covered = leaves->GetCellData()->GetArray("SkdCoverage")->GetTuple1(cell);
    const double value = leaves->GetCellData()->GetArray(name)->GetTuple1(cell);
    sum += covered > 0.0 ? volume * covered * value : 0.0;
  }
  return sum;
}

}

TEST(AMRFields, CellsHaveTheFieldConservatively)
{
  const auto field = MakeFields(12,
    { { "linear", [](const Point& x) { return 1.0 + x[0] - 2.0 * x[1] + 3.0 * x[2]; } },
      { "hill", [](const Point& x) { return std::exp(-20.0 * std::pow(x[0] - 0.3, 2)); } } });
  for (const bool isPartly : { false, true })
  {
    AMRPointer filter =
      MakeAMRIn(MakePolyData(Transformed(SphereTriangles(8), 0.2, { 0.3, 0.4, 0.5 })), 3,
        isPartly ? Bounds{ -0.5, 1.25, -0.25, 1.5, -0.125, 1.0 } : Square);
    filter->SetBaseDimensions(3, 3, 3);
    filter->SetFieldData(field);
    filter->ComputeFieldOn();
    EventCounter events(filter);
    RunLeaves(filter);
    EXPECT_EQ(events.Errors, 0);
    auto* leaves = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
    // Of trilinear cells the mean of the points is the mean of the cell.
    double sums[2] = { 0.0, 0.0 };
    for (vtkIdType cell = 0; cell < field->GetNumberOfCells(); ++cell)
    {
      vtkIdList* ids = field->GetCell(cell)->GetPointIds();
      for (vtkIdType i = 0; i < 8; ++i)
      {
        for (int k = 0; k < 2; ++k)
        {
          sums[k] +=
            field->GetPointData()->GetArray(k)->GetTuple1(ids->GetId(i)) / 8.0 / std::pow(12.0, 3);
        }
      }
    }
    EXPECT_NEAR(IntegralOf(leaves, "linear"), sums[0], 1e-12);
    EXPECT_NEAR(IntegralOf(leaves, "hill"), sums[1], 1e-12);
  }
}

TEST(AMRFields, RefinedCellsHaveTheMeansOfTheirChildren)
{
  const auto field = MakeFields(8, { { "x", [](const Point& x) { return x[0]; } } });
  AMRPointer filter = MakeAMRIn(MakeQueries({ { 0.1, 0.1, 0.1 } }), 3, Square);
  filter->SetOutputType(vtkSkdTreeAMR::HYPER_TREE_GRID);
  filter->SetBaseDimensions(1, 1, 1);
  filter->SetFieldData(field);
  filter->ComputeFieldOn();
  filter->Update();
  auto* data = filter->GetOutputDataObject(0)->GetAttributes(vtkDataObject::CELL);
  ASSERT_TRUE(data->GetArray("x"));
  EXPECT_NEAR(data->GetArray("x")->GetTuple1(0), 0.5, 1e-14);
  EXPECT_EQ(data->GetArray("SkdCoverage")->GetTuple1(0), 1.0);
}

TEST(AMRFields, AFieldOfAnotherDimensionIsWarnedOf)
{
  AMRPointer filter = MakeAMRIn(MakePolyData(SphereTriangles(4)), 2, Square);
  filter->SetFieldData(MakePolyData(SphereTriangles(4)));
  filter->ComputeFieldOn();
  EventCounter events(filter);
  filter->Update();
  EXPECT_EQ(events.Warnings, 1);
  EXPECT_NE(events.Warning.find("ComputeField is ignored"), std::string::npos);
}

TEST(AMRFields, TheEstimateOfCellsIsRightToFivePercent)
{
  const auto field = MakeFields(
    48, { { "hill", [](const Point& x) {
             return std::exp(-30.0 * (std::pow(x[0] - 0.3, 2) + std::pow(x[1] - x[2], 2)));
           } } });
  for (const int test : { vtkSkdTreeAMR::DIFFERENCE, vtkSkdTreeAMR::SECOND_DIFFERENCE })
  {
    AMRPointer filter = MakeFieldAMR(field, 3);
    filter->AddFieldArray("hill");
    filter->SetFieldTest(test);
    filter->SetFieldThreshold(0.1);
    filter->Update();
    EXPECT_GT(Reported(filter, "AllCells"), 5000);
    EXPECT_NEAR(Reported(filter, "EstimatedCells") / Reported(filter, "AllCells"), 1.0, 0.05);
  }
}
