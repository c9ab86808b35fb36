// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Exchange/SkdWholeInput.h"

#include "Exchange/SkdCompositePieces.h"
#include "Exchange/SkdJoinedPieces.h"
#include "Exchange/SkdMessage.h"
#include "Pipeline/SkdBlocks.h"
#include "vtkCommunicator.h"
#include "vtkFieldData.h"
#include "vtkMultiProcessController.h"

namespace skdtree
{
vtkDataObject* SkdWholeInput::Update(vtkDataObject* piece, vtkMultiProcessController* controller)
{
  SkdStamp stamp(piece);
  const int isNew = !this->Whole || stamp != this->Known ? 1 : 0;
  int isAnyNew = 0;
  controller->AllReduce(&isNew, &isAnyNew, 1, vtkCommunicator::MAX_OP);
  if (isAnyNew != 0)
  {
    this->Join(SkdExchangeAll(piece, controller), controller->GetLocalProcessId());
    this->Known = std::move(stamp);
  }
  return this->Whole;
}

void SkdWholeInput::Join(const std::vector<vtkSmartPointer<vtkDataObject>>& pieces, int own)
{
  struct Parts
  {
    std::vector<vtkSmartPointer<vtkDataSet>> Meshes;
    std::vector<int> Processes;
  };
  std::map<SkdBlockPath, Parts> byPath;
  vtkDataObject* ours = pieces[static_cast<std::size_t>(own)];
  this->Whole = SkdStructureOf(ours);
  for (std::size_t process = 0; process < pieces.size(); ++process)
  {
    SkdUniteStructures(this->Whole, pieces[process]);
    for (const SkdLeafBlock& leaf : SkdLeafBlocksOf(pieces[process]))
    {
      byPath[leaf.Path].Meshes.push_back(leaf.Mesh);
      byPath[leaf.Path].Processes.push_back(static_cast<int>(process));
    }
  }
  std::vector<std::vector<SkdPieceCell>> origins;
  this->Repeated = {};
  for (const auto& [path, parts] : byPath)
  {
    SkdJoinedPieces joined = SkdJoinPieces(parts.Meshes);
    for (SkdPieceCell& origin : joined.Origins)
    {
      origin.Piece = parts.Processes[static_cast<std::size_t>(origin.Piece)];
    }
    origins.push_back(std::move(joined.Origins));
    if (joined.Repeated.IsThere && !this->Repeated.IsThere)
    {
      this->Repeated = joined.Repeated;
      for (SkdRepeatedId::Owner& owner : this->Repeated.Owners)
      {
        owner.Process = parts.Processes[static_cast<std::size_t>(owner.Process)];
      }
    }
    if (this->Whole && !path.empty())
    {
      SkdSetBlock(this->Whole, path, joined.Mesh);
    }
    else
    {
      this->Whole = joined.Mesh;
    }
  }
  this->Origins.clear();
  const std::vector<SkdBlock> blocks = SkdBlocksOf(this->Whole); // in the order of their paths
  for (std::size_t i = 0; i < blocks.size(); ++i)
  {
    this->Origins[blocks[i].BlockIndex] = std::move(origins[i]);
  }
  if (this->Whole != ours)
  {
    this->Whole->GetFieldData()->PassData(ours->GetFieldData());
  }
}
}
