// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdJoinedPieces.h
 * @brief One mesh from the pieces that several processes have of it.
 */

#ifndef SkdJoinedPieces_h
#define SkdJoinedPieces_h

#include "Exchange/SkdJoinedMesh.h"

namespace skdtree
{
/// Joins the pieces of a mesh. Cells with global ids are in their order; others, and points, keep
/// the order that they have, those of the first piece first. Each counts once:
/// - Ghost cells (duplicates, by the ghost array) are left out, another piece has them.
/// - Points of different pieces with the same global id, or without global ids the same
///   coordinates but for rounding (SkdMergeNearPoints), are one point. Points of the same piece are
///   not merged; if a piece has several that coincide, the first of each piece are one, the second
///   of each piece, and so on.
/// - Cells of different pieces with the same global id, or without global ids the same type and the
///   same points in the same order, are one cell, which a source that ignores the requested piece
///   has put into each of them.
///
/// Arrays that only some pieces have are kept as SkdArrayGather does. Pieces of a structured grid
/// whose extents fill a box become one grid of that type; others, and pieces of different types,
/// become an unstructured grid. O(n) for n points and cells. At least one piece.
SkdJoinedPieces SkdJoinPieces(const std::vector<vtkSmartPointer<vtkDataSet>>& pieces);
}

#endif
