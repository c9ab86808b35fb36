// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Support/RandomSolids.h"

#include "Support/IntegerBodies.h"
#include "Support/SurfaceMeshes.h"

namespace skdtest
{
void Append(Mesh& mesh, const Mesh& other)
{
  const auto n = static_cast<vtkIdType>(mesh.Points.size());
  mesh.Points.insert(mesh.Points.end(), other.Points.begin(), other.Points.end());
  for (CellSpec cell : other.Cells)
  {
    for (vtkIdType& id : cell.Points)
    {
      id += n;
    }
    mesh.Cells.push_back(std::move(cell));
  }
}

namespace
{
constexpr double Pi = 3.14159265358979323846;

Mesh NoisySphere(Random& random)
{
  const double least = random.Index(2) ? 0.5 : 0.95;
  return Outward(SphereTriangles(1 + random.Index(5)))
    .Map([&](const Point& p) { return random.Between(least, 1.0) * p; });
}

Mesh Torus(Random& random)
{
  return TorusTriangles(3 + random.Index(12), 3 + random.Index(6))
    .Map([&](const Point& p) { return random.Between(0.99, 1.0) * p; });
}

Mesh Box(Random& random)
{
  const int n = 1 + random.Index(3);
  const auto side = [&] { return 0.25 * (1 + random.Index(8)) / n; };
  const Point sides = { side(), side(), side() };
  return CubeTriangles(n).Map(
    [&](const Point& p) {
      return Point{ sides[0] * p[0], sides[1] * p[1], sides[2] * p[2] };
    });
}

/// Around the third axis, with these radii in turn: a prism, or a star.
Mesh Extruded(const std::vector<double>& radii, double height)
{
  Mesh mesh;
  const auto n = static_cast<vtkIdType>(radii.size());
  for (vtkIdType i = 0; i < 2 * n; ++i)
  {
    const double angle = 2.0 * Pi * static_cast<double>(i % n) / static_cast<double>(n);
    const double radius = radii[i % n];
    mesh.Add({ radius * std::cos(angle), radius * std::sin(angle), i < n ? 0.0 : height });
  }
  const vtkIdType low = mesh.Add({ 0, 0, 0 });
  const vtkIdType high = mesh.Add({ 0, 0, height });
  for (vtkIdType i = 0; i < n; ++i)
  {
    const vtkIdType j = (i + 1) % n;
    mesh.Add(VTK_TRIANGLE, { low, j, i });
    mesh.Add(VTK_TRIANGLE, { high, n + i, n + j });
    mesh.Add(VTK_TRIANGLE, { i, j, n + j });
    mesh.Add(VTK_TRIANGLE, { i, n + j, n + i });
  }
  return mesh;
}

Mesh Prism(Random& random, bool isStar)
{
  std::vector<double> radii(3 + random.Index(8));
  for (double& radius : radii)
  {
    radius = isStar ? random.Between(0.2, 1.0) : 1.0;
  }
  return Extruded(radii, 0.25 * (1 + random.Index(6)));
}

/// Of random points, by each plane through three of them.
Mesh ConvexHull(Random& random)
{
  Mesh mesh;
  const int n = 4 + random.Index(9);
  for (int i = 0; i < n; ++i)
  {
    mesh.Add(random.InBox({ -1, 1, -1, 1, -1, 1 }));
  }
  const auto& x = mesh.Points;
  for (int i = 0; i < n; ++i)
  {
    for (int j = i + 1; j < n; ++j)
    {
      for (int k = j + 1; k < n; ++k)
      {
        const Point normal = Cross(x[j] - x[i], x[k] - x[i]);
        const auto above = std::count_if(
          x.begin(), x.end(), [&](const Point& p) { return Dot(normal, p - x[i]) > 1e-14; });
        const auto below = std::count_if(
          x.begin(), x.end(), [&](const Point& p) { return Dot(normal, p - x[i]) < -1e-14; });
        if (above == 0 || below == 0)
        {
          mesh.Add(VTK_TRIANGLE, above == 0 ? Ids{ i, j, k } : Ids{ i, k, j });
        }
      }
    }
  }
  return mesh;
}

Mesh Cavity(Random& random)
{
  Mesh mesh = NoisySphere(random);
  Append(mesh, Inverted(Transformed(NoisySphere(random), 0.2, { 0, 0, 0 })));
  return mesh;
}

Mesh TwoParts(Random& random)
{
  Mesh mesh = Transformed(NoisySphere(random), 0.5, { -0.5, 0, 0 });
  Append(mesh, Transformed(ConvexHull(random), 0.25, { 0.5, random.Between(-0.5, 0.5), 0 }));
  return mesh;
}
}

Mesh RandomCubes(Random& random)
{
  std::array<std::array<std::array<bool, 5>, 5>, 5> isIn{};
  const int size = 1 + random.Index(3);
  const double share = random.Between(0.3, 1.0);
  for (int i = 0; i < size * size * size; ++i)
  {
    isIn[1 + i % size][1 + i / size % size][1 + i / size / size] = random.Between(0.0, 1.0) < share;
  }
  Mesh mesh;
  const Mesh cube = BoxTriangles({ 0, 0, 0 }, { 1, 1, 1 });
  for (int at = 0; at < 27; ++at)
  {
    const std::array<int, 3> position = { 1 + at % 3, 1 + at / 3 % 3, 1 + at / 9 };
    for (std::size_t face = 0; face < 12 && isIn[position[0]][position[1]][position[2]]; ++face)
    {
      std::array<int, 3> next = position;
      next[face / 4] += face % 4 < 2 ? -1 : 1;
      if (!isIn[next[0]][next[1]][next[2]])
      {
        Ids ids;
        for (const vtkIdType id : cube.Cells[face].Points)
        {
          const Point low = { position[0] - 2.0, position[1] - 2.0, position[2] - 2.0 };
          ids.push_back(mesh.Add(0.5 * (low + cube.Points[id])));
        }
        mesh.Add(VTK_TRIANGLE, ids);
      }
    }
  }
  return Welded(mesh);
}

RandomSolid MakeRandomSolid(Random& random)
{
  switch (random.Index(9))
  {
    case 0:
      return { NoisySphere(random), "noisy sphere" };
    case 1:
      return { Box(random), "box" };
    case 2:
      return { Torus(random), "torus" };
    case 3:
      return { Prism(random, false), "prism" };
    case 4:
      return { Prism(random, true), "star" };
    case 5:
      return { ConvexHull(random), "convex hull" };
    case 6:
      return { Cavity(random), "sphere with a cavity" };
    case 7:
      return { TwoParts(random), "two parts" };
    default:
      return { RandomCubes(random), "cubes" };
  }
}

std::vector<Mesh> RandomRods(Random& random, int count, double width)
{
  std::vector<Mesh> rods;
  for (int i = 0; i < count; ++i)
  {
    const RandomRotation turned(random, false);
    const Point middle = random.Between(0.0, 1.0) * random.Direction();
    rods.push_back(BoxTriangles({ -1.0, -width, -width }, { 1.0, width, width })
                     .Map([&](const Point& p) { return middle + turned(p); }));
  }
  return rods;
}

RandomRotation::RandomRotation(Random& random, bool byRightAngles)
{
  this->Rows[0] = random.Direction();
  if (byRightAngles)
  {
    this->Rows[0] = { 0, 0, 0 };
    this->Rows[0][random.Index(3)] = random.Index(2) ? 1.0 : -1.0;
  }
  Point other = { this->Rows[0][1], this->Rows[0][2], this->Rows[0][0] };
  if (!byRightAngles)
  {
    other = random.Direction();
    other = other - Dot(other, this->Rows[0]) * this->Rows[0];
    other = (1.0 / Length(other)) * other;
  }
  this->Rows[1] = other;
  this->Rows[2] = Cross(this->Rows[0], this->Rows[1]);
}

Point RandomRotation::operator()(const Point& p) const
{
  return { Dot(this->Rows[0], p), Dot(this->Rows[1], p), Dot(this->Rows[2], p) };
}

}
