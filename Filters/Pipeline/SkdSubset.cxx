// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/SkdSubset.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"

#include <numeric>

namespace
{
int PointTypeOf(vtkDataSet* mesh)
{
  auto* set = vtkPointSet::SafeDownCast(mesh);
  return set && set->GetPoints() ? set->GetPoints()->GetDataType() : VTK_DOUBLE;
}

/// All tuples of an array in one call: one by one costs several calls a tuple.
void CopyTuples(vtkDataSetAttributes* from, vtkIdList* ids, vtkDataSetAttributes* into)
{
  const vtkIdType n = ids->GetNumberOfIds();
  vtkNew<vtkIdList> inTurn;
  inTurn->SetNumberOfIds(n);
  std::iota(inTurn->GetPointer(0), inTurn->GetPointer(0) + n, vtkIdType(0));
  into->CopyAllOn();
  into->CopyAllocate(from, n);
  into->CopyData(from, ids, inTurn);
}
}

SkdSubset::SkdSubset(vtkDataSet* mesh)
  : Mesh(mesh)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(PointTypeOf(mesh));
  this->Grid->SetPoints(points);
  this->Grid->Allocate(64);
}

void SkdSubset::AddCell(vtkIdType cell)
{
  auto* grid = vtkUnstructuredGrid::SafeDownCast(this->Mesh);
  const int type = this->Mesh->GetCellType(cell);
  if (grid && type == VTK_POLYHEDRON)
  {
    grid->GetFaceStream(cell, this->Ids);
    this->RenumberFaces();
  }
  else
  {
    this->Mesh->GetCellPoints(cell, this->Ids);
    this->Renumber(0, this->Ids->GetNumberOfIds());
  }
  this->Grid->InsertNextCell(type, this->Ids);
  this->CellIds->InsertNextId(cell);
}

void SkdSubset::AddPoint(vtkIdType point)
{
  const vtkIdType id = this->NewPoint(point);
  this->Grid->InsertNextCell(VTK_VERTEX, 1, &id);
}

void SkdSubset::CopyData()
{
  CopyTuples(this->Mesh->GetPointData(), this->PointIds, this->Grid->GetPointData());
  if (this->CellIds->GetNumberOfIds() > 0)
  {
    CopyTuples(this->Mesh->GetCellData(), this->CellIds, this->Grid->GetCellData());
  }
}

vtkIdType SkdSubset::NewPoint(vtkIdType point)
{
  if (this->NewIds.empty())
  {
    this->NewIds.assign(static_cast<std::size_t>(this->Mesh->GetNumberOfPoints()), -1);
  }
  vtkIdType& id = this->NewIds[static_cast<std::size_t>(point)];
  if (id < 0)
  {
    double x[3];
    this->Mesh->GetPoint(point, x);
    this->Grid->GetPoints()->InsertNextPoint(x);
    id = this->PointIds->InsertNextId(point);
  }
  return id;
}

void SkdSubset::Renumber(vtkIdType first, vtkIdType last)
{
  for (vtkIdType i = first; i < last; ++i)
  {
    this->Ids->SetId(i, this->NewPoint(this->Ids->GetId(i)));
  }
}

// The number of faces, then of each face its size and points.
void SkdSubset::RenumberFaces()
{
  for (vtkIdType at = 1; at < this->Ids->GetNumberOfIds();)
  {
    const vtkIdType size = this->Ids->GetId(at);
    this->Renumber(at + 1, at + 1 + size);
    at += 1 + size;
  }
}
