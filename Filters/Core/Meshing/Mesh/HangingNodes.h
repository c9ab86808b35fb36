// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Mesh_HangingNodes_h
#define skd_Mesh_HangingNodes_h

#include "EdgeOrder.h"

#include <vector>

namespace skd
{

/// Finds the nodes that are on an edge or a face of a leaf and are not among its corners.
class HangingNodes
{
public:
  explicit HangingNodes(const RefinedMesh& mesh)
    : Mesh(mesh)
    , Marks(mesh.NumberOfNodes(), 0)
  {
    for (std::uint32_t cell = 0; cell < mesh.NumberOfCells(); ++cell)
    {
      if (mesh[cell].IsLeaf())
      {
        this->MarkAt(cell);
      }
    }
  }

  bool operator[](std::uint32_t node) const { return this->Marks[node] != 0; }

  /// `share(marks)` may mark more: those that hang on cells of other processes.
  template <class Share>
  void Add(const Share& share)
  {
    share(this->Marks);
  }

private:
  static constexpr std::uint32_t None = RefinedMesh::None;

  void MarkAt(std::uint32_t cell)
  {
    const RefinedMesh::Nodes nodes = this->Mesh.NodesOf(cell);
    const CellKind kind = this->Mesh[cell].Kind;
    ForEachEdge(kind, nodes.First, nodes.Size,
      [this](std::uint32_t a, std::uint32_t b) { this->MarkOnEdge(a, b); });
    ForEachFace(kind, nodes.First,
      [this](const FaceNodes& f)
      {
        if (f[3] == None)
        {
          this->MarkOnTriangle(f[0], f[1], f[2]);
        }
        else
        {
          this->MarkOnQuad(f);
        }
      });
  }

  void MarkOnEdge(std::uint32_t a, std::uint32_t b)
  {
    const std::uint32_t middle = this->Mesh.MiddleOf(a, b);
    if (middle != None)
    {
      this->Marks[middle] = 1;
      this->MarkOnEdge(a, middle);
      this->MarkOnEdge(middle, b);
    }
  }

  /// However it was cut: at the middles of all edges, or from one of them to the corner opposite.
  void MarkOnTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c)
  {
    const std::uint32_t corners[3] = { a, b, c };
    std::uint32_t m[3];
    for (int i = 0; i < 3; ++i)
    {
      m[i] = this->Mesh.MiddleOf(corners[i], corners[(i + 1) % 3]);
    }
    if (m[0] != None && m[1] != None && m[2] != None && this->Mesh.HasEdge(m[0], m[1]) &&
      this->Mesh.HasEdge(m[1], m[2]))
    {
      this->MarkOnEdge(m[0], m[1]);
      this->MarkOnEdge(m[1], m[2]);
      this->MarkOnEdge(m[2], m[0]);
      this->MarkOnTriangle(m[0], m[1], m[2]);
      for (int i = 0; i < 3; ++i)
      {
        this->MarkOnTriangle(corners[i], m[i], m[(i + 2) % 3]);
      }
      return;
    }
    for (int i = 0; i < 3; ++i)
    {
      const std::uint32_t opposite = corners[(i + 2) % 3];
      if (m[i] != None && this->Mesh.HasEdge(m[i], opposite))
      {
        this->MarkOnEdge(m[i], opposite);
        this->MarkOnTriangle(corners[i], m[i], opposite);
        this->MarkOnTriangle(m[i], corners[(i + 1) % 3], opposite);
        return;
      }
    }
  }

  void MarkOnQuad(const FaceNodes& f)
  {
    const std::uint32_t middle = this->Mesh.MiddleOf(f);
    if (middle != None)
    {
      return this->MarkAround(middle, f);
    }
    if (this->Mesh.IsCut(f))
    {
      const int first = ShorterDiagonalOf(this->Mesh, f);
      this->MarkOnEdge(f[first], f[first + 2]);
      this->MarkOnTriangle(f[first], f[first + 1], f[first + 2]);
      this->MarkOnTriangle(f[first + 2], f[(first + 3) % 4], f[first]);
    }
  }

  void MarkAround(std::uint32_t middle, const FaceNodes& f)
  {
    this->Marks[middle] = 1;
    for (int i = 0; i < 4; ++i)
    {
      const std::uint32_t next = this->Mesh.MiddleOf(f[i], f[(i + 1) % 4]);
      const std::uint32_t last = this->Mesh.MiddleOf(f[(i + 3) % 4], f[i]);
      if (next != None && last != None)
      {
        this->MarkOnEdge(next, middle);
        this->MarkOnQuad({ f[i], next, middle, last });
      }
    }
  }

  const RefinedMesh& Mesh;
  std::vector<char> Marks;
};

}

#endif
