// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Meshing/Refine/SkdGridFractions.h"

#include "Meshing/Refine/SkdEnclosure.h"
#include "Meshing/Refine/SkdOrientedBoundary.h"
#include "Pipeline/SkdLoop.h"

#include <numeric>
#include <optional>

namespace skdtree
{
namespace
{
/// The part of 4 x 4 x 4 samples that is inside; fewer along flat axes.
double SampledFraction(const skd::Box3& box, const SkdEnclosure& enclosure)
{
  std::array<int, 3> counts;
  for (int axis = 0; axis < 3; ++axis)
  {
    counts[axis] = box.Length(axis) > 0.0 ? 4 : 1;
  }
  const int all = counts[0] * counts[1] * counts[2];
  int in = 0;
  for (int i = 0; i < all; ++i)
  {
    const int at[3] = { i % counts[0], i / counts[0] % counts[1], i / (counts[0] * counts[1]) };
    skd::Vector3 x;
    for (int axis = 0; axis < 3; ++axis)
    {
      x[axis] = box.Min[axis] + (at[axis] + 0.5) / counts[axis] * box.Length(axis);
    }
    in += enclosure.IsInside(x);
  }
  return static_cast<double>(in) / all;
}

void SetRefined(const SkdGrid& grid, std::vector<std::vector<double>>& fractions)
{
  for (int level = grid.Forest.NumberOfLevels() - 2; level >= 0; --level)
  {
    for (std::uint32_t cell = 0; cell < grid.Forest.NumberOfCells(level); ++cell)
    {
      if (!grid.Forest.IsLeaf(level, cell))
      {
        const auto child = fractions[level + 1].begin() + grid.Forest.FirstChild(level, cell);
        const auto size = grid.Forest.FamilySize();
        fractions[level][cell] = std::accumulate(child, child + size, 0.0) / size;
      }
    }
  }
}
}

std::vector<std::vector<double>> SkdFindFractions(const SkdGrid& grid,
  const SkdEnclosure& enclosure, const std::vector<std::vector<unsigned char>>& inside,
  double epsilon, vtkAlgorithm* algorithm, double first, double last)
{
  std::optional<SkdOrientedBoundary> surface;
  if (enclosure.IsClosed())
  {
    surface.emplace(enclosure.GetBoundary(), epsilon);
  }
  std::vector<std::vector<double>> fractions;
  SkdLoop loop(algorithm, static_cast<vtkIdType>(grid.Forest.NumberOfCells()), first, last);
  for (int level = 0; level < grid.Forest.NumberOfLevels(); ++level)
  {
    std::vector<double> row(inside[level].begin(), inside[level].end());
    loop.For(static_cast<vtkIdType>(row.size()),
      [&](vtkIdType begin, vtkIdType end)
      {
        for (auto cell = static_cast<std::uint32_t>(begin); cell < end; ++cell)
        {
          if (grid.Forest.IsLeaf(level, cell) && grid.Levels[level].Cut[cell])
          {
            const skd::Box3 box = grid.BoxOf(level, cell);
            row[cell] = surface ? surface->GetFraction(box) : SampledFraction(box, enclosure);
          }
        }
      });
    fractions.push_back(std::move(row));
  }
  SetRefined(grid, fractions);
  return fractions;
}
}
