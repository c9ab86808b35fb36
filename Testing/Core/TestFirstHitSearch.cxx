// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// Where a line first meets maps in Bernstein form, against roots found from a dense lattice.

#include "Core/Geometry/Cells/FirstHitSearch.h"
#include "Core/Geometry/Cells/LeastResidual.h"

#include "Dice.h"

#include <gtest/gtest.h>

namespace
{

using namespace skd;
using coretest::Dice;

/// A map as it is seen along a line: two coordinates across it, one along it, and a weight.
struct SeenMap
{
  BernsteinLayout Layout;
  bool IsRational = false;
  std::vector<double> Values;

  SeenMap(const BernsteinLayout& layout, bool isRational)
    : Layout(layout)
    , IsRational(isRational)
    , Values(static_cast<std::size_t>((isRational ? 4 : 3) * layout.Size))
  {
  }

  /// A coefficient.
  double& Value(int coordinate, int i)
  {
    return this->Values[static_cast<std::size_t>(coordinate * this->Layout.Size + i)];
  }

  /// The coordinates at p, and their gradients.
  std::array<BernsteinPoint, 3> At(const Vector3& p) const
  {
    const BernsteinWeights weights(this->Layout, p);
    std::array<BernsteinPoint, 3> at;
    for (std::size_t k = 0; k < 3; ++k)
    {
      at[k] = weights.Sum(this->Values.data() + k * static_cast<std::size_t>(this->Layout.Size));
    }
    if (this->IsRational)
    {
      const BernsteinPoint weight = weights.Sum(this->Values.data() + 3 * this->Layout.Size);
      for (BernsteinPoint& coordinate : at)
      {
        coordinate.Value /= weight.Value;
        coordinate.Gradient =
          (1.0 / weight.Value) * (coordinate.Gradient - coordinate.Value * weight.Gradient);
      }
    }
    return at;
  }

  double Distance(const Vector3& p) const
  {
    const auto at = this->At(p);
    return std::hypot(at[0].Value, at[1].Value);
  }

  bool Has(const Vector3& p) const
  {
    const double far = this->Layout.SimplexAxes > 0 ? p[0] + p[1] : std::max(p[0], p[1]);
    return std::min(p[0], p[1]) >= 0.0 && far <= 1.0;
  }

  /// The first of all roots that Newton's method finds from a lattice.
  double FirstRoot(double length) const
  {
    constexpr int n = 20;
    double first = std::numeric_limits<double>::infinity();
    for (int j = 0; j <= n; ++j)
    {
      for (int i = 0; i <= n; ++i)
      {
        Vector3 p = { { double(i) / n, double(j) / n, 0.0 } };
        if (this->Has(p) && this->FindRoot(p))
        {
          const double along = this->At(p)[2].Value;
          first = along >= 0.0 && along <= length ? std::min(first, along) : first;
        }
      }
    }
    return first;
  }

  bool FindRoot(Vector3& p) const
  {
    for (int i = 0; i < 8; ++i)
    {
      const auto at = this->At(p);
      const Vector3& a = at[0].Gradient;
      const Vector3& b = at[1].Gradient;
      const double determinant = a[0] * b[1] - a[1] * b[0];
      p[0] -= (at[0].Value * b[1] - at[1].Value * a[1]) / determinant;
      p[1] -= (a[0] * at[1].Value - b[0] * at[0].Value) / determinant;
      if (!(std::abs(p[0] - 0.5) < 1.0 && std::abs(p[1] - 0.5) < 1.0))
      {
        return false;
      }
    }
    return this->Has(p) && this->Distance(p) < 1e-13;
  }
};

/// From a point of the line, between its ends, to one of the map: a function of (r, s, t) or (r,
/// t).
struct Gap
{
  const SeenMap& Map;
  double Length;

