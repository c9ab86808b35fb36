// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Mesh_GivenHangingNodes_h
#define skd_Mesh_GivenHangingNodes_h

#include "FindBorder.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace skd
{

/// Nodes of a mesh that has not been cut that are in the middle of an edge of another cell, as the
/// nodes are that regular refinement leaves. They are looked for where cells have no neighbour:
/// along the edges of outer faces of volume cells, and those that one surface cell alone has. A
/// node counts if it is the mean of the edge's ends to the last bit in double precision, or, where
/// the ends have single precision, in that. O(cells), plus O(n log n) for n such edges.
class GivenHangingNodes
{
public:
  explicit GivenHangingNodes(const RefinedMesh& mesh)
    : Mesh(mesh)
  {
    this->ListEdges();
    this->ListNodes();
    for (const auto& [a, b] : this->Edges)
    {
      const std::uint32_t node = this->FindMiddle(a, b);
      if (node != RefinedMesh::None)
      {
        this->First = this->Count == 0 ? node : std::min(this->First, node);
        ++this->Count;
      }
    }
  }

  /// The number of edges that have such a node, and the lowest of the nodes.
  std::size_t Count = 0;
  std::uint32_t First = RefinedMesh::None;

private:
  using Edge = std::pair<std::uint32_t, std::uint32_t>;

  void ListEdges()
  {
    const auto add = [](std::vector<Edge>& to, std::uint32_t a, std::uint32_t b)
    { to.emplace_back(std::min(a, b), std::max(a, b)); };
    std::vector<Edge> ofSurface;
    for (std::uint32_t cell = 0; cell < this->Mesh.NumberOfCells(); ++cell)
    {
      const RefinedMesh::Nodes nodes = this->Mesh.NodesOf(cell);
      if (DimensionOf(this->Mesh[cell].Kind) == 2)
      {
        ForEachEdge(this->Mesh[cell].Kind, nodes.First, nodes.Size,
          [&](std::uint32_t a, std::uint32_t b) { add(ofSurface, a, b); });
      }
    }
    OuterFaces(this->Mesh)
      .ForEach(
        [&](const FaceNodes& face)
        {
          const std::uint32_t size = face[3] == RefinedMesh::None ? 3 : 4;
          for (std::uint32_t i = 0; i < size; ++i)
          {
            add(this->Edges, face[i], face[(i + 1) % size]);
          }
        });
    std::sort(this->Edges.begin(), this->Edges.end());
    this->Edges.erase(std::unique(this->Edges.begin(), this->Edges.end()), this->Edges.end());
    this->AddSingle(ofSurface);
  }

  void AddSingle(std::vector<Edge>& edges)
  {
    std::sort(edges.begin(), edges.end());
    for (auto first = edges.begin(); first != edges.end();)
    {
      const auto last =
        std::find_if(first, edges.end(), [&](const Edge& e) { return e != *first; });
      if (last - first == 1)
      {
        this->Edges.push_back(*first);
      }
      first = last;
    }
  }

  void ListNodes()
  {
    for (const auto& [a, b] : this->Edges)
    {
      this->Nodes.push_back(a);
      this->Nodes.push_back(b);
    }
    std::sort(this->Nodes.begin(), this->Nodes.end());
    this->Nodes.erase(std::unique(this->Nodes.begin(), this->Nodes.end()), this->Nodes.end());
    std::stable_sort(this->Nodes.begin(), this->Nodes.end(),
      [this](std::uint32_t a, std::uint32_t b)
      { return this->Mesh.FlatPoint(a) < this->Mesh.FlatPoint(b); });
  }

  /// Volatile because GCC 12 leaves out this rounding where it does two coordinates at a time.
  static Vector3 InSinglePrecision(const Vector3& x)
  {
    Vector3 rounded;
    for (int axis = 0; axis < 3; ++axis)
    {
      const volatile float coordinate = static_cast<float>(x[axis]);
      rounded[axis] = coordinate;
    }
    return rounded;
  }

  std::uint32_t FindMiddle(std::uint32_t a, std::uint32_t b) const
  {
    const Vector3& first = this->Mesh.FlatPoint(a);
    const Vector3& last = this->Mesh.FlatPoint(b);
    const Vector3 middle = 0.5 * (first + last);
    const std::uint32_t node = this->FindNode(middle, a, b);
    // Rounding points of double precision far from the origin would make different ones equal.
    const bool isSingle = InSinglePrecision(first) == first && InSinglePrecision(last) == last;
    return node == RefinedMesh::None && isSingle ? this->FindNode(InSinglePrecision(middle), a, b)
                                                 : node;
  }

  /// The lowest node there but for the ends.
  std::uint32_t FindNode(const Vector3& x, std::uint32_t a, std::uint32_t b) const
  {
    auto at = std::lower_bound(this->Nodes.begin(), this->Nodes.end(), x,
      [this](std::uint32_t node, const Vector3& y) { return this->Mesh.FlatPoint(node) < y; });
    for (; at != this->Nodes.end() && this->Mesh.FlatPoint(*at) == x; ++at)
    {
      if (*at != a && *at != b)
      {
        return *at;
      }
    }
    return RefinedMesh::None;
  }

  const RefinedMesh& Mesh;
  std::vector<Edge> Edges;
  std::vector<std::uint32_t> Nodes; // of these, by their points
};

}

#endif
