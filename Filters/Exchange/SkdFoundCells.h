// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdFoundCells_h
#define SkdFoundCells_h

#include "Exchange/SkdSpreadSource.h"

#include <vector>

namespace skdtree
{
/// A cell of a Source that stays in its pieces.
struct SkdFoundPieceCell
{
  int Process; // that told of it
  int Block;   // index in the list of the Source's blocks
  vtkIdType CellId;
};

/// The cells that a process's queries have found, brought from the processes that have them: what
/// is read of them afterwards is read here.
class SkdFoundCells
{
public:
  /// All processes must call it together. Cells may be named several times.
  SkdFoundCells(const SkdSpreadSource& spread, const std::vector<SkdFoundPieceCell>& found);

  /// As the Source's list of blocks: each has the cells found, with their points and all arrays.
  const std::vector<SkdBlock>& GetBlocks() const { return this->Blocks; }

  vtkDataSet* GetMesh(int block) const
  {
    return this->Blocks[static_cast<std::size_t>(block)].Mesh;
  }

  /// Where a cell is in the mesh of a block, by its id in the whole. O(log n).
  vtkIdType CellOf(int block, vtkIdType id) const
  {
    return this->Ids[static_cast<std::size_t>(block)].Find(id);
  }

private:
  std::vector<SkdBlock> Blocks;
  std::vector<SkdJoinedIds> Ids; // by block
};
}

#endif
