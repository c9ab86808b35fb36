// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Remap/SkdOverlapSearch.h"

#include "Cells/Search/SkdBuildTree.h"

namespace skdtree
{
//------------------------------------------------------------------------------
SkdOverlapTree::SkdOverlapTree(const SkdOverlapPieces& pieces)
{
  std::vector<skd::Box3> boxes;
  for (std::uint32_t cell = 0; cell < pieces.GetNumberOfCells(); ++cell)
  {
    if (!pieces.BoundsOf(cell).IsEmpty())
    {
      boxes.push_back(pieces.BoundsOf(cell));
      this->Cells.push_back(cell);
    }
  }
  this->Tree = SkdBuildTree(skd::MakeTreeInput(boxes, 0.0));
}
}
