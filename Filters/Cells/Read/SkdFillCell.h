// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdFillCell_h
#define SkdFillCell_h

#include "Cells/Read/SkdStoredValues.h"
#include "Core/Geometry/PointArray.h"

#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkPoints.h"

namespace skdtree
{
/// Copies points and their ids one after the other.
template <class Id, class Number>
void SkdCopyPoints(
  const Id* ids, vtkIdType size, const Number* from, vtkIdType* toIds, double* toPoints)
{
  for (vtkIdType i = 0; i < size; ++i, toPoints += 3)
  {
    const auto id = static_cast<vtkIdType>(ids[i]);
    const Number x = from[3 * id], y = from[3 * id + 1], z = from[3 * id + 2];
    toIds[i] = id;
    toPoints[0] = x;
    toPoints[1] = y;
    toPoints[2] = z;
  }
}

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
  if (points->GetData()->GetNumberOfValues() != 3 * size) // no division
  {
    points->SetNumberOfPoints(size);
  }
  points->Modified(); // their bounds are others
  double* to = SkdStoredValues<double>(points->GetData());
  if (!to)
  {
    return false;
  }
  vtkIdType* toIds = cellIds->GetPointer(0);
  from.Floats ? SkdCopyPoints(ids, size, from.Floats, toIds, to)
              : SkdCopyPoints(ids, size, from.Doubles, toIds, to);
  return true;
}
}

#endif
