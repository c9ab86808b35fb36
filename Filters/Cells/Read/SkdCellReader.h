// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdCellReader_h
#define SkdCellReader_h

#include "Cells/Read/SkdStoredCells.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cstddef>
#include <vector>

class vtkCellArray;
class vtkGenericCell;

namespace skdtree
{
/// The fewest points of a cell in an array of a vtkPolyData (0: verts, 1: lines, 2: polys, 3:
/// strips): if one has fewer, VTK 9.1 cannot fetch any cell of the mesh.
constexpr std::size_t SkdLeastSize(int kind)
{
  constexpr std::size_t ofPolygons = 3;
  return kind < 2 ? static_cast<std::size_t>(kind) + 1 : ofPolygons;
}

/// The type and the point ids of the cells of a data set: of vtkPolyData and vtkUnstructuredGrid
/// read where they are stored, in 32 or 64 bit, of others as vtkDataSet gives them. Immutable;
/// thread-safe if each thread has its own list. The data set must outlive it.
class SkdCellReader
{
public:
  explicit SkdCellReader(vtkDataSet* data);

  int TypeOf(vtkIdType cellId) const
  {
    return this->Types  ? this->Types[cellId]
      : !this->HasTypes ? this->TypeBySize(cellId)
      : this->Surface   ? this->Surface->vtkPolyData::GetCellType(cellId) // not virtual: inline
                        : this->Data->GetCellType(cellId);
  }

  /// Calls visit(ids, size), ids of whatever type they are stored in.
  template <class Visit>
  void VisitPoints(vtkIdType cellId, vtkIdList* list, const Visit& visit) const
  {
    this->VisitCells(cellId, cellId + 1, list,
      [&visit](vtkIdType, const auto* ids, std::size_t size) { visit(ids, size); });
  }

  /// The same of the cells begin .. end - 1: visit(cell id, ids, size).
  template <class Visit>
  void VisitCells(vtkIdType begin, vtkIdType end, vtkIdList* list, const Visit& visit) const
  {
    while (begin < end)
    {
      const Run* run = this->RunOf(begin);
      const vtkIdType last = run ? std::min(end, run->Last) : end;
      if (run)
      {
        VisitStored(*run, begin, last, visit);
      }
      else
      {
        this->VisitOthers(begin, last, list, visit);
      }
      begin = last;
    }
  }

private:
  /// The cells of one vtkCellArray.
  struct Run
  {
    vtkIdType First;
    vtkIdType Last;
    SkdStoredCells Cells;
    int Kind; // of vtkPolyData: vertices, lines, polygons, strips
  };

  template <class Visit>
  static void VisitStored(const Run& run, vtkIdType begin, vtkIdType end, const Visit& visit)
  {
    run.Cells.VisitEach(begin - run.First, end - run.First,
      [&](vtkIdType cell, const auto* ids, std::size_t size)
      { visit(run.First + cell, ids, size); });
  }
  template <class Visit>
  void VisitOthers(vtkIdType begin, vtkIdType end, vtkIdList* list, const Visit& visit) const
  {
    for (vtkIdType id = begin; id < end; ++id)
    {
      this->Data->GetCellPoints(id, list);
      visit(id, list->GetPointer(0), static_cast<std::size_t>(list->GetNumberOfIds()));
    }
  }

  const Run* RunOf(vtkIdType cellId) const
  {
    for (const Run& run : this->Runs)
    {
      if (cellId < run.Last)
      {
        return &run;
      }
    }
    return nullptr;
  }

  void ReadTypes(vtkDataArray* types);
  void AddRunsOf(vtkPolyData* mesh);
  void AddRun(vtkCellArray* cells, int kind);
  bool HasTooSmallCells() const;
  int TypeBySize(vtkIdType cellId) const;

  vtkDataSet* Data;
  vtkPolyData* Surface;                           // the data set, if it is one
  const unsigned char* Types = nullptr;           // of a vtkUnstructuredGrid
  vtkSmartPointer<vtkUnsignedCharArray> OwnTypes; // of one that stores them otherwise
  bool HasTypes = true;
  std::vector<Run> Runs; // of all cells, or of none
};

/// vtkDataSet::GetCell, also of the cells of vtkPolyData that VTK 9.1 cannot build. Thread-safe
/// once a reader of the data set was made.
void SkdLoadCell(vtkDataSet* data, vtkIdType cellId, vtkGenericCell* cell);

/// Whether GetCell of this data set takes nothing but type, point ids and points from it, but of
/// polyhedra and curved cells: of vtkPolyData and vtkUnstructuredGrid. A class derived from them
/// may have a GetCell of its own.
bool SkdHasPlainCells(vtkDataSet* data);
}

#endif
