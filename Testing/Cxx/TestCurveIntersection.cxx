// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeCurveIntersection: known crossings, options, bad input.

#include "Support/CurveRun.h"
#include "Support/EventCounter.h"
#include "Support/OneAndFourThreads.h"

#include "vtkMultiBlockDataSet.h"
#include "vtkSMPTools.h"
#include "vtkSkdTreeCurveIntersection.h"

#include <gtest/gtest.h>

using namespace skdtest;

namespace
{

using Filter = vtkSkdTreeCurveIntersection;
using FilterPointer = vtkSmartPointer<Filter>;
using Numbers = std::vector<double>;

constexpr auto MakeFilter = [](vtkDataObject* curves, vtkDataObject* others = nullptr)
{ return MakeCurveFilter<Filter>(curves, others); };

auto Lissajous(int a, int b)
{
  return [=](double t) { return Point{ std::sin(a * t + 0.3), std::sin(b * t), 0.0 }; };
}

/// The crossings of a closed polyline with itself, by looking at all pairs of its segments.
int CountCrossings(const std::vector<Point>& points)
{
  const auto side = [](const Point& a, const Point& b, const Point& c)
  { return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]); };
  int count = 0;
  const std::size_t n = points.size() - 1;
  for (std::size_t i = 0; i < n; ++i)
  {
    for (std::size_t j = i + 2; j < n - (i == 0); ++j)
    {
      const Point &a = points[i], &b = points[i + 1], &c = points[j], &d = points[j + 1];
      count += side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
    }
  }
  return count;
}

}

TEST(CurveIntersection, TwoLines)
{
  const FilterPointer filter = MakeFilter(
    MakePolyline({ { 0, 0, 0 }, { 4, 0, 0 } }), MakePolyline({ { 1, -1, 0 }, { 1, 3, 0 } }));
  EXPECT_EQ(OutputPoints(filter), (std::vector<Point>{ { 1, 0, 0 } }));
  EXPECT_EQ(OutputArray(filter, "SkdCurveParameter"), Numbers{ .25 });
  EXPECT_EQ(OutputArray(filter, "SkdArcLength"), Numbers{ 1 });
  EXPECT_EQ(OutputArray(filter, "SkdOtherCurveParameter"), Numbers{ .25 });
  EXPECT_EQ(OutputArray(filter, "SkdOtherArcLength"), Numbers{ 1 });
  EXPECT_EQ(OutputArray(filter, "SkdAngle"), Numbers{ 90 });
  EXPECT_EQ(OutputArray(filter, "SkdKind"), Numbers{ 0 });
  EXPECT_EQ(Reported(filter, "Hits"), 1);
}

TEST(CurveIntersection, PolylinesOfMirroredHelicesMissEachOther)
{
  const auto helix = [](double sign) {
    return [=](double t) { return Point{ std::cos(t), sign * std::sin(t), t / (2 * M_PI) }; };
  };
  // 100 segments a turn, one of them begun half a segment later: exactly mirrored ones would meet.
  const double shift = M_PI / 100;
  const PolyDataPointer one = MakePolyline(Sampled(helix(1), 0, 4 * M_PI, 200));
  const PolyDataPointer other = MakePolyline(Sampled(helix(-1), shift, 4 * M_PI - shift, 199));
  const FilterPointer filter = MakeFilter(one, other);
  EXPECT_TRUE(OutputPoints(filter).empty());
  filter->SetClearance(1e-3);
  EXPECT_EQ(OutputArray(filter, "SkdKind"), Numbers{ 3 }); // the nearest approach of the two
  EXPECT_LT(OutputArray(filter, "SkdGap")[0], 5e-4);
}

