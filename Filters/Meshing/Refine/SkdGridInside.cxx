// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Meshing/Refine/SkdGridInside.h"

#include "Core/Geometry/DisjointSets.h"
#include "Core/Meshing/Grid/Balance.h"
#include "Meshing/Refine/SkdEnclosure.h"
#include "Pipeline/SkdLoop.h"

namespace skdtree
{
namespace
{
using Unions = skd::DisjointSets<std::size_t>;

/// All cells in a row, level after level.
class Row
{
public:
  explicit Row(const SkdGrid& grid)
    : Grid(grid)
  {
    for (int level = 0; level < grid.Forest.NumberOfLevels(); ++level)
    {
      this->Starts.push_back(this->Cells.size());
      for (std::uint32_t cell = 0; cell < grid.Forest.NumberOfCells(level); ++cell)
      {
        this->Cells.push_back({ level, cell });
      }
    }
  }

  std::size_t IndexOf(int level, std::uint32_t cell) const { return this->Starts[level] + cell; }
  bool IsFree(int level, std::uint32_t cell) const
  {
    return this->Grid.Forest.IsLeaf(level, cell) && !this->Grid.Levels[level].Cut[cell];
  }

  std::vector<SkdGridCell> Cells;

private:
  const SkdGrid& Grid;
  std::vector<std::size_t> Starts;
};

/// Joins the free leaves that share a face. Of two levels the finer one looks.
Unions JoinFreeLeaves(const SkdGrid& grid, const Row& row)
{
  Unions unions(row.Cells.size());
  for (const SkdGridCell& at : row.Cells)
  {
    if (!row.IsFree(at.Level, at.Index))
    {
      continue;
    }
    skd::ForEachNeighbour(grid.Forest.LatticePointOf(at.Level, at.Index), skd::Contact::Face,
      [&](const skd::LatticePoint& position)
      {
        const skd::Forest::Node there = grid.Forest.Find(at.Level, position);
        if (there.Level >= 0 && row.IsFree(there.Level, there.Index))
        {
          unions.Unite(row.IndexOf(at.Level, at.Index), row.IndexOf(there.Level, there.Index));
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
  const Row row(grid);
  Unions unions = enclosure.IsClosed() ? JoinFreeLeaves(grid, row) : Unions(row.Cells.size());
  const std::vector<std::size_t> representatives = unions.Representatives();

  std::vector<unsigned char> answers(row.Cells.size(), 0);
  SkdLoop loop(algorithm, static_cast<vtkIdType>(answers.size()), first, last);
  loop.For(static_cast<vtkIdType>(answers.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        const SkdGridCell& at = row.Cells[i];
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
      inside.back()[cell] = answers[representatives[row.IndexOf(level, cell)]];
    }
  }
  SetRefined(grid, inside);
  return inside;
}
}
