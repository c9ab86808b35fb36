// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdGridEstimate_h
#define SkdGridEstimate_h

#include "Meshing/Refine/SkdGridExtras.h"
#include "Meshing/Refine/SkdGridRefiner.h"

namespace skdtree
{
/// An estimate of the size of a grid before it is made.
struct SkdGridEstimate
{
  double Cells = 0.0; ///< refined ones, too
  double Bytes = 0.0; ///< of the grid and of the output made of it, at once
  double Seconds = 0.0;
};

/// It runs the refinement on a sample: on each level at most 512 of the cells to refine, evenly
/// chosen, represent all others. All criteria are evaluated, and the number of cells is accurate to
/// a few percent; cells added by Balance are estimated as around a sphere, growing layers as around
/// a surface. Bytes are accurate to a factor of two; seconds are extrapolated. `grid` is not
/// refined yet. `outputType` is one of VTK's (VTK_UNSTRUCTURED_GRID, ...). O(base cells + 512
/// levels). Sets the algorithm's progress to `progress` and checks for abort.
SkdGridEstimate SkdEstimateGrid(const SkdGrid& grid, const SkdParts& parts,
  const SkdRefineSettings& settings, const SkdGridRequests& requests, int outputType,
  vtkAlgorithm* algorithm, double progress);
}

#endif