TEST(CurveIntersection, LissajousCurvesMeetThemselves)
{
  for (const auto& [a, b, expected] : { std::tuple(3, 4, 17), std::tuple(2, 3, 7) })
  {
    const std::vector<Point> points = Sampled(Lissajous(a, b), 0, 2 * M_PI, 400);
    std::vector<Point> closed = points;
    closed.back() = closed.front();
    const FilterPointer filter = MakeFilter(MakePolyline(closed));
    for (int form : { Filter::STRAIGHT, Filter::CARDINAL_SPLINE, Filter::KOCHANEK_SPLINE })
    {
      filter->SetPolylineForm(form);
      EXPECT_EQ(OutputPoints(filter).size(), static_cast<std::size_t>(expected)) << form;
      EXPECT_EQ(OutputArray(filter, "SkdKind"), Numbers(OutputPoints(filter).size(), 0.0));
    }
    EXPECT_EQ(CountCrossings(closed), expected);
  }
}

TEST(CurveIntersection, RationalCirclesCrossExactly)
{
  const FilterPointer filter = MakeFilter(BezierCircle(1.0), BezierCircle(1.0, { 1, 0, 0 }));
  const std::vector<Point> points = OutputPoints(filter);
  ASSERT_EQ(points.size(), 2u);
  for (const Point& point : points)
  {
    EXPECT_NEAR(point[0], 0.5, 1e-15);
    EXPECT_NEAR(std::abs(point[1]), std::sqrt(0.75), 1e-15);
  }
  for (double angle : OutputArray(filter, "SkdAngle"))
  {
    EXPECT_NEAR(angle, 60.0, 1e-12);
  }
}

TEST(CurveIntersection, CirclesThatTouch)
{
  const Point centre{ 0.5 * std::cos(0.5), 0.5 * std::sin(0.5), 0 };
  const FilterPointer filter = MakeFilter(BezierCircle(1.0), BezierCircle(0.5, centre));
  const std::vector<Point> points = OutputPoints(filter);
  ASSERT_EQ(points.size(), 1u);
  EXPECT_EQ(OutputArray(filter, "SkdKind"), Numbers{ 1 });
  EXPECT_NEAR(points[0][0], std::cos(0.5), 1e-7);
  EXPECT_NEAR(points[0][1], std::sin(0.5), 1e-7);
  filter->SetSourceData(BezierCircle(0.5 - 1e-12, centre));
  EXPECT_TRUE(OutputPoints(filter).empty());
}

TEST(CurveIntersection, CurvesThatOverlapTellTheInterval)
{
  const FilterPointer filter =
    MakeFilter(MakePolyline({ { 0, 0, 0 }, { 1, 0, 0 }, { 3, 0, 0 }, { 3, 2, 0 }, { 5, 2, 0 } }),
      MakePolyline(
        { { .5, 1, 0 }, { .5, 0, 0 }, { 2, 0, 0 }, { 3, 0, 0 }, { 3, 1, 0 }, { 9, 1, 0 } }));
  EXPECT_EQ(OutputArray(filter, "SkdKind"), (Numbers{ 2, 2 }));
  EXPECT_EQ(OutputArray(filter, "SkdArcLength"), (Numbers{ .5, 4 }));
  const std::vector<Point> interval = OutputPoints(filter, 1);
  ASSERT_EQ(interval.size(), 4u);
  EXPECT_EQ(interval.front(), (Point{ .5, 0, 0 }));
  EXPECT_EQ(interval[2], (Point{ 3, 0, 0 }));
  EXPECT_EQ(interval.back(), (Point{ 3, 1, 0 }));
  EXPECT_EQ(OutputCellArray(filter, "SkdOtherCurveId", 1), Numbers{ 0 });
}

TEST(CurveIntersection, EqualCirclesOverlapAllAround)
{
  const FilterPointer filter = MakeFilter(BezierCircle(1.0), BezierCircle(1.0));
  const Numbers kinds = OutputArray(filter, "SkdKind");
  EXPECT_EQ(std::count(kinds.begin(), kinds.end(), 2.0), 8);
  auto* intervals = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(1));
  EXPECT_EQ(intervals->GetNumberOfCells(), 4);
}

TEST(CurveIntersection, APositionOnAVertexIsOnePoint)
{
  const FilterPointer filter = MakeFilter(MakePolyline({ { -1, 0, 0 }, { 0, 0, 0 }, { 1, .5, 0 } }),
    MakePolyline({ { 0, -1, 0 }, { 0, 0, 0 }, { .3, 1, 0 } }));
  EXPECT_EQ(OutputPoints(filter).size(), 1u);
  EXPECT_EQ(OutputArray(filter, "SkdCurveParameter"), Numbers{ .5 });
}

