// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdOverlapMesh.h
 * @brief The overlaps of two meshes as a mesh.
 */

#ifndef SkdOverlapMesh_h
#define SkdOverlapMesh_h

#include "Remap/SkdOverlapWeights.h"

#include "vtkSmartPointer.h"

class vtkUnstructuredGrid;

namespace skdtree
{
/// Segments, polygons or polyhedra, by ascending (target, donor), with the cell arrays "TargetCell"
/// and "DonorCell" (ids) and "Measure" (signed: concave volume cells are sums of pieces some of
/// which count negative; all pieces of a pair sum up to its weight). No point is shared. Along
/// parallels edges are drawn in steps. nullptr if the algorithm was aborted, or if the weights of
/// these meshes would have a problem. Of the target only cells that are `listed`; empty: all.
vtkSmartPointer<vtkUnstructuredGrid> SkdMakeOverlapMesh(vtkDataSet* donor, vtkDataSet* target,
  const SkdOverlapSettings& settings, vtkAlgorithm* algorithm,
  const std::vector<unsigned char>& listed = {});
}

#endif
