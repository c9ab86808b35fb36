// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/SkdQueryPoints.h"

#include "Pipeline/SkdBlocks.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkRectilinearGrid.h"

#include <algorithm>

namespace skdtree
{
namespace
{
/// The mean of some points; NaN of none.
void MeanOf(vtkDataSet* mesh, vtkIdList* ids, double x[3])
{
  const vtkIdType n = ids->GetNumberOfIds();
  std::fill(x, x + 3, n > 0 ? 0.0 : vtkMath::Nan());
  for (vtkIdType i = 0; i < n; ++i)
  {
    double p[3];
    mesh->GetPoint(ids->GetId(i), p);
    for (int axis = 0; axis < 3; ++axis)
    {
      x[axis] += p[axis] / n;
    }
  }
}
}

SkdQueryPoints::SkdQueryPoints(vtkDataSet* mesh, At at)
  : Mesh(mesh)
  , Where(at)
{
  if (at == At::Points)
  {
    this->Order.emplace(mesh);
  }
  else
  {
    SkdTouchCells(mesh);
  }
  this->FindRows();
}

void SkdQueryPoints::FindRows()
{
  int dimensions[3] = { 0, 0, 0 };
  if (auto* image = vtkImageData::SafeDownCast(this->Mesh))
  {
    image->GetDimensions(dimensions);
  }
  else if (auto* grid = vtkRectilinearGrid::SafeDownCast(this->Mesh))
  {
    grid->GetDimensions(dimensions);
  }
  const int length = this->Where == At::Points ? dimensions[0] : dimensions[0] - 1;
  this->RowLength = length > 1 ? length : 0;
}

vtkIdType SkdQueryPoints::GetNumber() const
{
  return this->Where == At::Points ? this->Mesh->GetNumberOfPoints()
                                   : this->Mesh->GetNumberOfCells();
}

void SkdQueryPoints::GetPoint(vtkIdType i, double x[3]) const
{
  if (this->Where == At::Points)
  {
    this->Mesh->GetPoint(i, x);
    return;
  }
  thread_local vtkNew<vtkIdList> ids;
  this->Mesh->GetCellPoints(i, ids);
  MeanOf(this->Mesh, ids, x);
}
}
