// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdPieceArrays_h
#define SkdPieceArrays_h

#include "vtkDataSet.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"

#include <vector>

namespace skdtree
{
/// Which tuple of a joined array each tuple of a piece becomes.
struct SkdPieceTuples
{
  std::vector<vtkIdType> From;
  std::vector<vtkIdType> To;

  void Add(vtkIdType from, vtkIdType to)
  {
    this->From.push_back(from);
    this->To.push_back(to);
  }
};

using SkdPieces = std::vector<vtkSmartPointer<vtkDataSet>>;

/// Joins the arrays of the pieces' points or cells (vtkDataObject's type), with their attributes.
/// Marks of duplicates are removed from ghost arrays: joined, each counts once. O(tuples).
void SkdJoinArrays(const SkdPieces& pieces, const std::vector<SkdPieceTuples>& tuples, int type,
  vtkIdType number, vtkDataSetAttributes* into);

/// Joins the points' coordinates, in double precision if any piece's are.
vtkSmartPointer<vtkPoints> SkdJoinPoints(
  const SkdPieces& pieces, const std::vector<SkdPieceTuples>& tuples, vtkIdType number);

/// Whether each of a piece's points or cells is marked as a duplicate; empty if none is.
std::vector<unsigned char> SkdDuplicatesOf(vtkDataSet* piece, int type);

/// The same, also of points that are in duplicate cells alone. Sources do not mark all of these,
/// and data that come of a point's neighbours, as normals do, are not complete there: another piece
/// has them. So are points that are hidden there, but may be shown in another piece. O(n).
std::vector<unsigned char> SkdIncompleteOf(vtkDataSet* piece, int type);

/// Whether any point or cell of a piece is marked as a duplicate.
bool SkdHasDuplicates(vtkDataSet* piece);

/// Whether there are points that are of no cell.
bool SkdHasFreePoints(vtkDataSet* mesh);
}

#endif
