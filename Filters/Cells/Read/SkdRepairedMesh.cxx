// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/Read/SkdRepairedMesh.h"

#include "Cells/Read/SkdCellCheck.h"
#include "Cells/Read/SkdCellReader.h"
#include "Cells/Read/SkdRawCells.h"
#include "vtkSkdTreeVersion.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataSetAttributes.h"
#include "vtkExplicitStructuredGrid.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace skdtree
{
namespace
{
using Ids = std::vector<vtkIdType>;
using CellsPointer = vtkSmartPointer<vtkCellArray>;

/// The cells first .. of a data set, but broken ones have `instead`. So many, if there are fewer.
CellsPointer WithoutBroken(vtkCellArray* cells, vtkIdType first, const Ids& broken,
  vtkIdType number, const Ids& instead = {})
{
  const SkdRawCells raw(cells);
  auto repaired = CellsPointer::New();
  repaired->AllocateExact(number, raw.NumberOfIds());
  Ids copy;
  for (vtkIdType cell = 0; cell < number; ++cell)
  {
    copy = instead;
    const bool isBroken = std::binary_search(broken.begin(), broken.end(), first + cell);
    if (!isBroken && cell < raw.NumberOfCells())
    {
      raw.VisitCell(cell, [&](const auto* ids, vtkIdType size) { copy.assign(ids, ids + size); });
    }
    repaired->InsertNextCell(static_cast<vtkIdType>(copy.size()), copy.data());
  }
  return repaired;
}

/// Marks cells as hidden, so that nothing searches them.
void Blank(vtkDataSet* mesh, const Ids& cells)
{
  const vtkIdType number = mesh->GetNumberOfCells();
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfValues(number);
  ghosts->FillValue(0);
  if (vtkUnsignedCharArray* old = mesh->GetCellGhostArray())
  {
    ghosts->DeepCopy(old);
  }
  for (const vtkIdType cell : cells)
  {
    ghosts->SetValue(cell, ghosts->GetValue(cell) | vtkDataSetAttributes::HIDDENCELL);
  }
  mesh->GetCellData()->AddArray(ghosts);
}

/// Whether there are cells with so few points that VTK 9.1 cannot fetch any.
bool HasTooSmall(vtkPolyData* mesh)
{
  vtkCellArray* const arrays[4] = { mesh->GetVerts(), mesh->GetLines(), mesh->GetPolys(),
    mesh->GetStrips() };
  bool isOneSmall = false;
  for (int kind = 0; kind < 4; ++kind)
  {
    SkdForEachCell(arrays[kind],
      [&isOneSmall, least = SkdLeastSize(kind)](vtkIdType, const auto*, std::size_t size)
      { isOneSmall |= size < least; });
  }
  return isOneSmall;
}

/// To broken cells, in order, those with so few points that VTK 9.1 cannot fetch any.
void AddTooSmall(vtkPolyData* mesh, Ids& cells)
{
  vtkCellArray* const arrays[4] = { mesh->GetVerts(), mesh->GetLines(), mesh->GetPolys(),
    mesh->GetStrips() };
  Ids tooSmall;
  vtkIdType id = 0;
  for (int kind = 0; kind < 4; ++kind)
  {
    const SkdRawCells raw(arrays[kind]);
    const vtkIdType number = arrays[kind]->GetNumberOfCells();
    for (vtkIdType cell = 0; cell < number; ++cell, ++id)
    {
      std::size_t size = 0;
      if (cell < raw.NumberOfCells() && !std::binary_search(cells.begin(), cells.end(), id))
      {
        raw.VisitCell(cell, [&](const auto*, vtkIdType count) { size = count; });
      }
      if (size < SkdLeastSize(kind))
      {
        tooSmall.push_back(id);
      }
    }
  }
  cells = std::move(tooSmall);
}

// Broken cells become empty or, for VTK 9.1, hidden ones of the first point.
vtkSmartPointer<vtkDataSet> Repair(vtkPolyData* mesh, const Ids& broken)
{
  auto repaired = vtkSmartPointer<vtkPolyData>::New();
  if (!VTK_SKD_BUILDS_ALL_CELLS && mesh->GetNumberOfPoints() == 0)
  {
    return repaired;
  }
  repaired->vtkPointSet::ShallowCopy(mesh); // points and data, no cells
  vtkCellArray* const arrays[4] = { mesh->GetVerts(), mesh->GetLines(), mesh->GetPolys(),
    mesh->GetStrips() };
  CellsPointer cells[4];
  vtkIdType first = 0;
  for (int kind = 0; kind < 4; ++kind)
  {
    const vtkIdType number = arrays[kind]->GetNumberOfCells();
    const auto next = std::lower_bound(broken.begin(), broken.end(), first);
    const bool hasBroken = next != broken.end() && *next < first + number;
    const Ids instead(VTK_SKD_BUILDS_ALL_CELLS ? 0 : SkdLeastSize(kind), 0);
    cells[kind] = hasBroken ? WithoutBroken(arrays[kind], first, broken, number, instead)
                            : CellsPointer(arrays[kind]);
    first += number;
  }
  repaired->SetVerts(cells[0]);
  repaired->SetLines(cells[1]);
  repaired->SetPolys(cells[2]);
  repaired->SetStrips(cells[3]);
  if (!VTK_SKD_BUILDS_ALL_CELLS)
  {
    Blank(repaired, broken);
  }
  return repaired;
}

/// Copies the faces of another grid's valid polyhedra, and these cells.
void SetCells(vtkUnstructuredGrid* from, const Ids& broken, vtkUnsignedCharArray* types,
  vtkCellArray* cells, vtkUnstructuredGrid* to)
{
  const vtkIdType number = cells->GetNumberOfCells();
#if VTK_SKD_FACES_ARE_CELLS
  vtkCellArray* faces = from->GetPolyhedronFaces();
  vtkCellArray* facesOfCells = from->GetPolyhedronFaceLocations();
  if (faces && facesOfCells)
  {
    to->SetPolyhedralCells(types, cells, WithoutBroken(facesOfCells, 0, broken, number), faces);
    return;
  }
#else
  vtkIdTypeArray* faces = from->GetFaces();
  vtkIdTypeArray* locations = from->GetFaceLocations();
  if (faces && locations)
  {
    vtkNew<vtkIdTypeArray> repaired;
    repaired->SetNumberOfValues(number);
    for (vtkIdType cell = 0; cell < number; ++cell)
    {
      repaired->SetValue(
        cell, cell < locations->GetNumberOfValues() ? locations->GetValue(cell) : -1);
    }
    for (const vtkIdType cell : broken)
    {
      repaired->SetValue(cell, -1);
    }
    to->SetCells(types, cells, repaired, faces);
    return;
  }
#endif
  to->SetCells(types, cells);
}

vtkSmartPointer<vtkDataSet> Repair(vtkUnstructuredGrid* grid, const Ids& broken)
{
  auto repaired = vtkSmartPointer<vtkUnstructuredGrid>::New();
  repaired->vtkPointSet::ShallowCopy(grid); // points and data, no cells
  const vtkIdType number = grid->GetNumberOfCells();
  vtkNew<vtkUnsignedCharArray> types;
  types->SetNumberOfValues(number);
  for (vtkIdType cell = 0; cell < number; ++cell)
  {
    const bool isBroken = std::binary_search(broken.begin(), broken.end(), cell);
    types->SetValue(
      cell, static_cast<unsigned char>(isBroken ? VTK_EMPTY_CELL : grid->GetCellType(cell)));
  }
  SetCells(grid, broken, types, WithoutBroken(grid->GetCells(), 0, broken, number), repaired);
  return repaired;
}

// Its cells all have eight points: broken ones are blanked.
vtkSmartPointer<vtkDataSet> Repair(vtkExplicitStructuredGrid* grid, const Ids& broken)
{
  auto repaired = vtkSmartPointer<vtkExplicitStructuredGrid>::New();
  if (grid->GetNumberOfPoints() == 0)
  {
    return repaired;
  }
  const vtkIdType number = grid->GetNumberOfCells();
  repaired->vtkPointSet::ShallowCopy(grid);
  repaired->SetExtent(grid->GetExtent());
  repaired->SetCells(WithoutBroken(grid->GetCells(), 0, broken, number, Ids(8, 0)));
  Blank(repaired, broken);
  return repaired;
}

/// With an empty list of points if there are cells, but none: VTK reads cells through it, even
/// those without points.
vtkSmartPointer<vtkDataSet> WithPoints(vtkDataSet* data)
{
  auto* set = vtkPointSet::SafeDownCast(data);
  if (!set || set->GetPoints() || set->GetNumberOfCells() == 0)
  {
    return data;
  }
  const auto copy = vtkSmartPointer<vtkPointSet>::Take(set->NewInstance());
  copy->ShallowCopy(set);
  copy->SetPoints(vtkNew<vtkPoints>());
  return copy;
}
}

//------------------------------------------------------------------------------
SkdRepairedMesh SkdRepair(vtkDataSet* given)
{
  const vtkSmartPointer<vtkDataSet> data = WithPoints(given);
  SkdBrokenCells broken = SkdFindBrokenCells(data);
  const std::string fault = broken.Faults == 0 ? std::string() : broken.Tell(data);
  auto* mesh = vtkPolyData::SafeDownCast(data);
  if (mesh && !VTK_SKD_BUILDS_ALL_CELLS && (!broken.Ids.empty() || HasTooSmall(mesh)))
  {
    AddTooSmall(mesh, broken.Ids);
  }
  if (broken.Ids.empty())
  {
    return { data, {} };
  }
  if (mesh)
  {
    return { Repair(mesh, broken.Ids), fault };
  }
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    return { Repair(grid, broken.Ids), fault };
  }
  return { Repair(vtkExplicitStructuredGrid::SafeDownCast(data), broken.Ids), fault };
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataSet> SkdFetchable(vtkDataSet* given)
{
  return VTK_SKD_BUILDS_ALL_CELLS ? vtkSmartPointer<vtkDataSet>(given) : SkdRepair(given).Mesh;
}
}
