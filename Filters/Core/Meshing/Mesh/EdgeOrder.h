// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Mesh_EdgeOrder_h
#define skd_Mesh_EdgeOrder_h

#include "RefinedMesh.h"

#include <tuple>

namespace skd
{

/// An edge with its rank in the one order of all edges of a mesh: by length, then by where its
/// ends are, then by their numbers. So which of several edges is the longest depends on the mesh
/// alone, not on how its cells and nodes are numbered.
class OrderedEdge
{
public:
  OrderedEdge(const RefinedMesh& mesh, std::uint32_t a, std::uint32_t b)
    : Mesh(&mesh)
    , Ends{ a, b }
  {
    const bool isInOrder =
      mesh.FlatPoint(a) == mesh.FlatPoint(b) ? a < b : mesh.FlatPoint(a) < mesh.FlatPoint(b);
    if (!isInOrder)
    {
      std::swap(this->Ends[0], this->Ends[1]);
    }
    this->Length2 = Distance2(mesh.FlatPoint(a), mesh.FlatPoint(b));
  }

  std::uint32_t operator[](int end) const { return this->Ends[end]; }

  bool operator<(const OrderedEdge& other) const
  {
    if (this->Length2 != other.Length2)
    {
      return this->Length2 < other.Length2;
    }
    for (int end = 0; end < 2; ++end)
    {
      const Vector3& here = this->Mesh->FlatPoint(this->Ends[end]);
      const Vector3& there = this->Mesh->FlatPoint(other.Ends[end]);
      if (!(here == there))
      {
        return here < there;
      }
    }
    return this->Ends < other.Ends;
  }

private:
  const RefinedMesh* Mesh;
  std::array<std::uint32_t, 2> Ends;
  double Length2;
};

/// The longest edge of a cell that has edges.
inline OrderedEdge LongestEdgeOf(const RefinedMesh& mesh, std::uint32_t cell)
{
  const RefinedMesh::Nodes nodes = mesh.NodesOf(cell);
  OrderedEdge longest(mesh, nodes[0], nodes[1]);
  ForEachEdge(mesh[cell].Kind, nodes.First, nodes.Size,
    [&](std::uint32_t a, std::uint32_t b)
    {
      const OrderedEdge edge(mesh, a, b);
      longest = longest < edge ? edge : longest;
    });
  return longest;
}

/// The corner, 0 or 1, from which the shorter diagonal of a face of four nodes goes.
inline int ShorterDiagonalOf(const RefinedMesh& mesh, const FaceNodes& face)
{
  return OrderedEdge(mesh, face[0], face[2]) < OrderedEdge(mesh, face[1], face[3]) ? 0 : 1;
}

}

#endif
