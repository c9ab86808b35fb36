// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdPieceRuns.h
 * @brief Boxes within cells of many pieces: a polyline of thousands of points is one box to the
 * tree, and would be looked through from end to end by each query that comes near.
 */

#ifndef SkdPieceRuns_h
#define SkdPieceRuns_h

#include "Cells/SkdCellStore.h"

#include <cstdint>
#include <vector>

/// Of strips, polylines and polyvertices, whose pieces come in a row: a box for each run of 16
/// pieces, one for each 16 of these, and so on to one that holds all. 3 bytes a piece. Constant
/// once made.
class SkdPieceRuns
{
public:
  SkdPieceRuns() = default;

  /// `rounding` is by how much coordinates of points in cells may be off. O(pieces).
  SkdPieceRuns(const SkdCellStore& store, double rounding);

  /// Whether the cell has runs: if it has many pieces.
  bool Has(std::uint32_t cell) const { return this->Find(cell) != nullptr; }

  /// What SkdPolyKernels::Closest() tells of a cell that has runs, to the last bit, of pieces not
  /// farther than limit2. O(log pieces) typical.
  SkdCellPoint Closest(
    const SkdCellStore& store, std::uint32_t cell, const skd::Vector3& x, double limit2) const;

  std::size_t MemorySize() const;

private:
  static constexpr std::uint32_t Width = 16; // even: strips turn with every piece

  /// Where the boxes of a cell are: its runs, then level after level what holds 16 of those below.
  struct Row
  {
    std::uint32_t Cell;
    std::uint32_t Pieces;
    std::vector<std::size_t> Levels; ///< the first box of each, and one beyond the last
  };
  class Search;

  const Row* Find(std::uint32_t cell) const;
  void Add(const SkdCellStore& store, std::uint32_t cell, std::uint32_t pieces, double rounding);

  std::vector<Row> Rows; // by ascending cell
  std::vector<skd::Box3> Boxes;
};

#endif
