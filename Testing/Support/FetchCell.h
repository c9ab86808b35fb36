// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skdtest_FetchCell_h
#define skdtest_FetchCell_h

#include <vtkCellType.h>
#include <vtkDataSet.h>
#include <vtkGenericCell.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPoints.h>

namespace skdtest
{

/// As vtkDataSet::GetCell, but a convex point set gets the numbers of its points within itself as
/// their ids: VTK 9.3 takes the one for the other when it triangulates the cell, out of bounds.
inline void FetchCell(vtkDataSet* data, vtkIdType id, vtkGenericCell* cell)
{
  if (data->GetCellType(id) != VTK_CONVEX_POINT_SET)
  {
    data->GetCell(id, cell);
    return;
  }
  vtkNew<vtkIdList> ids;
  data->GetCellPoints(id, ids);
  const vtkIdType count = ids->GetNumberOfIds();
  cell->SetCellTypeToConvexPointSet();
  cell->GetPoints()->SetNumberOfPoints(count);
  cell->GetPointIds()->SetNumberOfIds(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    cell->GetPoints()->SetPoint(i, data->GetPoint(ids->GetId(i)));
    cell->GetPointIds()->SetId(i, i);
  }
  cell->Initialize();
}

} // namespace skdtest

#endif
