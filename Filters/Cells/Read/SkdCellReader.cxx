// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/Read/SkdCellReader.h"

#include "Cells/Read/SkdCellFunctions.h"
#include "Cells/Read/SkdFillCell.h"
#include "Cells/Read/SkdStoredTypes.h"
#include "Cells/Read/SkdStoredValues.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkGenericCell.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSkdTreeVersion.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <typeinfo>

namespace skdtree
{
namespace
{
enum KindOfRun
{
  Vertices,
  Lines,
  Polygons,
  Strips
};

/// The types of vtkPolyData cells as in VTK 9.2 and later, also for too few points.
int TypeOfSize(int kind, std::size_t size)
{
  switch (kind)
  {
    case Vertices:
      return size == 1 ? VTK_VERTEX : VTK_POLY_VERTEX;
    case Lines:
      return size == 2 ? VTK_LINE : VTK_POLY_LINE;
    case Polygons:
      return size == 3 ? VTK_TRIANGLE : size == 4 ? VTK_QUAD : VTK_POLYGON;
    default:
      return VTK_TRIANGLE_STRIP;
  }
}

/// The data set if it is of this class itself: one derived from it may have a GetCell of its own.
/// (SafeDownCast compares names, class by class, which takes as long as the rest.)
template <class DataSet>
DataSet* Exactly(vtkDataSet* data)
{
  return typeid(*data) == typeid(DataSet) ? static_cast<DataSet*>(data) : nullptr;
}

/// The points of a cell; false if they are not stored as floats or doubles.
bool CopyPoints(vtkPoints* points, vtkGenericCell* cell)
{
  const skd::PointArray from = SkdStoredPoints(points->GetData());
  vtkIdList* ids = cell->GetPointIds();
  return (from.Floats || from.Doubles) &&
    SkdFillCell(cell, ids->GetPointer(0), ids->GetNumberOfIds(), from);
}

/// GetCell of a cell that is its type and its points alone, without a virtual call for each of
/// them. False for others.
template <class Mesh>
bool LoadPlain(Mesh* mesh, vtkIdType cellId, vtkGenericCell* cell)
{
  const int type = mesh->Mesh::GetCellType(cellId);
  if (type == VTK_EMPTY_CELL || type >= VTK_CONVEX_POINT_SET)
  {
    return false;
  }
  cell->SetCellType(type);
  mesh->Mesh::GetCellPoints(cellId, cell->GetPointIds());
  if (CopyPoints(mesh->GetPoints(), cell))
  {
    return true;
  }
  cell->GetPoints()->Modified(); // VTK does not say so
  return false;
}

void LoadAny(vtkDataSet* data, vtkIdType cellId, vtkGenericCell* cell)
{
  auto* mesh = vtkPolyData::SafeDownCast(data);
  if (!mesh || !mesh->NeedToBuildCells())
  {
    data->GetCell(cellId, cell);
    SkdCellFunctions::ReadRationalWeights(data, cell);
    return;
  }
  const SkdCellReader reader(mesh);
  cell->SetCellType(reader.TypeOf(cellId));
  reader.VisitPoints(cellId, cell->GetPointIds(),
    [&](const auto* ids, std::size_t size)
    {
      const auto number = static_cast<vtkIdType>(size);
      cell->GetPointIds()->SetNumberOfIds(number);
      cell->GetPoints()->SetNumberOfPoints(number);
      for (vtkIdType i = 0; i < number; ++i)
      {
        double x[3];
        mesh->GetPoint(static_cast<vtkIdType>(ids[i]), x);
        cell->GetPointIds()->SetId(i, static_cast<vtkIdType>(ids[i]));
        cell->GetPoints()->SetPoint(i, x);
      }
    });
}
}

//------------------------------------------------------------------------------
SkdCellReader::SkdCellReader(vtkDataSet* data)
  : Data(data)
  , Surface(vtkPolyData::SafeDownCast(data))
{
  if (this->Surface)
  {
    this->AddRunsOf(this->Surface);
  }
  else if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    this->AddRun(grid->GetCells(), 0);
    this->ReadTypes(grid->VTK_SKD_GET_CELL_TYPES());
  }
  const bool areStored = std::all_of(
    this->Runs.begin(), this->Runs.end(), [](const Run& run) { return run.Cells.AreStored(); });
  if (!areStored || this->Runs.empty() || this->Runs.back().Last != data->GetNumberOfCells())
  {
    this->Runs.clear();
  }
  if (this->Runs.empty() && data->GetNumberOfCells() > 0)
  {
    vtkNew<vtkIdList> list;
    data->GetCellPoints(0, list); // what is made at the first call must not be made by many threads
  }
}

