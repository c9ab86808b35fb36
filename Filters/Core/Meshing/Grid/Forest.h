// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Grid_Forest_h
#define skd_Grid_Forest_h

#include "Lattice.h"

#include <cassert>
#include <limits>

namespace skd
{

/// The cells of a grid of trees, level by level: those of the base grid, and the children of each
/// that was refined. Cells are numbered within their level; the children of one cell (its family)
/// follow each other, x fastest. What is added never renumbers what is there.
///
/// Memory: 8 bytes a cell and 32 a family. At most 2^32 - 2 cells a level.
class Forest
{
public:
  static constexpr std::uint32_t None = std::numeric_limits<std::uint32_t>::max();

  /// A cell; Level is -1 outside of the grid.
  struct Node
  {
    int Level;
    std::uint32_t Index;
  };

  Forest(const std::array<std::int64_t, 3>& baseCells, const std::array<int, 3>& branch)
    : BaseCells(baseCells)
    , Branch(branch)
    , Levels(1)
  {
    this->Levels[0].Children.assign(
      static_cast<std::size_t>(baseCells[0] * baseCells[1] * baseCells[2]), None);
  }

  int NumberOfLevels() const { return static_cast<int>(this->Levels.size()); }
  std::uint32_t NumberOfCells(int level) const
  {
    return level < this->NumberOfLevels()
      ? static_cast<std::uint32_t>(this->Levels[level].Children.size())
      : 0;
  }
  std::uint32_t FamilySize() const
  {
    return static_cast<std::uint32_t>(this->Branch[0] * this->Branch[1] * this->Branch[2]);
  }

  std::uint64_t NumberOfCells() const
  {
    std::uint64_t cells = 0;
    for (const Generation& level : this->Levels)
    {
      cells += level.Children.size();
    }
    return cells;
  }

  /// The cells that are not refined.
  std::uint64_t NumberOfLeaves() const
  {
    std::uint64_t leaves = this->NumberOfCells();
    for (const Generation& level : this->Levels)
    {
      leaves -= level.Parents.size();
    }
    return leaves;
  }

  bool IsLeaf(int level, std::uint32_t cell) const
  {
    return this->Levels[level].Children[cell] == None;
  }

  /// The children of a refined cell are this one and the following, of the next level.
  std::uint32_t FirstChild(int level, std::uint32_t cell) const
  {
    return this->Levels[level].Children[cell] * this->FamilySize();
  }

  /// Of a cell of level 1 or more.
  std::uint32_t Parent(int level, std::uint32_t cell) const
  {
    return this->Levels[level].Parents[cell / this->FamilySize()];
  }

  LatticePoint LatticePointOf(int level, std::uint32_t cell) const
  {
    if (level == 0)
    {
      return this->Unfold(cell, this->BaseCells);
    }
    const std::uint32_t family = cell / this->FamilySize();
    LatticePoint position = this->Unfold(
      cell % this->FamilySize(), { this->Branch[0], this->Branch[1], this->Branch[2] });
    for (int axis = 0; axis < 3; ++axis)
    {
      position[axis] += this->Levels[level].Positions[family][axis];
    }
    return position;
  }

  /// Gives a leaf its children, at the end of the next level.
  void Refine(int level, std::uint32_t cell)
  {
    assert(this->IsLeaf(level, cell));
    if (level + 1 == this->NumberOfLevels())
    {
      this->Levels.emplace_back();
    }
    LatticePoint first = this->LatticePointOf(level, cell);
    for (int axis = 0; axis < 3; ++axis)
    {
      first[axis] *= this->Branch[axis];
    }
    Generation& next = this->Levels[level + 1];
    this->Levels[level].Children[cell] = static_cast<std::uint32_t>(next.Parents.size());
    next.Parents.push_back(cell);
    next.Positions.push_back(first);
    next.Children.insert(next.Children.end(), this->FamilySize(), None);
  }

  /// The cell at a lattice point of a level, or the leaf of a lower level that covers it. O(level).
  Node Find(int level, const LatticePoint& position) const
  {
    std::array<std::int64_t, 3> across{ 1, 1, 1 };
    for (int i = 0; i < level; ++i)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        across[axis] *= this->Branch[axis];
      }
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      if (position[axis] < 0 || position[axis] >= across[axis] * this->BaseCells[axis])
      {
        return { -1, None };
      }
    }
    return this->Descend(level, position, across);
  }

private:
  struct Generation
  {
    std::vector<std::uint32_t> Children; // the number of the cell's family, or None
    std::vector<std::uint32_t> Parents;  // of the families
    std::vector<LatticePoint> Positions; // of the families' first cells
  };

  static LatticePoint Unfold(std::int64_t number, const std::array<std::int64_t, 3>& counts)
  {
    return { number % counts[0], number / counts[0] % counts[1], number / (counts[0] * counts[1]) };
  }

  Node Descend(int level, const LatticePoint& position, std::array<std::int64_t, 3> across) const
  {
    const auto& n = this->BaseCells;
    Node at{ 0,
      static_cast<std::uint32_t>(position[0] / across[0] +
        n[0] * (position[1] / across[1] + n[1] * (position[2] / across[2]))) };
    while (at.Level < level && !this->IsLeaf(at.Level, at.Index))
    {
      std::int64_t child = 0;
      for (int axis = 2; axis >= 0; --axis)
      {
        across[axis] /= this->Branch[axis];
        child = child * this->Branch[axis] + position[axis] / across[axis] % this->Branch[axis];
      }
      at = { at.Level + 1,
        this->FirstChild(at.Level, at.Index) + static_cast<std::uint32_t>(child) };
    }
    return at;
  }

  std::array<std::int64_t, 3> BaseCells;
  std::array<int, 3> Branch;
  std::vector<Generation> Levels;
};

}

#endif
