// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdMeshReader.h
 * @brief Converts data sets to one mesh for refinement.
 */

#ifndef SkdMeshReader_h
#define SkdMeshReader_h

#include "Core/Meshing/Mesh/RefinedMesh.h"
#include "Pipeline/SkdBlocks.h"

#include <cstdint>
#include <vector>

namespace skdtree
{
/// All cells of all blocks. Points of equal coordinates, also of different blocks, are one node, so
/// that refined cells match across seams and blocks.
/// It reads whole cells, not surfaces, and so does not use SkdBlockSurface.
struct SkdReadMesh
{
  struct Block
  {
    SkdBlock Input;
    std::uint32_t FirstInput = 0; ///< cell c of the block is input cell FirstInput + c
    std::uint32_t FirstCell = 0;  ///< its cells in the refined mesh, as it was
    std::uint32_t LastCell = 0;   ///< one beyond
    std::vector<std::uint32_t> NodeOfPoint;
  };

  skd::RefinedMesh Mesh;
  std::vector<Block> Blocks;
  std::uint32_t NumberOfPointNodes = 0;
  vtkIdType CellsNotRefinable = 0; ///< of types that cannot be refined, degenerate or not finite
};

/// Fills it. Lines, triangles, quads and pixels, polygons, strips (as triangles), tetrahedra,
/// pyramids, wedges, hexahedra and voxels can be refined. All other cells are Fixed and without
/// nodes, and so are cells with points that are not finite and volume cells that use a node twice.
/// Repeated corners of polygons are removed. `counted` says which cells of each block count, of
/// blocks that several processes have in pieces; empty lists: all do; nullptr: those of all blocks.
/// Throws std::length_error if there are too many cells or points for 32-bit numbers.
void SkdReadBlocks(const std::vector<SkdBlock>& inputs,
  const std::vector<std::vector<unsigned char>>* counted, SkdReadMesh& read);
}

#endif