  int AxisOfT() const { return this->Map.Layout.Dimension; }
  const ParameterDomain& Domain() const
  {
    return this->AxisOfT() == 1          ? UnitSquare
      : this->Map.Layout.SimplexAxes > 0 ? UnitPrism
                                         : UnitCube;
  }
  Vector3 OnMap(Vector3 p) const
  {
    p[this->AxisOfT()] = 0.0;
    return p;
  }
  Vector3 Value(const Vector3& p) const
  {
    const auto at = this->Map.At(this->OnMap(p));
    return { { at[0].Value, at[1].Value, at[2].Value - this->Length * p[this->AxisOfT()] } };
  }
  void Tangents(const Vector3& p, Vector3 (&tangents)[3]) const
  {
    const auto at = this->Map.At(this->OnMap(p));
    for (int axis = 0; axis < this->AxisOfT(); ++axis)
    {
      tangents[axis] = { { at[0].Gradient[axis], at[1].Gradient[axis], at[2].Gradient[axis] } };
    }
    tangents[this->AxisOfT()] = { { 0.0, 0.0, -this->Length } };
  }
};

struct Result
{
  double First = std::numeric_limits<double>::infinity();
  int Calls = 0;
};

Result Search(const std::vector<SeenMap>& maps, const HitLimits& limits)
{
  FirstHitSearch search;
  search.Clear();
  for (const SeenMap& map : maps)
  {
    std::copy(map.Values.begin(), map.Values.end(), search.Add(map.Layout, map.IsRational));
  }
  Result result;
  search.Find(limits,
    [&](int number, const Vector3& p, double along, bool isCrossing) -> std::optional<double>
    {
      ++result.Calls;
      const Gap gap{ maps[static_cast<std::size_t>(number)], limits.Length };
      Vector3 start = p;
      start[gap.AxisOfT()] = std::clamp(along / limits.Length, 0.0, 1.0);
      EXPECT_TRUE(!isCrossing || Norm(gap.Value(start)) < 1e-12);
      LeastResidual<Gap> descent(gap.Domain(), gap);
      const auto found = descent.Find(start, 1e-32, [](const Vector3&) { return false; });
      if (!(found.Norm2 <= limits.Tolerance * limits.Tolerance))
      {
        return std::nullopt;
      }
      const double at = limits.Length * found.Parameters[gap.AxisOfT()];
      result.First = std::min(result.First, at);
      return at;
    });
  return result;
}

constexpr double Rounding = 1e-14;

struct Kind
{
  BernsteinLayout Layout;
  bool IsRational;
};

class FirstHits : public testing::TestWithParam<Kind>
{
protected:
  Dice TheDice{ 5 };

