// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdWholeInput.h
 * @brief The whole of a filter's input of which each process has a piece.
 *
 * A filter that searches all of a mesh asks the pipeline for this process's piece alone, as VTK's
 * filters do, and gathers the others from the processes that have them. To ask the pipeline for the
 * whole is wrong: a mesh that is spread in memory cannot be delivered whole, and two requests for
 * different pieces that meet at one reader are answered alike.
 */

#ifndef SkdWholeInput_h
#define SkdWholeInput_h

#include "Exchange/SkdJoinedMesh.h"
#include "Exchange/SkdStamp.h"
#include "vtkDataObject.h"
#include "vtkSmartPointer.h"

#include <map>
#include <vector>

class vtkMultiProcessController;

namespace skdtree
{
class SkdWholeInput
{
public:
  /// The pieces of all processes as one data object: see SkdJoinPieces; of composite data the
  /// pieces of each block, by the blocks' paths. All processes must call it together. The same
  /// object again, without an exchange of data, if the pieces of all of them are unchanged.
  vtkDataObject* Update(vtkDataObject* piece, vtkMultiProcessController* controller);

  /// Global ids with which pieces cannot be joined, on all processes the same.
  const SkdRepeatedId& GetRepeatedId() const { return this->Repeated; }

  /// The own piece of the last Update().
  vtkDataObject* GetPiece() const { return this->Known.Get(); }

  /// Where the cells of a block come from, by its flat index in composite data, else 0;
  /// SkdPieceCell::Piece is the process.
  const std::vector<SkdPieceCell>& GetOrigins(int blockIndex) const
  {
    return this->Origins.at(blockIndex);
  }

private:
  void Join(const std::vector<vtkSmartPointer<vtkDataObject>>& pieces, int own);

  SkdStamp Known; // the own piece
  vtkSmartPointer<vtkDataObject> Whole;
  std::map<int, std::vector<SkdPieceCell>> Origins; // of each block's cells
  SkdRepeatedId Repeated;
};
}

#endif
