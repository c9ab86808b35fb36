// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/SkdBlockSnapshots.h"

#include <algorithm>

namespace skdtree
{
std::vector<SkdBlock> SkdBlockSnapshots::Keep(const std::vector<SkdBlock>& blocks)
{
  std::vector<SkdBlock> structures = blocks;
  this->Meshes.resize(blocks.size());
  this->FirstPieces.resize(blocks.size());
  for (std::size_t i = 0; i < blocks.size(); ++i)
  {
    this->Meshes[i].Keep(blocks[i].Mesh);
    structures[i].Mesh = this->Meshes[i].Get();
    this->FirstPieces[i] = blocks[i].FirstPiece;
  }
  return structures;
}

bool SkdBlockSnapshots::AreSameAs(const std::vector<SkdBlock>& blocks) const
{
  return std::equal(this->Meshes.begin(), this->Meshes.end(), blocks.begin(), blocks.end(),
           [](const SkdMeshSnapshot& snapshot, const SkdBlock& block)
           { return snapshot.IsSameAs(block.Mesh); }) &&
    std::equal(this->FirstPieces.begin(), this->FirstPieces.end(), blocks.begin(),
      [](int first, const SkdBlock& block) { return first == block.FirstPiece; });
}
}
