// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdTouchCells_h
#define SkdTouchCells_h

#include "vtkDataSet.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkNew.h"

/// Makes GetCell(), GetCellPoints() and GetCellBounds() of a mesh thread-safe.
inline void SkdTouchCells(vtkDataSet* mesh)
{
  if (mesh->GetNumberOfCells() > 0)
  {
    vtkNew<vtkGenericCell> cell;
    vtkNew<vtkIdList> ids;
    double bounds[6];
    mesh->GetCell(0, cell);
    mesh->GetCellPoints(0, ids);
    mesh->GetCellBounds(0, bounds);
  }
}

#endif
