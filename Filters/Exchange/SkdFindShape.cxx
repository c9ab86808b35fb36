// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Exchange/SkdFindShape.h"

#include "Cells/Read/SkdCellReader.h"
#include "Pipeline/SkdShownElements.h"
#include "vtkGenericCell.h"
#include "vtkNew.h"

#include <algorithm>

namespace skdtree
{
namespace
{
void AddPoints(
  vtkDataSet* piece, const SkdPieceNumbers& numbers, int process, SkdJoinedShape& shape)
{
  const SkdShown shown(piece, vtkDataObject::POINT);
  for (std::size_t point = 0; point < numbers.PointIds.size(); ++point)
  {
    const SkdPointOrigin& origin = numbers.PointOrigins[point];
    const auto id = static_cast<vtkIdType>(point);
    if (numbers.PointIds[point] >= 0 && origin.Process == process && origin.Point == id &&
      shown.Has(id))
    {
      skd::Vector3 x;
      piece->GetPoint(id, x.X);
      shape.AddPoint(x);
    }
  }
}

void AddCells(vtkDataSet* piece, const SkdPieceNumbers& numbers, SkdJoinedShape& shape)
{
  const SkdCellReader reader(piece);
  const SkdShown shown(piece, vtkDataObject::CELL);
  vtkNew<vtkGenericCell> cell;
  int known = VTK_EMPTY_CELL;
  for (std::size_t at = 0; at < numbers.CellIds.size(); ++at)
  {
    const vtkIdType joined = numbers.CellIds[at];
    const auto id = static_cast<vtkIdType>(at);
    const int type = reader.TypeOf(id);
    if (joined >= 0 && type != known && type != VTK_EMPTY_CELL && shown.Has(id))
    {
      cell->SetCellType(type);
      shape.Dimension = std::max(shape.Dimension, cell->GetCellDimension());
      known = type;
    }
    if (joined >= 0 && joined < SkdCellsForNormal && shown.Has(id))
    {
      shape.AddNormal(SkdNormalOfCorners(piece, id), joined);
    }
  }
}
}

SkdJoinedShape SkdFindShape(SkdTransport& transport, vtkDataSet* piece, const SkdAllFacts& facts,
  const SkdPieceNumbers& numbers)
{
  SkdJoinedShape own;
  AddPoints(piece, numbers, transport.GetRank(), own);
  AddCells(piece, numbers, own);
  SkdJoinedShape all;
  for (const std::vector<SkdJoinedShape>& other :
    SkdGatherRows(transport, std::vector<SkdJoinedShape>{ own }))
  {
    all.Add(other.front());
  }
  all.IsStructured = facts.FillGrid();
  if (all.IsStructured)
  {
    const std::array<int, 6> extent = facts.GetGridExtent();
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      all.CellsAlong[axis] = extent[2 * axis + 1] - extent[2 * axis];
    }
  }
  return all;
}
}