TEST(CurveIntersection, JointsOfLinesAreIgnoredByChoice)
{
  Mesh mesh = OneCell(VTK_LINE, { { 0, 0, 0 }, { 1, 0, 0 } });
  mesh.Add(VTK_LINE, { 1, mesh.Add({ 1, 1, 0 }) });
  mesh.Add(VTK_LINE, { 2, mesh.Add({ .5, -1, 0 }) });
  const FilterPointer filter = MakeFilter(MakePolyData(mesh));
  EXPECT_EQ(OutputArray(filter, "SkdOtherCurveId"), Numbers{ 2 }); // the first with the third
  filter->IgnoreJointsOff();
  EXPECT_EQ(OutputPoints(filter).size(), 3u);
}

TEST(CurveIntersection, TellsNearestApproaches)
{
  Mesh mesh = OneCell(VTK_LINE, { { -1, 0, 0 }, { 1, 0, 0 } });
  mesh.Add(VTK_LINE, { mesh.Add({ 0, -1, .25 }), mesh.Add({ 0, 1, .25 }) });
  mesh.Add(VTK_LINE, { mesh.Add({ 0.5, -1, 2 }), mesh.Add({ 0.5, 1, 2 }) });
  const FilterPointer filter = MakeFilter(MakePolyData(mesh));
  EXPECT_TRUE(OutputPoints(filter).empty());
  filter->SetClearance(0.25);
  EXPECT_EQ(OutputPoints(filter), (std::vector<Point>{ { 0, 0, .125 } }));
  EXPECT_EQ(OutputArray(filter, "SkdGap"), Numbers{ .25 });
  EXPECT_EQ(OutputArray(filter, "SkdKind"), Numbers{ 3 });
  filter->SetClearance(0.2499);
  EXPECT_TRUE(OutputPoints(filter).empty());
  filter->SetClearance(3);
  EXPECT_EQ(OutputPoints(filter).size(), 3u);
  filter->SetInputDataObject(0, BezierCircle(1.0));
  filter->SetSourceData(BezierCircle(0.5, { 0.2, 0, 0 }));
  filter->SetClearance(0.3 + 1e-9);
  EXPECT_NEAR(OutputPoints(filter)[0][0], 0.85, 1e-9);
}

TEST(CurveIntersection, InterpolatesDataOfBothSides)
{
  const PolyDataPointer one = MakePolyline({ { 0, 0, 0 }, { 4, 0, 0 } });
  const PolyDataPointer other = MakePolyline({ { 1, -1, 0 }, { 1, 3, 0 } });
  const auto add = [](vtkDataSet* to, const char* name, double a, double b)
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    array->InsertNextValue(a);
    array->InsertNextValue(b);
    to->GetPointData()->AddArray(array);
  };
  add(one, "A", 0, 8);
  add(other, "B", 4, 0);
  add(other, "A", 4, 0);
  const FilterPointer filter = MakeFilter(one, other);
  EventCounter events(filter);
  EXPECT_EQ(OutputArray(filter, "A"), Numbers{ 2 });
  EXPECT_EQ(OutputArray(filter, "B"), Numbers{ 3 });
  EXPECT_EQ(events.Warnings, 1);
}

TEST(CurveIntersection, KeepsItsTrees)
{
  const PolyDataPointer other = MakePolyline({ { 1, -1, 0 }, { 1, 3, 0 } });
  const FilterPointer filter = MakeFilter(MakePolyline({ { 0, 0, 0 }, { 4, 0, 0 } }), other);
  filter->Update();
  EXPECT_EQ(Reported(filter, "TreesBuilt"), 2);
  filter->SetInputDataObject(0, MakePolyline({ { 0, 1, 0 }, { 4, 1, 0 } }));
  filter->Update();
  EXPECT_EQ(Reported(filter, "TreesBuilt"), 1);
  filter->SetClearance(1);
  filter->Update();
  EXPECT_EQ(Reported(filter, "TreesBuilt"), 0);
}

