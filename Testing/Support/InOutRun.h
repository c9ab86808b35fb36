// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file InOutRun.h
 * @brief vtkSkdTreePointInOut run on points and a source, and closed surfaces to be inside of
 */
#ifndef skdtest_InOutRun_h
#define skdtest_InOutRun_h

#include "Support/FilterRun.h"
#include "Support/SurfaceMeshes.h"

#include "vtkSkdTreePointInOut.h"

namespace skdtest
{

using InOut = vtkSkdTreePointInOut;
using InOutPointer = vtkSmartPointer<InOut>;

inline constexpr int AllMethods[] = { InOut::AXIS_RAYS, InOut::RANDOM_RAYS, InOut::WINDING_NUMBER,
  InOut::NEAREST_FEATURE, InOut::AUTOMATIC };

inline InOutPointer MakeInOut(
  vtkDataObject* input, vtkDataObject* source, int method = InOut::AUTOMATIC)
{
  auto made = InOutPointer::New();
  made->SetInputDataObject(0, input);
  made->SetSourceData(source);
  made->SetMethod(method);
  return made;
}

inline std::vector<double> RunFor(InOut* filter, const char* name)
{
  filter->Update();
  return PointArray(filter->GetOutputDataObject(0), name);
}

inline std::vector<Point> PointsAround(double radius, int count, int seed = 41)
{
  Random random(seed);
  std::vector<Point> points;
  for (int i = 0; i < count; ++i)
  {
    points.push_back(random.InBox({ -radius, radius, -radius, radius, -radius, radius }));
  }
  return points;
}

inline Mesh Sphere(int n, double radius, const Point& centre = { 0, 0, 0 })
{
  return SphereTriangles(n).Map([=](const Point& p) { return (radius / Length(p)) * p + centre; });
}

/// As SphereTriangles, but the faces' normals point outward.
inline Mesh Outward(Mesh mesh)
{
  for (CellSpec& cell : mesh.Cells)
  {
    const Point& a = mesh.Points[cell.Points[0]];
    const Point& b = mesh.Points[cell.Points[1]];
    const Point& c = mesh.Points[cell.Points[2]];
    if (Dot(Cross(b - a, c - a), a) < 0)
    {
      std::swap(cell.Points[1], cell.Points[2]);
    }
  }
  return mesh;
}

}

#endif
