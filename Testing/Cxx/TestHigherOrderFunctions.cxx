// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// The interpolation functions of Lagrange and Bezier triangles, tetrahedra and wedges: those of VTK
// where these do not take too long, and of all orders those of the points' places.

#include "Cells/Read/SkdCellFunctions.h"
#include "Support/CellZoo.h"
#include "Support/CurveRun.h"

#include <gtest/gtest.h>

using namespace skdtest;

namespace
{

struct Kind
{
  int Type;
  int Order;
  bool IsRational;
};

void PrintTo(const Kind& kind, std::ostream* os)
{
  *os << (kind.IsRational ? "Rational" : "") << NameOfType(kind.Type) << kind.Order;
}

std::vector<Kind> KindsUpTo(int order)
{
  std::vector<Kind> kinds;
  for (int i = 1; i <= order; ++i)
  {
    for (const int type : { VTK_LAGRANGE_TRIANGLE, VTK_LAGRANGE_TETRAHEDRON, VTK_LAGRANGE_WEDGE })
    {
      kinds.push_back({ type, i, false });
    }
    for (const int type : { VTK_BEZIER_TRIANGLE, VTK_BEZIER_TETRAHEDRON, VTK_BEZIER_WEDGE })
    {
      kinds.push_back({ type, i, false });
      kinds.push_back({ type, i, true });
    }
  }
  return kinds;
}

/// A cell, some points of it, its corners, middles of edges, and points about it.
class HigherOrderFunctions : public testing::TestWithParam<Kind>
{
protected:
  void SetUp() override
  {
    Random random(31);
    const Mesh mesh = ReferenceCell(GetParam().Type, GetParam().Order);
    this->Grid = MakeGrid(mesh);
    if (GetParam().IsRational)
    {
      std::vector<double> weights(mesh.Points.size());
      std::generate(weights.begin(), weights.end(), [&] { return random.Between(0.5, 2.0); });
      SetRationalWeights(this->Grid, weights);
    }
    this->Grid->GetCell(0, this->Loaded);
    this->Cell = this->Loaded->GetRepresentativeCell();
    for (const double r : { 0.0, 0.5, 1.0, 0.3, -0.1 })
    {
      for (const double s : { 0.0, 0.5, 1.0, 0.2 })
      {
        for (const double t : { 0.0, 0.5, 1.0, 0.4 })
        {
          this->PCoords.push_back({ r, s, this->Cell->GetCellDimension() == 3 ? t : 0.0 });
        }
      }
    }
  }

  std::vector<double> At(const Point& pcoords)
  {
    std::vector<double> values(this->Cell->GetNumberOfPoints());
    skdtree::SkdCellFunctions::Interpolate(this->Loaded, pcoords.data(), values.data());
    return values;
  }

  GridPointer Grid;
  vtkNew<vtkGenericCell> Loaded;
  vtkCell* Cell = nullptr;
  std::vector<Point> PCoords;
};

using HigherOrderFunctionsOfVtk = HigherOrderFunctions;
INSTANTIATE_TEST_SUITE_P(All, HigherOrderFunctionsOfVtk, testing::ValuesIn(KindsUpTo(3)),
  [](const auto& info) { return testing::PrintToString(info.param); });

TEST_P(HigherOrderFunctionsOfVtk, AreTheSame)
{
  std::vector<double> expected(this->Cell->GetNumberOfPoints());
  for (const Point& p : this->PCoords)
  {
    this->Cell->InterpolateFunctions(p.data(), expected.data());
    const std::vector<double> values = this->At(p);
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      ASSERT_NEAR(values[i], expected[i], 1e-13 * (1.0 + std::abs(expected[i]))) << "point " << i;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, HigherOrderFunctions, testing::ValuesIn(KindsUpTo(9)),
  [](const auto& info) { return testing::PrintToString(info.param); });

/// Multiplied by the rational weights: a map whose points are at their places is none.
TEST_P(HigherOrderFunctions, BelongToThePlacesOfPoints)
{
  const double* places = this->Cell->GetParametricCoords();
  const double* weights = skdtree::SkdCellFunctions::RationalWeights(this->Cell);
  ASSERT_EQ(weights != nullptr, GetParam().IsRational);
  for (const Point& p : this->PCoords)
  {
    const std::vector<double> values = this->At(p);
    double sum = 0.0;
    double magnitude = 0.0; // far outside large values cancel
    Point moment{ 0.0, 0.0, 0.0 };
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      const double value = weights ? values[i] / weights[i] : values[i];
      sum += value;
      magnitude += std::abs(value);
      moment = moment + value * Point{ places[3 * i], places[3 * i + 1], places[3 * i + 2] };
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      ASSERT_NEAR(moment[axis], p[axis] * sum, 1e-13 * magnitude) << "order " << GetParam().Order;
    }
  }
}

/// Where all is at one corner, rounding adds nothing.
TEST_P(HigherOrderFunctions, AreExactAtCorners)
{
  const std::vector<double> values = this->At({ 0.0, 0.0, 0.0 });
  EXPECT_NEAR(values[0], 1.0, 1e-15);
  EXPECT_EQ(
    std::count(values.begin(), values.end(), 0.0), static_cast<std::ptrdiff_t>(values.size()) - 1);
}

}
