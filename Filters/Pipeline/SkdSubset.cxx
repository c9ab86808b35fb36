// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/SkdSubset.h"

#include "Cells/Read/SkdCellReader.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <numeric>

namespace skdtree
{
namespace
{
vtkPoints* PointsOf(vtkDataSet* mesh)
{
  auto* set = vtkPointSet::SafeDownCast(mesh);
  return set ? set->GetPoints() : nullptr;
}

vtkSmartPointer<vtkIdList> ListOf(const std::vector<vtkIdType>& ids)
{
  auto list = vtkSmartPointer<vtkIdList>::New();
  list->SetNumberOfIds(static_cast<vtkIdType>(ids.size()));
  std::copy(ids.begin(), ids.end(), list->GetPointer(0));
  return list;
}

/// 0, 1, ... n - 1.
vtkSmartPointer<vtkIdList> FirstIds(vtkIdType n)
{
  auto list = vtkSmartPointer<vtkIdList>::New();
  list->SetNumberOfIds(n);
  std::iota(list->GetPointer(0), list->GetPointer(0) + n, vtkIdType(0));
  return list;
}

/// All tuples of an array in one call: one by one costs several calls a tuple.
void CopyTuples(
  vtkDataSetAttributes* from, const std::vector<vtkIdType>& ids, vtkDataSetAttributes* into)
{
  const auto n = static_cast<vtkIdType>(ids.size());
  into->CopyAllOn();
  into->CopyAllocate(from, n);
  into->CopyData(from, ListOf(ids), FirstIds(n));
}
}

SkdSubset::SkdSubset(vtkDataSet* mesh)
  : Mesh(mesh)
{
  vtkPoints* theirs = PointsOf(mesh);
  vtkNew<vtkPoints> points;
  points->SetDataType(theirs ? theirs->GetDataType() : VTK_DOUBLE);
  this->Grid->SetPoints(points);
  this->Grid->Allocate(0);
}

void SkdSubset::SetCells(const std::vector<vtkIdType>& cells)
{
  this->CellIds = cells;
  if (cells.empty())
  {
    return;
  }
  this->NewIds.assign(static_cast<std::size_t>(this->Mesh->GetNumberOfPoints()), -1);
  const SkdCellReader reader(this->Mesh);
  vtkNew<vtkUnsignedCharArray> types;
  types->SetNumberOfValues(static_cast<vtkIdType>(cells.size()));
  unsigned char* const first = types->GetPointer(0);
  unsigned char* const last = std::transform(cells.begin(), cells.end(), first,
    [&reader](vtkIdType cell) { return static_cast<unsigned char>(reader.TypeOf(cell)); });
  if (std::find(first, last, static_cast<unsigned char>(VTK_POLYHEDRON)) != last)
  {
    this->InsertCells(reader);
  }
  else
  {
    this->CopyCells(reader, types);
  }
  this->CopyPoints();
}

void SkdSubset::SetPoints(const std::vector<vtkIdType>& points)
{
  this->PointIds = points;
  for (vtkIdType id = 0; id < static_cast<vtkIdType>(points.size()); ++id)
  {
    this->Grid->InsertNextCell(VTK_VERTEX, 1, &id);
  }
  this->CopyPoints();
}

void SkdSubset::CopyShaping()
{
  const auto copy = [](vtkDataArray* from, const std::vector<vtkIdType>& ids)
  {
    auto to = vtkSmartPointer<vtkDataArray>::Take(from->NewInstance());
    to->SetName(from->GetName());
    to->SetNumberOfComponents(from->GetNumberOfComponents());
    to->SetNumberOfTuples(static_cast<vtkIdType>(ids.size()));
    from->GetTuples(ListOf(ids), to);
    return to;
  };
  if (vtkDataArray* weights = this->Mesh->GetPointData()->GetRationalWeights())
  {
    this->Grid->GetPointData()->SetRationalWeights(copy(weights, this->PointIds));
  }
  if (vtkDataArray* degrees = this->Mesh->GetCellData()->GetHigherOrderDegrees())
  {
    this->Grid->GetCellData()->SetHigherOrderDegrees(copy(degrees, this->CellIds));
  }
}

void SkdSubset::CopyData()
{
  CopyTuples(this->Mesh->GetPointData(), this->PointIds, this->Grid->GetPointData());
  if (!this->CellIds.empty())
  {
    CopyTuples(this->Mesh->GetCellData(), this->CellIds, this->Grid->GetCellData());
  }
}

// Ids that follow each other at once.
template <class Visit>
void SkdSubset::VisitCells(const SkdCellReader& reader, vtkIdList* list, const Visit& visit) const
{
  const std::size_t n = this->CellIds.size();
  for (std::size_t begin = 0, end = 0; begin < n; begin = end)
  {
    for (end = begin + 1; end < n && this->CellIds[end] == this->CellIds[end - 1] + 1;)
    {
      ++end;
    }
    reader.VisitCells(this->CellIds[begin], this->CellIds[end - 1] + 1, list, visit);
  }
}

// Whole arrays, for to insert a cell takes VTK several calls.
void SkdSubset::CopyCells(const SkdCellReader& reader, vtkUnsignedCharArray* types)
{
  vtkNew<vtkIdTypeArray> offsets;
  offsets->SetNumberOfValues(types->GetNumberOfValues() + 1);
  vtkNew<vtkIdList> list;
  vtkIdType* offset = offsets->GetPointer(0);
  *offset = 0;
  const auto addSize = [&offset](vtkIdType, const auto*, std::size_t size)
  {
    offset[1] = offset[0] + static_cast<vtkIdType>(size);
    ++offset;
  };
  this->VisitCells(reader, list, addSize);
  vtkNew<vtkIdTypeArray> connectivity;
  connectivity->SetNumberOfValues(*offset);
  vtkIdType* to = connectivity->GetPointer(0);
  const auto renumber = [&](vtkIdType, const auto* ids, std::size_t size)
  {
    to = std::transform(
      ids, ids + size, to, [this](auto id) { return this->NewPoint(static_cast<vtkIdType>(id)); });
  };
  this->VisitCells(reader, list, renumber);
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, connectivity);
  this->Grid->SetCells(types, cells);
}

