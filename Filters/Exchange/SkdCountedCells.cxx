// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Exchange/SkdCountedCells.h"

#include "Exchange/SkdJoinedRows.h"
#include "Exchange/SkdNearbyInput.h"
#include "Pipeline/SkdBlocks.h"
#include "vtkCellData.h"
#include "vtkCommunicator.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace skdtree
{
namespace
{
std::vector<std::vector<unsigned char>> AllOf(vtkDataObject* piece)
{
  return std::vector<std::vector<unsigned char>>(SkdBlocksOf(piece).size());
}

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

/// Marks the cells of a copy that are not counted.
void Mark(vtkDataSet* mesh, const std::vector<unsigned char>& counted)
{
  vtkUnsignedCharArray* given = mesh->GetCellGhostArray();
  vtkNew<vtkUnsignedCharArray> marks;
  marks->SetName(vtkDataSetAttributes::GhostArrayName());
  marks->SetNumberOfValues(mesh->GetNumberOfCells());
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    const int mark = given ? given->GetValue(cell) : 0;
    const bool isCounted = counted[static_cast<std::size_t>(cell)] != 0;
    marks->SetValue(cell,
      static_cast<unsigned char>(isCounted ? mark : mark | vtkDataSetAttributes::DUPLICATECELL));
  }
  mesh->GetCellData()->AddArray(marks);
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
    if (transport && SkdCanBring(piece))
    {
      this->OfBlocks = SkdFindCountedElements(*transport, piece, this->Type);
    }
    else
    {
      this->OfBlocks =
        this->Type == vtkDataObject::POINT ? AllOf(piece) : CountedByRows(piece, controller);
    }
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

vtkDataObject* SkdCountedInput::Update(vtkDataObject* piece, vtkMultiProcessController* controller)
{
  const std::vector<std::vector<unsigned char>>& counted = this->Counted.Update(piece, controller);
  SkdStamp stamp(piece);
  if (stamp == this->Known && counted == this->OfBlocks)
  {
    return this->Marked ? this->Marked.Get() : piece;
  }
  this->Known = std::move(stamp);
  this->OfBlocks = counted;
  this->Marked = nullptr;
  const bool areAll = std::all_of(counted.begin(), counted.end(),
    [](const std::vector<unsigned char>& ofBlock) { return ofBlock.empty(); });
  if (!areAll)
  {
    this->Marked = vtkSmartPointer<vtkDataObject>::Take(piece->NewInstance());
    const std::vector<SkdBlock> blocks = SkdMirror(piece, this->Marked);
    for (std::size_t i = 0; i < blocks.size(); ++i)
    {
      if (!counted[i].empty())
      {
        Mark(blocks[i].Mesh, counted[i]);
      }
    }
  }
  return this->Marked ? this->Marked.Get() : piece;
}

const std::vector<std::vector<vtkIdType>>& SkdCountedInput::FindIds(
  vtkDataObject* piece, vtkMultiProcessController* controller, SkdTransport& transport)
{
  const std::vector<std::vector<unsigned char>>& counted = this->Counted.Update(piece, controller);
  SkdStamp stamp(piece);
  const int isNew = stamp != this->Numbered ? 1 : 0;
  int isAnyNew = 0;
  controller->AllReduce(&isNew, &isAnyNew, 1, vtkCommunicator::MAX_OP);
  if (isAnyNew != 0)
  {
    this->Ids = SkdNumberCountedCells(transport, piece, counted);
    this->Numbered = std::move(stamp);
  }
  return this->Ids;
}

// What is not like the piece, but a list of what was found by its cells, has lost those that are
// marked.
void SkdCountedInput::Restore(vtkInformationVector* outputs) const
{
  const std::vector<SkdBlock> pieces =
    this->Marked ? SkdBlocksOf(this->Known.Get()) : std::vector<SkdBlock>();
  const bool haveMarks = std::any_of(pieces.begin(), pieces.end(),
    [](const SkdBlock& block) { return block.Mesh->GetCellGhostArray() != nullptr; });
  for (int port = 0; this->Marked && port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    for (const SkdBlock& block : SkdBlocksOf(vtkDataObject::GetData(outputs, port)))
    {
      const auto piece = std::find_if(pieces.begin(), pieces.end(),
        [&](const SkdBlock& each)
        {
          return each.BlockIndex == block.BlockIndex &&
            each.Mesh->GetNumberOfCells() == block.Mesh->GetNumberOfCells();
        });
      vtkUnsignedCharArray* own =
        piece != pieces.end() ? piece->Mesh->GetCellGhostArray() : nullptr;
      if (own && port == 0 && block.Mesh->GetCellGhostArray()) // a copy passed the marks on
      {
        block.Mesh->GetCellData()->AddArray(own);
      }
      else if (!haveMarks)
      {
        block.Mesh->GetCellData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
      }
    }
  }
}
}
