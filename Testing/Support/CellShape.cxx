// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Support/CellShape.h"

namespace skdtest
{

namespace
{
bool AddFaces(CellShape& s)
{
  switch (s.Type)
  {
    case VTK_TETRA:
      s.AddTriangle(0, 1, 2);
      s.AddTriangle(0, 1, 3);
      s.AddTriangle(0, 2, 3);
      s.AddTriangle(1, 2, 3);
      return true;
    case VTK_HEXAHEDRON:
    case VTK_VOXEL:
    {
      const int two = s.Type == VTK_VOXEL ? 3 : 2;
      const int top = s.Type == VTK_VOXEL ? 7 : 6;
      s.AddPatch(0, 1, two, 5 - two);
      s.AddPatch(4, 5, top, 13 - top);
      s.AddPatch(0, 1, 5, 4);
      s.AddPatch(1, two, top, 5);
      s.AddPatch(two, 5 - two, 13 - top, top);
      s.AddPatch(5 - two, 0, 4, 13 - top);
      return true;
    }
    case VTK_WEDGE:
      s.AddTriangle(0, 1, 2);
      s.AddTriangle(3, 4, 5);
      s.AddPatch(0, 1, 4, 3);
      s.AddPatch(1, 2, 5, 4);
      s.AddPatch(2, 0, 3, 5);
      return true;
    case VTK_PYRAMID:
      s.AddPatch(0, 1, 2, 3);
      s.AddTriangle(0, 1, 4);
      s.AddTriangle(1, 2, 4);
      s.AddTriangle(2, 3, 4);
      s.AddTriangle(3, 0, 4);
      return true;
    case VTK_PENTAGONAL_PRISM:
    case VTK_HEXAGONAL_PRISM:
    {
      const int n = s.Type == VTK_PENTAGONAL_PRISM ? 5 : 6;
      for (int i = 0; i < n; ++i)
      {
        s.AddPatch(i, (i + 1) % n, n + (i + 1) % n, n + i);
      }
      for (int i = 1; i + 1 < n; ++i)
      {
        s.AddTriangle(0, i, i + 1);
        s.AddTriangle(n, n + i, n + i + 1);
      }
      return true;
    }
    default:
      return false;
  }
}

bool AddCurveOrSurface(CellShape& s)
{
  const int n = static_cast<int>(s.Points.size());
  switch (s.Type)
  {
    case VTK_VERTEX:
    case VTK_POLY_VERTEX:
      s.Vertices = s.Points;
      return true;
    case VTK_LINE:
    case VTK_POLY_LINE:
      for (int i = 0; i + 1 < n; ++i)
      {
        s.Segments.push_back({ s.Points[i], s.Points[i + 1] });
      }
      return true;
    case VTK_TRIANGLE:
    case VTK_TRIANGLE_STRIP:
      for (int i = 0; i + 2 < n; ++i)
      {
        s.AddTriangle(i, i + 1, i + 2);
      }
      return true;
    case VTK_POLYGON: // convex ones only
      for (int i = 1; i + 1 < n; ++i)
      {
        s.AddTriangle(0, i, i + 1);
      }
      return true;
    case VTK_QUAD:
      s.AddPatch(0, 1, 2, 3);
      return true;
    case VTK_PIXEL:
      s.AddPatch(0, 1, 3, 2);
      return true;
    default:
      return false;
  }
}

// Faces are convex and planar.
bool AddPolyhedron(CellShape& s, vtkCell* cell)
{
  for (int face = 0; face < cell->GetNumberOfFaces(); ++face)
  {
    vtkPoints* points = cell->GetFace(face)->GetPoints();
    Point p[3];
    points->GetPoint(0, p[0].data());
    for (vtkIdType i = 1; i + 1 < points->GetNumberOfPoints(); ++i)
    {
      points->GetPoint(i, p[1].data());
      points->GetPoint(i + 1, p[2].data());
      s.Triangles.push_back({ p[0], p[1], p[2] });
    }
  }
  return true;
}
}

CellShape MakeShape(vtkCell* cell)
{
  CellShape s;
  s.Points.resize(cell->GetNumberOfPoints());
  for (std::size_t i = 0; i < s.Points.size(); ++i)
  {
    cell->GetPoints()->GetPoint(static_cast<vtkIdType>(i), s.Points[i].data());
    Extend(s.Box, s.Points[i]);
  }
  if (!s.Points.empty())
  {
    s.Type = cell->GetCellType();
    s.IsSolid = cell->GetCellDimension() == 3;
    s.IsKnown =
      s.Type == VTK_POLYHEDRON ? AddPolyhedron(s, cell) : AddCurveOrSurface(s) || AddFaces(s);
  }
  return s;
}

double BoundaryDistance(const CellShape& shape, const Point& x)
{
  double best = std::numeric_limits<double>::infinity();
  for (const Point& p : shape.Vertices)
  {
    best = std::min(best, Distance(x, p));
  }
  for (const auto& s : shape.Segments)
  {
    best = std::min(best, SegmentDistance(x, s[0], s[1]));
  }
  for (const auto& t : shape.Triangles)
  {
    best = std::min(best, TriangleDistance(x, t[0], t[1], t[2]));
  }
  for (const Patch& p : shape.Patches)
  {
    best = std::min(best, PatchDistance(x, p));
  }
  return best;
}

std::optional<double> HitTriangle(const Point& p1, const Point& p2, const std::array<Point, 3>& t)
{
  using Long = long double;
  Long d[3], e[3], f[3], s[3];
  for (int i = 0; i < 3; ++i)
  {
    d[i] = Long(p2[i]) - p1[i];
    e[i] = Long(t[1][i]) - t[0][i];
    f[i] = Long(t[2][i]) - t[0][i];
    s[i] = Long(p1[i]) - t[0][i];
  }
  const Long p[3] = { d[1] * f[2] - d[2] * f[1], d[2] * f[0] - d[0] * f[2],
    d[0] * f[1] - d[1] * f[0] };
  const Long q[3] = { s[1] * e[2] - s[2] * e[1], s[2] * e[0] - s[0] * e[2],
    s[0] * e[1] - s[1] * e[0] };
  const Long determinant = e[0] * p[0] + e[1] * p[1] + e[2] * p[2];
  if (determinant == 0)
  {
    return std::nullopt;
  }
  const Long u = (s[0] * p[0] + s[1] * p[1] + s[2] * p[2]) / determinant;
  const Long v = (d[0] * q[0] + d[1] * q[1] + d[2] * q[2]) / determinant;
  const Long at = (f[0] * q[0] + f[1] * q[1] + f[2] * q[2]) / determinant;
  const bool hits = u >= 0 && v >= 0 && u + v <= 1 && at >= 0 && at <= 1;
  return hits ? std::optional<double>(static_cast<double>(at)) : std::nullopt;
}

std::vector<std::array<Point, 3>> SeenTriangles(const CellShape& shape)
{
  std::vector<std::array<Point, 3>> found = shape.Triangles;
  for (const Patch& p : shape.Patches)
  {
    if (Distance(p.A, p.C) < Distance(p.B, p.D))
    {
      found.push_back({ p.A, p.B, p.C });
      found.push_back({ p.A, p.C, p.D });
    }
    else
    {
      found.push_back({ p.A, p.B, p.D });
      found.push_back({ p.B, p.C, p.D });
    }
  }
  return found;
}

bool IsInsideByParity(const CellShape& shape, const Point& x)
{
  const double far = 4 * Diagonal(shape.Box) + Distance(Center(shape.Box), x);
  const Point end = x + far * Point{ 0.5377, 0.6231, 0.5681 };
  int crossings = 0;
  for (const auto& t : SeenTriangles(shape))
  {
    crossings += HitTriangle(x, end, t).has_value();
  }
  return crossings % 2 == 1;
}

bool IsInsideVoxel(const CellShape& shape, const Point& x)
{
  for (int corner : { 1, 2, 4 })
  {
    const Point edge = shape.Points[corner] - shape.Points[0];
    const double along = Dot(x - shape.Points[0], edge);
    if (!(along >= 0 && along <= Dot(edge, edge)))
    {
      return false;
    }
  }
  return true;
}

}
