// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdGrid.h
 * @brief An adaptive grid: its cells, their geometry and their values.
 */

#ifndef SkdGrid_h
#define SkdGrid_h

#include "Core/Meshing/Grid/Forest.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace skdtree
{
/// A cell of a grid.
struct SkdGridCell
{
  int Level;
  std::uint32_t Index;
};

struct SkdGrid
{
  /// The values of the cells of one level.
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
    , LastOwn(this->Forest.NumberOfCells(0))
  {
  }

  skd::Box3 BoxOf(int level, std::uint32_t cell) const
  {
    return this->Lattice.BoxOf(level, this->Forest.LatticePointOf(level, cell));
  }

  /// @{ The range of base cells that each process outputs, with their descendants.
  void OwnPiece(int piece, int pieces)
  {
    const std::uint64_t n = this->Forest.NumberOfCells(0);
    this->Piece = piece;
    this->Pieces = pieces;
    this->FirstOwn = static_cast<std::uint32_t>(n * static_cast<std::uint64_t>(piece) / pieces);
    this->LastOwn =
      static_cast<std::uint32_t>(n * (static_cast<std::uint64_t>(piece) + 1) / pieces);
  }
  bool OwnsAll() const
  {
    return this->FirstOwn == 0 && this->LastOwn == this->Forest.NumberOfCells(0);
  }
  bool IsOwn(int level, std::uint32_t cell) const
  {
    for (; level > 0 && !this->OwnsAll(); --level)
    {
      cell = this->Forest.Parent(level, cell);
    }
    return this->OwnsAll() || (this->FirstOwn <= cell && cell < this->LastOwn);
  }
  ///@}

  /// Own ones, level by level.
  std::vector<SkdGridCell> Leaves() const
  {
    std::vector<SkdGridCell> leaves;
    leaves.reserve(this->Forest.NumberOfLeaves());
    for (int level = 0; level < this->Forest.NumberOfLevels(); ++level)
    {
      for (std::uint32_t cell = 0; cell < this->Forest.NumberOfCells(level); ++cell)
      {
        if (this->Forest.IsLeaf(level, cell) && this->IsOwn(level, cell))
        {
          leaves.push_back({ level, cell });
        }
      }
    }
    return leaves;
  }

  skd::Lattice Lattice;
  skd::Forest Forest;
  std::vector<Level> Levels;
  int Piece = 0;
  int Pieces = 1;
  std::uint32_t FirstOwn = 0;
  std::uint32_t LastOwn;

  /// The lowest level of cells that were not refined because they are about as small as the
  /// resolution of their coordinates; -1 if there is none.
  int ResolvedLevel = -1;

  /// @{ Whether the cell limit stopped the refinement; if so, the level whose cells were not all
  /// refined, and the number of cells that would have resulted.
  bool IsStopped = false;
  int StoppedAtLevel = -1;
  std::uint64_t CellsWanted = 0;
  ///@}
};
}

#endif
