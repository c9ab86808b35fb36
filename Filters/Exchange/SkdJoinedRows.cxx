// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Exchange/SkdJoinedRows.h"

#include "Exchange/SkdCompositePieces.h"
#include "Exchange/SkdWholeInput.h"
#include "Pipeline/SkdBlocks.h"
#include "vtkMultiProcessController.h"

#include <algorithm>
#include <cstddef>
#include <map>

namespace skdtree
{
SkdJoinedRows SkdJoinRows(vtkDataObject* piece, vtkMultiProcessController* controller)
{
  SkdWholeInput input;
  SkdJoinedRows rows;
  rows.Whole = input.Update(piece, controller);
  if (input.GetRepeatedId().IsThere)
  {
    rows.Problem = input.GetRepeatedId().Describe();
  }
  std::map<SkdBlockPath, std::size_t> own; // a block's path is the same on all processes
  for (const SkdLeafBlock& leaf : SkdLeafBlocksOf(piece))
  {
    own[leaf.Path] = rows.OfBlocks.size();
    rows.OfBlocks.emplace_back(static_cast<std::size_t>(leaf.Mesh->GetNumberOfCells()), -1);
  }
  const std::vector<SkdBlock> blocks = SkdBlocksOf(rows.Whole);
  const std::vector<SkdLeafBlock> leaves = SkdLeafBlocksOf(rows.Whole); // the same ones
  for (std::size_t i = 0; i < blocks.size(); ++i)
  {
    const auto block = own.find(leaves[i].Path);
    for (const SkdPieceCell& origin : input.GetOrigins(blocks[i].BlockIndex))
    {
      if (origin.Piece == controller->GetLocalProcessId() && block != own.end())
      {
        rows.OfBlocks[block->second][static_cast<std::size_t>(origin.CellId)] = rows.Number;
      }
      ++rows.Number;
    }
  }
  return rows;
}

void SkdGatherAt(int process, const std::vector<double>& own,
  const std::function<void(const std::vector<double>&)>& take,
  vtkMultiProcessController* controller)
{
  constexpr int tag = 31027;
  constexpr vtkIdType most = vtkIdType(1) << 27; // MPI counts in int
  if (controller->GetLocalProcessId() != process)
  {
    const auto size = static_cast<vtkIdType>(own.size());
    controller->Send(&size, 1, process, tag);
    for (vtkIdType sent = 0; sent < size; sent += most)
    {
      controller->Send(own.data() + sent, std::min(size - sent, most), process, tag);
    }
    return;
  }
  for (int from = 0; from < controller->GetNumberOfProcesses(); ++from)
  {
    if (from == process)
    {
      take(own);
      continue;
    }
    vtkIdType size = 0;
    controller->Receive(&size, 1, from, tag);
    std::vector<double> numbers(static_cast<std::size_t>(size));
    for (vtkIdType received = 0; received < size; received += most)
    {
      controller->Receive(numbers.data() + received, std::min(size - received, most), from, tag);
    }
    take(numbers);
  }
}
}
