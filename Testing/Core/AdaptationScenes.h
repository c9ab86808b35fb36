// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef AdaptationScenes_h
#define AdaptationScenes_h

#include "Core/Meshing/Adaptation/Adapt.h"
#include "Core/Meshing/Adaptation/FitShape.h"

#include <map>
#include <random>

/// Meshes to move, and what is known of where they go.
namespace adaptation
{

using skd::SurfaceMesh;
using skd::Vector3;

constexpr double Pi = 3.14159265358979323846;

/// Points by their places on the unit sphere.
class SpherePoints
{
public:
  explicit SpherePoints(SurfaceMesh& mesh)
    : Mesh(mesh)
  {
  }

  std::uint32_t Put(const Vector3& at)
  {
    const Vector3 x = (1.0 / skd::Norm(at)) * at;
    const std::array<long, 3> key{ std::lround(x[0] * 1e8), std::lround(x[1] * 1e8),
      std::lround(x[2] * 1e8) };
    const auto next = static_cast<std::uint32_t>(this->Mesh.Points.size());
    const auto found = this->Ids.emplace(key, next);
    if (found.second)
    {
      this->Mesh.Points.push_back(x);
    }
    return found.first->second;
  }

private:
  SurfaceMesh& Mesh;
  std::map<std::array<long, 3>, std::uint32_t> Ids;
};

/// The faces of an icosahedron, each cut into four level by level.
inline SurfaceMesh MakeTriangles(int level)
{
  const double f = 0.5 * (1.0 + std::sqrt(5.0));
  const Vector3 v[12] = { { { -1, f, 0 } }, { { 1, f, 0 } }, { { -1, -f, 0 } }, { { 1, -f, 0 } },
    { { 0, -1, f } }, { { 0, 1, f } }, { { 0, -1, -f } }, { { 0, 1, -f } }, { { f, 0, -1 } },
    { { f, 0, 1 } }, { { -f, 0, -1 } }, { { -f, 0, 1 } } };
  const int faces[20][3] = { { 0, 11, 5 }, { 0, 5, 1 }, { 0, 1, 7 }, { 0, 7, 10 }, { 0, 10, 11 },
    { 1, 5, 9 }, { 5, 11, 4 }, { 11, 10, 2 }, { 10, 7, 6 }, { 7, 1, 8 }, { 3, 9, 4 }, { 3, 4, 2 },
    { 3, 2, 6 }, { 3, 6, 8 }, { 3, 8, 9 }, { 4, 9, 5 }, { 2, 4, 11 }, { 6, 2, 10 }, { 8, 6, 7 },
    { 9, 8, 1 } };
  std::vector<std::array<Vector3, 3>> triangles;
  for (const auto& face : faces)
  {
    triangles.push_back({ v[face[0]], v[face[1]], v[face[2]] });
  }
  for (; level > 0; --level)
  {
    std::vector<std::array<Vector3, 3>> finer;
    for (const auto& t : triangles)
    {
      const auto unit = [](const Vector3& x) { return (1.0 / skd::Norm(x)) * x; };
      const Vector3 a = unit(unit(t[0]) + unit(t[1]));
      const Vector3 b = unit(unit(t[1]) + unit(t[2]));
      const Vector3 c = unit(unit(t[2]) + unit(t[0]));
      finer.insert(finer.end(), { { t[0], a, c }, { t[1], b, a }, { t[2], c, b }, { a, b, c } });
    }
    triangles = finer;
  }
  SurfaceMesh mesh;
  SpherePoints points(mesh);
  for (const auto& t : triangles)
  {
    const std::uint32_t ids[3] = { points.Put(t[0]), points.Put(t[1]), points.Put(t[2]) };
    mesh.Cells.Add(ids, ids + 3);
  }
  mesh.FindEdges();
  return mesh;
}

/// A polygon around each point of triangles, of the middles of their circumcircles (the Voronoi
/// cells of the points, if the triangles are Delaunay's).
inline SurfaceMesh MakeDual(const SurfaceMesh& triangles)
{
  SurfaceMesh mesh;
  for (std::uint32_t cell = 0; cell < triangles.Cells.size(); ++cell)
  {
    const Vector3 area = skd::VectorArea(triangles, cell);
    mesh.Points.push_back((1.0 / skd::Norm(area)) * area);
  }
  for (std::uint32_t point = 0; point < triangles.Points.size(); ++point)
  {
    Vector3 u, v;
    skd::detail::MakeTangents(triangles.Points[point], u, v);
    std::map<double, std::uint32_t> around;
    for (const std::uint32_t corner : triangles.CellsOfPoint[point])
    {
      const Vector3 to = skd::CornerMean(triangles, corner);
      around[std::atan2(Dot(v, to), Dot(u, to))] = corner;
    }
    std::vector<std::uint32_t> corners;
    for (const auto& corner : around)
    {
      corners.push_back(corner.second);
    }
    mesh.Cells.Add(corners.begin(), corners.end());
  }
  mesh.FindEdges();
  return mesh;
}

/// Hexagons and twelve pentagons, 10 x 4^level + 2.
inline SurfaceMesh MakePolygons(int level)
{
  return MakeDual(MakeTriangles(level));
}

/// Triangles whose points lie at random by up to an eighth of an edge in each direction.
inline SurfaceMesh MakeIrregular(int level)
{
  SurfaceMesh mesh = MakeTriangles(level);
  std::mt19937 random(5);
  const double most = 0.125 * 1.1 / (1 << level);
  for (Vector3& x : mesh.Points)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      x[axis] += most * (random() / 2147483648.0 - 1.0);
    }
    x = (1.0 / skd::Norm(x)) * x;
  }
  return mesh;
}

