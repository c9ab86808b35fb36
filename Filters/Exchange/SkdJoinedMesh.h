// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdJoinedMesh_h
#define SkdJoinedMesh_h

#include "Exchange/SkdRepeatedId.h"
#include "vtkDataSet.h"
#include "vtkSmartPointer.h"

#include <vector>

namespace skdtree
{
/// A cell of a piece.
struct SkdPieceCell
{
  int Piece;
  vtkIdType CellId;
};

struct SkdJoinedPieces
{
  vtkSmartPointer<vtkDataSet> Mesh;
  std::vector<SkdPieceCell> Origins; ///< where each cell of the mesh comes from
  SkdRepeatedId Repeated = {};       ///< a global id that does not tell cells or points apart
};
}

#endif
