// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdPiecePoints_h
#define SkdPiecePoints_h

#include "Exchange/SkdPieceArrays.h"
#include "Exchange/SkdPointJoin.h"
#include "Exchange/SkdRepeatedId.h"

#include <vector>

namespace skdtree
{
/// Which points of several pieces are one: see SkdJoinPieces.
class SkdPiecePoints
{
public:
  explicit SkdPiecePoints(const SkdPieces& pieces);

  vtkIdType GetNumber() const { return this->Join.GetNumber(); }

  /// The joined point that a point of a piece becomes; -1 for ghost points until they are added.
  vtkIdType IdOf(int piece, vtkIdType point) const
  {
    return this->Ids[static_cast<std::size_t>(piece)][static_cast<std::size_t>(point)];
  }

  /// The same of a point that a cell uses, which may be a ghost point.
  vtkIdType AddUsed(int piece, vtkIdType point)
  {
    const vtkIdType id = this->IdOf(piece, point);
    return id >= 0 ? id : this->Add(piece, point);
  }

  /// The first joined point that may be the same: at the same coordinates, or with its global id.
  vtkIdType FirstLike(vtkIdType id) const { return this->Join.FirstLike(id); }

  /// Whether several pieces have a joined point.
  bool IsShared(vtkIdType id) const { return this->Join.IsShared(id); }

  /// IdOf() of all, by piece and point.
  const std::vector<std::vector<vtkIdType>>& GetIds() const { return this->Ids; }

  /// Of which point each joined one has its coordinates and data: the first that is complete
  /// (SkdIncompleteOf).
  std::vector<SkdPieceTuples> GetTuples() const;

  /// One that different points have.
  const SkdRepeatedId& GetRepeatedId() const { return this->Repeated; }

private:
  struct Origin
  {
    int Piece;
    vtkIdType Point;
  };

  void FindKeys();
  void FindKeysByGlobalIds();
  void FindKeysByCoordinates();
  vtkIdType Add(int piece, vtkIdType point);
  bool IsIncomplete(const Origin& point) const;

  const SkdPieces& Pieces;
  std::vector<std::vector<vtkIdType>> Keys; // of each piece's points: equal where they may be one
  std::vector<std::vector<vtkIdType>> Ids;  // of each piece's points, joined
  SkdPointJoin Join;
  std::vector<Origin> Origins;                        // by joined point
  std::vector<std::vector<unsigned char>> Incomplete; // of each piece's points
  SkdRepeatedId Repeated;
};
}

#endif
