// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeCurveIntersection where the crossings are known.

#include "Support/CurveRun.h"
#include "Support/TestAmount.h"

#include "vtkSkdTreeCurveIntersection.h"

#include <gtest/gtest.h>

using namespace skdtest;

namespace
{

using FilterPointer = vtkSmartPointer<vtkSkdTreeCurveIntersection>;
using Numbers = std::vector<double>;

constexpr auto MakeFilter = [](vtkDataObject* curves, vtkDataObject* others = nullptr)
{ return MakeCurveFilter<vtkSkdTreeCurveIntersection>(curves, others); };

/// (cos t, +-sin t, t / 2 pi)
auto MirroredHelix(double sign)
{
  return [=](double t) { return Point{ std::cos(t), sign * std::sin(t), t / (2 * M_PI) }; };
}

/// Where (sin(a t + shift), sin(b t)) from t = start on crosses itself, both parameters, ascending:
/// one of the sines has the same angle twice, and the other the supplement.
std::vector<std::array<double, 2>> LissajousCrossings(int a, int b, double shift, double start)
{
  std::vector<std::array<double, 2>> all;
  const auto add = [&](double t, double apart)
  {
    const auto rotated = [&](double angle)
    { return angle - 2 * M_PI * std::floor((angle - start) / (2 * M_PI)); };
    const double first = rotated(t);
    const double second = rotated(t + apart);
    if (first < second)
    {
      all.push_back({ first, second });
    }
  };
  for (int m = 0; m < 2 * b; ++m)
  {
    for (int k = 1; k < a; ++k)
    {
      add(M_PI * (1 + 2 * m) / (2 * b) - M_PI * k / a, 2 * M_PI * k / a);
    }
  }
  for (int m = 0; m < 2 * a; ++m)
  {
    for (int k = 1; k < b; ++k)
    {
      add((M_PI * (1 + 2 * m) - 2 * shift) / (2 * a) - M_PI * k / b, 2 * M_PI * k / b);
    }
  }
  std::sort(all.begin(), all.end());
  return all;
}

/// A rational arc from (-1, 0, 0) to (1, 0, 0) over (0, height, 0); nearly all of its hull's
/// height.
struct Arc
{
  static constexpr double Weight = 1023.0;
  double Hull;

  double Height() const { return this->Hull * Weight / (1.0 + Weight); }

  template <class Place>
  GridPointer Make(const Place& position) const
  {
    Mesh mesh = OneCell(VTK_BEZIER_CURVE, { { -1, 0, 0 }, { 1, 0, 0 }, { 0, this->Hull, 0 } });
    mesh.Map(position);
    GridPointer grid = MakeGrid(mesh);
    SetRationalWeights(grid, { 1, 1, Weight });
    return grid;
  }
};

/// Two arcs that bend towards each other, crosswise, with a gap between them, turned and moved.
FilterPointer TwoArcs(const Arc& arc, double gap, Random& random)
{
  const Point x = random.Direction();
  const Point other = random.Direction();
  const Point z = (1.0 / Length(Cross(x, other))) * Cross(x, other);
  const Point y = Cross(z, x);
  const Point middle = random.InBox({ -1, 1, -1, 1, -1, 1 });
  const double away = 2.0 * arc.Height() + gap;
  return MakeFilter(arc.Make([&](const Point& p) { return middle + p[0] * x + p[1] * y; }),
    arc.Make([&](const Point& p) { return middle + p[0] * z + (away - p[1]) * y; }));
}

}

// Their polylines of 100 segments a turn miss each other by up to 4.6e-4.
TEST(CurveIntersectionKnown, MirroredHelicesMeetFiveTimes)
{
  constexpr int pieces = 63; // t = k pi is within a piece, but at both ends
  const double end = 4 * M_PI;
  const FilterPointer filter = MakeFilter(LagrangeCurve(MirroredHelix(1), 0, end, pieces),
    LagrangeCurve(MirroredHelix(-1), 0, end, pieces));
  for (double tolerance : { 1e-1, 1e-3, 1e-4 })
  {
    filter->SetChordTolerance(tolerance);
    const Numbers positions = PlacesOfPieces(filter, 0, end, pieces);
    const Numbers others = PlacesOfPieces(filter, 0, end, pieces, "SkdOtherCurve");
    ASSERT_EQ(positions.size(), 5u) << tolerance;
    for (std::size_t k = 0; k < 5; ++k)
    {
      EXPECT_NEAR(positions[k], k * M_PI, 1e-14 * (k + 1.0));
      EXPECT_NEAR(others[k], k * M_PI, 1e-14 * (k + 1.0));
    }
  }
}

