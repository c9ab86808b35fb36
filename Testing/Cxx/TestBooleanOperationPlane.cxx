// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeBooleanOperation: a plane cuts the Input, as a half space does.

#include "Support/ClosedSurface.h"
#include "Support/Reported.h"
#include "Support/SolidRun.h"
#include "Support/SurfaceMeshes.h"

#include <cmath>

using namespace skdtest;

namespace
{
using Filter = vtkSkdTreeBooleanOperation;

struct Plane
{
  Point Origin;
  Point Normal;
};

void SetPlane(Filter* filter, const Plane& plane)
{
  filter->CutByPlaneOn();
  filter->SetPlaneOrigin(plane.Origin.data());
  filter->SetPlaneNormal(plane.Normal.data());
}

vtkPolyData* OutputOf(Filter* filter, int port = 0)
{
  filter->Update();
  return vtkPolyData::SafeDownCast(filter->GetOutputDataObject(port));
}

/// A body that a plane cuts by an operation.
struct Cut
{
  vtkNew<Filter> Run;
  EventCounter Events{ this->Run };

  Cut(const Mesh& body, const Plane& plane, int operation)
  {
    this->Run->SetInputData(MakePolyData(body));
    this->Run->SetOperation(operation);
    SetPlane(this->Run, plane);
  }

  ~Cut() { EXPECT_EQ(this->Events.Errors, 0) << this->Events.Error; }

  vtkPolyData* Get(int port = 0) { return OutputOf(this->Run, port); }
};

/// What is behind a plane, as far as a large box reaches.
Mesh HalfSpace(const Plane& plane)
{
  const Point n = (1.0 / Length(plane.Normal)) * plane.Normal;
  const Point axis = std::abs(n[0]) < 0.6 ? Point{ 1, 0, 0 } : Point{ 0, 1, 0 };
  const Point u = (1.0 / Length(Cross(axis, n))) * Cross(axis, n);
  const Point v = Cross(n, u);
  return BoxTriangles({ -9, -9, -9 }, { 9, 9, 0 })
    .Map([&](const Point& p) { return plane.Origin + p[0] * u + p[1] * v + p[2] * n; });
}

/// The area of polygons, with the sum of their normals.
Point AreaVectorOf(vtkPolyData* polygons)
{
  const Mesh triangles = MeshOf(Triangulated(polygons));
  Point sum{ 0, 0, 0 };
  for (const CellSpec& cell : triangles.Cells)
  {
    const Point& a = triangles.Points[cell.Points[0]];
    sum =
      sum + 0.5 * Cross(triangles.Points[cell.Points[1]] - a, triangles.Points[cell.Points[2]] - a);
  }
  return sum;
}

Mesh PointsAlone()
{
  Mesh mesh;
  mesh.Add(Point{ 1, 2, 3 });
  return mesh;
}

TEST(BooleanOperationPlane, CutsAsAHalfSpaceDoes)
{
  for (int number = 0; number < 24; ++number)
  {
    SCOPED_TRACE(number);
    Random random(static_cast<std::uint64_t>(number));
    std::string what;
    const Mesh body = AnySolid(random, what);
    SCOPED_TRACE(what);
    const int axis = random.Index(6);
    Plane plane{ random.InBox({ -0.7, 0.7, -0.7, 0.7, -0.7, 0.7 }), random.Direction() };
    plane.Normal = axis < 3 ? Point{ 1.0 * (axis == 0), -2.0 * (axis == 1), 1e-9 * (axis == 2) }
                            : (1.0 + random.Index(3)) * plane.Normal;
    const Mesh half = HalfSpace(plane);
    Cut split(body, plane, Filter::SPLIT);
    EXPECT_EQ(CountEdges(split.Get()).Open, 0u);
    EXPECT_EQ(CountEdges(Cleaned(split.Get())).Open, 0u);
    const std::vector<double> parts = ReportedRow(split.Get(), "PartVolumes");
    const double expected[] = { Measures(Combine(body, half, Filter::DIFFERENCE)).Volume,
      Measures(Combine(body, half, Filter::INTERSECTION)).Volume };
    for (const std::size_t part : { 0, 1 })
    {
      EXPECT_NEAR(part < parts.size() ? parts[part] : 0.0, expected[part], 1e-13);
      Cut alone(body, plane, part == 0 ? Filter::DIFFERENCE : Filter::INTERSECTION);
      ExpectClosed(alone.Get());
      EXPECT_NEAR(Reported(alone.Get(), "Volume"), expected[part], 1e-13);
    }
  }
}

/// In the plane to the last bit if that is normal to an axis, else to rounding; with its normal.
TEST(BooleanOperationPlane, HasItsSectionOnItsOwnOutput)
{
  const Mesh ball = Outward(SphereTriangles(6));
  for (const int operation : { Filter::SPLIT, Filter::DIFFERENCE, Filter::INTERSECTION })
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      Plane plane{ { 0.1, -0.3, 0.7 }, { 0, 0, 0 } };
      plane.Normal[axis] = axis == 1 ? -3.0 : 1e-3;
      Cut cut(ball, plane, operation);
      vtkPolyData* section = cut.Get(1);
      ASSERT_EQ(section->GetNumberOfCells(), 1);
      double bounds[6];
      section->GetBounds(bounds);
      EXPECT_EQ(bounds[2 * axis], plane.Origin[axis]);
      EXPECT_EQ(bounds[2 * axis + 1], plane.Origin[axis]);
      EXPECT_GT(Dot(AreaVectorOf(section), plane.Normal), 0.0);
    }
  }
  const Plane diagonal{ { 0, 0, 0 }, { 1, 1, 1 } };
  Cut cut(BoxTriangles({ -1, -1, -1 }, { 1, 1, 1 }), diagonal, Filter::SPLIT);
  vtkPolyData* hexagon = cut.Get(1);
  ASSERT_EQ(hexagon->GetNumberOfCells(), 1);
  EXPECT_EQ(hexagon->GetCell(0)->GetNumberOfPoints(), 6);
  EXPECT_NEAR(Length(AreaVectorOf(hexagon)), 3.0 * std::sqrt(3.0), 1e-14);
}