TEST(CurveIntersection, CompositeCurvesTellTheirBlocks)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, MakePolyline({ { 0, 0, 0 }, { 4, 0, 0 } }));
  blocks->SetBlock(1, MakePolyline({ { 1, -1, 0 }, { 1, 3, 0 } }));
  const FilterPointer filter = MakeFilter(blocks);
  EXPECT_EQ(OutputArray(filter, "SkdCurveBlockIndex"), Numbers{ 1 });
  EXPECT_EQ(OutputArray(filter, "SkdOtherCurveBlockIndex"), Numbers{ 2 });
}

TEST(CurveIntersection, AnswersTheRestOfBadInput)
{
  const double nan = std::nan("");
  Mesh curves = OneCell(VTK_LINE, { { 0, 0, 0 }, { 4, 0, 0 } });
  curves.Add(VTK_LINE, { curves.Add({ 1, 1, 1 }), curves.Add({ 1, 1, 1 }) });
  curves.Add(VTK_LINE, { curves.Add({ nan, 1, 1 }), 0 });
  curves.Add(VTK_TRIANGLE, { 0, 1, 2 });
  curves.Add(VTK_LINE, { curves.Add({ 1, -1, 0 }), curves.Add({ 1, 1, 0 }) });
  const FilterPointer filter = MakeFilter(MakeGrid(curves));
  filter->SetChordTolerance(0.0);
  EventCounter events(filter);
  EXPECT_EQ(OutputPoints(filter).size(), 1u);
  EXPECT_EQ(OutputArray(filter, "SkdOtherCurveCellId"), Numbers{ 4 });
  EXPECT_EQ(events.Warnings, 5); // points; no length, not finite, no curve; tolerance
  EXPECT_EQ(events.Errors, 0);
  const FilterPointer empty = MakeFilter(PolyDataPointer::New());
  EventCounter more(empty);
  EXPECT_TRUE(OutputPoints(empty).empty());
  EXPECT_EQ(more.Warnings, 1);
}

TEST(CurveIntersection, LeavesOutWhatCannotBeMeasured)
{
  Mesh curves = OneCell(VTK_LINE, { { 0, 0, 0 }, { 4, 0, 0 } });
  for (double size : { 1e200, 1e-200 })
  {
    curves.Add(VTK_POLY_LINE,
      { curves.Add({ 0, 0, 0 }), curves.Add({ size, size, 0 }), curves.Add({ 2 * size, 0, 0 }) });
  }
  curves.Add(VTK_LINE, { curves.Add({ 1, -1, 0 }), curves.Add({ 1, 1, 0 }) });
  const FilterPointer filter = MakeFilter(MakeGrid(curves));
  EventCounter events(filter);
  for (int form : { Filter::STRAIGHT, Filter::CARDINAL_SPLINE, Filter::KOCHANEK_SPLINE })
  {
    filter->SetPolylineForm(form);
    EXPECT_EQ(OutputPoints(filter), (std::vector<Point>{ { 1, 0, 0 } }));
    EXPECT_NE(events.Warning.find("2 curves are longer than"), std::string::npos) << events.Warning;
  }
  EXPECT_EQ(events.Warnings, 6); // the others count points beyond 1e152
}

TEST(CurveIntersection, RefusesWeightsThatAreNotPositive)
{
  for (double weight : { 0.0, -1.0 })
  {
    const GridPointer circle = BezierCircle(1.0);
    circle->GetPointData()->GetRationalWeights()->SetTuple1(1, weight);
    const FilterPointer filter = MakeFilter(circle, BezierCircle(1.0, { 1, 0, 0 }));
    EventCounter events(filter);
    filter->Update();
    EXPECT_EQ(events.Warnings, 1);
    EXPECT_NE(events.Warning.find("1 curves have a weight that is not positive"), std::string::npos)
      << events.Warning;
    EXPECT_EQ(Reported(filter, "Curves"), 3);
    EXPECT_EQ(Reported(filter, "Hits"), 1); // of the two of whole circles
  }
}

