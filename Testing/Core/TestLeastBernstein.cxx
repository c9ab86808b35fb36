// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// Polynomials in Bernstein form on products of simplices: their parts, and their least values.

#include "Core/Geometry/Cells/DistanceForm.h"
#include "Core/Geometry/Cells/LeastBernstein.h"

#include "Dice.h"

#include <gtest/gtest.h>

namespace
{

using namespace skd;
using coretest::Dice;

class BernsteinForms : public testing::TestWithParam<BernsteinLayout>
{
protected:
  Dice TheDice{ 77 };

  std::vector<double> RandomValues()
  {
    std::vector<double> values(static_cast<std::size_t>(GetParam().Size));
    std::generate(
      values.begin(), values.end(), [this] { return this->TheDice.Between(-1.0, 1.0); });
    return values;
  }

  /// Within the domain of a layout.
  Vector3 RandomPoint(const BernsteinLayout& layout)
  {
    for (;;)
    {
      Vector3 p{};
      double sum = 0.0;
      for (int axis = 0; axis < layout.Dimension; ++axis)
      {
        p[axis] = this->TheDice.Between(0.0, 1.0);
        sum += layout.IsInSimplex(axis) ? p[axis] : 0.0;
      }
      if (sum <= 1.0)
      {
        return p;
      }
    }
  }
};

std::string NameOfLayout(const testing::TestParamInfo<BernsteinLayout>& info)
{
  const BernsteinLayout& layout = info.param;
  return "Axes" + std::to_string(layout.Dimension) + "Simplex" +
    std::to_string(layout.SimplexAxes) + "Degrees" + std::to_string(layout.Degree[0]) +
    std::to_string(layout.Degree[1]) + std::to_string(layout.Degree[2]);
}

INSTANTIATE_TEST_SUITE_P(All, BernsteinForms,
  testing::Values(BernsteinLayout(1, 0, { 5, 0, 0 }), BernsteinLayout(2, 0, { 3, 4, 0 }),
    BernsteinLayout(2, 2, { 4, 4, 0 }), BernsteinLayout(3, 0, { 2, 3, 4 }),
    BernsteinLayout(3, 3, { 4, 4, 4 }), BernsteinLayout(3, 2, { 4, 4, 3 })),
  NameOfLayout);

Vector3 ToWhole(const BernsteinPart& part, const Vector3& u)
{
  Vector3 p = part.Origin;
  for (int axis = 0; axis < part.Layout.Dimension; ++axis)
  {
    p = p + u[axis] * part.Legs[axis];
  }
  return p;
}

BernsteinPart WholeOf(const BernsteinLayout& layout, double* values)
{
  return { layout, {}, { { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 1 } } }, values };
}

double ValueAt(const BernsteinLayout& layout, const double* values, const Vector3& p)
{
  return BernsteinWeights(layout, p).Sum(values).Value;
}

TEST_P(BernsteinForms, GradientsAreDifferencesOfValues)
{
  const auto values = this->RandomValues();
  for (int i = 0; i < 20; ++i)
  {
    const Vector3 p = this->RandomPoint(GetParam());
    const BernsteinPoint point = BernsteinWeights(GetParam(), p).Sum(values.data());
    for (int axis = 0; axis < GetParam().Dimension; ++axis)
    {
      constexpr double h = 1e-5;
      Vector3 before = p;
      Vector3 after = p;
      before[axis] -= h;
      after[axis] += h;
      const double slope =
        (ValueAt(GetParam(), values.data(), after) - ValueAt(GetParam(), values.data(), before)) /
        (2.0 * h);
      ASSERT_NEAR(point.Gradient[axis], slope, 1e-6);
    }
  }
}

TEST_P(BernsteinForms, PartsHaveTheValuesOfTheWhole)
{
  const auto whole = this->RandomValues();
  auto values = whole;
  std::vector<double> others(values.size());
  BernsteinPart part = WholeOf(GetParam(), values.data());
  const auto check = [&](const BernsteinPart& p)
  {
    const Vector3 u = this->RandomPoint(p.Layout);
    const double value = ValueAt(p.Layout, p.Values, u);
    ASSERT_NEAR(value, ValueAt(GetParam(), whole.data(), ToWhole(p, u)), 1e-12);
    const NumberRange range = p.Range();
    ASSERT_GE(value, range.Min - 1e-12);
    ASSERT_LE(value, range.Max + 1e-12);
  };
  for (int i = 0; i < 12; ++i)
  {
    const int axis = i % GetParam().Dimension;
    BernsteinPart other;
    other.Values = others.data();
    part.SplitOff(axis, other);
    check(part);
    check(other);
    if (i % 3 == 1)
    {
      part.Reverse(axis);
      check(part);
    }
    if (i % 4 == 3)
    {
      std::swap(part, other);
      std::copy(others.begin(), others.end(), values.begin());
      part.Values = values.data();
    }
  }
  while (part.Layout.Dimension > 0)
  {
    part.Collapse(part.Layout.Dimension / 2);
    check(part);
  }
}

/// From some point ever lower.
TEST_P(BernsteinForms, NoPointIsBelowTheLeast)
{
  LeastBernstein search;
  for (int i = 0; i < 20; ++i)
  {
    const auto values = this->RandomValues();
    Vector3 best = this->RandomPoint(GetParam());
    double least = ValueAt(GetParam(), values.data(), best);
    for (int step = 0; step < 200; ++step)
    {
      double* const form = search.Reserve(GetParam());
      std::transform(values.begin(), values.end(), form, [&](double v) { return v - least; });
      double tolerance = 1e-6;
      const auto lower = search.Find(best, tolerance);
      if (!lower)
      {
        break;
      }
      best = *lower;
      const double value = ValueAt(GetParam(), values.data(), best);
      ASSERT_LT(value, least);
      ASSERT_LT(step, 199);
      least = value;
    }
    for (int k = 0; k < 2000; ++k)
    {
      const Vector3 p = this->RandomPoint(GetParam());
      ASSERT_GE(ValueAt(GetParam(), values.data(), p), least - 1e-5);
    }
  }
}

TEST_P(BernsteinForms, DistanceFormsAreSquaredDistances)
{
  const DistanceForm form(GetParam());
  const auto x = this->RandomValues();
  const auto y = this->RandomValues();
  const auto z = this->RandomValues();
  auto weights = this->RandomValues();
  std::vector<double> controls[3] = { x, y, z };
  double* const pointers[3] = { controls[0].data(), controls[1].data(), controls[2].data() };
  std::vector<double> other(3 * x.size());
  std::vector<double> square(static_cast<std::size_t>(form.GetSquare().Size));
  const Vector3 gap = this->TheDice.Point(2.0);
  form.Make(pointers, weights.data(), gap, 0.5, other.data(), square.data());
  for (int i = 0; i < 20; ++i)
  {
    const Vector3 p = this->RandomPoint(GetParam());
    const Vector3 q = { { ValueAt(GetParam(), x.data(), p), ValueAt(GetParam(), y.data(), p),
      ValueAt(GetParam(), z.data(), p) } };
    const double w = ValueAt(GetParam(), weights.data(), p);
    const double expected = 0.5 * (Norm2(q + w * gap) - w * w * Norm2(gap));
    ASSERT_NEAR(ValueAt(form.GetSquare(), square.data(), p), expected, 1e-12);
  }
}

}
