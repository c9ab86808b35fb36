// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Grid_Balance_h
#define skd_Grid_Balance_h

#include "Forest.h"

namespace skd
{

/// Over what neighbouring leaves may differ by one level at most: faces, edges and faces, or
/// corners, edges and faces. The value is the number of axes along which neighbours lie apart.
enum class Contact : int
{
  None = 0,
  Face = 1,
  Edge = 2,
  Corner = 3
};

/// Calls visit(point) for the lattice points of all neighbours over such contacts.
template <class Visit>
void ForEachNeighbour(const LatticePoint& position, Contact contact, Visit visit)
{
  for (int direction = 0; direction < 27; ++direction)
  {
    const int steps[3] = { direction % 3 - 1, direction / 3 % 3 - 1, direction / 9 - 1 };
    const int apart = std::abs(steps[0]) + std::abs(steps[1]) + std::abs(steps[2]);
    if (apart >= 1 && apart <= static_cast<int>(contact))
    {
      visit(LatticePoint{ position[0] + steps[0], position[1] + steps[1], position[2] + steps[2] });
    }
  }
}

/// Whether the leaves are 2:1 over such contacts: every neighbour of a refined cell is there.
inline bool IsBalanced(const Forest& forest, Contact contact)
{
  bool isBalanced = true;
  for (int level = 1; level < forest.NumberOfLevels(); ++level)
  {
    for (std::uint32_t cell = 0; cell < forest.NumberOfCells(level); ++cell)
    {
      if (forest.IsLeaf(level, cell))
      {
        continue;
      }
      ForEachNeighbour(forest.LatticePointOf(level, cell), contact,
        [&](const LatticePoint& position)
        {
          const Forest::Node there = forest.Find(level, position);
          isBalanced &= there.Level < 0 || there.Level == level;
        });
    }
  }
  return isBalanced;
}

/// The least refinement that makes the leaves 2:1 over such contacts. `refine(level, cell)` is
/// called for each leaf that has to be refined, parents before children, and must do it; if it
/// returns false the work ends there. Returns whether all was done. From the finest level down, so
/// that each cell is looked at once: what is added to a level is no finer than that level.
template <class Refine>
bool MakeBalanced(const Forest& forest, Contact contact, Refine refine)
{
  bool goesOn = true;
  const auto makeThere = [&](int level, const LatticePoint& position)
  {
    for (Forest::Node there = forest.Find(level, position);
         goesOn && there.Level >= 0 && there.Level < level; there = forest.Find(level, position))
    {
      goesOn = refine(there.Level, there.Index);
    }
  };
  for (int level = forest.NumberOfLevels() - 2; level >= 1 && contact != Contact::None; --level)
  {
    for (std::uint32_t cell = 0; goesOn && cell < forest.NumberOfCells(level); ++cell)
    {
      if (!forest.IsLeaf(level, cell))
      {
        ForEachNeighbour(forest.LatticePointOf(level, cell), contact,
          [&](const LatticePoint& position) { makeThere(level, position); });
      }
    }
  }
  return goesOn;
}

/// Marks the cells of a level that are at most `layers` cells away, corners included, from one that
/// is marked, in a copy.
inline std::vector<char> Grown(
  const Forest& forest, int level, const std::vector<char>& marks, int layers)
{
  std::vector<char> grown = marks;
  const auto mark = [&](const LatticePoint& position)
  {
    const Forest::Node there = forest.Find(level, position);
    if (there.Level == level)
    {
      grown[there.Index] = 1;
    }
  };
  for (std::uint32_t cell = 0; layers > 0 && cell < marks.size(); ++cell)
  {
    const LatticePoint position = marks[cell] ? forest.LatticePointOf(level, cell) : LatticePoint{};
    const std::int64_t layersLeft = marks[cell] ? layers : -1;
    for (std::int64_t i = -layersLeft; i <= layersLeft; ++i)
    {
      for (std::int64_t j = -layersLeft; j <= layersLeft; ++j)
      {
        for (std::int64_t k = -layersLeft; k <= layersLeft; ++k)
        {
          mark({ position[0] + i, position[1] + j, position[2] + k });
        }
      }
    }
  }
  return grown;
}

}

#endif
