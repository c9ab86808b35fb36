// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/SkdSubset.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"

namespace
{
int PointTypeOf(vtkDataSet* mesh)
{
  auto* set = vtkPointSet::SafeDownCast(mesh);
  return set && set->GetPoints() ? set->GetPoints()->GetDataType() : VTK_DOUBLE;
}

void CopyTuples(
  vtkDataSetAttributes* from, const std::vector<vtkIdType>& ids, vtkDataSetAttributes* into)
{
  const auto n = static_cast<vtkIdType>(ids.size());
  into->CopyAllOn();
  into->CopyAllocate(from, n);
  for (vtkIdType i = 0; i < n; ++i)
  {
    into->CopyData(from, ids[i], i);
  }
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
  this->CellIds.push_back(cell);
}

void SkdSubset::AddPoint(vtkIdType point)
{
  const vtkIdType id = this->NewPoint(point);
  this->Grid->InsertNextCell(VTK_VERTEX, 1, &id);
}

void SkdSubset::CopyData()
{
  CopyTuples(this->Mesh->GetPointData(), this->PointIds, this->Grid->GetPointData());
  if (!this->CellIds.empty())
  {
    CopyTuples(this->Mesh->GetCellData(), this->CellIds, this->Grid->GetCellData());
  }
}

vtkIdType SkdSubset::NewPoint(vtkIdType point)
{
  const auto next = static_cast<vtkIdType>(this->PointIds.size());
  const auto [entry, isNew] = this->NewIds.emplace(point, next);
  if (isNew)
  {
    double x[3];
    this->Mesh->GetPoint(point, x);
    this->Grid->GetPoints()->InsertNextPoint(x);
    this->PointIds.push_back(point);
  }
  return entry->second;
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
