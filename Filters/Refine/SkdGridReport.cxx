// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Refine/SkdGridReport.h"

#include "Pipeline/SkdReport.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace
{
/// All cells at the maximum level: those that there are, or if the limit stopped it, what they
/// would grow to as the last levels did.
double EstimateCells(const SkdGrid& grid, int maximumLevel)
{
  double cells = static_cast<double>(grid.Forest.NumberOfCells());
  if (!grid.IsStopped)
  {
    return cells;
  }
  const double ofSurface =
    std::pow(*std::max_element(grid.Lattice.GetBranch().begin(), grid.Lattice.GetBranch().end()),
      grid.Lattice.Dimension() - 1);
  double next = static_cast<double>(grid.CellsWanted) - cells;
  for (int level = grid.StoppedAtLevel; level < maximumLevel; ++level)
  {
    cells += next;
    next *= ofSurface;
  }
  return cells;
}

}

//------------------------------------------------------------------------------
void SkdReportGrid(SkdReport& report, const SkdGrid& grid, int maximumLevel)
{
  std::vector<vtkIdType> leaves;
  std::vector<vtkIdType> cut;
  vtkIdType cells = 0;
  vtkIdType cutLeaves = 0;
  for (int level = 0; level < grid.Forest.NumberOfLevels(); ++level)
  {
    leaves.push_back(0);
    cut.push_back(0);
    for (std::uint32_t cell = 0; cell < grid.Forest.NumberOfCells(level); ++cell)
    {
      if (!grid.IsOwn(level, cell))
      {
        continue;
      }
      ++cells;
      const bool isLeaf = grid.Forest.IsLeaf(level, cell);
      const bool isCut = grid.Levels[level].Cut[cell] != 0;
      leaves.back() += isLeaf;
      cut.back() += isCut;
      cutLeaves += isLeaf && isCut;
    }
  }
  report.AddCount("Cells", std::accumulate(leaves.begin(), leaves.end(), vtkIdType(0)));
  report.AddCount("CutCells", cutLeaves);
  report.AddCount("AllCells", cells);
  report.AddCounts("LeavesAtLevel", leaves);
  report.AddCounts("CutAtLevel", cut);
  report.AddCount("StoppedAtLevel", grid.StoppedAtLevel);
  report.AddCount("EstimatedCells", static_cast<vtkIdType>(EstimateCells(grid, maximumLevel)));
}
