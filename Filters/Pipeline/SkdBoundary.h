// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdBoundary.h
 * @brief The one surface that bounds what all blocks of a Source enclose together.
 *
 * The boundary is that of the Source's volume cells; of a Source without any, it is its surface
 * cells. Points are one point when their coordinates are equal, so that blocks, and triangles that
 * were written point by point, join. Then
 * - a face between two volume cells, be they of different blocks, is no boundary;
 * - a face that occurs more than once is there once.
 * Ghost cells and faces with points that are not finite are left out.
 */

#ifndef SkdBoundary_h
#define SkdBoundary_h

#include "Pipeline/SkdBlocks.h"
#include "Pipeline/SkdOuterSurface.h"
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

  /// Triangles, by ascending (block, cell id). Larger faces are cut: a warped quad has no crossings
  /// that are exact and fit its distances, two triangles have.
  vtkSmartPointer<vtkPolyData> Faces;
  std::vector<Origin> Origins; // one a face

  /// The faces whose crossings tell inside from outside: `Faces` itself, or less when bodies touch
  /// each other with equal faces. Such a face is between two insides and is left out here.
  vtkSmartPointer<vtkPolyData> Surface;

  /// Of each triangle how many more faces there are that are turned like it than are turned against
  /// it, or 1 if as many are. Empty if it is 1 of all.
  std::vector<int> Repeats;

  /// The edges that an odd number of its triangles use. 0 exactly when the parity of the crossings
  /// is the same along any way out.
  vtkIdType OpenEdges = 0;
};

/// Curved faces as facets no farther from them than a length (SkdChordalLength). Cost: O(n log n)
/// in the number of faces.
SkdBoundary SkdBoundaryOf(const std::vector<SkdBlock>& blocks, double chordalLength);

#endif
