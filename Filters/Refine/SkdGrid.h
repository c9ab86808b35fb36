// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdGrid.h
 * @brief An adaptive grid: its cells, where they are, and what is known of each.
 */

#ifndef SkdGrid_h
#define SkdGrid_h

#include "Core/Grid/Forest.h"

#include <cstdint>
#include <utility>
#include <vector>

struct SkdGrid
{
  /// What is known of the cells of one level, a slot a cell.
  struct Level
  {
    std::vector<unsigned char> Cut;       ///< a part meets the cell
    std::vector<std::int32_t> Part;       ///< the first part that does, or -1
    std::vector<std::int32_t> Candidates; ///< of leaves: the parts' cells that meet it, else -1

    void Resize(std::size_t cells)
    {
      this->Cut.resize(cells, 0);
      this->Part.resize(cells, -1);
      this->Candidates.resize(cells, -1);
    }
  };

  explicit SkdGrid(const skd::Lattice& lattice)
    : Lattice(lattice)
    , Forest({ lattice.NumberOfBaseCells(0), lattice.NumberOfBaseCells(1),
               lattice.NumberOfBaseCells(2) },
        lattice.GetBranch())
  {
  }

  skd::Box3 BoxOf(int level, std::uint32_t cell) const
  {
    return this->Lattice.BoxOf(level, this->Forest.PlaceOf(level, cell));
  }

  skd::Lattice Lattice;
  skd::Forest Forest;
  std::vector<Level> Levels;

  ///@{
  /// Whether the cell limit stopped the refinement; then the level whose cells could not all be
  /// refined that should have been, and how many cells there would have been.
  bool IsStopped = false;
  int StoppedAtLevel = -1;
  std::uint64_t CellsWanted = 0;
  ///@}
};

/// A cell of a grid.
struct SkdGridCell
{
  int Level;
  std::uint32_t Index;
};

#endif
