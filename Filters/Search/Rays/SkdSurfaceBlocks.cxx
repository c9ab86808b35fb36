// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Search/Rays/SkdSurfaceBlocks.h"

#include "Bodies/SkdPieceSurfaces.h"
#include "Cells/Read/SkdRepairedMesh.h"
#include "Pipeline/SkdVolumeCells.h"

#include <utility>

namespace skdtree
{
std::vector<SkdBlock> SkdSurfaceBlocks::Update(const std::vector<SkdBlock>& blocks)
{
  if (!this->Snapshots.AreSameAs(blocks) || this->Surfaces.size() != blocks.size())
  {
    const double chordalLength = SkdChordalLength(blocks, SkdDefaultChordalDeviation);
    this->Surfaces.clear();
    this->Meshes.clear();
    this->ChordalLength = 0.0;
    const std::vector<SkdBlock> kept = this->Snapshots.Keep(blocks);
    for (SkdPieceSurface& piece : SkdSurfacesOfPieces(kept, chordalLength))
    {
      vtkDataSet* const block = kept[this->Surfaces.size()].Mesh;
      auto& surface = this->Surfaces.emplace_back(std::move(piece.Faces));
      auto& mesh = this->Meshes.emplace_back();
      if (!surface && SkdHasVolumeCells(block))
      {
        surface.emplace(block, chordalLength);
      }
      if (surface)
      {
        mesh = SkdFetchable(surface->Get()); // some faces may have two points
        this->ChordalLength = chordalLength;
      }
    }
  }
  std::vector<SkdBlock> surfaces = blocks;
  for (std::size_t i = 0; i < blocks.size(); ++i)
  {
    if (this->Meshes[i])
    {
      surfaces[i].Mesh = this->Meshes[i];
    }
  }
  return surfaces;
}
}