TEST(BooleanOperationPlane, ThatPassesOrTouchesLeavesTheBodyWhole)
{
  const Mesh box = BoxTriangles({ -1, -1, -1 }, { 1, 1, 1 });
  for (const double z : { 1.0, 3.0, 1e10, 1e200, 1e308 })
  {
    SCOPED_TRACE(z);
    for (const double side : { 1.0, -1.0 })
    {
      const Plane plane{ { 0, 0, side * z }, { 0, 0, 1 } };
      EXPECT_NEAR(Reported(Cut(box, plane, Filter::INTERSECTION).Get(), "Volume"),
        side > 0 ? 8.0 : 0.0, 1e-13);
      EXPECT_NEAR(
        Reported(Cut(box, plane, Filter::DIFFERENCE).Get(), "Volume"), side > 0 ? 0.0 : 8.0, 1e-13);
      EXPECT_EQ(Cut(box, plane, Filter::SPLIT).Get(1)->GetNumberOfCells(), 0);
    }
  }
  for (const double far : { 1e3, 1e15, 1e300 }) // where its origin is does not matter along it
  {
    const Plane plane{ { far, -far, 0.25 }, { 0, 0, 1e300 } };
    EXPECT_NEAR(Reported(Cut(box, plane, Filter::DIFFERENCE).Get(), "Volume"), 3.0, 1e-13) << far;
  }
}

/// A ball with a gap is cut as the whole one is, with its section.
TEST(BooleanOperationPlane, CutsOpenSurfacesByWindingNumbers)
{
  const Mesh ball = Outward(SphereTriangles(12));
  Mesh open = ball;
  const auto isOnTop = [&](const CellSpec& cell)
  {
    return ball.Points[cell.Points[0]][2] + ball.Points[cell.Points[1]][2] +
      ball.Points[cell.Points[2]][2] >
      3.0 * 0.95;
  };
  open.Cells.erase(std::remove_if(open.Cells.begin(), open.Cells.end(), isOnTop), open.Cells.end());
  ASSERT_LT(open.Cells.size(), ball.Cells.size());
  for (const Point& normal : { Point{ 0, 0, 1 }, Point{ 0.3, 0.2, 1 } })
  {
    const Plane plane{ { 0.01, 0.02, 0.0625 }, normal };
    for (const int operation : { Filter::INTERSECTION, Filter::SPLIT })
    {
      SCOPED_TRACE(operation);
      Cut whole(ball, plane, operation);
      Cut cut(open, plane, operation);
      cut.Run->SetOpenSurfaces(Filter::WINDING_NUMBER);
      const Point expected = AreaVectorOf(whole.Get(1));
      EXPECT_NEAR(Length(AreaVectorOf(cut.Get(1)) - expected), 0.0, 1e-13);
      EXPECT_NEAR(Length(expected), 3.1, 0.1);
      if (operation == Filter::INTERSECTION)
      {
        ExpectClosed(cut.Get());
        EXPECT_NEAR(Reported(cut.Get(), "Volume"), Reported(whole.Get(), "Volume"), 1e-13);
      }
    }
  }
}

