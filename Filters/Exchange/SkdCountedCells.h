// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdCountedCells.h
 * @brief Of cells that several processes have, which of them counts each: for sums over an input
 * that stays in its pieces.
 */

#ifndef SkdCountedCells_h
#define SkdCountedCells_h

#include "Exchange/SkdStamp.h"

#include <vector>

class vtkMultiProcessController;

namespace skdtree
{
class SkdCountedCells
{
public:
  /// Finds, by block of this process's piece (SkdBlocksOf), whether it counts each cell: one
  /// process does, and none counts ghosts (see SkdJoinPieces). Empty lists: all count. All
  /// processes must call it together. Nothing is exchanged if no piece has changed.
  const std::vector<std::vector<unsigned char>>& Update(
    vtkDataObject* piece, vtkMultiProcessController* controller);

private:
  SkdStamp Known;
  std::vector<std::vector<unsigned char>> OfBlocks;
};
}

#endif
