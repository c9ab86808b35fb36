// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdMeshReader.h
 * @brief Data sets as one mesh that can be refined.
 */

#ifndef SkdMeshReader_h
#define SkdMeshReader_h

#include "Core/Mesh/RefinedMesh.h"
#include "Pipeline/SkdBlocks.h"

#include <cstdint>
#include <vector>

/// All cells of all blocks. Points of equal coordinates are one node, be they of different blocks:
/// so what is refined fits together across seams and blocks.
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
/// nodes, and so are those of points that are not finite and volume cells that use a node twice.
/// Polygons lose corners that repeat the one before. Without duplicates, ghost cells that are those
/// of other processes are left out. Throws std::length_error where there are more cells or points
/// than 32-bit numbers tell apart.
void SkdReadBlocks(const std::vector<SkdBlock>& inputs, bool withDuplicates, SkdReadMesh& read);

#endif
