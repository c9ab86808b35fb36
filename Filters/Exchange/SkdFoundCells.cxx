// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Exchange/SkdFoundCells.h"

#include <algorithm>

namespace skdtree
{
SkdFoundCells::SkdFoundCells(
  const SkdSpreadSource& spread, const std::vector<SkdFoundPieceCell>& found)
{
  SkdTransport& transport = spread.GetTransport();
  const auto processes = static_cast<std::size_t>(transport.GetNumber());
  std::vector<SkdRowsByProcess<vtkIdType>> wanted(
    spread.GetBlocks().size(), SkdRowsByProcess<vtkIdType>(processes));
  for (const SkdFoundPieceCell& cell : found)
  {
    wanted[static_cast<std::size_t>(cell.Block)][static_cast<std::size_t>(cell.Process)].push_back(
      cell.CellId);
  }
  std::size_t at = 0;
  spread.VisitBlocks(
    [&](const SkdSpreadBlock& block)
    {
      for (std::vector<vtkIdType>& ids : wanted[at])
      {
        std::sort(ids.begin(), ids.end());
        ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
      }
      this->Blocks.push_back(
        { block.BringThose(transport, wanted[at]), spread.GetBlocks()[at].BlockIndex });
      this->Ids.emplace_back(this->Blocks.back().Mesh);
      SkdTouchCells(this->Blocks.back().Mesh);
      ++at;
    });
}
}
