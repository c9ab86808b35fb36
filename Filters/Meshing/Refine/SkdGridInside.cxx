// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Meshing/Refine/SkdGridInside.h"

#include "Core/Geometry/DisjointSets.h"
#include "Core/Geometry/Rows.h"
#include "Core/Meshing/Grid/Balance.h"
#include "Meshing/Refine/SkdEnclosure.h"
#include "Pipeline/SkdLoop.h"

namespace skdtree
{
namespace
{
using Unions = skd::DisjointSets<std::size_t>;

/// All cells, numbered level after level.
class CellNumbers
{
public:
  explicit CellNumbers(const SkdGrid& grid)
    : Grid(grid)
  {
    std::vector<SkdGridCell> cells;
    for (int level = 0; level < grid.Forest.NumberOfLevels(); ++level)
    {
      cells.clear();
      for (std::uint32_t cell = 0; cell < grid.Forest.NumberOfCells(level); ++cell)
      {
        cells.push_back({ level, cell });
      }
      this->OfLevels.Add(cells.begin(), cells.end());
    }
  }

  const std::vector<SkdGridCell>& GetCells() const { return this->OfLevels.GetItems(); }
  std::size_t IndexOf(int level, std::uint32_t cell) const
  {
    return this->OfLevels.GetOffsets()[level] + cell;
  }
  bool IsFree(int level, std::uint32_t cell) const
  {
    return this->Grid.Forest.IsLeaf(level, cell) && !this->Grid.Levels[level].Cut[cell];
  }

private:
  const SkdGrid& Grid;
  skd::Rows<SkdGridCell> OfLevels;
};

/// Joins the free leaves that share a face. Of two levels the finer one looks.
Unions JoinFreeLeaves(const SkdGrid& grid, const CellNumbers& numbers)
{
  Unions unions(numbers.GetCells().size());
  for (const SkdGridCell& at : numbers.GetCells())
  {
    if (!numbers.IsFree(at.Level, at.Index))
    {
      continue;
    }
    skd::ForEachNeighbour(grid.Forest.LatticePointOf(at.Level, at.Index), skd::Contact::Face,
      [&](const skd::LatticePoint& position)
      {
        const skd::Forest::Node there = grid.Forest.Find(at.Level, position);
        if (there.Level >= 0 && numbers.IsFree(there.Level, there.Index))
        {
          unions.Unite(
            numbers.IndexOf(at.Level, at.Index), numbers.IndexOf(there.Level, there.Index));
        }
      });
  }
  return unions;
}

void SetRefined(const SkdGrid& grid, std::vector<std::vector<unsigned char>>& inside)
{
  for (int level = grid.Forest.NumberOfLevels() - 2; level >= 0; --level)
  {
    for (std::uint32_t cell = 0; cell < grid.Forest.NumberOfCells(level); ++cell)
    {
      if (!grid.Forest.IsLeaf(level, cell))
      {
        const auto child = inside[level + 1].begin() + grid.Forest.FirstChild(level, cell);
        const auto size = grid.Forest.FamilySize();
        inside[level][cell] = 2u * std::accumulate(child, child + size, 0u) > size;
      }
    }
  }
}
}

//------------------------------------------------------------------------------
std::vector<std::vector<unsigned char>> SkdFindInside(const SkdGrid& grid,
  const SkdEnclosure& enclosure, vtkAlgorithm* algorithm, double first, double last)
{
  const CellNumbers numbers(grid);
  const std::vector<SkdGridCell>& cells = numbers.GetCells();
  Unions unions = enclosure.IsClosed() ? JoinFreeLeaves(grid, numbers) : Unions(cells.size());
  const std::vector<std::size_t> representatives = unions.Representatives();

  std::vector<unsigned char> answers(cells.size(), 0);
  SkdLoop loop(algorithm, static_cast<vtkIdType>(answers.size()), first, last);
  loop.For(static_cast<vtkIdType>(answers.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        const SkdGridCell& at = cells[i];
        if (representatives[i] == i && grid.Forest.IsLeaf(at.Level, at.Index))
        {
          answers[i] = enclosure.IsInside(grid.BoxOf(at.Level, at.Index).Centroid());
        }
      }
    });

  std::vector<std::vector<unsigned char>> inside;
  for (int level = 0; level < grid.Forest.NumberOfLevels(); ++level)
  {
    inside.emplace_back(grid.Forest.NumberOfCells(level));
    for (std::uint32_t cell = 0; cell < inside.back().size(); ++cell)
    {
      inside.back()[cell] = answers[representatives[numbers.IndexOf(level, cell)]];
    }
  }
  SetRefined(grid, inside);
  return inside;
}
}
