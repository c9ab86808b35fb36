// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdMeshOutput.h
 * @brief The leaves of a refined mesh as the output data set of a block.
 */

#ifndef SkdMeshOutput_h
#define SkdMeshOutput_h

#include "Core/Meshing/Mesh/HangingNodes.h"
#include "Meshing/Refine/SkdMeshReader.h"

class vtkPointSet;

namespace skdtree
{
namespace SkdMeshArrays
{
constexpr const char* ParentName = "SkdParentCellId";
constexpr const char* LevelName = "SkdLevel";
constexpr const char* HangingName = "SkdHanging";
}

/// The output type of a block: VTK_POLY_DATA for vtkPolyData, else VTK_UNSTRUCTURED_GRID.
int SkdRefinedTypeOf(vtkDataSet* mesh);

/// Fills `output`, of that type: cells in the order of their parents, original points with their
/// ids followed by new ones, point data interpolated, cell data by parent, ghost marks kept (of new
/// points those that all of the points that they are made of have), our arrays, field data. Points
/// are of `precision` (vtkAlgorithm's); by default of the type that the block's have.
void SkdWriteBlock(const SkdReadMesh& read, const SkdReadMesh::Block& block,
  const skd::HangingNodes& hanging, int precision, vtkPointSet* output);
}

#endif