/// Delaunay's triangles of points of the unit sphere, which some tetrahedron of the first four
/// begins: each further point takes the place of the triangles whose circles it is in.
inline SurfaceMesh MakeDelaunay(const std::vector<Vector3>& points)
{
  using Triangle = std::array<std::uint32_t, 3>;
  std::vector<Triangle> triangles{ { 0, 1, 2 }, { 0, 3, 1 }, { 0, 2, 3 }, { 1, 3, 2 } };
  for (std::uint32_t next = 4; next < points.size(); ++next)
  {
    const auto isAway = [&](const Triangle& t)
    {
      const Vector3& a = points[t[0]];
      return Dot(Cross(points[t[1]] - a, points[t[2]] - a), points[next] - a) <= 0.0;
    };
    const auto gone = std::partition(triangles.begin(), triangles.end(), isAway);
    std::map<std::array<std::uint32_t, 2>, int> sides;
    for (auto t = gone; t != triangles.end(); ++t)
    {
      for (int k = 0; k < 3; ++k)
      {
        sides[{ (*t)[k], (*t)[(k + 1) % 3] }] = 1;
      }
    }
    triangles.erase(gone, triangles.end());
    for (const auto& side : sides)
    {
      if (sides.count({ side.first[1], side.first[0] }) == 0)
      {
        triangles.push_back({ side.first[0], side.first[1], next });
      }
    }
  }
  SurfaceMesh mesh;
  mesh.Points = points;
  for (const Triangle& t : triangles)
  {
    mesh.Cells.Add(t.begin(), t.end());
  }
  mesh.FindEdges();
  return mesh;
}

/// Those of n points at random, each of which goes to the middle of its Voronoi cell some times.
inline SurfaceMesh MakeRandomTriangles(std::size_t n, int times)
{
  const double s = std::sqrt(1.0 / 3.0);
  std::vector<Vector3> points{ { { s, s, s } }, { { s, -s, -s } }, { { -s, s, -s } },
    { { -s, -s, s } } };
  std::mt19937 random(5);
  while (points.size() < n)
  {
    Vector3 x;
    for (int axis = 0; axis < 3; ++axis)
    {
      x[axis] = random() / 2147483648.0 - 1.0;
    }
    if (skd::Norm(x) < 1.0)
    {
      points.push_back((1.0 / skd::Norm(x)) * x);
    }
  }
  SurfaceMesh mesh = MakeDelaunay(points);
  for (; times > 0; --times)
  {
    const SurfaceMesh dual = MakeDual(mesh);
    for (std::uint32_t i = 4; i < points.size(); ++i)
    {
      const Vector3 mean = skd::CornerMean(dual, i);
      points[i] = (1.0 / skd::Norm(mean)) * mean;
    }
    mesh = MakeDelaunay(points);
  }
  return mesh;
}

