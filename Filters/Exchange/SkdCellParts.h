// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdCellParts_h
#define SkdCellParts_h

#include "Exchange/SkdMeshAssembly.h"
#include "Exchange/SkdPieceNumbers.h"
#include "vtkIdTypeArray.h"

namespace skdtree
{
/// Some cells of a piece, with the points that they use, all arrays, and what SkdCellParts needs to
/// know of them; nullptr without cells. `isSurface`: the joined mesh is a vtkPolyData.
vtkSmartPointer<vtkDataSet> SkdTakeCells(vtkDataSet* piece, const std::vector<vtkIdType>& cells,
  const SkdPieceNumbers& numbers, bool isSurface);

/// Cells that came from several processes, put together. Points that several pieces have come with
/// the cells from each, but the joined mesh has the coordinates and data of one: where it did not
/// send them, it is asked.
class SkdCellParts
{
public:
  SkdCellParts(SkdTransport& transport, const SkdAllFacts& facts, const SkdPieces& examples);

  /// What SkdTakeCells made there, or nullptr.
  void Take(int from, vtkDataSet* cells);

  /// All processes must call it together.
  void AskForPoints(SkdTransport& transport, vtkDataSet* piece);

  /// There are pieces that are not empty.
  vtkSmartPointer<vtkDataSet> Assemble() const;

private:
  /// What came from a process.
  struct Part
  {
    vtkSmartPointer<vtkDataSet> Mesh;
    vtkSmartPointer<vtkIdTypeArray> Cells;  // joined ids and kinds
    vtkSmartPointer<vtkIdTypeArray> Points; // joined ids, processes and points there
  };

  /// A joined point in a list of pieces: where it is taken from.
  struct Found
  {
    vtkIdType Id;
    int Piece; // from GetNumber() of processes on: asked for
    vtkIdType Point;
  };

  /// A cell of those that came from the pieces that are not empty.
  struct Joined
  {
    vtkIdType Id;
    SkdPieceCell Cell;
  };

  void FindPoints();
  std::vector<vtkIdType> FindLocalIds(int process) const;
  std::vector<Joined> SortCells() const;
  int ProcessOf(const SkdPieceCell& cell) const
  {
    return this->Facts.GetFull()[static_cast<std::size_t>(cell.Piece)];
  }
  int KindOf(const SkdPieceCell& cell) const;

  const SkdAllFacts& Facts;
  const SkdPieces& Examples;
  std::vector<Part> Parts;   // by process
  SkdPieces Queries;         // by process, points
  std::vector<Found> Points; // by joined id, each once
  int Rank;
};
}

#endif
