// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdGridOutput.h
 * @brief An adaptive grid as VTK's data objects.
 */

#ifndef SkdGridOutput_h
#define SkdGridOutput_h

#include "Refine/SkdGrid.h"

#include <vector>

class vtkHyperTreeGrid;
class vtkUnstructuredGrid;

/// Gives the hyper tree grid the base cells and their trees. Returns its cells, refined ones too,
/// in its order.
std::vector<SkdGridCell> SkdMakeHyperTreeGrid(const SkdGrid& grid, vtkHyperTreeGrid* output);

/// Gives the unstructured grid the leaves as voxels, pixels or lines, and marks the points that are
/// not corners of all the leaves that they are on. Returns its cells in its order: level by level.
std::vector<SkdGridCell> SkdMakeUnstructuredGrid(const SkdGrid& grid, vtkUnstructuredGrid* output);

#endif
