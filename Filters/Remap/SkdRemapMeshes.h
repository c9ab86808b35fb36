// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdRemapMeshes.h
 * @brief The meshes of a remapping as they are taken: blocks as one, longitudes and latitudes on
 * the sphere.
 */

#ifndef SkdRemapMeshes_h
#define SkdRemapMeshes_h

#include "Pipeline/SkdBlocks.h"
#include "Pipeline/SkdJoinedShape.h"
#include "Remap/SkdOverlapWeights.h"

#include <set>
#include <string>

class vtkPolyData;

namespace skdtree
{
/// The blocks as one mesh; the mesh itself if there is but one, and an empty one if there is none.
/// Arrays of numbers that only some have are NaN elsewhere; `partial` becomes their names.
vtkSmartPointer<vtkDataSet> SkdJoinBlocks(
  const std::vector<SkdBlock>& blocks, std::set<std::string>& partial);

/// A mesh whose points are longitude and latitude in degrees, moved to a sphere about the origin.
/// The arrays are the old ones.
vtkSmartPointer<vtkDataSet> SkdMovedToSphere(vtkDataSet* mesh, double radius);

/// Whether a mesh is flat in z, and x and y may well be longitudes and latitudes in degrees: more
/// than a radian wide, and between the poles.
bool SkdMayBeLonLat(vtkDataSet* mesh);

/// Whether a donor and all blocks that have cells are in one plane.
bool SkdAreInOnePlane(vtkDataSet* donor, const std::vector<SkdBlock>& blocks);

/// The space that a mesh is in: by the dimension of its cells, surfaces by their radius.
SkdOverlapSpace SkdSpaceOf(vtkDataSet* mesh);

/// The middles of a mesh's cells (their parametric centres), or its points. NaN of empty cells.
std::vector<skd::Vector3> SkdPointsOf(vtkDataSet* mesh);
std::vector<skd::Vector3> SkdMiddlesOf(vtkDataSet* mesh);

/// Points and nothing else.
vtkSmartPointer<vtkPolyData> SkdCloudOf(const std::vector<skd::Vector3>& positions);
}

#endif
