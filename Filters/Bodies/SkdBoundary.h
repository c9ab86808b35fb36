// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdBoundary.h
 * @brief The boundary surface of the union of all blocks of a Source.
 *
 * The boundary is that of the Source's volume cells; of a Source without any, it is its surface
 * cells. Points of equal coordinates are merged, so that blocks and triangle soups are connected.
 * Then
 * - a face between two volume cells, also of different blocks, is not part of the boundary;
 * - duplicate faces are merged. Ghost cells and faces with points that are not finite are ignored.
 */

#ifndef SkdBoundary_h
#define SkdBoundary_h

#include "Bodies/SkdOuterSurface.h"
#include "Pipeline/SkdBlocks.h"
#include "vtkPolyData.h"

#include <vector>

struct SkdBoundary
{
  /// Where a face comes from: an index in the list of blocks, and a cell there.
  struct Origin
  {
    int Block;
    vtkIdType CellId;
  };

  /// Triangles, by ascending (block, cell id). Larger faces are triangulated, because exact
  /// crossings that are consistent with distances are not available for warped quads.
  vtkSmartPointer<vtkPolyData> Faces;
  std::vector<Origin> Origins; // one a face

  /// The faces whose crossings are counted in inside tests: `Faces`, without faces that two
  /// touching bodies share, because both of their sides are inside.
  vtkSmartPointer<vtkPolyData> Surface;

  /// For each triangle the number of duplicate faces of its orientation minus that of the opposite
  /// one, or 1 if these are equal. Empty if all are 1.
  std::vector<int> Repeats;

  /// The number of edges used by an odd number of its triangles. It is 0 exactly if the parity of
  /// crossings does not depend on the ray.
  vtkIdType OpenEdges = 0;

  vtkIdType CoarseFaces = 0; // see SkdBlockSurface
};

/// Curved faces as facets no farther from them than a length (SkdChordalLength). Cost: O(n log n)
/// in the number of faces.
SkdBoundary SkdBoundaryOf(const std::vector<SkdBlock>& blocks, double chordalLength);

#endif
