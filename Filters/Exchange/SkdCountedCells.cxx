// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Exchange/SkdCountedCells.h"

#include "Exchange/SkdJoinedRows.h"
#include "Exchange/SkdNearbyInput.h"
#include "vtkCommunicator.h"
#include "vtkMultiProcessController.h"

#include <algorithm>

namespace skdtree
{
namespace
{
/// Without an exchange between processes all have the whole for a moment.
std::vector<std::vector<unsigned char>> CountedByRows(
  vtkDataObject* piece, vtkMultiProcessController* controller)
{
  std::vector<std::vector<unsigned char>> counted;
  for (const std::vector<vtkIdType>& rows : SkdJoinRows(piece, controller).OfBlocks)
  {
    counted.emplace_back(rows.size());
    std::transform(rows.begin(), rows.end(), counted.back().begin(),
      [](vtkIdType row) { return static_cast<unsigned char>(row >= 0 ? 1 : 0); });
  }
  return counted;
}
}

const std::vector<std::vector<unsigned char>>& SkdCountedCells::Update(
  vtkDataObject* piece, vtkMultiProcessController* controller)
{
  SkdStamp stamp(piece);
  const int isNew = stamp != this->Known ? 1 : 0;
  int isAnyNew = 0;
  controller->AllReduce(&isNew, &isAnyNew, 1, vtkCommunicator::MAX_OP);
  if (isAnyNew != 0)
  {
    const std::unique_ptr<SkdTransport> transport = SkdMakeTransport(controller);
    this->OfBlocks = transport && SkdCanBring(piece)
      ? SkdNearbyInput().FindCounted(*transport, piece)
      : CountedByRows(piece, controller);
    for (std::vector<unsigned char>& counted : this->OfBlocks)
    {
      if (std::find(counted.begin(), counted.end(), 0) == counted.end())
      {
        counted.clear();
      }
    }
    this->Known = std::move(stamp);
  }
  return this->OfBlocks;
}
}
