// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdGridEstimate_h
#define SkdGridEstimate_h

#include "Refine/SkdGridExtras.h"
#include "Refine/SkdGridRefiner.h"

/// What a grid will be, about, known before it is made.
struct SkdGridEstimate
{
  double Cells = 0.0; ///< refined ones, too
  double Bytes = 0.0; ///< of the grid and of the output made of it, at once
  double Seconds = 0.0;
};

/// By the walk that refines the grid, thinned: at each level at most 512 of the cells to refine,
/// evenly chosen, go on and stand for all others. So whatever asks for cells is asked, and the
/// number of cells is right to a few percent; but what Balance adds is taken for what it adds
/// around a sphere, and growing layers for those of a surface. Bytes are to a factor of two;
/// seconds go by what the walk took. `grid` is not refined yet. `outputType` is one of VTK's
/// (VTK_UNSTRUCTURED_GRID, ...). O(base cells + 512 levels). The algorithm is told to be at
/// `progress`, and asked whether to stop.
SkdGridEstimate SkdEstimateGrid(const SkdGrid& grid, const SkdParts& parts,
  const SkdRefineSettings& settings, const SkdGridRequests& requests, int outputType,
  vtkAlgorithm* algorithm, double progress);

#endif
