// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Mesh_MeshBorder_h
#define skd_Mesh_MeshBorder_h

#include "CellKind.h"
#include "TupleNumbers.h"

#include <vector>

namespace skd
{

/// The edges and faces on the border of a mesh of volume cells, kept while these are cut: the faces
/// that one cell alone has, and what they become. All of lines and surfaces is border. Halves of an
/// edge on the border are, too, whatever cell has them.
class MeshBorder
{
public:
  bool HasEdge(std::uint32_t a, std::uint32_t b) const
  {
    return this->Edges.Find({ a, b }) != TupleNumbers<2>::None;
  }
  bool HasFace(const FaceNodes& face) const
  {
    return this->Faces.Find(face) != TupleNumbers<4>::None;
  }

  void AddFace(const FaceNodes& face)
  {
    const bool isTriangle = face[3] == TupleNumbers<4>::None;
    this->Faces.FindOrAdd(face);
    this->AddEdgesOf(
      isTriangle ? CellKind::Triangle : CellKind::Polygon, face.data(), isTriangle ? 3 : 4);
  }

  /// A line or a surface cell.
  void AddCell(CellKind kind, const std::uint32_t* nodes, std::uint32_t size)
  {
    this->AddEdgesOf(kind, nodes, size);
    if (kind == CellKind::Polygon && size == 4)
    {
      this->Faces.FindOrAdd({ nodes[0], nodes[1], nodes[2], nodes[3] });
    }
  }

  void AddHalves(std::uint32_t a, std::uint32_t middle, std::uint32_t b)
  {
    this->Edges.FindOrAdd({ a, middle });
    this->Edges.FindOrAdd({ middle, b });
  }

  ///@{
  /// Edges, the last nodes None, and faces, each for itself, the nodes of a face in any order.
  void AddSide(const FaceNodes& side)
  {
    if (side[2] == TupleNumbers<4>::None)
    {
      this->Edges.FindOrAdd({ side[0], side[1] });
    }
    else
    {
      this->Faces.FindOrAdd(side);
    }
  }
  template <class Visit>
  void ForEachSide(const Visit& visit) const
  {
    for (std::uint32_t edge = 0; edge < this->Edges.Size(); ++edge)
    {
      visit(FaceNodes{
        this->Edges[edge][0], this->Edges[edge][1], TupleNumbers<4>::None, TupleNumbers<4>::None });
    }
    for (std::uint32_t face = 0; face < this->Faces.Size(); ++face)
    {
      visit(this->Faces[face]);
    }
  }
  ///@}

private:
  void AddEdgesOf(CellKind kind, const std::uint32_t* nodes, std::uint32_t size)
  {
    ForEachEdge(kind, nodes, size,
      [this](std::uint32_t a, std::uint32_t b) {
        this->Edges.FindOrAdd({ a, b });
      });
  }

  TupleNumbers<2> Edges;
  TupleNumbers<4> Faces;
};

}

#endif
