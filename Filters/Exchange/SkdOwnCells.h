// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdOwnCells.h
 * @brief Those of a piece's cells that count, as they are in the mesh that all pieces are together.
 */

#ifndef SkdOwnCells_h
#define SkdOwnCells_h

#include "Exchange/SkdPieceNumbers.h"
#include "vtkDataSet.h"
#include "vtkSmartPointer.h"

#include <vector>

struct SkdOwnCells
{
  vtkSmartPointer<vtkDataSet> Mesh; ///< with the data of the piece
  std::vector<vtkIdType> Ids;       ///< of each cell in the whole mesh, ascending
};

/// Of this process's piece: together all processes have each cell once. Points have the coordinates
/// that SkdJoinPieces gives them, so that what is computed of a cell is the same. The piece itself
/// where that is so already. All processes must call it together. O(n).
SkdOwnCells SkdTakeOwnCells(
  SkdTransport& transport, vtkDataSet* piece, const SkdPieceNumbers& numbers);

#endif
