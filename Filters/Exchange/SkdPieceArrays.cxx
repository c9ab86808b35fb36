// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Exchange/SkdPieceArrays.h"

#include "Pipeline/SkdArrayGather.h"
#include "vtkDataSetAttributes.h"
#include "vtkPointSet.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace skdtree
{
namespace
{
void CopyActiveAttributes(vtkDataSetAttributes* from, vtkDataSetAttributes* into)
{
  for (int i = 0; i < from->GetNumberOfArrays(); ++i)
  {
    const int attribute = from->IsArrayAnAttribute(i);
    const char* name = from->GetAbstractArray(i)->GetName();
    if (attribute >= 0 && name && into->HasArray(name))
    {
      into->SetActiveAttribute(name, attribute);
    }
  }
}

/// The bits of duplicates of points and of cells are the same.
void RemoveMarksOfDuplicates(vtkDataSetAttributes* data)
{
  auto* ghosts =
    vtkUnsignedCharArray::SafeDownCast(data->GetArray(vtkDataSetAttributes::GhostArrayName()));
  if (ghosts)
  {
    unsigned char* const marks = ghosts->GetPointer(0);
    std::transform(marks, marks + ghosts->GetNumberOfValues(), marks,
      [](unsigned char mark)
      { return static_cast<unsigned char>(mark & ~vtkDataSetAttributes::DUPLICATECELL); });
  }
}

int PrecisionOf(const SkdPieces& pieces)
{
  for (vtkDataSet* piece : pieces)
  {
    auto* set = vtkPointSet::SafeDownCast(piece);
    const bool isSingle =
      set && (!set->GetPoints() || set->GetPoints()->GetDataType() == VTK_FLOAT);
    if (!isSingle)
    {
      return VTK_DOUBLE;
    }
  }
  return VTK_FLOAT;
}
}

void SkdJoinArrays(const SkdPieces& pieces, const std::vector<SkdPieceTuples>& tuples, int type,
  vtkIdType number, vtkDataSetAttributes* into)
{
  std::vector<vtkDataSetAttributes*> sets;
  for (vtkDataSet* piece : pieces)
  {
    sets.push_back(piece->GetAttributes(type));
  }
  SkdArrayGather gather(sets, [](vtkAbstractArray*) { return true; });
  gather.Allocate(number);
  for (std::size_t set = 0; set < sets.size(); ++set)
  {
    const SkdPieceTuples& own = tuples[set];
    for (std::size_t i = 0; i < own.From.size(); ++i)
    {
      gather.Take(own.To[i], static_cast<int>(set), own.From[i]);
    }
  }
  gather.AddTo(into);
  CopyActiveAttributes(sets.front(), into);
  RemoveMarksOfDuplicates(into);
}

vtkSmartPointer<vtkPoints> SkdJoinPoints(
  const SkdPieces& pieces, const std::vector<SkdPieceTuples>& tuples, vtkIdType number)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataType(PrecisionOf(pieces));
  points->SetNumberOfPoints(number);
  for (std::size_t piece = 0; piece < pieces.size(); ++piece)
  {
    for (std::size_t i = 0; i < tuples[piece].From.size(); ++i)
    {
      double x[3];
      pieces[piece]->GetPoint(tuples[piece].From[i], x);
      points->SetPoint(tuples[piece].To[i], x);
    }
  }
  return points;
}

const unsigned char* SkdGhostsOf(vtkDataSet* piece, int type)
{
  auto* ghosts = vtkUnsignedCharArray::SafeDownCast(
    piece->GetAttributes(type)->GetArray(vtkDataSetAttributes::GhostArrayName()));
  return ghosts && ghosts->GetNumberOfValues() > 0 ? ghosts->GetPointer(0) : nullptr;
}

bool SkdHasDuplicates(vtkDataSet* piece)
{
  for (int type : { vtkDataObject::POINT, vtkDataObject::CELL })
  {
    const unsigned char* ghosts = SkdGhostsOf(piece, type);
    const vtkIdType number = ghosts ? piece->GetNumberOfElements(type) : 0;
    if (std::any_of(ghosts, ghosts + number,
          [](unsigned char mark) { return (mark & vtkDataSetAttributes::DUPLICATECELL) != 0; }))
    {
      return true;
    }
  }
  return false;
}
}
