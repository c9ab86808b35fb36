// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Exchange/SkdMeshAssembly.h"

#include "Cells/Read/SkdCellReader.h"
#include "Exchange/SkdRepeatedCells.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace skdtree
{
namespace
{
class CellSource
{
public:
  explicit CellSource(const SkdMeshParts& parts)
    : Parts(parts)
  {
    for (vtkDataSet* piece : parts.Pieces)
    {
      this->Readers.emplace_back(piece);
    }
  }

  int TypeOf(const SkdPieceCell& cell) const
  {
    return this->Readers[static_cast<std::size_t>(cell.Piece)].TypeOf(cell.CellId);
  }

  void ReadPoints(const SkdPieceCell& cell, vtkIdList* ids) const
  {
    this->Readers[static_cast<std::size_t>(cell.Piece)].VisitPoints(cell.CellId, this->Own,
      [&](const auto* points, std::size_t size)
      {
        ids->SetNumberOfIds(static_cast<vtkIdType>(size));
        std::transform(points, points + size, ids->begin(),
          [&](auto point) { return this->IdOf(cell, static_cast<vtkIdType>(point)); });
      });
  }

  // VTK's stream: the number of faces, then of each its size and points.
  void ReadFaces(const SkdPieceCell& cell, vtkIdList* stream) const
  {
    vtkDataSet* piece = this->Parts.Pieces[static_cast<std::size_t>(cell.Piece)];
    vtkUnstructuredGrid::SafeDownCast(piece)->GetFaceStream(cell.CellId, stream);
    for (vtkIdType at = 1; at < stream->GetNumberOfIds(); at += 1 + stream->GetId(at))
    {
      const auto first = stream->begin() + at + 1;
      std::transform(first, first + stream->GetId(at), first,
        [&](vtkIdType point) { return this->IdOf(cell, point); });
    }
  }

private:
  vtkIdType IdOf(const SkdPieceCell& cell, vtkIdType point) const
  {
    return this->Parts
      .PointIds[static_cast<std::size_t>(cell.Piece)][static_cast<std::size_t>(point)];
  }

  const SkdMeshParts& Parts;
  std::vector<SkdCellReader> Readers;
  vtkNew<vtkIdList> Own; // of a cell's points in its piece
};

/// Gives the mesh the points and all arrays.
void Finish(const SkdMeshParts& parts, vtkPointSet* mesh)
{
  std::vector<SkdPieceTuples> cells(parts.Pieces.size());
  for (std::size_t id = 0; id < parts.Cells.size(); ++id)
  {
    const SkdPieceCell& cell = parts.Cells[id];
    cells[static_cast<std::size_t>(cell.Piece)].Add(cell.CellId, static_cast<vtkIdType>(id));
  }
  mesh->SetPoints(SkdJoinPoints(parts.Pieces, parts.Points, parts.NumberOfPoints));
  SkdJoinArrays(
    parts.Pieces, parts.Points, vtkDataObject::POINT, parts.NumberOfPoints, mesh->GetPointData());
  SkdJoinArrays(parts.Pieces, cells, vtkDataObject::CELL,
    static_cast<vtkIdType>(parts.Cells.size()), mesh->GetCellData());
}
}

vtkSmartPointer<vtkPointSet> SkdAssembleSurface(
  const SkdMeshParts& parts, const std::function<int(const SkdPieceCell& cell)>& kindOf)
{
  const CellSource source(parts);
  vtkNew<vtkCellArray> kinds[SkdNumberOfKinds];
  vtkNew<vtkIdList> ids;
  for (const SkdPieceCell& cell : parts.Cells)
  {
    source.ReadPoints(cell, ids);
    kinds[kindOf(cell)]->InsertNextCell(ids);
  }
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetVerts(kinds[0]);
  surface->SetLines(kinds[1]);
  surface->SetPolys(kinds[2]);
  surface->SetStrips(kinds[3]);
  Finish(parts, surface);
  return surface;
}

vtkSmartPointer<vtkPointSet> SkdAssembleGrid(const SkdMeshParts& parts)
{
  const CellSource source(parts);
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->Allocate(static_cast<vtkIdType>(parts.Cells.size()));
  vtkNew<vtkIdList> ids;
  for (const SkdPieceCell& cell : parts.Cells)
  {
    const int type = source.TypeOf(cell);
    if (type == VTK_POLYHEDRON)
    {
      source.ReadFaces(cell, ids);
    }
    else
    {
      source.ReadPoints(cell, ids);
    }
    grid->InsertNextCell(type, ids);
  }
  Finish(parts, grid);
  return grid;
}
}