TEST(BooleanOperationPlane, CutsOnlyWithoutASource)
{
  const Mesh box = BoxTriangles({ -1, -1, -1 }, { 1, 1, 1 });
  Cut cut(box, { { 0, 0, 0 }, { 0, 0, 1 } }, Filter::DIFFERENCE);
  EXPECT_NEAR(Reported(cut.Get(), "Volume"), 4.0, 1e-13);
  cut.Run->SetTranslation(5.0, 5.0, 5.0); // of a Source
  EXPECT_NEAR(Reported(cut.Get(), "Volume"), 4.0, 1e-13);
  EXPECT_EQ(Reported(cut.Get(), "TreesBuilt"), 0.0);
  cut.Run->SetOperationToIntersection();
  EXPECT_NEAR(Reported(cut.Get(), "Volume"), 4.0, 1e-13);
  EXPECT_EQ(Reported(cut.Get(), "TreesBuilt"), 0.0);
  cut.Run->SetPlaneOrigin(0, 0, 0.5);
  EXPECT_NEAR(Reported(cut.Get(), "Volume"), 6.0, 1e-13);
  cut.Run->SetTranslation(0.0, 0.0, 0.0);
  cut.Run->SetSourceData(MakePolyData(BoxTriangles({ 0, 0, 0 }, { 3, 3, 3 })));
  EXPECT_NEAR(Reported(cut.Get(), "Volume"), 1.0, 1e-13);
  EXPECT_EQ(cut.Events.Warnings, 0);
}

TEST(BooleanOperationPlane, ThatCannotCutIsToldOf)
{
  const Mesh box = BoxTriangles({ -1, -1, -1 }, { 1, 1, 1 });
  for (const int operation : { Filter::UNION, Filter::IMPRINT, Filter::AT_LEAST })
  {
    Cut cut(box, { { 0, 0, 0 }, { 0, 0, 1 } }, operation);
    cut.Get();
    EXPECT_EQ(cut.Events.Warnings, 1);
    EXPECT_NE(cut.Events.Warning.find("CutByPlane"), std::string::npos);
  }
  vtkNew<Filter> filter;
  filter->SetInputData(MakePolyData(box));
  filter->SetOperationToSplit();
  SetPlane(filter, { { 0, 0, 0 }, { 0, 0, 0 } });
  EventCounter events(filter);
  EXPECT_EQ(OutputOf(filter)->GetNumberOfCells(), 0);
  EXPECT_EQ(events.Errors, 1);
  EXPECT_NE(events.Error.find("PlaneNormal"), std::string::npos);
}

/// Tiny and large ones, flat ones and none at all.
TEST(BooleanOperationPlane, CutsInputsOfAnySize)
{
  for (const double size : { 1e-200, 1e-30, 1e30, 1e150, 1e290 })
  {
    SCOPED_TRACE(size);
    const Mesh box = BoxTriangles({ -size, -size, -size }, { size, size, size });
    Cut cut(box, { { 0, 0, 0.5 * size }, { 0, 0, 1 } }, Filter::SPLIT);
    vtkPolyData* section = cut.Get(1);
    ASSERT_EQ(section->GetNumberOfCells(), 1);
    double bounds[6];
    section->GetBounds(bounds);
    EXPECT_EQ(bounds[4], 0.5 * size);
    EXPECT_EQ(bounds[5], 0.5 * size);
    EXPECT_EQ(bounds[1], size);
  }
  for (const Mesh& empty : { Mesh(), PointsAlone() })
  {
    Cut cut(empty, { { 0, 0, 0 }, { 0, 0, 1 } }, Filter::SPLIT);
    EXPECT_EQ(cut.Get()->GetNumberOfCells(), 0);
    EXPECT_EQ(cut.Get(1)->GetNumberOfCells(), 0);
  }
}
}
