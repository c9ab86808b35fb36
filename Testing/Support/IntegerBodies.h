// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file IntegerBodies.h
 * @brief closed bodies with integer corners, and their winding number in whole numbers: exact
 */
#ifndef skdtest_IntegerBodies_h
#define skdtest_IntegerBodies_h

#include "Support/InOutRun.h"

#include <optional>

namespace skdtest
{

/// Signed crossings of the ray from x along the first axis; magnitudes below 2^19. Nothing where x
/// is on the surface, or the ray meets an edge.
inline std::optional<int> ExactWindingNumber(const Mesh& triangles, const Point& x)
{
  using Integer = std::int64_t;
  int sum = 0;
  for (const CellSpec& cell : triangles.Cells)
  {
    Integer p[3][3];
    for (int k = 0; k < 3; ++k)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        const Point& corner = triangles.Points[cell.Points[k]];
        p[k][axis] = static_cast<Integer>(corner[axis]) - static_cast<Integer>(x[axis]);
      }
    }
    const auto turn = [&](int a, int b) { return p[a][1] * p[b][2] - p[a][2] * p[b][1]; };
    const Integer turns[3] = { turn(1, 2), turn(2, 0), turn(0, 1) };
    if (turns[0] + turns[1] + turns[2] == 0)
    {
      continue; // seen edge-on: where the ray meets it, it meets the edge of another
    }
    const bool isAny = turns[0] > 0 || turns[1] > 0 || turns[2] > 0;
    const bool isAnyBelow = turns[0] < 0 || turns[1] < 0 || turns[2] < 0;
    if (isAny && isAnyBelow)
    {
      continue;
    }
    const Integer volume = p[0][0] * turns[0] + p[1][0] * turns[1] + p[2][0] * turns[2];
    const bool isOnEdge = turns[0] == 0 || turns[1] == 0 || turns[2] == 0;
    if (isOnEdge || volume == 0)
    {
      return std::nullopt;
    }
    sum += (volume > 0) != isAny ? 0 : (isAny ? 1 : -1);
  }
  return sum;
}

inline Mesh Inverted(Mesh mesh)
{
  for (CellSpec& cell : mesh.Cells)
  {
    std::swap(cell.Points[1], cell.Points[2]);
  }
  return mesh;
}

/// The box between two corners, normals outward.
inline Mesh BoxTriangles(const Point& low, const Point& high)
{
  Mesh box;
  for (int i = 0; i < 8; ++i)
  {
    box.Add({ i & 1 ? high[0] : low[0], i & 2 ? high[1] : low[1], i & 4 ? high[2] : low[2] });
  }
  const vtkIdType quads[6][4] = { { 0, 4, 6, 2 }, { 1, 3, 7, 5 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 },
    { 0, 2, 3, 1 }, { 4, 5, 7, 6 } };
  for (const auto& q : quads)
  {
    box.Add(VTK_TRIANGLE, { q[0], q[1], q[2] });
    box.Add(VTK_TRIANGLE, { q[0], q[2], q[3] });
  }
  return box;
}

/// A convex body, or one that is seen whole from its middle, normals outward; then rounded to
/// integers, so that a small one may run through itself.
inline Mesh StarTriangles(Random& random, double size)
{
  const bool isConvex = random.Index(3) == 0;
  Mesh star = Outward(random.Index(2) ? Octahedron(1.0) : SphereTriangles(1 + random.Index(3)));
  const Point interval = { 0.5 + 0.5 * random.Index(3), 1.0, 0.5 + 0.25 * random.Index(4) };
  star.Map(
    [&](const Point& p)
    {
      const double radius = size * (isConvex ? 1.0 : random.Between(0.35, 1.0)) / Length(p);
      return Point{ std::round(interval[0] * radius * p[0]),
        std::round(interval[1] * radius * p[1]), std::round(interval[2] * radius * p[2]) };
    });
  return star;
}

}

#endif