  /// A square or a triangle along the line or across it, its control points displaced.
  SeenMap RandomMap(double by)
  {
    const BernsteinLayout& layout = GetParam().Layout;
    SeenMap map(layout, GetParam().IsRational);
    const Vector3 from = this->TheDice.Point(0.3);
    const Vector3 axes[2] = { this->TheDice.Point(1.0), this->TheDice.Point(1.0) };
    layout.ForEachRow(0,
      [&](int offset, int degree, const int(&index)[3])
      {
        for (int i = 0; i <= degree; ++i)
        {
          const double r = double(i) / layout.Degree[0] - 0.4;
          const double s = double(index[1]) / layout.Degree[1] - 0.4;
          const Vector3 x = from + r * axes[0] + s * axes[1] + this->TheDice.Point(by);
          const double weight = map.IsRational ? this->TheDice.Between(0.4, 2.0) : 1.0;
          for (int k = 0; k < 3; ++k)
          {
            map.Value(k, offset + i) = weight * x[k];
          }
          if (map.IsRational)
          {
            map.Value(3, offset + i) = weight;
          }
        }
      });
    return map;
  }
};

INSTANTIATE_TEST_SUITE_P(All, FirstHits,
  testing::Values(Kind{ { 2, 0, { 2, 2, 0 } }, false }, Kind{ { 2, 0, { 3, 4, 0 } }, false },
    Kind{ { 2, 0, { 6, 6, 0 } }, false }, Kind{ { 2, 2, { 2, 2, 0 } }, false },
    Kind{ { 2, 2, { 5, 5, 0 } }, false }, Kind{ { 2, 0, { 2, 3, 0 } }, true },
    Kind{ { 2, 2, { 3, 3, 0 } }, true }));

TEST_P(FirstHits, NoRootIsBefore)
{
  int hits = 0;
  for (int i = 0; i < 40; ++i)
  {
    const std::vector<SeenMap> maps = { this->RandomMap(i % 2 == 0 ? 0.2 : 0.8),
      this->RandomMap(0.5) };
    const HitLimits limits = { 0.7, Rounding, Rounding };
    const double expected =
      std::min(maps[0].FirstRoot(limits.Length), maps[1].FirstRoot(limits.Length));
    const double first = Search(maps, limits).First;
    ASSERT_LE(first, expected + 1e-7);
    hits += first <= limits.Length ? 1 : 0;
  }
  EXPECT_GT(hits, 10);
}

/// With a tolerance there are more hits, none of which is far from the line.
TEST_P(FirstHits, ToleranceAddsHits)
{
  for (int i = 0; i < 40; ++i)
  {
    const std::vector<SeenMap> maps = { this->RandomMap(0.3) };
    const double narrow = Search(maps, { 0.7, Rounding, Rounding }).First;
    const double wide = Search(maps, { 0.7, Rounding, 1e-3 }).First;
    ASSERT_LE(wide, narrow + 1e-7);
  }
}

/// Two coordinates across and one along of a polynomial of degree 2 in both parameters: what
/// `value` gives at the lattice of halves, as coefficients.
template <class Value>
SeenMap Biquadratic(const Value& value)
{
  SeenMap map({ 2, 0, { 2, 2, 0 } }, false);
  for (int k = 0; k < 3; ++k)
  {
    double at[3][3];
    for (int j = 0; j < 3; ++j)
    {
      for (int i = 0; i < 3; ++i)
      {
        at[j][i] = value(0.5 * i, 0.5 * j)[k];
      }
      at[j][1] = 2.0 * at[j][1] - 0.5 * (at[j][0] + at[j][2]);
    }
    for (int i = 0; i < 3; ++i)
    {
      at[1][i] = 2.0 * at[1][i] - 0.5 * (at[0][i] + at[2][i]);
      for (int j = 0; j < 3; ++j)
      {
        map.Value(k, 3 * j + i) = at[j][i];
      }
    }
  }
  return map;
}

/// A valley along the line that is just deep enough, seen along either axis and askew.
TEST(FirstHitsOfValleys, AreBothEndsOfTheCut)
{
  for (const double depth : { 1e-10, 1e-6, 1e-2 })
  {
    const auto straight = Biquadratic(
      [depth](double r, double s) {
        return Vector3{ { (r - 0.4) * (r - 0.4) - depth, s - 0.3, r } };
      });
    EXPECT_NEAR(Search({ straight }, { 1.0, Rounding, Rounding }).First, 0.4 - std::sqrt(depth),
      1e-3 * std::sqrt(depth));
    const auto askew = Biquadratic(
      [depth](double r, double s)
      {
        const double along = 0.5 * (r + s);
        return Vector3{ { (along - 0.4) * (along - 0.4) - depth, r - s, along } };
      });
    EXPECT_NEAR(Search({ askew }, { 1.0, Rounding, Rounding }).First, 0.4 - std::sqrt(depth),
      1e-3 * std::sqrt(depth));
    EXPECT_GT(Search({ askew }, { 0.3 - std::sqrt(depth), Rounding, Rounding }).First, 1.0);
  }
}

TEST(FirstHitsOfValleys, AreWithinTheToleranceAbove)
{
  const auto above = Biquadratic(
    [](double r, double s) {
      return Vector3{ { (r - 0.4) * (r - 0.4) + 1e-4, s - 0.3, r } };
    });
  EXPECT_GT(Search({ above }, { 1.0, Rounding, 0.9e-4 }).First, 1.0);
  EXPECT_LE(Search({ above }, { 1.0, Rounding, 1.1e-4 }).First, 1.0);
}

/// The line lies in a patch: the first of all points that they share.
TEST(FirstHitsAlong, AreWhereTheLineComesIn)
{
  const auto flat = Biquadratic(
    [](double r, double s) {
      return Vector3{ { 0.0, s - 0.3 + 0.1 * r, 0.2 + r } };
    });
  EXPECT_NEAR(Search({ flat }, { 2.0, Rounding, Rounding }).First, 0.2, 1e-6);
}

/// Patches that are drawn together in a curve or a point, on the line: the work is bounded.
TEST(FirstHitsAlong, TakeBoundedWork)
{
  const auto drawn = [](double r, double s) { return Vector3{ { 0.0, 0.0, 0.1 + r * r + s } }; };
  const auto point = [](double, double) { return Vector3{ { 0.0, 0.0, 0.1 } }; };
  const auto cone = [](double r, double s) { return Vector3{ { r * s, r * (1.0 - s), 0.1 + r } }; };
  for (const SeenMap& map : { Biquadratic(drawn), Biquadratic(point), Biquadratic(cone) })
  {
    const Result result = Search({ map }, { 1.0, Rounding, Rounding });
    EXPECT_NEAR(result.First, 0.1, 1e-6);
    EXPECT_LT(result.Calls, 200);
  }
}

/// Curves meet a line within the tolerance only.
TEST(FirstHitsOfCurves, AreWithinTheTolerance)
{
  SeenMap curve({ 1, 0, { 2, 0, 0 } }, false);
  for (int i = 0; i < 3; ++i)
  {
    curve.Value(0, i) = i == 1 ? -0.5 : 0.5; // (1 - 2 r)^2 / 2, above 0
    curve.Value(1, i) = 1e-4;
    curve.Value(2, i) = 0.5 * i;
  }
  EXPECT_GT(Search({ curve }, { 1.0, Rounding, 0.9e-4 }).First, 1.0);
  EXPECT_NEAR(Search({ curve }, { 1.0, Rounding, 1.1e-4 }).First, 0.5, 0.02);
}

}
