// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// Curves made of several cells or pieces: an intersection in a joint is reported once, and is what
// it would be on one curve.

#include "Support/CurveRun.h"

#include "vtkSkdTreeCurveIntersection.h"
#include "vtkSkdTreeCurveSurfaceIntersection.h"

#include <gtest/gtest.h>

using namespace skdtest;

namespace
{

using Numbers = std::vector<double>;

constexpr auto MakeFilter = [](vtkDataObject* curves, vtkDataObject* others = nullptr)
{ return MakeCurveFilter<vtkSkdTreeCurveIntersection>(curves, others); };

constexpr auto MakeSurfaceFilter = [](vtkDataObject* curves, vtkDataObject* surfaces)
{ return MakeCurveFilter<vtkSkdTreeCurveSurfaceIntersection>(curves, surfaces); };

/// Adds a polyline as lines that are cells each, with points of their own.
void AddLines(Mesh& mesh, const std::vector<Point>& points)
{
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
  {
    mesh.Add(VTK_LINE, { mesh.Add(points[i]), mesh.Add(points[i + 1]) });
  }
}

PolyDataPointer LinesOf(const std::vector<Point>& points)
{
  Mesh mesh;
  AddLines(mesh, points);
  return MakePolyData(mesh);
}

Numbers KindsOf(vtkDataObject* curves, vtkDataObject* others = nullptr)
{
  return OutputArray(MakeFilter(curves, others), "SkdKind");
}

/// y = left x^degree for x < 0 and right x^degree for x > 0, to x = -1 and 1, a Bezier cell each;
/// one is reversed by choice.
GridPointer TwoPowers(int degree, double left, double right, bool isTurned = false)
{
  Mesh mesh;
  const auto add = [&](double x, double y, bool rotated)
  {
    // Control points: all but the last on the axis.
    Ids ids;
    for (int i = 0; i <= degree; ++i)
    {
      ids.push_back(mesh.Add({ x * i / degree, i == degree ? y : 0.0, 0.0 }));
    }
    if (rotated)
    {
      std::reverse(ids.begin(), ids.end());
    }
    std::rotate(ids.begin() + 1, ids.end() - 1, ids.end()); // ends first
    mesh.Add(VTK_BEZIER_CURVE, ids);
  };
  add(-1.0, left, !isTurned);
  add(1.0, right, false);
  return MakeGrid(mesh);
}

const std::vector<Point> Axis{ { -2, 0, 0 }, { 3, 0, 0 } };

/// Four triangles about the origin, in y = 0; normals along y.
PolyDataPointer Fan()
{
  Mesh mesh;
  const vtkIdType middle = mesh.Add({ 0, 0, 0 });
  const Ids rim{ mesh.Add({ -3, 0, -3 }), mesh.Add({ -3, 0, 3 }), mesh.Add({ 3, 0, 3 }),
    mesh.Add({ 3, 0, -3 }) };
  for (std::size_t i = 0; i < 4; ++i)
  {
    mesh.Add(VTK_TRIANGLE, { middle, rim[i], rim[(i + 1) % 4] });
  }
  return MakePolyData(mesh);
}

}

TEST(CurveJoints, ACrossingInAJointIsReportedOnce)
{
  const std::vector<Point> bent{ { -1, -1, 0 }, { 0, 0, 0 }, { 2, 1, 0 } };
  const std::vector<Point> across{ { -1, 1, 0 }, { 0, 0, 0 }, { 1, -1, 0 } };
  for (const PolyDataPointer& one : { MakePolyline(bent), LinesOf(bent) })
  {
    for (const PolyDataPointer& other : { MakePolyline(across), LinesOf(across) })
    {
      EXPECT_EQ(KindsOf(one, other), Numbers{ 0 });
      EXPECT_EQ(KindsOf(other, one), Numbers{ 0 });
    }
  }
  const auto filter = MakeFilter(LinesOf(bent), LinesOf(across));
  filter->IgnoreJointsOff();
  EXPECT_EQ(OutputPoints(filter).size(), 4u); // each cell for itself
}

