// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Exchange/SkdJoinedExtents.h"

#include "Cells/Search/SkdCellStore.h"
#include "Pipeline/SkdBlocks.h"

#include <stdexcept>

namespace skdtree
{
namespace
{
struct ExtentOfBlock
{
  int BlockIndex;
  SkdMeshExtent Extent;
};

std::vector<ExtentOfBlock> ExtentsOf(vtkDataObject* piece, const SkdMagnitudes& magnitudes)
{
  std::vector<ExtentOfBlock> extents;
  for (const SkdBlock& block : SkdBlocksWithCells(SkdBlocksOf(piece)))
  {
    try
    {
      extents.push_back(
        { block.BlockIndex, SkdCellStore(block.Mesh, true, magnitudes).GetExtent() });
    }
    catch (const std::length_error&)
    {
      // No tree can have them, which the filter is told when it asks for one; others wait here.
    }
  }
  return extents;
}
}

const std::map<int, SkdMeshExtent>& SkdJoinedExtents::Update(
  SkdTransport& transport, vtkDataObject* piece, const SkdMagnitudes& magnitudes)
{
  SkdStamp stamp(piece);
  if (SkdIsAny(transport, stamp != this->Known))
  {
    this->Extents.clear();
    for (const auto& ofProcess : SkdGatherRows(transport, ExtentsOf(piece, magnitudes)))
    {
      for (const ExtentOfBlock& block : ofProcess)
      {
        this->Extents[block.BlockIndex].Add(block.Extent);
      }
    }
    this->Known = std::move(stamp);
  }
  return this->Extents;
}
}
