// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// Polylines as splines: both filters of curves meet them where VTK's own splines are.

#include "Support/CurveRun.h"
#include "Support/EventCounter.h"

#include "vtkCardinalSpline.h"
#include "vtkKochanekSpline.h"
#include "vtkSkdTreeCurveIntersection.h"
#include "vtkSkdTreeCurveSurfaceIntersection.h"

#include <gtest/gtest.h>

#include <string>

using namespace skdtest;

namespace
{

struct Form
{
  int Kind;
  double Tension = 0.0;
  double Bias = 0.0;
  double Continuity = 0.0;
};

constexpr int Cardinal = vtkSkdTreeCurveIntersection::CARDINAL_SPLINE;
constexpr int Kochanek = vtkSkdTreeCurveIntersection::KOCHANEK_SPLINE;

const Form Forms[] = { { Cardinal }, { Kochanek }, { Kochanek, 0.75 }, { Kochanek, -1.0 },
  { Kochanek, 0.0, 0.5 }, { Kochanek, 0.0, -1.0 }, { Kochanek, 0.0, 0.0, 0.6 },
  { Kochanek, 0.0, 0.0, -1.0 }, { Kochanek, 0.3, -0.4, 0.5 } };

std::vector<Point> RandomPolyline(int count, bool isClosed, Random& random)
{
  std::vector<Point> points;
  for (int i = 0; i < count; ++i)
  {
    points.push_back(random.InBox({ -1, 1, -1, 1, -1, 1 }));
  }
  points.back() = isClosed ? points.front() : points.back();
  return points;
}

/// VTK's own spline through a polyline, over chord lengths.
class Reference
{
public:
  Reference(const std::vector<Point>& points, const Form& form, bool isClosed)
    : Knots(1, 0.0)
  {
    for (std::size_t i = 1; i < points.size(); ++i)
    {
      this->Knots.push_back(this->Knots.back() + Distance(points[i - 1], points[i]));
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Axes[axis] = Make(form);
      this->Axes[axis]->SetClosed(isClosed);
      this->Axes[axis]->SetParametricRange(0.0, this->Knots.back());
      for (std::size_t i = 0; i < points.size() - (isClosed ? 1 : 0); ++i)
      {
        this->Axes[axis]->AddPoint(this->Knots[i], points[i][axis]);
      }
    }
  }

  /// At a parameter from 0 to 1 by the numbers of the polyline's points.
  Point At(double parameter) const
  {
    const double position = parameter * static_cast<double>(this->Knots.size() - 1);
    const auto i = static_cast<std::size_t>(position);
    const double length =
      this->Knots[i] + (position - std::floor(position)) * (this->Knots[i + 1] - this->Knots[i]);
    return { this->Axes[0]->Evaluate(length), this->Axes[1]->Evaluate(length),
      this->Axes[2]->Evaluate(length) };
  }

private:
  static vtkSmartPointer<vtkSpline> Make(const Form& form)
  {
    if (form.Kind == Cardinal)
    {
      return vtkSmartPointer<vtkCardinalSpline>::New();
    }
    auto spline = vtkSmartPointer<vtkKochanekSpline>::New();
    spline->SetDefaultTension(form.Tension);
    spline->SetDefaultBias(form.Bias);
    spline->SetDefaultContinuity(form.Continuity);
    return spline;
  }

