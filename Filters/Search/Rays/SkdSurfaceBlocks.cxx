// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Search/Rays/SkdSurfaceBlocks.h"

#include "Cells/Read/SkdRepairedMesh.h"
#include "Pipeline/SkdVolumeCells.h"

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
    for (const SkdBlock& block : this->Snapshots.Keep(blocks))
    {
      auto& surface = this->Surfaces.emplace_back();
      auto& mesh = this->Meshes.emplace_back();
      if (SkdHasVolumeCells(block.Mesh))
      {
        surface.emplace(block.Mesh, chordalLength);
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
