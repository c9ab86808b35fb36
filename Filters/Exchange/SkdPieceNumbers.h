// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdPieceNumbers.h
 * @brief The ids that a piece's cells and points have in the mesh that all pieces are together,
 * without a process that has all of it.
 */

#ifndef SkdPieceNumbers_h
#define SkdPieceNumbers_h

#include "Exchange/SkdPieceFacts.h"
#include "Exchange/SkdRepeatedId.h"
#include "Exchange/SkdTransport.h"
#include "vtkDataSet.h"

#include <vector>

namespace skdtree
{
/// Where a point of the joined mesh is taken from, a process of -1: it is in no piece's cells.
struct SkdPointOrigin
{
  int Process;
  vtkIdType Point; ///< in that process's piece
};

/// Of this process's piece.
struct SkdPieceNumbers
{
  /// The joined id of each cell; -1: it is a duplicate, or another process's piece has it, too, and
  /// counts it.
  std::vector<vtkIdType> CellIds;

  /// The joined id of each point, whoever counts it; -1: a ghost that no counted cell uses.
  std::vector<vtkIdType> PointIds;

  /// The piece whose coordinates and data a point has in the joined mesh.
  std::vector<SkdPointOrigin> PointOrigins;

  ///@{
  /// Of the joined mesh.
  vtkIdType NumberOfCells = 0;
  vtkIdType NumberOfPoints = 0;
  ///@}

  /// One that different points or cells have, on all processes the same.
  SkdRepeatedId Repeated;
};

/// Numbers cells and points as SkdJoinPieces does. All processes must call it together. Points and
/// cells that may be in several pieces are told to processes that are chosen by their coordinates
/// or ids, which compare them: memory and bytes are O(n) for n points and cells of the piece, with
/// any partition, and much less where pieces have only their borders in common.
SkdPieceNumbers SkdNumberPiece(
  SkdTransport& transport, vtkDataSet* piece, const SkdAllFacts& facts);

/// The joined ids of the cells of a piece, -1 of those that do not count, as SkdFindCounted has
/// told. Cells alone are numbered.
std::vector<vtkIdType> SkdNumberCounted(SkdTransport& transport, vtkDataSet* piece,
  const SkdAllFacts& facts, const std::vector<unsigned char>& counted);

/// Whether each cell of the piece counts in it: has a joined id of SkdNumberPiece. Of points only
/// those are compared of which cells are that other pieces may have, too; nothing is numbered.
std::vector<unsigned char> SkdFindCounted(
  SkdTransport& transport, vtkDataSet* piece, const SkdAllFacts& facts);

/// Whether each point of the piece is the one that the joined mesh has its data from: one of those
/// that several pieces have is.
std::vector<unsigned char> SkdFindCountedPoints(
  SkdTransport& transport, vtkDataSet* piece, const SkdAllFacts& facts);

///@{
/// Parts of it.
/// Points and cells of one grid by their index in it.
void SkdNumberGrid(
  SkdTransport& transport, vtkDataSet* piece, const SkdAllFacts& facts, SkdPieceNumbers& numbers);

/// Points by their global ids or coordinates.
/// `likes` gets a number for each that is the same for points of all pieces at its coordinates, or
/// with its global id; -1 if no other piece has such.
void SkdNumberPoints(SkdTransport& transport, vtkDataSet* piece, const SkdAllFacts& facts,
  SkdPieceNumbers& numbers, std::vector<vtkIdType>& likes);

/// The same numbers alone, of points whose cells may be in other pieces, too.
void SkdFindLikePoints(SkdTransport& transport, vtkDataSet* piece, const SkdAllFacts& facts,
  std::vector<vtkIdType>& likes);

/// Whether each cell counts.
std::vector<unsigned char> SkdCountCells(SkdTransport& transport, vtkDataSet* piece,
  const SkdAllFacts& facts, const std::vector<vtkIdType>& likes);

/// The ids of those that count, by global ids or in order.
void SkdNumberCells(SkdTransport& transport, vtkDataSet* piece, const SkdAllFacts& facts,
  const std::vector<unsigned char>& counted, SkdPieceNumbers& numbers);

/// Cells by their points, which are numbered, or global ids.
void SkdNumberCells(SkdTransport& transport, vtkDataSet* piece, const SkdAllFacts& facts,
  const std::vector<vtkIdType>& likes, SkdPieceNumbers& numbers);

/// That of the first process that has found one.
SkdRepeatedId SkdFirstRepeatedId(SkdTransport& transport, const SkdRepeatedId& own);

/// The sum of the numbers of earlier processes, and of all.
struct SkdRunningSum
{
  vtkIdType Before = 0;
  vtkIdType All = 0;
};
std::vector<SkdRunningSum> SkdSumOver(
  SkdTransport& transport, const std::vector<vtkIdType>& numbers);

/// What is numbered kind by kind, and of each kind process by process.
struct SkdKindNumbers
{
  std::vector<vtkIdType> First; ///< by kind, of this process
  vtkIdType All = 0;            ///< of all kinds and processes
};
SkdKindNumbers SkdNumberKinds(SkdTransport& transport, const std::vector<vtkIdType>& counts);
///@}
}

#endif
