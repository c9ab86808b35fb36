// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdGridOutput.h
 * @brief An adaptive grid as VTK's data objects.
 */

#ifndef SkdGridOutput_h
#define SkdGridOutput_h

#include "Meshing/Refine/SkdGridExtras.h"
#include "vtkSmartPointer.h"
#include "vtkUniformGrid.h"

#include <vector>

class vtkDataObject;
class vtkHyperTreeGrid;
class vtkOverlappingAMR;
class vtkUnstructuredGrid;

namespace skdtree
{
/// Sets the base cells and trees of the hyper tree grid. Returns its cells, including refined ones,
/// in its order.
std::vector<SkdGridCell> SkdMakeHyperTreeGrid(const SkdGrid& grid, vtkHyperTreeGrid* output);

/// Fills the unstructured grid with the leaves as voxels, pixels or lines, and marks hanging nodes.
/// Returns its cells in its order: level by level.
std::vector<SkdGridCell> SkdMakeUnstructuredGrid(const SkdGrid& grid, vtkUnstructuredGrid* output);

/// The same for a two-dimensional grid without hanging nodes: a leaf with hanging nodes becomes
/// triangles around its centre. Returns the leaf of each cell, in its order.
std::vector<SkdGridCell> SkdMakeConformingGrid(const SkdGrid& grid, vtkUnstructuredGrid* output);

/// One block of an AMR data set and its cells, in the block's order.
struct SkdGridBlock
{
  vtkSmartPointer<vtkUniformGrid> Grid;
  std::vector<SkdGridCell> Cells;
};

/// Whether all base cells have equal sizes, up to rounding, and at least two dimensions, as
/// SkdMakeOverlappingAMR() requires.
bool SkdIsUniform(const skd::Lattice& lattice);

/// Fills the AMR data set with one block of all base cells, and on further levels blocks of the
/// children of refined cells, joined to larger ones (see skd::JoinIntoBlocks). Refined cells are
/// marked as in VTK (vtkDataSetAttributes::REFINEDCELL). Returns the blocks with their cells: with
/// n processes, each has every n-th block.
std::vector<SkdGridBlock> SkdMakeOverlappingAMR(const SkdGrid& grid, vtkOverlappingAMR* output);

/// The grid as the output's type, one of the above, with the arrays of its cells. `blockIndices`
/// has that of each part.
void SkdFillGridOutput(const SkdGrid& grid, const SkdGridExtras& extras,
  const std::vector<int>& blockIndices, bool isConforming, vtkDataObject* output);
}

#endif
