// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceIntersectionRun.h
 * @brief vtkSkdTreeSurfaceIntersection run on surfaces, and its outputs by value
 */
#ifndef skdtest_SurfaceIntersectionRun_h
#define skdtest_SurfaceIntersectionRun_h

#include "Support/MeshBuilder.h"
#include "Support/Reported.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkSkdTreeSurfaceIntersection.h"
#include "vtkTable.h"

#include <algorithm>
#include <string>
#include <tuple>

namespace skdtest
{

using IntersectionPointer = vtkSmartPointer<vtkSkdTreeSurfaceIntersection>;

inline IntersectionPointer MakeIntersection(vtkDataObject* input, vtkDataObject* source = nullptr)
{
  auto filter = IntersectionPointer::New();
  filter->SetInputDataObject(0, input);
  if (source)
  {
    filter->SetSourceData(source);
  }
  return filter;
}

/// A row of the table of pairs.
struct CellPair
{
  vtkIdType First;
  vtkIdType Second;
  int Contact;
  double Distance;
  Point FirstPoint;
  Point SecondPoint;

  std::pair<vtkIdType, vtkIdType> Cells() const { return { this->First, this->Second }; }
};

inline std::vector<CellPair> PairsOf(vtkSkdTreeSurfaceIntersection* filter)
{
  auto table = vtkTable::SafeDownCast(filter->GetOutputDataObject(2));
  const auto column = [&](const char* name)
  { return vtkDataArray::SafeDownCast(table->GetColumnByName(name)); };
  std::vector<CellPair> pairs(table->GetNumberOfRows());
  for (std::size_t i = 0; i < pairs.size(); ++i)
  {
    const auto row = static_cast<vtkIdType>(i);
    pairs[i].First = static_cast<vtkIdType>(column("SkdFirstCellId")->GetTuple1(row));
    pairs[i].Second = static_cast<vtkIdType>(column("SkdSecondCellId")->GetTuple1(row));
    pairs[i].Contact = static_cast<int>(column("SkdContact")->GetTuple1(row));
    pairs[i].Distance = column("SkdDistance")->GetTuple1(row);
    column("SkdFirstPoint")->GetTuple(row, pairs[i].FirstPoint.data());
    column("SkdSecondPoint")->GetTuple(row, pairs[i].SecondPoint.data());
  }
  return pairs;
}

inline std::vector<CellPair> RunPairs(vtkSkdTreeSurfaceIntersection* filter)
{
  filter->Update();
  return PairsOf(filter);
}

/// The same without the arrays of each.
inline std::vector<std::pair<vtkIdType, vtkIdType>> RunCellPairs(
  vtkSkdTreeSurfaceIntersection* filter)
{
  std::vector<std::pair<vtkIdType, vtkIdType>> cells;
  for (const CellPair& pair : RunPairs(filter))
  {
    cells.push_back(pair.Cells());
  }
  return cells;
}

inline vtkPolyData* OutputOf(vtkSkdTreeSurfaceIntersection* filter, int port)
{
  return vtkPolyData::SafeDownCast(filter->GetOutputDataObject(port));
}

/// A segment of a curve: its ends, the lower first, and its cells.
using CurveSegment = std::tuple<Point, Point, vtkIdType, vtkIdType>;

/// The segments of curves, joined or not, sorted.
inline std::vector<CurveSegment> SegmentsOf(vtkPolyData* curves)
{
  std::vector<CurveSegment> segments;
  vtkDataSetAttributes* data = curves->GetPointData()->HasArray("SkdFirstCellId")
    ? static_cast<vtkDataSetAttributes*>(curves->GetPointData())
    : curves->GetCellData();
  vtkNew<vtkIdList> ids;
  for (vtkIdType line = 0; line < curves->GetNumberOfLines(); ++line)
  {
    curves->GetLines()->GetCellAtId(line, ids);
    for (vtkIdType i = 0; i + 1 < ids->GetNumberOfIds(); ++i)
    {
      const vtkIdType at =
        data == curves->GetPointData() ? ids->GetId(i) : curves->GetNumberOfVerts() + line;
      Point p;
      Point q;
      curves->GetPoint(ids->GetId(i), p.data());
      curves->GetPoint(ids->GetId(i + 1), q.data());
      const auto cell = [&](const char* name)
      { return static_cast<vtkIdType>(data->GetArray(name)->GetTuple1(at)); };
      segments.emplace_back(
        std::min(p, q), std::max(p, q), cell("SkdFirstCellId"), cell("SkdSecondCellId"));
    }
  }
  std::sort(segments.begin(), segments.end());
  return segments;
}

inline double LengthOfCurves(vtkPolyData* curves)
{
  double length = 0.0;
  for (const auto& [p, q, first, second] : SegmentsOf(curves))
  {
    length += Distance(p, q);
  }
  return length;
}

inline double AreaOfPolygons(vtkPolyData* polygons)
{
  double area = 0.0;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < polygons->GetNumberOfPolys(); ++cell)
  {
    polygons->GetPolys()->GetCellAtId(cell, ids);
    std::vector<Point> corners(ids->GetNumberOfIds());
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
      polygons->GetPoint(ids->GetId(static_cast<vtkIdType>(i)), corners[i].data());
    }
    Point sum = { 0, 0, 0 };
    for (std::size_t i = 2; i < corners.size(); ++i)
    {
      sum = sum + Cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
    }
    area += 0.5 * Length(sum);
  }
  return area;
}

/// A square [x, x + size] x [y, y + size] at a height, as one quad.
inline Mesh Square(double x, double y, double size, double z = 0.0)
{
  Mesh mesh;
  mesh.Points = { { x, y, z }, { x + size, y, z }, { x + size, y + size, z }, { x, y + size, z } };
  mesh.Add(VTK_QUAD, { 0, 1, 2, 3 });
  return mesh;
}

/// Triangles whose corners have whole coordinates from 0 to `maxDistance`: most meet in special
/// ways.
inline Mesh LatticeTriangles(int n, int maxDistance, std::uint64_t seed)
{
  Random random(seed);
  Mesh mesh;
  while (static_cast<int>(mesh.Cells.size()) < n)
  {
    Point p[3];
    for (Point& x : p)
    {
      x = { double(random.Index(maxDistance + 1)), double(random.Index(maxDistance + 1)),
        double(random.Index(maxDistance + 1)) };
    }
    if (Length(Cross(p[1] - p[0], p[2] - p[0])) > 0.0)
    {
      mesh.Add(VTK_TRIANGLE, { mesh.Add(p[0]), mesh.Add(p[1]), mesh.Add(p[2]) });
    }
  }
  return mesh;
}

}

#endif
