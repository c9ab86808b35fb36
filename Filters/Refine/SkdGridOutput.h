// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdGridOutput.h
 * @brief An adaptive grid as VTK's data objects.
 */

#ifndef SkdGridOutput_h
#define SkdGridOutput_h

#include "Refine/SkdGridExtras.h"
#include "vtkSmartPointer.h"
#include "vtkUniformGrid.h"

#include <vector>

class vtkDataObject;
class vtkHyperTreeGrid;
class vtkOverlappingAMR;
class vtkUnstructuredGrid;

/// Gives the hyper tree grid the base cells and their trees. Returns its cells, refined ones too,
/// in its order.
std::vector<SkdGridCell> SkdMakeHyperTreeGrid(const SkdGrid& grid, vtkHyperTreeGrid* output);

/// Gives the unstructured grid the leaves as voxels, pixels or lines, and marks the points that are
/// not corners of all the leaves that they are on. Returns its cells in its order: level by level.
std::vector<SkdGridCell> SkdMakeUnstructuredGrid(const SkdGrid& grid, vtkUnstructuredGrid* output);

/// The same of a grid of two dimensions, without hanging points: a leaf with points between its
/// corners becomes triangles around its middle. Returns the leaf of each cell, in its order.
std::vector<SkdGridCell> SkdMakeConformingGrid(const SkdGrid& grid, vtkUnstructuredGrid* output);

/// One block of an AMR data set and its cells, in the block's order.
struct SkdGridBlock
{
  vtkSmartPointer<vtkUniformGrid> Grid;
  std::vector<SkdGridCell> Cells;
};

/// Whether all base cells are of one size, up to rounding, and along two axes at least: what
/// SkdMakeOverlappingAMR() needs.
bool SkdIsUniform(const skd::Lattice& lattice);

/// Gives the AMR data set one block of all base cells, and below these blocks of the children of
/// refined cells, joined where they fit (see skd::JoinPlaces). Cells that are
/// refined are marked as VTK marks them (vtkDataSetAttributes::REFINEDCELL). Returns the blocks
/// with their cells: of several processes, each has every so-manieth block.
std::vector<SkdGridBlock> SkdMakeOverlappingAMR(const SkdGrid& grid, vtkOverlappingAMR* output);

/// The grid as whatever the output is of the types above, with the arrays of its cells.
/// `blockIndices` has that of each part.
void SkdFillGridOutput(const SkdGrid& grid, const SkdGridExtras& extras,
  const std::vector<int>& blockIndices, bool isConforming, vtkDataObject* output);

#endif
