// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdPieceSurfaces.h
 * @brief The outer faces of meshes that consist of several blocks: AMR data, partitioned data sets.
 *
 * Faces between pieces of one mesh are no outer faces: see SkdInnerFaces for those that are found.
 * Where cells of images or voxels differ in size, the larger of the faces that are left have the
 * corners of smaller ones on their sides as corners, too, so that the surface of the mesh is closed
 * and no edge of it touches another one but at its ends.
 */

#ifndef SkdPieceSurfaces_h
#define SkdPieceSurfaces_h

#include "Bodies/SkdOuterSurface.h"
#include "Pipeline/SkdBlocks.h"
#include "vtkType.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace skdtree
{
/// The blocks with volume cells that are pieces of one mesh, by their indices in the list; one list
/// for each mesh that has several, or one with faces within it.
std::vector<std::vector<std::size_t>> SkdPiecesOfMeshes(const std::vector<SkdBlock>& blocks);

struct SkdPieceSurface
{
  /// None of a block that is a mesh by itself.
  std::optional<SkdBlockSurface> Faces;

  /// For each point of these its number among those of all pieces, -1 if no outer face has it.
  std::vector<vtkIdType> Numbers;
  std::size_t NumberOfAll = 0; ///< of all pieces of the mesh
};

/// One for each block. Curved faces as facets no farther from them than a length. O(n log n) in the
/// number of faces of pieces.
std::vector<SkdPieceSurface> SkdSurfacesOfPieces(
  const std::vector<SkdBlock>& blocks, double chordalLength);

/// Calls visit(index in the list, outer faces) for each block that has cells.
template <class Visit>
void SkdVisitSurfaces(const std::vector<SkdBlock>& blocks, double chordalLength, const Visit& visit)
{
  const std::vector<SkdPieceSurface> pieces = SkdSurfacesOfPieces(blocks, chordalLength);
  for (std::size_t i = 0; i < blocks.size(); ++i)
  {
    if (pieces[i].Faces)
    {
      visit(static_cast<int>(i), *pieces[i].Faces);
    }
    else if (blocks[i].Mesh->GetNumberOfCells() > 0)
    {
      visit(static_cast<int>(i), SkdBlockSurface(blocks[i].Mesh, chordalLength));
    }
  }
}
}

#endif
