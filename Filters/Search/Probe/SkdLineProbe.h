// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdLineProbe.h
 * @brief Segments of lines within the cells of a Source.
 */

#ifndef SkdLineProbe_h
#define SkdLineProbe_h

#include "Core/Geometry/Vector.h"
#include "Pipeline/SkdLoop.h"
#include "Search/Probe/SkdCellFinder.h"

#include <set>
#include <string>

class vtkPolyData;
class vtkTable;

namespace skdtree
{
/// A straight piece of an input's line.
struct SkdLinePiece
{
  int Input; // index in the list of input blocks
  vtkIdType Line;
  skd::Vector3 From;
  skd::Vector3 To;
  double Start; // length of the line up to From
};

/// A segment of a line within one cell.
struct SkdLineInterval
{
  std::size_t Piece;
  skd::Vector3 From;
  skd::Vector3 To;
  double Entry; // lengths along the line
  double Exit;
  int Block;
  vtkIdType CellId;
};

/// The pieces of all cells of type VTK_LINE and VTK_POLY_LINE, without ghosts, pieces of zero
/// length, and pieces with points that are not finite.
std::vector<SkdLinePiece> SkdPiecesOf(const std::vector<SkdBlock>& inputs);

/// The segments of all pieces, in the order of the lines. Each point of a line in the Source
/// belongs to one segment: that of the lowest (block, cell) that contains it. A surface contains
/// points within the rules' tolerance, a volume only points in it. In parallel.
std::vector<SkdLineInterval> SkdCutLines(const std::vector<SkdLinePiece>& pieces,
  const SkdCellFinderSource& source, const SkdCellFinderRules& rules, SkdLoop& loop);

/// The input of the lines' outputs.
struct SkdLineOutput
{
  const std::vector<SkdBlock>& Inputs;
  const SkdCellFinderSource& Source;
  const std::vector<SkdLinePiece>& Pieces;
  const std::vector<SkdLineInterval>& Intervals;
  bool IsInputComposite;
  bool IsSourceComposite;
};

/// One line for each segment, with its own end points: the Source's point data there, interpolated
/// in its cell, and its cell data.
void SkdFillIntervals(
  const SkdLineOutput& output, std::set<std::string>& refused, vtkPolyData* lines);

/// A row for each input line of positive length: its length, the length within the Source, and the
/// integral of each numeric array along it, by two Gauss points a segment.
void SkdFillIntegrals(const SkdLineOutput& output, vtkTable* table);
}

#endif