// Polyhedra as a stream: the number of faces, then of each face its size and points.
void SkdSubset::InsertCells(const SkdCellReader& reader)
{
  auto* grid = vtkUnstructuredGrid::SafeDownCast(this->Mesh);
  vtkNew<vtkIdList> ids;
  const auto renumber = [&](vtkIdType first, vtkIdType last)
  {
    std::transform(ids->GetPointer(first), ids->GetPointer(last), ids->GetPointer(first),
      [this](vtkIdType id) { return this->NewPoint(id); });
  };
  for (const vtkIdType cell : this->CellIds)
  {
    const int type = reader.TypeOf(cell);
    if (grid && type == VTK_POLYHEDRON)
    {
      grid->GetFaceStream(cell, ids);
      for (vtkIdType at = 1; at < ids->GetNumberOfIds(); at += 1 + ids->GetId(at))
      {
        renumber(at + 1, at + 1 + ids->GetId(at));
      }
    }
    else
    {
      this->Mesh->GetCellPoints(cell, ids);
      renumber(0, ids->GetNumberOfIds());
    }
    this->Grid->InsertNextCell(type, ids);
  }
}

void SkdSubset::CopyPoints()
{
  const auto n = static_cast<vtkIdType>(this->PointIds.size());
  vtkPoints* into = this->Grid->GetPoints();
  into->SetNumberOfPoints(n);
  if (vtkPoints* points = PointsOf(this->Mesh))
  {
    points->GetData()->GetTuples(ListOf(this->PointIds), into->GetData());
    return;
  }
  for (vtkIdType i = 0; i < n; ++i)
  {
    double x[3];
    this->Mesh->GetPoint(this->PointIds[static_cast<std::size_t>(i)], x);
    into->SetPoint(i, x);
  }
}
}
