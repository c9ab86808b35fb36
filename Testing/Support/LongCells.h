// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LongCells.h
 * @brief meshes of cells that are expensive unless their pieces are searched: cells of thousands of
 *   pieces, and curved cells that touch
 */
#ifndef skdtest_LongCells_h
#define skdtest_LongCells_h

#include "Support/CellZoo.h"
#include "Support/NamedMeshes.h"

#include <cmath>
#include <numeric>
#include <vector>

namespace skdtest
{

/// Points along a helix with noise; some are repeated.
inline std::vector<Point> NoisyHelix(int n)
{
  Random random(77);
  std::vector<Point> points;
  for (int i = 0; i < n; ++i)
  {
    const double t = 0.01 * i;
    const double r = 1.0 + 0.2 * random.Between(-1.0, 1.0);
    points.push_back({ r * std::cos(t), r * std::sin(t), 0.002 * (i % 3000) });
    if (i % 97 == 0)
    {
      points.push_back(points.back());
    }
  }
  return points;
}

/// One cell of the given type through all points of such a helix.
inline Mesh LongCell(int type, int n)
{
  Mesh one;
  one.Points = NoisyHelix(n);
  Ids ids(one.Points.size());
  std::iota(ids.begin(), ids.end(), 0);
  one.Add(type, ids);
  return one;
}

/// n^3 quadratic hexahedra of a block, each with points of its own.
inline Mesh SeparateQuadraticHexahedra(int n)
{
  const Mesh one = ReferenceCell(VTK_QUADRATIC_HEXAHEDRON, 2);
  Mesh cells;
  for (int i = 0; i < n * n * n; ++i)
  {
    const Point corner = { double(i % n), double(i / n % n), double(i / (n * n)) };
    Ids ids;
    for (const Point& x : one.Points)
    {
      ids.push_back(cells.Add(x + corner));
    }
    cells.Add(VTK_QUADRATIC_HEXAHEDRON, ids);
  }
  return cells;
}

}

#endif
