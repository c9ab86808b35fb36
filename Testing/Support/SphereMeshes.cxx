// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Support/SphereMeshes.h"

#include <algorithm>
#include <cmath>

namespace skdtest
{

namespace
{
Point Unit(const Point& x)
{
  return (1.0 / std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2])) * x;
}

double Determinant(const Point& a, const Point& b, const Point& c)
{
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
    a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/// Triangles of an icosahedron cut n x n, welded.
Mesh Icosphere(int n)
{
  const double g = 0.5 * (1.0 + std::sqrt(5.0));
  const std::vector<Point> corners = { { -1, g, 0 }, { 1, g, 0 }, { -1, -g, 0 }, { 1, -g, 0 },
    { 0, -1, g }, { 0, 1, g }, { 0, -1, -g }, { 0, 1, -g }, { g, 0, -1 }, { g, 0, 1 },
    { -g, 0, -1 }, { -g, 0, 1 } };
  const int faces[20][3] = { { 0, 11, 5 }, { 0, 5, 1 }, { 0, 1, 7 }, { 0, 7, 10 }, { 0, 10, 11 },
    { 1, 5, 9 }, { 5, 11, 4 }, { 11, 10, 2 }, { 10, 7, 6 }, { 7, 1, 8 }, { 3, 9, 4 }, { 3, 4, 2 },
    { 3, 2, 6 }, { 3, 6, 8 }, { 3, 8, 9 }, { 4, 9, 5 }, { 2, 4, 11 }, { 6, 2, 10 }, { 8, 6, 7 },
    { 9, 8, 1 } };
  Mesh mesh;
  std::map<std::array<long, 3>, vtkIdType>
    known; // points of the icosahedron, by their place in n-ths
  const auto add = [&](const int* face, int i, int j)
  {
    const int k = n - i - j;
    const Point x =
      double(i) * corners[face[0]] + double(j) * corners[face[1]] + double(k) * corners[face[2]];
    const auto position = [&](int axis) { return std::lround(x[axis] * 1e6); };
    const auto [at, isNew] = known.insert({ { position(0), position(1), position(2) }, 0 });
    at->second = isNew ? mesh.Add(Unit(x)) : at->second;
    return at->second;
  };
  for (const auto& face : faces)
  {
    for (int i = 0; i < n; ++i)
    {
      for (int j = 0; i + j < n; ++j)
      {
        mesh.Add(VTK_TRIANGLE, { add(face, i + 1, j), add(face, i, j + 1), add(face, i, j) });
        if (i + j + 1 < n)
        {
          mesh.Add(
            VTK_TRIANGLE, { add(face, i + 1, j + 1), add(face, i, j + 1), add(face, i + 1, j) });
        }
      }
    }
  }
  return mesh;
}
}

Mesh CubedSphere(int n)
{
  Mesh mesh;
  std::map<std::array<long, 3>, vtkIdType> known;
  const auto add = [&](int face, int i, int j)
  {
    const double quarter = std::atan(1.0);
    const double u = std::tan(quarter * (2.0 * i - n) / n);
    const double v = std::tan(quarter * (2.0 * j - n) / n);
    const int axis = face % 3;
    const double side = face < 3 ? 1.0 : -1.0;
    Point x;
    x[axis] = side;
    x[(axis + 1) % 3] = side * u;
    x[(axis + 2) % 3] = v;
    const auto position = [&](int k) { return std::lround(x[k] * 1e9); };
    const auto [at, isNew] = known.insert({ { position(0), position(1), position(2) }, 0 });
    at->second = isNew ? mesh.Add(Unit(x)) : at->second;
    return at->second;
  };
  for (int face = 0; face < 6; ++face)
  {
    for (int i = 0; i < n; ++i)
    {
      for (int j = 0; j < n; ++j)
      {
        mesh.Add(VTK_QUAD,
          { add(face, i, j), add(face, i + 1, j), add(face, i + 1, j + 1), add(face, i, j + 1) });
      }
    }
  }
  return mesh;
}

Mesh IcosahedralDual(int n)
{
  const Mesh triangles = Icosphere(n);
  Mesh dual;
  std::vector<Ids> around(triangles.Points.size());
  for (const CellSpec& cell : triangles.Cells)
  {
    Point middle = { 0, 0, 0 };
    for (const vtkIdType corner : cell.Points)
    {
      middle = middle + triangles.Points[corner];
    }
    const vtkIdType id = dual.Add(Unit(middle));
    for (const vtkIdType corner : cell.Points)
    {
      around[corner].push_back(id);
    }
  }
  for (std::size_t i = 0; i < around.size(); ++i)
  {
    const Point& axis = triangles.Points[i];
    const Point first = dual.Points[around[i].front()];
    const auto angle = [&](vtkIdType id)
    {
      const Point& x = dual.Points[id];
      const double cosine = Dot(x, first) - Dot(x, axis) * Dot(first, axis);
      return std::atan2(Determinant(axis, first, x), cosine);
    };
    std::sort(around[i].begin(), around[i].end(),
      [&](vtkIdType a, vtkIdType b) { return angle(a) < angle(b); });
    dual.Add(VTK_POLYGON, around[i]);
  }
  return dual;
}

std::vector<double> CellAverages(
  const Mesh& mesh, const std::function<double(const Point&)>& function)
{
  const double nodes[] = { 0.033765242898423975, 0.16939530676686776, 0.38069040695840156,
    0.61930959304159844, 0.83060469323313224, 0.96623475710157602 };
  const double weights[] = { 0.085662246189585178, 0.18038078652406930, 0.23395696728634552,
    0.23395696728634552, 0.18038078652406930, 0.085662246189585178 };
  std::vector<double> averages;
  for (const CellSpec& cell : mesh.Cells)
  {
    double sum = 0.0, area = 0.0;
    const Point& a = mesh.Points[cell.Points[0]];
    for (std::size_t k = 1; k + 1 < cell.Points.size(); ++k)
    {
      const Point& b = mesh.Points[cell.Points[k]];
      const Point& c = mesh.Points[cell.Points[k + 1]];
      for (int i = 0; i < 6; ++i)
      {
        for (int j = 0; j < 6; ++j)
        {
          const double u = nodes[i];
          const double v = nodes[j] * (1.0 - u);
          const Point x = (1.0 - u - v) * a + u * b + v * c;
          const double length = std::sqrt(Dot(x, x));
          const double w =
            weights[i] * weights[j] * (1.0 - u) * Determinant(a, b, c) / (length * length * length);
          sum += w * function((1.0 / length) * x);
          area += w;
        }
      }
    }
    averages.push_back(sum / area);
  }
  return averages;
}

double L2Error(
  const std::vector<double>& a, const std::vector<double>& b, const std::vector<double>& areas)
{
  double error = 0.0, size = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    error += areas[i] * (a[i] - b[i]) * (a[i] - b[i]);
    size += areas[i] * b[i] * b[i];
  }
  return std::sqrt(error / size);
}

}
