// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Triangles.h"

#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkNew.h"

namespace skdbench
{

std::optional<std::vector<Corners>> TrianglesOf(vtkDataSet* data)
{
  std::vector<Corners> triangles;
  triangles.reserve(static_cast<std::size_t>(data->GetNumberOfCells()));
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    if (data->GetCellType(cell) != VTK_TRIANGLE)
    {
      return std::nullopt;
    }
    data->GetCellPoints(cell, ids);
    Corners corners;
    data->GetPoint(ids->GetId(0), corners.A.data());
    data->GetPoint(ids->GetId(1), corners.B.data());
    data->GetPoint(ids->GetId(2), corners.C.data());
    triangles.push_back(corners);
  }
  return triangles;
}

}
