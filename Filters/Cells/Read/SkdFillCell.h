// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdFillCell_h
#define SkdFillCell_h

#include "Cells/Read/SkdStoredValues.h"

#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkPoints.h"

#include <cstddef>

namespace skdtree
{
/// Gives a cell that has its type these point ids, which may be its own already, and their points
/// from a list of coordinates, without a call for each of them. False if the cell's points are not
/// stored as doubles, as they are unless someone changed that.
template <class Id, class Real>
bool SkdFillCell(vtkGenericCell* cell, const Id* ids, vtkIdType size, const Real* coordinates)
{
  vtkIdList* cellIds = cell->GetPointIds();
  if (cellIds->GetNumberOfIds() != size)
  {
    cellIds->SetNumberOfIds(size);
  }
  vtkPoints* points = cell->GetPoints();
  if (points->GetNumberOfPoints() != size)
  {
    points->SetNumberOfPoints(size);
  }
  points->Modified(); // their bounds are others
  double* to = SkdStoredValues<double>(points->GetData());
  vtkIdType* toId = cellIds->GetPointer(0);
  for (vtkIdType i = 0; to && i < size; ++i, to += 3)
  {
    const Real* from = coordinates + 3 * static_cast<std::size_t>(ids[i]);
    toId[i] = static_cast<vtkIdType>(ids[i]);
    to[0] = from[0];
    to[1] = from[1];
    to[2] = from[2];
  }
  return to;
}
}

#endif
