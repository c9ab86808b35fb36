// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Meshing/Refine/SkdGridReport.h"

#include "Pipeline/SkdReport.h"

#include <numeric>

namespace skdtree
{
//------------------------------------------------------------------------------
void SkdReportGrid(SkdReport& report, const SkdGrid& grid, const SkdGridEstimate& estimate)
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
  report.AddMeasure("EstimatedCells", estimate.Cells);
  report.AddMeasure("EstimatedBytes", estimate.Bytes);
  report.AddMeasure("EstimatedSeconds", estimate.Seconds);
}
}
