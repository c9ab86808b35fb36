// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdLineProbe.h
 * @brief Through which cells of a Source lines run, from where to where.
 */

#ifndef SkdLineProbe_h
#define SkdLineProbe_h

#include "Core/Geometry/Vector.h"
#include "Pipeline/SkdLoop.h"
#include "Probe/SkdCellFinder.h"

#include <set>
#include <string>

class vtkPolyData;
class vtkTable;

/// A straight piece of an input's line.
struct SkdLinePiece
{
  int Input; // index in the list of input blocks
  vtkIdType Line;
  skd::Vector3 From;
  skd::Vector3 To;
  double Start; // length of the line up to From
};

/// A stretch of a line within one cell.
struct SkdStretch
{
  std::size_t Piece;
  skd::Vector3 From;
  skd::Vector3 To;
  double Entry; // lengths along the line
  double Exit;
  int Block;
  vtkIdType CellId;
};

/// The pieces of all cells of type VTK_LINE and VTK_POLY_LINE that are no ghosts, those of no
/// length and with points that are not finite left out.
std::vector<SkdLinePiece> SkdPiecesOf(const std::vector<SkdBlock>& inputs);

/// The stretches of all pieces, in the order of the lines. Each point of a line that is in the
/// Source belongs to one stretch: of the lowest (block, cell) that holds it. A surface holds what
/// is within the rules' tolerance of it, a volume only what is in it. In parallel.
std::vector<SkdStretch> SkdCutLines(const std::vector<SkdLinePiece>& pieces,
  const SkdCellFinderSource& source, const SkdCellFinderRules& rules, SkdLoop& loop);

/// What the lines' outputs are made from.
struct SkdLineOutput
{
  const std::vector<SkdBlock>& Inputs;
  const SkdCellFinderSource& Source;
  const std::vector<SkdLinePiece>& Pieces;
  const std::vector<SkdStretch>& Stretches;
  bool IsInputComposite;
  bool IsSourceComposite;
};

/// A line a stretch, with points of its own at its ends: the Source's point data there, as its cell
/// interpolates them, and its cell data.
void SkdFillStretches(
  const SkdLineOutput& output, std::set<std::string>& refused, vtkPolyData* lines);

/// A row for each input line that has a length: its length, that within the Source, and the
/// integral of each array of numbers along it, by two Gauss points a stretch.
void SkdFillIntegrals(const SkdLineOutput& output, vtkTable* table);

#endif
