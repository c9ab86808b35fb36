// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Mesh_MeshLayers_h
#define skd_Mesh_MeshLayers_h

#include "RefinedMesh.h"

#include <algorithm>
#include <vector>

namespace skd
{

/// Some leaves, and layers of leaves around them: those that share a node with one and are not
/// finer than it. In the order of their numbers. O(layers cells). `share(finest)` may raise what
/// is known of nodes, for each layer: the level of the finest cell so far that has it, or -1.
template <class Share>
std::vector<std::uint32_t> WithLayers(
  const RefinedMesh& mesh, const std::vector<std::uint32_t>& leaves, int layers, const Share& share)
{
  std::vector<std::uint32_t> grown = leaves;
  for (int layer = 0; layer < layers; ++layer)
  {
    std::vector<int> finest(mesh.NumberOfNodes(), -1);
    for (const std::uint32_t cell : grown)
    {
      for (const std::uint32_t node : mesh.NodesOf(cell))
      {
        finest[node] = std::max(finest[node], mesh[cell].Level());
      }
    }
    share(finest);
    grown.clear();
    for (std::uint32_t cell = 0; cell < mesh.NumberOfCells(); ++cell)
    {
      const RefinedMesh::Nodes nodes = mesh.NodesOf(cell);
      const int level = mesh[cell].Level();
      if (mesh[cell].IsLeaf() && !mesh[cell].IsFixed &&
        std::any_of(
          nodes.begin(), nodes.end(), [&](std::uint32_t node) { return finest[node] >= level; }))
      {
        grown.push_back(cell);
      }
    }
  }
  return grown;
}

}

#endif
