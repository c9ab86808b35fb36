// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdSurfaceBlocks_h
#define SkdSurfaceBlocks_h

#include "Bodies/SkdOuterSurface.h"
#include "Pipeline/SkdBlockSnapshots.h"
#include "Pipeline/SkdBlocks.h"

#include <optional>
#include <vector>

namespace skdtree
{
/// Blocks as surfaces: those with volume cells are replaced by their outer faces, so that a ray
/// within a body ends where the body does, and not where the next cell begins. Curved faces become
/// facets within the default chordal deviation. Reused while the blocks are unchanged.
class SkdSurfaceBlocks
{
public:
  /// The surfaces of the blocks, with their indices.
  std::vector<SkdBlock> Update(const std::vector<SkdBlock>& blocks);

  /// The cell of a block, given by its index in the list, that a cell of its surface is a face of.
  vtkIdType GetCellId(int block, vtkIdType cell) const
  {
    const auto& surface = this->Surfaces[static_cast<std::size_t>(block)];
    return surface ? surface->GetCellId(cell) : cell;
  }

  /// How far facets may be from the curved faces of volume cells; 0 if there are none.
  double GetChordalLength() const { return this->ChordalLength; }

private:
  SkdBlockSnapshots Snapshots;
  double ChordalLength = 0.0;
  std::vector<std::optional<SkdBlockSurface>> Surfaces; // none of blocks without volume cells
  std::vector<vtkSmartPointer<vtkDataSet>> Meshes;      // theirs, as VTK can fetch their faces
};
}

#endif
