// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Exchange/SkdMeshAssembly.h"

#include "Cells/Read/SkdCellReader.h"
#include "Exchange/SkdRepeatedCells.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>

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

  /// The cells `first` to `last` of a piece: adds their points, and where those of each end.
  void AddCells(const SkdPieceCell& first, vtkIdType last, std::vector<vtkIdType>& offsets,
    std::vector<vtkIdType>& points) const
  {
    const std::vector<vtkIdType>& joined =
      this->Parts.PointIds[static_cast<std::size_t>(first.Piece)];
    this->Readers[static_cast<std::size_t>(first.Piece)].VisitCells(first.CellId, last + 1,
      this->Own,
      [&](vtkIdType, const auto* ids, std::size_t size)
      {
        for (std::size_t i = 0; i < size; ++i)
        {
          points.push_back(joined[static_cast<std::size_t>(ids[i])]);
        }
        offsets.push_back(static_cast<vtkIdType>(points.size()));
      });
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

/// The cells of one kind.
struct CellLists
{
  std::vector<vtkIdType> Offsets{ 0 };
  std::vector<vtkIdType> Points;

  vtkSmartPointer<vtkCellArray> Make() const
  {
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    cells->SetData(ArrayOf(this->Offsets), ArrayOf(this->Points));
    return cells;
  }

private:
  static vtkSmartPointer<vtkIdTypeArray> ArrayOf(const std::vector<vtkIdType>& values)
  {
    auto array = vtkSmartPointer<vtkIdTypeArray>::New();
    array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
    std::copy(values.begin(), values.end(), array->GetPointer(0));
    return array;
  }
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
  std::array<CellLists, SkdNumberOfKinds> kinds;
  std::size_t end = 0;
  for (std::size_t begin = 0; begin < parts.Cells.size(); begin = end)
  {
    const SkdPieceCell& first = parts.Cells[begin];
    const int kind = kindOf(first);
    const auto goesOn = [&](const SkdPieceCell& cell)
    {
      return cell.Piece == first.Piece &&
        cell.CellId - first.CellId == static_cast<vtkIdType>(end - begin) && kindOf(cell) == kind;
    };
    for (end = begin + 1; end < parts.Cells.size() && goesOn(parts.Cells[end]);)
    {
      ++end;
    }
    CellLists& lists = kinds[static_cast<std::size_t>(kind)];
    source.AddCells(first, parts.Cells[end - 1].CellId, lists.Offsets, lists.Points);
  }
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetVerts(kinds[0].Make());
  surface->SetLines(kinds[1].Make());
  surface->SetPolys(kinds[2].Make());
  surface->SetStrips(kinds[3].Make());
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
