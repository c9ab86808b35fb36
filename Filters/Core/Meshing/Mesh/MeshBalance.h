// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Mesh_MeshBalance_h
#define skd_Mesh_MeshBalance_h

#include "../Grid/Balance.h"
#include "RefinedMesh.h"

#include <algorithm>
#include <vector>

namespace skd
{

/// How many levels neighbouring leaves of a mesh of regular cuts (RegularCuts.h) differ, over
/// contacts of a kind: on a surface a face is an edge, and an edge a corner. O(leaves).
class MeshBalance
{
public:
  MeshBalance(const RefinedMesh& mesh, Contact balance)
    : Mesh(mesh)
    , Balance(balance)
  {
  }

  /// Leaves with a neighbour of two levels more. `share(levels)` may raise what is known of nodes:
  /// the level of the finest leaf that has it.
  template <class Share>
  std::vector<std::uint32_t> FindUnbalanced(const Share& share)
  {
    std::vector<std::uint32_t> found;
    if (this->Balance == Contact::None)
    {
      return found;
    }
    this->FindLevelsOfNodes();
    share(this->NodeLevels);
    for (std::uint32_t cell = 0; cell < this->Mesh.NumberOfCells(); ++cell)
    {
      const RefinedMesh::Cell& at = this->Mesh[cell];
      if (at.IsLeaf() && !at.IsFixed && this->IsUnbalanced(cell))
      {
        found.push_back(cell);
      }
    }
    return found;
  }

private:
  static constexpr std::uint32_t None = RefinedMesh::None;

  void FindLevelsOfNodes()
  {
    this->NodeLevels.assign(this->Mesh.NumberOfNodes(), 0);
    for (std::uint32_t cell = 0; cell < this->Mesh.NumberOfCells(); ++cell)
    {
      if (this->Mesh[cell].IsLeaf())
      {
        for (const std::uint32_t node : this->Mesh.NodesOf(cell))
        {
          this->NodeLevels[node] = std::max(this->NodeLevels[node], this->Mesh[cell].Level());
        }
      }
    }
  }

  bool IsUnbalanced(std::uint32_t cell) const
  {
    const RefinedMesh::Nodes nodes = this->Mesh.NodesOf(cell);
    const CellKind kind = this->Mesh[cell].Kind;
    const bool hasEdges = this->Balance != Contact::Face || DimensionOf(kind) < 3;
    const bool hasCorners =
      this->Balance == Contact::Corner || (this->Balance == Contact::Edge && DimensionOf(kind) < 3);
    const int level = this->Mesh[cell].Level() + 1;
    bool isFound = false;
    const auto lookAtNode = [&](std::uint32_t node)
    { isFound = isFound || (hasCorners && node != None && this->NodeLevels[node] > level); };
    std::for_each(nodes.begin(), nodes.end(), lookAtNode);
    ForEachEdge(kind, nodes.First, nodes.Size,
      [&](std::uint32_t a, std::uint32_t b)
      {
        const std::uint32_t middle = this->Mesh.MiddleOf(a, b);
        lookAtNode(middle);
        isFound = isFound ||
          (hasEdges && middle != None &&
            (this->Mesh.MiddleOf(a, middle) != None || this->Mesh.MiddleOf(middle, b) != None));
      });
    ForEachFace(kind, nodes.First,
      [&](const FaceNodes& face)
      {
        lookAtNode(this->Mesh.MiddleOf(face));
        isFound = isFound || this->IsCutTwice(face);
      });
    return isFound;
  }

  bool IsCutTwice(const FaceNodes& f) const
  {
    if (!this->Mesh.IsCut(f))
    {
      return false;
    }
    const int size = f[3] == None ? 3 : 4;
    std::uint32_t m[4];
    for (int i = 0; i < size; ++i)
    {
      m[i] = this->Mesh.MiddleOf(f[i], f[(i + 1) % size]);
    }
    const std::uint32_t middle = this->Mesh.MiddleOf(f);
    bool isFound = size == 3 && this->Mesh.IsCut({ m[0], m[1], m[2], None });
    for (int i = 0; i < size; ++i)
    {
      const std::uint32_t before = m[(i + size - 1) % size];
      const bool isInnerEdgeCut = this->Balance != Contact::Face &&
        this->Mesh.MiddleOf(m[i], size == 3 ? before : middle) != None;
      isFound = isFound || isInnerEdgeCut ||
        this->Mesh.IsCut({ f[i], m[i], before, size == 3 ? None : middle });
    }
    return isFound;
  }

  const RefinedMesh& Mesh;
  Contact Balance;
  std::vector<int> NodeLevels;
};

}

#endif
