// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// Convex point sets, whose IntersectWithLine and EvaluatePosition take global point ids for those
// of the cell since VTK 9.3: here the cell's points come last of many.

#include "Support/LocatorCalls.h"
#include "Support/NamedMeshes.h"

#include "vtkDoubleArray.h"
#include "vtkPointData.h"
#include "vtkSkdTreeCurveSurfaceIntersection.h"
#include "vtkSkdTreeProbe.h"

#include <gtest/gtest.h>

using namespace skdtest;

namespace
{

constexpr vtkIdType Unused = 1000;

/// The corners of the unit cube as one cell, behind points that no cell has.
GridPointer Cube()
{
  Mesh mesh;
  mesh.Points.assign(Unused, Point{ 0.5, 0.5, 0.5 });
  Ids ids;
  for (int corner = 0; corner < 8; ++corner)
  {
    ids.push_back(static_cast<vtkIdType>(mesh.Points.size()));
    mesh.Points.push_back({ double(corner & 1), double(corner / 2 & 1), double(corner / 4) });
  }
  mesh.Add(VTK_CONVEX_POINT_SET, ids);
  return MakeGrid(mesh);
}

double Linear(const Point& p)
{
  return 3.0 + 2.0 * p[0] - 5.0 * p[1] + 7.0 * p[2];
}

TEST(ConvexPointSets, LinesMeetTheOutsideOnly)
{
  const GridPointer grid = Cube();
  const LocatorPointer locator = MakeLocator(grid);
  Random random(7);
  for (int i = 0; i < 200; ++i)
  {
    const Point from = random.InBox({ 0.01, 0.99, 0.01, 0.99, 0.01, 0.99 });
    const int axis = i % 3;
    Point to = from;
    to[axis] += i % 2 == 0 ? 2.0 : -2.0;
    const LineHit out = FindFirstHit(locator, from, to);
    ASSERT_EQ(out.Cell, 0);
    EXPECT_NEAR(out.X[axis], i % 2 == 0 ? 1.0 : 0.0, 1e-14);
    const LineHit in = FindFirstHit(locator, to, from);
    ASSERT_EQ(in.Cell, 0);
    EXPECT_LT(Distance(in.X, out.X), 1e-14);
  }
}

TEST(ConvexPointSets, CurvesMeetTheirFaces)
{
  vtkNew<vtkSkdTreeCurveSurfaceIntersection> filter;
  const PolyDataPointer line = PolyDataPointer::New();
  line->SetPoints(MakePoints({ { -1.0, 0.3, 0.6 }, { 2.0, 0.4, 0.7 } }));
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 0, 1 });
  line->SetLines(lines);
  filter->SetInputDataObject(line);
  filter->SetSourceData(Cube());
  filter->VolumeFacesOn();
  filter->Update();
  EXPECT_EQ(vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0))->GetNumberOfPoints(), 2);
}

TEST(ConvexPointSets, LinearFieldsAreProbedExactly)
{
  const GridPointer grid = Cube();
  vtkNew<vtkDoubleArray> field;
  field->SetName("Linear");
  Point p;
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    grid->GetPoint(i, p.data());
    field->InsertNextValue(Linear(p));
  }
  grid->GetPointData()->AddArray(field);
  Random random(7);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int i = 0; i < 100; ++i)
  {
    points->InsertNextPoint(random.InBox({ 0, 1, 0, 1, 0, 1 }).data());
  }
  vtkNew<vtkPolyData> where;
  where->SetPoints(points);
  vtkNew<vtkSkdTreeProbe> probe;
  probe->SetInputDataObject(where);
  probe->SetSourceData(grid);
  probe->Update();
  auto* output = vtkDataSet::SafeDownCast(probe->GetOutputDataObject(0));
  vtkDataArray* probed = output->GetPointData()->GetArray("Linear");
  ASSERT_NE(probed, nullptr);
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    output->GetPoint(i, p.data());
    EXPECT_NEAR(probed->GetTuple1(i), Linear(p), 1e-12);
  }
}

}
