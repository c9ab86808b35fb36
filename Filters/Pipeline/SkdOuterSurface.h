// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdOuterSurface.h
 * @brief The surface cells of a data set and the outer faces of its volume cells, as polygons.
 *
 * Linear cells give the polygons that they have. Curved ones (quadratic, Lagrange, Bezier) give
 * flat facets no farther from the face than a chordal deviation (Core/Curves/PatchFacets.h): one
 * polygon where the face is straight within it. Facets of neighbours fit together, be these of
 * different data sets, and faces that two data sets share are cut the same.
 */

#ifndef SkdOuterSurface_h
#define SkdOuterSurface_h

#include "Core/Mesh/Processes.h"
#include "Pipeline/SkdBlocks.h"
#include "vtkPolyData.h"

/// The default chordal deviation, relative to the diagonal of the bounds.
constexpr double SkdDefaultChordalDeviation = 1e-4;

/// A chordal deviation as a length, for the diagonal of all blocks; 0 if none has curved cells.
/// With several processes it uses the blocks of all and is the same on each.
double SkdChordalLength(
  const std::vector<SkdBlock>& blocks, double share, const skd::Processes* processes = nullptr);

/// Of a data set that is no vtkPolyData. Its cells have "vtkOriginalCellIds", its points
/// "vtkOriginalPointIds", -1 of those that are on curved faces. Faces that cannot be cut (a weight
/// that is not positive, a point that is not finite) are there as polygons of two points.
vtkSmartPointer<vtkPolyData> SkdOuterSurfaceOf(vtkDataSet* mesh, double chordalLength);

#endif
