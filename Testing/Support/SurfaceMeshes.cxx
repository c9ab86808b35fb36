// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Support/SurfaceMeshes.h"

namespace skdtest
{

Mesh CubeQuads(int n)
{
  Mesh mesh;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int side = 0; side < 2; ++side)
    {
      for (int cell = 0; cell < n * n; ++cell)
      {
        const int i = cell % n;
        const int j = cell / n;
        const int corners[4][2] = { { i, j }, { i + 1, j }, { i + 1, j + 1 }, { i, j + 1 } };
        Ids ids;
        for (const auto& corner : corners)
        {
          Point p;
          p[axis] = side * n;
          p[(axis + 1) % 3] = corner[0];
          p[(axis + 2) % 3] = corner[1];
          ids.push_back(mesh.Add(p));
        }
        if (side == 0)
        {
          std::reverse(ids.begin(), ids.end());
        }
        mesh.Add(VTK_QUAD, ids);
      }
    }
  }
  return Welded(mesh);
}

Mesh CubeTriangles(int n)
{
  return Triangulated(CubeQuads(n));
}

Mesh Octahedron(double size)
{
  Mesh mesh;
  mesh.Points = { { size, 0, 0 }, { -size, 0, 0 }, { 0, size, 0 }, { 0, -size, 0 }, { 0, 0, size },
    { 0, 0, -size } };
  for (int octant = 0; octant < 8; ++octant)
  {
    const vtkIdType x = octant & 1;
    const vtkIdType y = 2 + ((octant >> 1) & 1);
    const vtkIdType z = 4 + ((octant >> 2) & 1);
    mesh.Add(VTK_TRIANGLE, { x, y, z });
  }
  return mesh;
}

Mesh SphereQuads(int n)
{
  return CubeQuads(n).Map(
    [n](const Point& p)
    {
      const Point out = (2.0 / n) * p - Point{ 1, 1, 1 };
      return (1.0 / Length(out)) * out;
    });
}

Mesh SphereTriangles(int n)
{
  return Triangulated(SphereQuads(n));
}

Mesh TorusQuads(int around, int across)
{
  const double pi = 3.14159265358979323846;
  Mesh mesh;
  for (int i = 0; i < around; ++i)
  {
    for (int j = 0; j < across; ++j)
    {
      const double u = 2 * pi * i / around;
      const double v = 2 * pi * j / across;
      const double r = 1 + 0.35 * std::cos(v);
      mesh.Add(Point{ r * std::cos(u), r * std::sin(u), 0.35 * std::sin(v) });
    }
  }
  for (int i = 0; i < around; ++i)
  {
    for (int j = 0; j < across; ++j)
    {
      const vtkIdType iNext = (i + 1) % around;
      const vtkIdType jNext = (j + 1) % across;
      mesh.Add(VTK_QUAD,
        { i * across + j, iNext * across + j, iNext * across + jNext, i * across + jNext });
    }
  }
  return mesh;
}

Mesh TorusTriangles(int around, int across)
{
  return Triangulated(TorusQuads(around, across));
}

Mesh Sheet(int n, int type)
{
  Mesh mesh;
  for (int j = 0; j <= n; ++j)
  {
    for (int i = 0; i <= n; ++i)
    {
      mesh.Add(Point{ double(i), double(j), 0.0 });
    }
  }
  for (int j = 0; j < n; ++j)
  {
    for (int i = 0; i < n; ++i)
    {
      const vtkIdType a = j * (n + 1) + i;
      const vtkIdType b = a + n + 1;
      if (type == VTK_PIXEL)
      {
        mesh.Add(type, { a, a + 1, b, b + 1 });
      }
      else
      {
        mesh.Add(VTK_QUAD, { a, a + 1, b + 1, b });
      }
    }
  }
  return type == VTK_TRIANGLE ? Triangulated(mesh) : mesh;
}

Mesh Hexagons(int n)
{
  const double pi = 3.14159265358979323846;
  Mesh mesh;
  for (int cell = 0; cell < n * n; ++cell)
  {
    Ids ids;
    for (int corner = 0; corner < 6; ++corner)
    {
      const double angle = pi * corner / 3;
      const double x = 2.5 * (cell % n) + std::cos(angle);
      const double y = 2.5 * (cell / n) + std::sin(angle);
      ids.push_back(mesh.Add(Point{ x, y, 0.25 * x - 0.5 * y }));
    }
    mesh.Add(VTK_POLYGON, ids);
  }
  return mesh;
}

Mesh Strips(int n)
{
  Mesh mesh = Sheet(n, VTK_QUAD);
  mesh.Map(
    [](const Point& p) {
      return Point{ p[0], p[1], 0.4 * std::sin(p[0]) * std::cos(p[1]) };
    });
  mesh.Cells.clear();
  for (int j = 0; j < n; ++j)
  {
    Ids ids;
    for (int i = 0; i <= n; ++i)
    {
      ids.push_back(j * (n + 1) + i);
      ids.push_back((j + 1) * (n + 1) + i);
    }
    mesh.Add(VTK_TRIANGLE_STRIP, ids);
  }
  return mesh;
}

Mesh Helix(int n, int type)
{
  Mesh mesh;
  for (int i = 0; i <= n; ++i)
  {
    mesh.Add(Point{ std::cos(0.3 * i), std::sin(0.3 * i), 0.05 * i });
  }
  const int step = type == VTK_LINE ? 1 : 4;
  for (int i = 0; i < n; i += step)
  {
    Ids ids;
    for (int k = i; k <= std::min(i + step, n); ++k)
    {
      ids.push_back(k);
    }
    mesh.Add(type, ids);
  }
  return mesh;
}

Mesh Cloud(int n, int type)
{
  Random random(7);
  Mesh mesh;
  const int step = type == VTK_VERTEX ? 1 : 3;
  for (int i = 0; i < n; i += step)
  {
    Ids ids;
    for (int k = 0; k < step; ++k)
    {
      ids.push_back(mesh.Add(random.InBox({ 0, 1, 0, 1, 0, 1 })));
    }
    mesh.Add(type, ids);
  }
  return mesh;
}

Mesh TriangleSoup(int n, double size)
{
  Random random(11);
  Mesh mesh;
  for (int i = 0; i < n; ++i)
  {
    const Point center = random.InBox({ 0, 1, 0, 1, 0, 1 });
    Ids ids;
    for (int k = 0; k < 3; ++k)
    {
      ids.push_back(mesh.Add(center + size * random.Direction()));
    }
    mesh.Add(VTK_TRIANGLE, ids);
  }
  return mesh;
}

Mesh Together(const std::vector<Mesh>& meshes)
{
  Mesh all;
  for (const Mesh& mesh : meshes)
  {
    const auto first = static_cast<vtkIdType>(all.Points.size());
    all.Points.insert(all.Points.end(), mesh.Points.begin(), mesh.Points.end());
    for (CellSpec cell : mesh.Cells)
    {
      for (vtkIdType& id : cell.Points)
      {
        id += first;
      }
      all.Cells.push_back(cell);
    }
  }
  return all;
}

}
