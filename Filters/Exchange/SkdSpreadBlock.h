// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdSpreadBlock_h
#define SkdSpreadBlock_h

#include "Exchange/SkdCut.h"
#include "Exchange/SkdPieceArrays.h"
#include "Exchange/SkdPieceNumbers.h"
#include "Pipeline/SkdSearchRange.h"

#include <memory>

namespace skdtree
{
/// A mesh that lies in pieces. Each process gets some of its cells, as one mesh with the points,
/// arrays and field data that they have in the joined mesh (SkdJoinPieces), in its order, with
/// their ids there (SkdJoinedIds). It is of the type of the joined mesh, but for structured grids a
/// vtkUnstructuredGrid.
///
/// Each process also gets the cells that reach the bounds of the whole, so that what is relative to
/// the size of the mesh is the same everywhere.
///
/// All processes must call each function together.
class SkdSpreadBlock
{
public:
  /// `examples` have the arrays of each process's piece, with a tuple or none, and its field data;
  /// nullptr where a process has no piece.
  SkdSpreadBlock(SkdTransport& transport, vtkDataSet* piece, SkdPieces examples);

  /// The cells that are near what this process has told of itself by the cut, and by that of
  /// directions if there is one.
  vtkSmartPointer<vtkDataSet> Bring(SkdTransport& transport, const SkdCut& cut,
    const SkdCut* directions, const SkdSearchRange& range) const;

  /// The cells that count in this process's own piece.
  vtkSmartPointer<vtkDataSet> BringOwn(SkdTransport& transport) const;

  /// Cells by their joined ids: `wanted` has those to be taken from each process's piece. Ids that
  /// it does not count are ignored.
  vtkSmartPointer<vtkDataSet> BringThose(
    SkdTransport& transport, const SkdRowsByProcess<vtkIdType>& wanted) const;

  /// The same, and no others: without those that reach the bounds of the whole.
  vtkSmartPointer<vtkDataSet> BringOnly(
    SkdTransport& transport, const SkdRowsByProcess<vtkIdType>& wanted) const;

  /// The joined ids of the cells that this process counts, ascending.
  std::vector<vtkIdType> ListOwnIds() const;

  /// The cells of the joined mesh.
  vtkIdType GetNumberOfCells() const { return this->Numbers.NumberOfCells; }

  /// A global id that does not tell cells or points apart; on all processes the same.
  const SkdRepeatedId& GetRepeatedId() const { return this->Numbers.Repeated; }

  /// Whether the joined mesh is a structured grid.
  bool IsGrid() const { return this->Facts.FillGrid(); }

  /// The boxes of the cells of this process's piece; empty ones of those that do not count.
  const std::vector<skd::Box3>& GetBoxes() const { return this->Boxes; }

  /// The same of directions.
  std::vector<skd::Box3> FindDirections(bool inDegrees) const;

  /// What stands for a piece among the examples.
  static vtkSmartPointer<vtkDataSet> MakeExample(vtkDataSet* piece);

private:
  using Chosen = SkdRowsByProcess<vtkIdType>; // cells for each process, ascending

  void AddNear(const std::vector<skd::Box3>& boxes, const SkdCut& cut, int rank, double distance,
    double ofDiagonal, Chosen& chosen) const;
  void AddOwn(std::vector<vtkIdType>& cells) const;
  void AddExtremes(SkdTransport& transport, Chosen& chosen) const;
  Chosen FindThose(SkdTransport& transport, const SkdRowsByProcess<vtkIdType>& wanted) const;
  vtkSmartPointer<vtkDataSet> Send(SkdTransport& transport, Chosen chosen) const;
  vtkSmartPointer<vtkDataSet> SendOnly(SkdTransport& transport, const Chosen& chosen) const;

  vtkSmartPointer<vtkDataSet> Piece;
  SkdPieces Examples; // by process
  SkdAllFacts Facts;
  SkdPieceNumbers Numbers;
  std::vector<skd::Box3> Boxes; // of cells that count, else empty
};
}

#endif