  std::vector<double> Knots;
  vtkSmartPointer<vtkSpline> Axes[3];
};

template <class Filter>
vtkSmartPointer<Filter> MakeFilter(vtkDataObject* polyline, vtkDataObject* source, const Form& form)
{
  auto filter = MakeCurveFilter<Filter>(polyline, source);
  filter->SetPolylineForm(form.Kind);
  filter->SetTension(form.Tension);
  filter->SetBias(form.Bias);
  filter->SetContinuity(form.Continuity);
  return filter;
}

/// Short lines, or small triangles, through the places of the curve, across it as chance has it.
PolyDataPointer Targets(const std::vector<Point>& positions, int type, Random& random)
{
  Mesh mesh;
  for (const Point& position : positions)
  {
    const Point u = 1e-4 * random.Direction();
    const Point v = 1e-4 * random.Direction();
    const Ids ends{ mesh.Add(position + u), mesh.Add(position - u + v),
      mesh.Add(position - u - v) };
    mesh.Add(VTK_TRIANGLE, ends);
    if (type == VTK_LINE)
    {
      mesh.Cells.back() = { VTK_LINE, { ends[0], mesh.Add(position - u) } };
    }
  }
  return MakePolyData(mesh);
}

/// Each target is met, and where it was made.
void ExpectMet(vtkAlgorithm* filter, const std::string& targetName,
  const std::vector<double>& parameters, const std::vector<Point>& positions)
{
  const std::vector<double> targets = OutputArray(filter, targetName);
  const std::vector<double> found = OutputArray(filter, "SkdCurveParameter");
  const std::vector<Point> points = OutputPoints(filter);
  std::vector<int> met(positions.size(), 0);
  for (std::size_t i = 0; i < targets.size(); ++i)
  {
    const auto target = static_cast<std::size_t>(targets[i]);
    met[target] += Distance(points[i], positions[target]) < 1e-12 &&
      std::abs(found[i] - parameters[target]) < 1e-12;
  }
  EXPECT_EQ(met, std::vector<int>(positions.size(), 1));
}

class CurveSpline : public testing::TestWithParam<int>
{
};

INSTANTIATE_TEST_SUITE_P(Forms, CurveSpline, testing::Range(0, int(std::size(Forms))));

TEST_P(CurveSpline, IsMetWhereVtksOwnIs)
{
  const Form form = Forms[GetParam()];
  Random random(21);
  for (bool isClosed : { false, true })
  {
    const std::vector<Point> polyline = RandomPolyline(9, isClosed, random);
    const Reference reference(polyline, form, isClosed);
    std::vector<double> parameters;
    std::vector<Point> positions;
    for (int i = 0; i < 60; ++i)
    {
      parameters.push_back(random.Between(0.0, 1.0));
      positions.push_back(reference.At(parameters.back()));
    }
    const PolyDataPointer curve = MakePolyline(polyline);
    const auto crossed = MakeFilter<vtkSkdTreeCurveSurfaceIntersection>(
      curve, Targets(positions, VTK_TRIANGLE, random), form);
    ExpectMet(crossed, "SkdCellId", parameters, positions);
    const auto met =
      MakeFilter<vtkSkdTreeCurveIntersection>(curve, Targets(positions, VTK_LINE, random), form);
    ExpectMet(met, "SkdOtherCurveCellId", parameters, positions);
  }
}

template <class Filter>
void ExpectRebuiltByParameters()
{
  const Form form{ Kochanek };
  const PolyDataPointer curve = MakePolyline({ { 0, 0, 0 }, { 1, 1, 0 }, { 2, 0, 0 } });
  const PolyDataPointer wall =
    MakePolyData(OneCell(VTK_QUAD, { { .5, -9, -9 }, { .5, 9, -9 }, { .5, 9, 9 }, { .5, -9, 9 } }));
  const PolyDataPointer pole = MakePolyline({ { .5, -9, 0 }, { .5, 9, 0 } });
  const bool isOfSurfaces = std::is_same_v<Filter, vtkSkdTreeCurveSurfaceIntersection>;
  const auto filter = MakeFilter<Filter>(curve, isOfSurfaces ? wall : pole, form);
  const std::vector<Point> before = OutputPoints(filter);
  ASSERT_EQ(before.size(), 1u);
  filter->SetTension(1.0); // straight between its points
  const std::vector<Point> after = OutputPoints(filter);
  ASSERT_EQ(after.size(), 1u);
  EXPECT_NEAR(after[0][1], 0.5, 1e-12);
  EXPECT_GT(std::abs(before[0][1] - 0.5), 0.01);
  filter->SetTension(0.0);
  EventCounter events(filter);
  EXPECT_EQ(OutputPoints(filter), before);
  EXPECT_EQ(events.Warnings + events.Errors, 0);
}

TEST(CurveSplines, FollowTheirParametersWhenTheyChange)
{
  ExpectRebuiltByParameters<vtkSkdTreeCurveIntersection>();
  ExpectRebuiltByParameters<vtkSkdTreeCurveSurfaceIntersection>();
}

}
