// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdFillCell_h
#define SkdFillCell_h

#include "Cells/Read/SkdStoredValues.h"
#include "Core/Geometry/PointArray.h"

#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cstddef>

namespace skdtree
{
/// Gives a cell that has its type these point ids, which may be its own already, and their points
/// from an array of points, without a call for each of them. False if the cell's points are not
/// stored as doubles, as they are unless someone changed that.
template <class Id>
bool SkdFillCell(vtkGenericCell* cell, const Id* ids, vtkIdType size, const skd::PointArray& from)
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
    const skd::Vector3 x = from.At(static_cast<std::size_t>(ids[i]));
    toId[i] = static_cast<vtkIdType>(ids[i]);
    std::copy(x.X, x.X + 3, to);
  }
  return to;
}
}

#endif
