// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdPieceRuns.h
 * @brief Boxes within cells of many pieces: without them, each query near a polyline of thousands
 * of points, one box in the tree, would test all of its pieces.
 */

#ifndef SkdPieceRuns_h
#define SkdPieceRuns_h

#include "Cells/Kernels/SkdCellAnswers.h"
#include "Cells/Search/SkdCellStore.h"

#include <cstdint>
#include <vector>

namespace skdtree
{
/// For strips, polylines and polyvertices, whose pieces are consecutive: a box for each run of 16
/// pieces, one for each 16 of these, and so on. 3 bytes a piece. Immutable.
class SkdPieceRuns
{
public:
  SkdPieceRuns() = default;

  /// `rounding` is the maximum error of coordinates of points in cells. O(pieces).
  SkdPieceRuns(const SkdCellStore& store, double rounding);

  /// Whether the cell has runs: if it has many pieces.
  bool Has(std::uint32_t cell) const { return this->Find(cell) != nullptr; }

  /// The result of SkdPolyKernels::Closest() for a cell that has runs, to the last bit, for pieces
  /// within limit2. O(log pieces) typical.
  SkdCellPoint Closest(
    const SkdCellStore& store, std::uint32_t cell, const skd::Vector3& x, double limit2) const;

  std::size_t MemorySize() const;

private:
  static constexpr std::uint32_t Width = 16; // even: strips turn with every piece

  /// The indices of a cell's boxes: its runs, then level by level boxes of 16 of those below.
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
}

#endif
