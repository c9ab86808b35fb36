// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef MeshScenes_h
#define MeshScenes_h

#include "Core/Meshing/Mesh/RefinedMesh.h"

#include <vector>

/// A square of n times n squares, two triangles each.
inline skd::RefinedMesh MakeSquare(std::uint32_t n)
{
  skd::RefinedMesh mesh;
  for (std::uint32_t i = 0; i < (n + 1) * (n + 1); ++i)
  {
    mesh.AddNode({ { double(i % (n + 1)), double(i / (n + 1)), 0.0 } });
  }
  for (std::uint32_t cell = 0; cell < n * n; ++cell)
  {
    const std::uint32_t a = cell / n * (n + 1) + cell % n;
    const std::uint32_t low[3] = { a, a + 1, a + n + 2 };
    const std::uint32_t high[3] = { a, a + n + 2, a + n + 1 };
    mesh.AddCell(skd::CellKind::Triangle, low, 3, 2 * cell, 0);
    mesh.AddCell(skd::CellKind::Triangle, high, 3, 2 * cell + 1, 0);
  }
  return mesh;
}

/// A cube of n^3 hexahedra, a little longer along x, then y.
inline skd::RefinedMesh MakeBricks(std::uint32_t n)
{
  skd::RefinedMesh mesh;
  const std::uint32_t m = n + 1;
  for (std::uint32_t i = 0; i < m * m * m; ++i)
  {
    mesh.AddNode({ { 1.1 * (i % m), 1.05 * (i / m % m), double(i / m / m) } });
  }
  for (std::uint32_t cell = 0; cell < n * n * n; ++cell)
  {
    const std::uint32_t a = cell % n + m * (cell / n % n) + m * m * (cell / n / n);
    const std::uint32_t nodes[8] = { a, a + 1, a + m + 1, a + m, a + m * m, a + m * m + 1,
      a + m * m + m + 1, a + m * m + m };
    mesh.AddCell(skd::CellKind::Hexahedron, nodes, 8, cell, 0);
  }
  return mesh;
}

/// The nodes of each leaf.
inline std::vector<std::vector<std::uint32_t>> LeavesOf(const skd::RefinedMesh& mesh)
{
  std::vector<std::vector<std::uint32_t>> leaves;
  for (std::uint32_t cell = 0; cell < mesh.NumberOfCells(); ++cell)
  {
    if (mesh[cell].IsLeaf())
    {
      leaves.emplace_back(mesh.NodesOf(cell).begin(), mesh.NodesOf(cell).end());
    }
  }
  return leaves;
}

#endif