TEST(CurveIntersectionKnown, LissajousCurvesCrossThemselves)
{
  constexpr int pieces = 61;
  const double start = 0.1; // no crossing itself
  const double end = start + 2 * M_PI;
  for (const auto& [a, b, count] : { std::tuple(3, 4, 17u), std::tuple(2, 3, 7u) })
  {
    const auto curve = [a = a, b = b](double t) {
      return Point{ std::sin(a * t + 0.3), std::sin(b * t), 0 };
    };
    const FilterPointer filter = MakeFilter(LagrangeCurve(curve, start, end, pieces));
    const Numbers first = PlacesOfPieces(filter, start, end, pieces);
    const Numbers second = PlacesOfPieces(filter, start, end, pieces, "SkdOtherCurve");
    std::vector<std::array<double, 2>> found;
    for (std::size_t i = 0; i < first.size(); ++i)
    {
      found.push_back({ first[i], second[i] });
    }
    std::sort(found.begin(), found.end());
    const auto expected = LissajousCrossings(a, b, 0.3, start);
    ASSERT_EQ(expected.size(), count);
    ASSERT_EQ(found.size(), count);
    for (std::size_t i = 0; i < found.size(); ++i)
    {
      EXPECT_NEAR(found[i][0], expected[i][0], 1e-12);
      EXPECT_NEAR(found[i][1], expected[i][1], 1e-12);
    }
    EXPECT_EQ(OutputArray(filter, "SkdKind"), Numbers(count, 0.0));
  }
}

// What their chords are apart, in chord tolerances: their safety cylinders overlap up to 2, and
// from there on they are cut.
TEST(CurveIntersectionKnown, CurvesWhoseChordsAreApartAreNotLost)
{
  Random random(4);
  for (int round = 0; round < Amount(100); ++round)
  {
    const Arc arc{ random.Between(1e-4, 0.1) };
    const FilterPointer filter = TwoArcs(arc, 0.0, random);
    auto* data = vtkDataSet::SafeDownCast(filter->GetInputDataObject(0, 0));
    for (double apart : { 0.5, 1.0, 1.001, 1.5, 1.99, 2.01, 4.0 })
    {
      filter->SetChordTolerance(2.0 * arc.Height() / apart / data->GetLength());
      ASSERT_EQ(OutputPoints(filter).size(), 1u) << apart << " in round " << round;
      EXPECT_NEAR(OutputArray(filter, "SkdCurveParameter")[0], 0.5, 1e-12);
      EXPECT_NEAR(OutputArray(filter, "SkdOtherCurveParameter")[0], 0.5, 1e-12);
      EXPECT_NEAR(OutputArray(filter, "SkdAngle")[0], 90.0, 1e-9);
    }
  }
}

TEST(CurveIntersectionKnown, CurvesThatHardlyMissDoNotCross)
{
  Random random(6);
  for (int round = 0; round < Amount(500); ++round)
  {
    const double gap = std::pow(10.0, random.Between(-13.5, -3.0)); // coordinates are up to 3
    const FilterPointer filter = TwoArcs({ random.Between(1e-4, 0.1) }, gap, random);
    filter->SetChordTolerance(std::pow(10.0, random.Between(-4.0, 0.0)));
    ASSERT_TRUE(OutputPoints(filter).empty()) << gap << " in round " << round;
    filter->SetClearance(1.01 * gap + 1e-14);
    ASSERT_EQ(OutputArray(filter, "SkdKind"), Numbers{ 3 }) << gap << " in round " << round;
    ASSERT_NEAR(OutputArray(filter, "SkdGap")[0], gap, 1e-14);
  }
}