/// n rows of 2n cells between meridians and parallels, triangles at the poles.
inline SurfaceMesh MakeLonLat(std::uint32_t n)
{
  SurfaceMesh mesh;
  SpherePoints points(mesh);
  const auto at = [&](std::uint32_t i, std::uint32_t j)
  {
    const double longitude = Pi * (i % (2 * n)) / n;
    const double latitude = Pi * j / n - 0.5 * Pi;
    return points.Put({ { std::cos(latitude) * std::cos(longitude),
      std::cos(latitude) * std::sin(longitude), std::sin(latitude) } });
  };
  for (std::uint32_t k = 0; k < 2 * n * n; ++k)
  {
    const std::uint32_t i = k % (2 * n);
    const std::uint32_t j = k / (2 * n);
    std::vector<std::uint32_t> ids = { at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1) };
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    mesh.Cells.Add(ids.begin(), ids.end());
  }
  mesh.FindEdges();
  return mesh;
}

/// A cube's faces of n x n cells, blown up to the sphere.
inline SurfaceMesh MakeQuads(int n)
{
  SurfaceMesh mesh;
  SpherePoints points(mesh);
  for (int face = 0; face < 6 * n * n; ++face)
  {
    const int axis = face % 3;
    const double side = face / 3 % 2 == 0 ? -1.0 : 1.0;
    const int steps[4][2] = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } };
    std::uint32_t ids[4];
    for (int k = 0; k < 4; ++k)
    {
      const double i = face / 6 % n + steps[k][0];
      const double j = face / 6 / n + steps[k][1];
      Vector3 x;
      x[axis] = side;
      x[(axis + 1) % 3] = std::tan((2.0 * i / n - 1.0) * Pi / 4.0);
      x[(axis + 2) % 3] = side * std::tan((2.0 * j / n - 1.0) * Pi / 4.0);
      ids[k] = points.Put(x);
    }
    mesh.Cells.Add(ids, ids + 4);
  }
  mesh.FindEdges();
  return mesh;
}

/// n x n quads of the unit square.
inline SurfaceMesh MakeSquare(std::uint32_t n)
{
  SurfaceMesh mesh;
  for (std::uint32_t i = 0; i < (n + 1) * (n + 1); ++i)
  {
    mesh.Points.push_back({ { double(i % (n + 1)) / n, double(i / (n + 1)) / n, 0.0 } });
  }
  for (std::uint32_t i = 0; i < n * n; ++i)
  {
    const std::uint32_t a = i / n * (n + 1) + i % n;
    const std::uint32_t ids[4] = { a, a + 1, a + n + 2, a + n + 1 };
    mesh.Cells.Add(ids, ids + 4);
  }
  mesh.FindEdges();
  return mesh;
}

/// sqrt(rho) at a colatitude, sixteen times as large at one pole as at the other.
inline double Monitor(double s)
{
  const double g = 1.0 / 256.0;
  return std::sqrt((std::tanh((Pi / 6.0 - s) / (Pi / 20.0)) + 1.0) / (2.0 * (1.0 - g)) + g);
}

/// Where the colatitude X goes for shares to be equal: by the midpoint rule.
inline double ExactColatitude(double X)
{
  constexpr int n = 20000;
  static const std::vector<double> sums = []
  {
    std::vector<double> made{ 0.0 };
    for (int i = 0; i < n; ++i)
    {
      const double s = (i + 0.5) * Pi / n;
      made.push_back(made.back() + Monitor(s) * std::sin(s));
    }
    return made;
  }();
  const double share = 0.5 * (1.0 - std::cos(X)) * sums.back();
  const auto at = std::lower_bound(sums.begin() + 1, sums.end() - 1, share);
  const double before = static_cast<double>(at - 1 - sums.begin());
  return (before + (share - *(at - 1)) / (*at - *(at - 1))) * Pi / n;
}

}

#endif
