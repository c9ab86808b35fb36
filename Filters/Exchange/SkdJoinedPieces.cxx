// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Exchange/SkdJoinedPieces.h"

#include "Cells/Read/SkdCellReader.h"
#include "Exchange/SkdJoinedGrids.h"
#include "Exchange/SkdMeshAssembly.h"
#include "Exchange/SkdPiecePoints.h"
#include "Exchange/SkdRepeatedCells.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace skdtree
{
namespace
{
/// The cells of pieces with their joined points.
class CellJoin
{
public:
  explicit CellJoin(const SkdPieces& pieces);

  /// In the order of ids of the joined mesh.
  const std::vector<SkdPieceCell>& GetCells() const { return this->Cells; }

  const SkdPiecePoints& GetPoints() const { return this->Points; }

  const SkdRepeatedId& GetRepeatedId() const { return this->Repeated; }

  /// Of a cell of a vtkPolyData.
  int KindOf(const SkdPieceCell& cell) const
  {
    return this->Kinds[static_cast<std::size_t>(cell.Piece)].Of(cell.CellId);
  }

private:
  int TypeOf(const SkdPieceCell& cell) const
  {
    return this->Readers[static_cast<std::size_t>(cell.Piece)].TypeOf(cell.CellId);
  }
  vtkIdType GlobalIdOf(const SkdPieceCell& cell) const
  {
    vtkDataSet* piece = this->Pieces[static_cast<std::size_t>(cell.Piece)];
    return static_cast<vtkIdType>(piece->GetCellData()->GetGlobalIds()->GetTuple1(cell.CellId));
  }
  void ReadPoints(const SkdPieceCell& cell, vtkIdList* ids) const;

  template <class Visit>
  void VisitOwnCells(int piece, const Visit& visit) const;
  void AddPointsUsedIn(int piece);
  void AddCellsOf(int piece);
  bool IsOfEarlier(const SkdPieceCell& cell, vtkIdList* ids);
  void SortByGlobalIds();
  void SortByKinds();
  void FindRepeatedId();

  SkdPieces Pieces;
  SkdPiecePoints Points;
  std::vector<SkdCellReader> Readers;
  std::vector<SkdKinds> Kinds;
  std::vector<SkdPieceCell> Cells;
  bool HaveGlobalIds;
  vtkNew<vtkIdList> Own;        // of a cell's points in its piece
  SkdRepeatedCells SharedCells; // by points and type or global id
  SkdRepeatedId Repeated;
};

CellJoin::CellJoin(const SkdPieces& pieces)
  : Pieces(pieces)
  , Points(this->Pieces)
{
  for (vtkDataSet* piece : this->Pieces)
  {
    this->Readers.emplace_back(piece);
    this->Kinds.emplace_back(vtkPolyData::SafeDownCast(piece));
  }
  this->HaveGlobalIds = std::all_of(this->Pieces.begin(), this->Pieces.end(),
    [](vtkDataSet* piece)
    { return piece->GetNumberOfCells() == 0 || piece->GetCellData()->GetGlobalIds(); });
  for (std::size_t piece = 0; piece < this->Pieces.size(); ++piece)
  {
    this->AddPointsUsedIn(static_cast<int>(piece));
  }
  for (std::size_t piece = 0; piece < this->Pieces.size(); ++piece)
  {
    this->AddCellsOf(static_cast<int>(piece));
  }
  this->SortByGlobalIds();
  this->SortByKinds();
  this->Repeated = this->Points.GetRepeatedId();
  if (this->HaveGlobalIds && !this->Repeated.IsThere)
  {
    this->FindRepeatedId();
  }
}

template <class Visit>
void CellJoin::VisitOwnCells(int piece, const Visit& visit) const
{
  vtkDataSet* mesh = this->Pieces[static_cast<std::size_t>(piece)];
  const std::vector<unsigned char> ghosts = SkdDuplicatesOf(mesh, vtkDataObject::CELL);
  for (vtkIdType id = 0; id < mesh->GetNumberOfCells(); ++id)
  {
    if (ghosts.empty() || !ghosts[static_cast<std::size_t>(id)])
    {
      visit(id);
    }
  }
}

void CellJoin::AddPointsUsedIn(int piece)
{
  vtkNew<vtkIdList> ids;
  this->VisitOwnCells(piece,
    [&](vtkIdType id)
    {
      this->Readers[static_cast<std::size_t>(piece)].VisitPoints(id, ids,
        [&](const auto* points, std::size_t size)
        {
          std::for_each(points, points + size,
            [&](auto point) { this->Points.AddUsed(piece, static_cast<vtkIdType>(point)); });
        });
    });
}

// Cells whose points other pieces have, too, may be there as well. Which points these are is known
// when all are added.
void CellJoin::AddCellsOf(int piece)
{
  vtkNew<vtkIdList> ids;
  this->VisitOwnCells(piece,
    [&](vtkIdType id)
    {
      const SkdPieceCell cell{ piece, id };
      this->ReadPoints(cell, ids);
      if (!this->IsOfEarlier(cell, ids))
      {
        this->Cells.push_back(cell);
      }
    });
}

bool CellJoin::IsOfEarlier(const SkdPieceCell& cell, vtkIdList* ids)
{
  // Of points that coincide a piece may have others than another one, but not other coordinates.
  std::transform(ids->begin(), ids->end(), ids->begin(),
    [this](vtkIdType id) { return this->Points.FirstLike(id); });
  const bool mayBe = std::all_of(
    ids->begin(), ids->end(), [this](vtkIdType id) { return this->Points.IsShared(id); });
  if (!mayBe)
  {
    return false;
  }
  return this->SharedCells.IsOfEarlier(cell.Piece,
    this->HaveGlobalIds ? SkdRepeatedCells::KeyById(this->GlobalIdOf(cell), ids->begin(),
                            static_cast<std::size_t>(ids->GetNumberOfIds()))
                        : SkdRepeatedCells::KeyByPoints(this->TypeOf(cell), ids->begin(),
                            static_cast<std::size_t>(ids->GetNumberOfIds())));
}

void CellJoin::ReadPoints(const SkdPieceCell& cell, vtkIdList* ids) const
{
  this->Readers[static_cast<std::size_t>(cell.Piece)].VisitPoints(cell.CellId, this->Own,
    [&](const auto* points, std::size_t size)
    {
      ids->SetNumberOfIds(static_cast<vtkIdType>(size));
      std::transform(points, points + size, ids->begin(),
        [&](auto point) { return this->Points.IdOf(cell.Piece, static_cast<vtkIdType>(point)); });
    });
}

//------------------------------------------------------------------------------
bool AreSurfaces(const SkdPieces& pieces)
{
  return std::all_of(pieces.begin(), pieces.end(),
    [](vtkDataSet* piece) { return vtkPolyData::SafeDownCast(piece) != nullptr; });
}

// So that their order, which decides ties, does not depend on the partition.
void CellJoin::SortByGlobalIds()
{
  if (this->HaveGlobalIds)
  {
    std::stable_sort(this->Cells.begin(), this->Cells.end(),
      [this](const SkdPieceCell& a, const SkdPieceCell& b)
      { return this->GlobalIdOf(a) < this->GlobalIdOf(b); });
  }
}

// The ids of a vtkPolyData's cells are by kind.
void CellJoin::SortByKinds()
{
  if (!AreSurfaces(this->Pieces))
  {
    return;
  }
  std::stable_sort(this->Cells.begin(), this->Cells.end(),
    [&](const SkdPieceCell& a, const SkdPieceCell& b)
    { return this->KindOf(a) < this->KindOf(b); });
}

// Of cells in the order of their ids.
void CellJoin::FindRepeatedId()
{
  const auto found = std::adjacent_find(this->Cells.begin(), this->Cells.end(),
    [this](const SkdPieceCell& a, const SkdPieceCell& b)
    { return this->GlobalIdOf(a) == this->GlobalIdOf(b); });
  if (found != this->Cells.end())
  {
    const SkdPieceCell& next = *(found + 1);
    this->Repeated = { true, false, this->GlobalIdOf(*found),
      { { { found->Piece, found->CellId }, { next.Piece, next.CellId } } } };
  }
}

//------------------------------------------------------------------------------
SkdJoinedPieces JoinAnyCells(const SkdPieces& pieces)
{
  const CellJoin join(pieces);
  const std::vector<SkdPieceTuples> tuples = join.GetPoints().GetTuples();
  const SkdMeshParts parts{ pieces, join.GetCells(), join.GetPoints().GetIds(), tuples,
    join.GetPoints().GetNumber() };
  vtkSmartPointer<vtkDataSet> mesh;
  if (AreSurfaces(pieces))
  {
    mesh = SkdAssembleSurface(parts, [&](const SkdPieceCell& cell) { return join.KindOf(cell); });
  }
  else
  {
    mesh = SkdAssembleGrid(parts);
  }
  return { mesh, join.GetCells(), join.GetRepeatedId() };
}

SkdJoinedPieces AsOne(vtkDataSet* mesh)
{
  SkdJoinedPieces joined{ mesh, {} };
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    joined.Origins.push_back({ 0, cell });
  }
  return joined;
}

/// Of pieces that are not empty.
SkdJoinedPieces Join(const SkdPieces& pieces)
{
  if (pieces.size() == 1 && !SkdHasDuplicates(pieces.front()))
  {
    return AsOne(pieces.front());
  }
  SkdJoinedPieces joined;
  if (!SkdJoinGrids(pieces, joined))
  {
    joined = JoinAnyCells(pieces);
  }
  joined.Mesh->SetFieldData(pieces.front()->GetFieldData());
  return joined;
}
}

// Empty pieces may be of another type than the others, and lack their arrays.
SkdJoinedPieces SkdJoinPieces(const std::vector<vtkSmartPointer<vtkDataSet>>& pieces)
{
  SkdPieces full;
  std::vector<int> numbers;
  for (std::size_t piece = 0; piece < pieces.size(); ++piece)
  {
    if (pieces[piece]->GetNumberOfPoints() > 0 || pieces[piece]->GetNumberOfCells() > 0)
    {
      full.push_back(pieces[piece]);
      numbers.push_back(static_cast<int>(piece));
    }
  }
  if (full.empty())
  {
    return AsOne(pieces.front());
  }
  SkdJoinedPieces joined = Join(full);
  for (SkdPieceCell& origin : joined.Origins)
  {
    origin.Piece = numbers[static_cast<std::size_t>(origin.Piece)];
  }
  for (SkdRepeatedId::Owner& owner : joined.Repeated.Owners)
  {
    owner.Process = numbers[static_cast<std::size_t>(owner.Process)];
  }
  return joined;
}
}
