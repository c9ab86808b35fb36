// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdBlockSnapshots.h
 * @brief What SkdMeshSnapshot is to a mesh, of all blocks of a data object together.
 */

#ifndef SkdBlockSnapshots_h
#define SkdBlockSnapshots_h

#include "Cells/Read/SkdMeshSnapshot.h"
#include "Pipeline/SkdBlocks.h"

#include <vector>

namespace skdtree
{
class SkdBlockSnapshots
{
public:
  /// Keeps the structures of the blocks. Returns these, in the order and with the indices of the
  /// blocks.
  std::vector<SkdBlock> Keep(const std::vector<SkdBlock>& blocks);

  /// Whether there are as many blocks, and each has the structure that is kept for it and is a
  /// piece of the same mesh.
  bool AreSameAs(const std::vector<SkdBlock>& blocks) const;

  /// What is kept of a block.
  vtkDataSet* Get(int block) const { return this->Meshes[static_cast<std::size_t>(block)].Get(); }

private:
  std::vector<SkdMeshSnapshot> Meshes;
  std::vector<int> FirstPieces;
};
}

#endif