// They are cut into no more than so many parts: what is left of a pair is looked at bit by bit.
TEST(CurveIntersectionKnown, CurvesThatNearlyCoincideCrossWhereTheyDo)
{
  constexpr int pieces = 4;
  for (double amplitude : { 1e-6, 1e-9, 1e-11 })
  {
    const auto weave = [&](double t)
    {
      const double r = 1 + amplitude * std::sin(5 * t);
      return Point{ r * std::cos(t), r * std::sin(t), 0 };
    };
    const FilterPointer filter =
      MakeFilter(LagrangeCurve(weave, 0.1, 1.5, pieces), BezierCircle(1.0));
    const Numbers positions = PlacesOfPieces(filter, 0.1, 1.5, pieces);
    ASSERT_EQ(positions.size(), 2u) << amplitude;
    EXPECT_NEAR(positions[0], M_PI / 5, 1e-14 / amplitude);
    EXPECT_NEAR(positions[1], 2 * M_PI / 5, 1e-14 / amplitude);
  }
}

namespace
{

/// (t, (t - root)^degree + slope (t - root), 0), t from 0 to 1, as a Bezier curve.
GridPointer Power(int degree, double root, double slope)
{
  std::vector<Point> points;
  for (int i = 0; i <= degree; ++i)
  {
    const double x = static_cast<double>(i) / degree;
    points.push_back(
      { x, std::pow(1.0 - root, i) * std::pow(-root, degree - i) + slope * (x - root), 0.0 });
  }
  std::rotate(points.begin() + 1, points.end() - 1, points.end()); // ends first
  return MakeGrid(OneCell(VTK_BEZIER_CURVE, points));
}

Numbers KindsBothWays(vtkDataObject* curves, vtkDataObject* others)
{
  const Numbers kinds = OutputArray(MakeFilter(curves, others), "SkdKind");
  EXPECT_EQ(OutputArray(MakeFilter(others, curves), "SkdKind"), kinds);
  return kinds;
}

}

// They are cut at eighths, and where the chord tolerance requires it.
TEST(CurveIntersectionKnown, CrossingsAtSmallAnglesAreFoundWhereACurveIsCut)
{
  const PolyDataPointer axis = MakePolyline({ { -1.25, 0, 0 }, { 2, 0, 0 } });
  for (double slope : { 0.1, 0.01, 1e-3, 1e-4, 1e-5 })
  {
    for (int k = 0; k <= 8; ++k)
    {
      const std::size_t expected = k / 8.0 > slope ? 2 : 1; // also at k / 8 - slope
      EXPECT_EQ(KindsBothWays(Power(2, k / 8.0, slope), axis), Numbers(expected, 0.0))
        << k << " " << slope;
    }
  }
}

TEST(CurveIntersectionKnown, ARootOfHigherOrderIsOnePlace)
{
  const PolyDataPointer axis = MakePolyline({ { -1.25, 0, 0 }, { 2, 0, 0 } });
  for (const int degree : { 2, 3, 4, 5, 6, 7 })
  {
    for (const double root : { 0.125, 0.3, 0.5 })
    {
      const double kind = degree % 2 == 0 ? 1 : 0;
      EXPECT_EQ(KindsBothWays(Power(degree, root, 0.0), axis), Numbers{ kind }) << degree << root;
      if (degree % 2 == 1)
      {
        EXPECT_EQ(KindsBothWays(Power(degree, root, 1e-11), axis), Numbers{ 0 }) << degree << root;
      }
    }
  }
}

TEST(CurveIntersectionKnown, SplinesCrossInTheirJoints)
{
  for (double slope : { 1.0, 0.1, 0.01, 1e-3, 1e-5, 1e-7 })
  {
    std::vector<Point> points;
    for (int x = -3; x <= 3; ++x)
    {
      points.push_back({ double(x), slope * x * (1.0 + 0.1 * x * x), 0.0 });
    }
    const PolyDataPointer spline = MakePolyline(points);
    for (const std::vector<Point>& other : { std::vector<Point>{ { -4, 0, 0 }, { 3.5, 0, 0 } },
           std::vector<Point>{ { -4, 0, 0 }, { 0, 0, 0 }, { 3.5, 0, 0 } } })
    {
      for (int form : { 1, 2 })
      {
        const FilterPointer filter = MakeFilter(spline, MakePolyline(other));
        filter->SetPolylineForm(form);
        EXPECT_EQ(OutputArray(filter, "SkdCurveParameter"), Numbers{ 0.5 }) << slope << form;
      }
    }
  }
}