TEST(CurveIntersection, ProgressRisesAndAnAbortStops)
{
  Random random(7);
  Mesh mesh;
  for (int i = 0; i < 20000; ++i)
  {
    const Point start = random.InBox({ 0, 1, 0, 1, 0, 0 });
    mesh.Add(VTK_LINE, { mesh.Add(start), mesh.Add(start + 0.02 * random.Direction()) });
  }
  mesh.Map([](const Point& p) { return Point{ p[0], p[1], 0.0 }; });
  const FilterPointer filter = MakeFilter(MakePolyData(mesh));
  std::vector<double> steps;
  vtkNew<vtkCallbackCommand> watch;
  watch->SetClientData(&steps);
  watch->SetCallback(
    [](vtkObject* self, unsigned long, void* all, void*) {
      static_cast<std::vector<double>*>(all)->push_back(Filter::SafeDownCast(self)->GetProgress());
    });
  filter->AddObserver(vtkCommand::ProgressEvent, watch);
  const std::size_t all = OutputPoints(filter).size();
  EXPECT_GT(steps.size(), 5u);
  EXPECT_TRUE(std::is_sorted(steps.begin(), steps.end()));
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* self, unsigned long, void*, void*)
    { Filter::SafeDownCast(self)->SetAbortExecute(1); });
  filter->AddObserver(vtkCommand::ProgressEvent, stop);
  filter->Modified();
  EXPECT_LT(OutputPoints(filter).size(), all);
}

TEST(CurveIntersection, AnswersTheSameWithAnyNumberOfThreads)
{
  Random random(8);
  Mesh mesh;
  for (int i = 0; i < 400; ++i)
  {
    mesh.Add(VTK_LINE,
      { mesh.Add({ random.Between(0, 1), random.Between(0, 1), 0 }),
        mesh.Add({ random.Between(0, 1), random.Between(0, 1), 0 }) });
  }
  const auto [one, four] = OneAndFourThreads(
    [&]
    {
      const FilterPointer filter = MakeFilter(MakePolyData(mesh));
      const Numbers lengths = OutputArray(filter, "SkdArcLength");
      return std::make_pair(lengths, OutputArray(filter, "SkdOtherCurveId"));
    });
  EXPECT_EQ(one, four);
  EXPECT_GT(one.first.size(), 500u);
}

TEST(CurveIntersection, RandomLinesAgreeWithAllPairs)
{
  Random random(5);
  for (double offset : { 0.0, 1e6 })
  {
    Mesh mesh;
    std::vector<Point> points;
    for (int i = 0; i < 600; ++i)
    {
      points.push_back({ offset + std::floor(random.Between(0, 30)),
        offset + std::floor(random.Between(0, 30)), 0.0 });
      mesh.Add(points.back());
    }
    std::size_t expected = 0;
    const auto side = [](const Point& a, const Point& b, const Point& c)
    { return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]); };
    for (vtkIdType i = 0; i < 300; ++i)
    {
      mesh.Add(VTK_LINE, { 2 * i, 2 * i + 1 });
    }
    const FilterPointer filter = MakeFilter(MakePolyData(mesh));
    filter->IgnoreJointsOff();
    const Numbers kinds = OutputArray(filter, "SkdKind");
    std::size_t degenerate = 0;
    for (std::size_t i = 0; i < 300; ++i)
    {
      for (std::size_t j = i + 1; j < 300; ++j)
      {
        const Point &a = points[2 * i], &b = points[2 * i + 1], &c = points[2 * j],
                    &d = points[2 * j + 1];
        const double across = (b[0] - a[0]) * (d[1] - c[1]) - (b[1] - a[1]) * (d[0] - c[0]);
        const bool meets = side(a, b, c) * side(a, b, d) <= 0 && side(c, d, a) * side(c, d, b) <= 0;
        expected += across != 0.0 && meets;
        degenerate += across == 0.0 && meets;
      }
    }
    EXPECT_EQ(static_cast<std::size_t>(std::count(kinds.begin(), kinds.end(), 0.0)), expected);
  }
}
