// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Meshing/Refine/SkdGridDistances.h"

#include "Pipeline/SkdLoop.h"

#include <limits>

namespace skdtree
{
std::vector<std::vector<double>> SkdFindDistances(
  const SkdGrid& grid, const SkdParts& parts, vtkAlgorithm* algorithm, double first, double last)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<std::vector<double>> distances;
  SkdLoop loop(algorithm, static_cast<vtkIdType>(grid.Forest.NumberOfCells()), first, last);
  for (int level = 0; level < grid.Forest.NumberOfLevels(); ++level)
  {
    std::vector<double> row(
      grid.Forest.NumberOfCells(level), std::numeric_limits<double>::quiet_NaN());
    loop.For(static_cast<vtkIdType>(row.size()),
      [&](vtkIdType begin, vtkIdType end)
      {
        for (auto cell = static_cast<std::uint32_t>(begin); cell < end; ++cell)
        {
          row[cell] = parts.FindDistance(grid.BoxOf(level, cell).Centroid(), infinity);
        }
      });
    distances.push_back(std::move(row));
  }
  return distances;
}

void SkdSignDistances(std::vector<std::vector<double>>& distances,
  const std::vector<std::vector<unsigned char>>& inside)
{
  for (std::size_t level = 0; level < distances.size(); ++level)
  {
    for (std::size_t cell = 0; cell < distances[level].size(); ++cell)
    {
      double& distance = distances[level][cell];
      distance = inside[level][cell] ? -distance : distance;
    }
  }
}
}
