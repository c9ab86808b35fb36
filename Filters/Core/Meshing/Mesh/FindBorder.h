// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Mesh_FindBorder_h
#define skd_Mesh_FindBorder_h

#include "RefinedMesh.h"

#include <vector>

namespace skd
{

/// The faces of volume cells that one cell alone has. O(cells).
class OuterFaces
{
public:
  explicit OuterFaces(const RefinedMesh& mesh)
  {
    for (std::uint32_t cell = 0; cell < mesh.NumberOfCells(); ++cell)
    {
      ForEachFace(mesh[cell].Kind, mesh.NodesOf(cell).First,
        [&](const FaceNodes& face)
        {
          const bool isNew = this->Numbers.FindOrAdd(face) == this->Faces.size();
          if (isNew)
          {
            this->Faces.push_back({ face, cell, true });
          }
          else
          {
            this->LeaveOut(face);
          }
        });
    }
  }

  /// If there is such a face.
  void LeaveOut(const FaceNodes& face)
  {
    const std::uint32_t number = this->Numbers.Find(face);
    if (number != RefinedMesh::None)
    {
      this->Faces[number].IsOuter = false;
    }
  }

  /// Whether it is a face of several cells, or was left out.
  bool IsInner(const FaceNodes& face) const
  {
    const std::uint32_t number = this->Numbers.Find(face);
    return number != RefinedMesh::None && !this->Faces[number].IsOuter;
  }

  /// The first cell that has a face; None if there is none.
  std::uint32_t CellOf(const FaceNodes& face) const
  {
    const std::uint32_t number = this->Numbers.Find(face);
    return number == RefinedMesh::None ? RefinedMesh::None : this->Faces[number].Cell;
  }

  /// Calls visit(face) in the order in which they were met, their nodes in turn.
  template <class Visit>
  void ForEach(const Visit& visit) const
  {
    for (const Face& face : this->Faces)
    {
      if (face.IsOuter)
      {
        visit(face.Nodes);
      }
    }
  }

private:
  struct Face
  {
    FaceNodes Nodes;
    std::uint32_t Cell; // the first that has it
    bool IsOuter;
  };
  TupleNumbers<4> Numbers;
  std::vector<Face> Faces;
};

/// The border of a mesh that has not been cut: these faces, and all of lines and surface cells.
inline MeshBorder MakeBorder(const RefinedMesh& mesh, const OuterFaces& faces)
{
  MeshBorder border;
  faces.ForEach([&](const FaceNodes& face) { border.AddFace(face); });
  for (std::uint32_t cell = 0; cell < mesh.NumberOfCells(); ++cell)
  {
    if (DimensionOf(mesh[cell].Kind) < 3)
    {
      border.AddCell(mesh[cell].Kind, mesh.NodesOf(cell).First, mesh.NodesOf(cell).Size);
    }
  }
  return border;
}

}

#endif