//------------------------------------------------------------------------------
void SkdCellReader::ReadTypes(vtkDataArray* types)
{
  this->Types = SkdStoredTypes(types, this->OwnTypes);
}

//------------------------------------------------------------------------------
// VTK makes a table of cells when the first one is fetched, which is not thread-safe. VTK 9.1
// makes none where a cell has too few points, but an error, and crashes at the next one.
void SkdCellReader::AddRunsOf(vtkPolyData* mesh)
{
  vtkCellArray* const arrays[4] = { mesh->GetVerts(), mesh->GetLines(), mesh->GetPolys(),
    mesh->GetStrips() };
  for (int kind = 0; kind < 4; ++kind)
  {
    this->AddRun(arrays[kind], kind);
  }
  if (mesh->NeedToBuildCells() && (VTK_SKD_BUILDS_ALL_CELLS || !this->HasTooSmallCells()))
  {
    mesh->BuildCells();
  }
  this->HasTypes = !mesh->NeedToBuildCells();
}

//------------------------------------------------------------------------------
// Of implicit offsets, or of others that are not stored, there is no run: then VTK fetches the
// cell.
void SkdCellReader::AddRun(vtkCellArray* cells, int kind)
{
  const vtkIdType first = this->Runs.empty() ? 0 : this->Runs.back().Last;
  if (!cells || cells->GetNumberOfCells() == 0)
  {
    return;
  }
  this->Runs.push_back({ first, first + cells->GetNumberOfCells(), SkdStoredCells(cells), kind });
}

//------------------------------------------------------------------------------
bool SkdCellReader::HasTooSmallCells() const
{
  return std::any_of(this->Runs.begin(), this->Runs.end(),
    [this](const Run& run)
    {
      bool isSmall = false;
      VisitStored(run, run.First, run.Last,
        [&](vtkIdType, const auto*, std::size_t size)
        { isSmall |= size < SkdLeastSize(run.Kind); });
      return isSmall;
    });
}

//------------------------------------------------------------------------------
int SkdCellReader::TypeBySize(vtkIdType cellId) const
{
  const Run* run = this->RunOf(cellId);
  int type = VTK_EMPTY_CELL;
  if (run)
  {
    VisitStored(*run, cellId, cellId + 1,
      [&](vtkIdType, const auto*, std::size_t size) { type = TypeOfSize(run->Kind, size); });
  }
  return type;
}

//------------------------------------------------------------------------------
bool SkdHasPlainCells(vtkDataSet* data)
{
  const int type = data->GetDataObjectType(); // two names take longer to compare
  return (type == VTK_POLY_DATA && Exactly<vtkPolyData>(data)) ||
    (type == VTK_UNSTRUCTURED_GRID && Exactly<vtkUnstructuredGrid>(data));
}

//------------------------------------------------------------------------------
void SkdLoadCell(vtkDataSet* data, vtkIdType cellId, vtkGenericCell* cell)
{
  auto* grid = Exactly<vtkUnstructuredGrid>(data);
  auto* mesh = grid ? nullptr : Exactly<vtkPolyData>(data);
  const bool isLoaded = grid ? LoadPlain(grid, cellId, cell)
                             : mesh && !mesh->NeedToBuildCells() && LoadPlain(mesh, cellId, cell);
  if (!isLoaded)
  {
    LoadAny(data, cellId, cell);
  }
}
}