TEST(CurveJoints, ACrossingOfASetWithItselfInAJointIsReportedOnce)
{
  Mesh mesh;
  AddLines(mesh, { { -1, -1, 0 }, { 0, 0, 0 }, { 2, 1, 0 } });
  EXPECT_EQ(KindsOf(MakePolyData(mesh)), Numbers{}); // only goes on
  AddLines(mesh, { { -1, 1, 0 }, { 0, 0, 0 } });
  EXPECT_EQ(KindsOf(MakePolyData(mesh)), Numbers{ 0 }); // ends on the other
  AddLines(mesh, { { 0, 0, 0 }, { 1, -1, 0 } });
  const auto filter = MakeFilter(MakePolyData(mesh));
  EXPECT_EQ(OutputArray(filter, "SkdKind"), Numbers{ 0 });
  EXPECT_EQ(OutputArray(filter, "SkdCurveParameter"), Numbers{ 1 });
  filter->IgnoreJointsOff();
  EXPECT_EQ(OutputPoints(filter).size(), 6u);
}

TEST(CurveJoints, LinesThatOnlyBeginTogetherMeetNowhere)
{
  Mesh mesh;
  for (int i = 0; i < 5; ++i)
  {
    AddLines(mesh, { { 0, 0, 0 }, { 1, 0.25 * i, 0 } });
  }
  EXPECT_EQ(KindsOf(MakePolyData(mesh)), Numbers{});
}

TEST(CurveJoints, ASplitPolylineMeetsOthersWhereAWholeOneDoes)
{
  Random random(3);
  for (int round = 0; round < 30; ++round)
  {
    std::vector<Point> whole;
    std::vector<Point> other;
    for (int i = 0; i < 12; ++i)
    {
      whole.push_back(random.InBox({ -1, 1, -1, 1, 0, 0 }));
      other.push_back(i % 3 ? random.InBox({ -1, 1, -1, 1, 0, 0 }) : whole.back());
    }
    const std::size_t expected =
      OutputPoints(MakeFilter(MakePolyline(whole), MakePolyline(other))).size();
    EXPECT_EQ(OutputPoints(MakeFilter(LinesOf(whole), MakePolyline(other))).size(), expected);
    EXPECT_EQ(OutputPoints(MakeFilter(MakePolyline(other), LinesOf(whole))).size(), expected);
    EXPECT_EQ(OutputPoints(MakeFilter(LinesOf(whole), LinesOf(other))).size(), expected);
    EXPECT_EQ(OutputPoints(MakeFilter(LinesOf(whole))).size(),
      OutputPoints(MakeFilter(MakePolyline(whole))).size());
  }
}

TEST(CurveJoints, WhatIsNotSimpleInAJointIsWhatItIsOnOneCurve)
{
  const PolyDataPointer axis = MakePolyline(Axis);
  for (const int degree : { 2, 3, 4, 5 })
  {
    for (const bool isTurned : { false, true })
    {
      const GridPointer through = TwoPowers(degree, -1, 1, isTurned);
      const GridPointer back = TwoPowers(degree, 0.5, 1, isTurned);
      EXPECT_EQ(KindsOf(through, axis), Numbers{ 0 }) << degree;
      EXPECT_EQ(KindsOf(axis, through), Numbers{ 0 }) << degree;
      EXPECT_EQ(KindsOf(back, axis), Numbers{ 1 }) << degree;
      EXPECT_EQ(KindsOf(axis, back), Numbers{ 1 }) << degree;
      const auto filter = MakeSurfaceFilter(through, Fan());
      const double sense = isTurned ? 1 : -1; // along the first cell, which is from -1 to 0
      EXPECT_EQ(OutputArray(filter, "SkdSense"), Numbers{ sense }) << degree << isTurned;
      filter->SetInputDataObject(0, back);
      EXPECT_EQ(OutputArray(filter, "SkdSense"), Numbers{ 0 }) << degree << isTurned;
      EXPECT_EQ(OutputArray(filter, "SkdKind"), Numbers{ 1 }) << degree << isTurned;
    }
  }
}

TEST(CurveJoints, APolylineGoesThroughASurfaceInAJointOnce)
{
  for (const Point& middle : { Point{ 0, 0, 0 }, Point{ 1, 0, 1 }, Point{ 1, 0, 0.25 } })
  {
    const std::vector<Point> down{ { 1, 2, 0.5 }, middle, { -1, -1, 0.25 } };
    const std::vector<Point> back{ { 1, 2, 0.5 }, middle, { -1, 1, 0.25 } };
    for (const PolyDataPointer& curve : { MakePolyline(down), LinesOf(down) })
    {
      EXPECT_EQ(OutputArray(MakeSurfaceFilter(curve, Fan()), "SkdSense"), Numbers{ 1 });
    }
    for (const PolyDataPointer& curve : { MakePolyline(back), LinesOf(back) })
    {
      EXPECT_EQ(OutputArray(MakeSurfaceFilter(curve, Fan()), "SkdSense"), Numbers{ 0 });
    }
  }
}
