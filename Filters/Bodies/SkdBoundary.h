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

#include <functional>
#include <vector>

namespace skdtree
{
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

  /// The same of the triangles of `Surface`. Only where the blocks are shared with other processes.
  std::vector<Origin> SurfaceOrigins;

  /// For each triangle the number of duplicate faces of its orientation minus that of the opposite
  /// one, or 1 if these are equal. Empty if all are 1.
  std::vector<int> Repeats;

  /// The number of edges used by an odd number of its triangles. It is 0 exactly if the parity of
  /// crossings does not depend on the ray.
  vtkIdType OpenEdges = 0;

  vtkIdType CoarseFaces = 0; // see SkdBlockSurface
};

/// For blocks of a mesh that lies in pieces on several processes, each of which has the cells of
/// its own piece and all others that touch these: then what is said of the faces of own cells, and
/// of their edges, is what would be said of them in the whole. Others may be missing or wrong.
struct SkdSharedBlocks
{
  std::function<bool(const SkdBoundary::Origin&)> IsOwn; ///< each cell is on one process
  std::function<vtkIdType(vtkIdType)> SumOverAll;        ///< all processes call it together
};

/// Curved faces as facets no farther from them than a length (SkdChordalLength). Cost: O(n log n)
/// in the number of faces. With shared blocks open edges are those of all processes.
SkdBoundary SkdBoundaryOf(const std::vector<SkdBlock>& blocks, double chordalLength,
  const SkdSharedBlocks* shared = nullptr);
}

#endif
