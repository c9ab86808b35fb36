// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Meshing/Refine/SkdMeshReport.h"

#include "Core/Meshing/Mesh/Divisible.h"
#include "Core/Meshing/Mesh/SmallestAngle.h"
#include "Pipeline/SkdReport.h"
#include "vtkMath.h"

#include <cmath>

namespace skdtree
{
namespace
{
double SmallestAngleIn(const skd::RefinedMesh& mesh)
{
  double smallest = std::numeric_limits<double>::infinity();
  for (std::uint32_t cell = 0; cell < mesh.NumberOfCells(); ++cell)
  {
    if (mesh[cell].IsLeaf())
    {
      smallest = std::min(smallest, skd::SmallestAngleOf(mesh, cell));
    }
  }
  return vtkMath::DegreesFromRadians(smallest);
}
}

SkdMeshTally::SkdMeshTally(const skd::RefinedMesh& before)
  : CellsBefore(before.NumberOfLeaves())
  , SmallestAngleBefore(SmallestAngleIn(before))
{
}

void SkdMeshTally::Finish(const skd::RefinedMesh& after, const skd::HangingNodes& hanging)
{
  this->Cells = after.NumberOfLeaves();
  this->SmallestAngle = SmallestAngleIn(after);
  for (std::uint32_t cell = 0; cell < after.NumberOfCells(); ++cell)
  {
    if (after[cell].IsLeaf())
    {
      const auto level = static_cast<std::size_t>(after[cell].Level());
      this->CellsAtLevel.resize(std::max(this->CellsAtLevel.size(), level + 1), 0);
      ++this->CellsAtLevel[level];
      if (after[cell].IsFixed && after[cell].Kind != skd::CellKind::Fixed)
      {
        ++(skd::IsDivisible(after, cell) ? this->CellsOddlyShaped : this->CellsTooSmall);
      }
    }
  }
  for (std::uint32_t node = 0; node < after.NumberOfNodes(); ++node)
  {
    this->HangingNodes += hanging[node];
  }
}

void SkdReportMesh(SkdReport& report, const SkdReadMesh& read, const SkdMeshOutcome& outcome,
  const SkdMeshTally& tally)
{
  report.AddCount("Cells", tally.Cells);
  report.AddCount("Points", read.Mesh.NumberOfNodes());
  report.AddCount("CellsBefore", tally.CellsBefore);
  report.AddCounts("CellsAtLevel", tally.CellsAtLevel);
  report.AddCount("HangingPoints", tally.HangingNodes);
  report.AddCount("Rounds", outcome.Rounds);
  report.AddCount("StoppedAtLevel", outcome.StoppedAtLevel);
  report.AddCount("EstimatedCells", static_cast<vtkIdType>(outcome.CellsEstimated));
  report.AddCount("MemoryBytes", static_cast<vtkIdType>(read.Mesh.MemorySize()));
  report.AddCount(
    "CellsNotRefinable", read.CellsNotRefinable + tally.CellsOddlyShaped + tally.CellsTooSmall);
  if (std::isfinite(tally.SmallestAngle) && std::isfinite(tally.SmallestAngleBefore))
  {
    report.AddMeasure("MinimumAngleBefore", tally.SmallestAngleBefore);
    report.AddMeasure("MinimumAngle", tally.SmallestAngle);
  }
}
}
