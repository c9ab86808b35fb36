// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdMeshReport_h
#define SkdMeshReport_h

#include "Core/Meshing/Mesh/HangingNodes.h"
#include "Meshing/Refine/SkdMeshReader.h"
#include "Meshing/Refine/SkdMeshRefiner.h"

namespace skdtree
{
class SkdReport;

/// Statistics of a mesh before and after refinement.
struct SkdMeshTally
{
  explicit SkdMeshTally(const skd::RefinedMesh& before);
  void Finish(const skd::RefinedMesh& after, const skd::HangingNodes& hanging);

  vtkIdType CellsBefore = 0;
  vtkIdType Cells = 0;
  std::vector<vtkIdType> CellsAtLevel;
  vtkIdType HangingNodes = 0;
  vtkIdType CellsOddlyShaped = 0;   ///< that could have been cut by type, but not by shape
  vtkIdType CellsTooSmall = 0;      ///< that are no larger than the resolution of coordinates
  double SmallestAngleBefore = 0.0; ///< in degrees; infinity without cells that have such angles
  double SmallestAngle = 0.0;
};

void SkdReportMesh(SkdReport& report, const SkdReadMesh& read, const SkdMeshOutcome& outcome,
  const SkdMeshTally& tally);
}

#endif
