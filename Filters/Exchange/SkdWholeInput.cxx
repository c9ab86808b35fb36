// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Exchange/SkdWholeInput.h"

#include "Exchange/SkdCompositePieces.h"
#include "Exchange/SkdMessage.h"
#include "vtkCommunicator.h"
#include "vtkFieldData.h"
#include "vtkMultiProcessController.h"

#include <map>

SkdWholeInput::Stamp SkdWholeInput::StampOf(vtkDataObject* piece)
{
  Stamp stamp{ { piece, piece->GetMTime() } };
  for (const SkdLeaf& leaf : SkdLeavesOf(piece))
  {
    stamp.emplace_back(leaf.Mesh.Get(), leaf.Mesh->GetMTime());
  }
  return stamp;
}

vtkDataObject* SkdWholeInput::Update(vtkDataObject* piece, vtkMultiProcessController* controller)
{
  Stamp stamp = StampOf(piece);
  const int isNew = !this->Whole || stamp != this->Known ? 1 : 0;
  int isAnyNew = 0;
  controller->AllReduce(&isNew, &isAnyNew, 1, vtkCommunicator::MAX_OP);
  if (isAnyNew != 0)
  {
    this->Join(SkdExchangeAll(piece, controller), controller->GetLocalProcessId());
    this->Known = std::move(stamp);
    this->Piece = piece;
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
  std::map<SkdLeafPath, Parts> places;
  vtkDataObject* ours = pieces[static_cast<std::size_t>(own)];
  this->Whole = SkdStructureOf(ours);
  for (std::size_t process = 0; process < pieces.size(); ++process)
  {
    SkdUniteStructures(this->Whole, pieces[process]);
    for (const SkdLeaf& leaf : SkdLeavesOf(pieces[process]))
    {
      places[leaf.Path].Meshes.push_back(leaf.Mesh);
      places[leaf.Path].Processes.push_back(static_cast<int>(process));
    }
  }
  this->Origins.clear();
  for (const auto& [path, parts] : places)
  {
    SkdJoinedPieces joined = SkdJoinPieces(parts.Meshes);
    for (SkdPieceCell& origin : joined.Origins)
    {
      origin.Piece = parts.Processes[static_cast<std::size_t>(origin.Piece)];
    }
    this->Origins.push_back(std::move(joined.Origins));
    if (this->Whole && !path.empty())
    {
      SkdSetLeaf(this->Whole, path, joined.Mesh);
    }
    else
    {
      this->Whole = joined.Mesh;
    }
  }
  if (this->Whole != ours)
  {
    this->Whole->GetFieldData()->PassData(ours->GetFieldData());
  }
}
