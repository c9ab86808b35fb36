// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Meshing/Refine/SkdGridEstimate.h"

#include "Pipeline/SkdReport.h"
#include "vtkType.h"

namespace skdtree
{
namespace
{
constexpr std::size_t SampledFamilies = 1536; // of each level

/// All cells, if so many are to be refined at each level.
double CountCells(
  const SkdGrid& grid, const SkdRefineSettings& settings, const std::vector<double>& wanted)
{
  // The factor by which 2:1 balance across faces, edges and corners increases the number of cells
  // around a sphere.
  const double more[4] = { 1.0, 1.16, 1.27, 1.31 };
  const double base =
    settings.KnownLayers >= 0 ? grid.LastOwn - grid.FirstOwn : grid.Forest.NumberOfCells(0);
  double ofLevel = base;
  double below = 0.0;
  for (const double families : wanted)
  {
    ofLevel = std::min(ofLevel, families * (1 + 2 * settings.Layers)) * grid.Forest.FamilySize();
    below += ofLevel;
  }
  return base + more[static_cast<int>(settings.Balance)] * below;
}

/// The forest, the arrays of its cells and again in the output, and what the output is made of.
double BytesPerCell(const SkdGridRequests& requests, int outputType, int corners)
{
  const double extras = (requests.NeedBoundary() ? 2 : 0) + (requests.Fractions ? 16 : 0) +
    (requests.Distances ? 16 : 0);
  const double ofGrid = 12 + 9 + 10 + extras;
  // A leaf's connectivity, offset and type, and about one point, its mark and its number
  const double ofLeaf = 8.0 * corners + 8 + 1 + 24 + 1 + 8;
  return ofGrid + (outputType == VTK_UNSTRUCTURED_GRID ? ofLeaf : 10.0);
}
}

SkdGridEstimate SkdEstimateGrid(const SkdGrid& grid, const SkdParts& parts,
  const SkdRefineSettings& settings, const SkdGridRequests& requests, int outputType,
  vtkAlgorithm* algorithm, double progress)
{
  SkdStopwatch watch;
  SkdGrid sample = grid;
  SkdRefineSettings plain = settings;
  plain.Layers = 0;
  const std::vector<double> wanted =
    SkdGridRefiner(algorithm, progress, progress, sample, parts, plain)
      .RefineSample(SampledFamilies);
  SkdGridEstimate estimate;
  estimate.Cells = CountCells(grid, settings, wanted);
  estimate.Bytes =
    BytesPerCell(requests, outputType, 1 << grid.Lattice.Dimension()) * estimate.Cells;
  estimate.Seconds =
    watch.Lap() * estimate.Cells / static_cast<double>(sample.Forest.NumberOfCells());
  return estimate;
}
}
