// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdMovedMesh.h
 * @brief The surface cells of data sets as one mesh whose points move, and the data sets then.
 */

#ifndef SkdMovedMesh_h
#define SkdMovedMesh_h

#include "Core/Meshing/Adaptation/SurfaceMesh.h"
#include "Pipeline/SkdBlocks.h"
#include "vtkPolyData.h"

#include <string>

namespace skdtree
{
/// Triangles, quads, pixels and polygons of all blocks. Points of equal coordinates are one, be
/// they of different blocks: so seams stay closed. Points of other cells of two dimensions or more
/// (their number is CellsLeftOut) stay where they are, and so do those of broken polygons. Hidden
/// cells are none of it; points that they alone use stay where they are. Points and cells are in
/// the order of coordinates, whatever order the blocks have.
class SkdMovedMesh
{
public:
  explicit SkdMovedMesh(const std::vector<SkdBlock>& blocks);

  skd::SurfaceMesh Mesh;
  vtkIdType CellsLeftOut = 0;

  /// The mesh as it was read, or as it is at the time of the call, with its points less an origin.
  vtkSmartPointer<vtkPolyData> MakePolyData(const skd::Vector3& origin) const;

  /// Gives a block's copy its new points, and their displacements.
  void SetPoints(std::size_t block, vtkPointSet* output) const;

  /// A block's cell values as an array, NaN of cells that are none of the mesh's.
  void AddCellArray(std::size_t block, vtkDataSet* output, const char* name,
    const std::vector<double>& values) const;

  /// What a message calls a cell of the mesh: its number in Input, and in which block if there are
  /// several.
  std::string NameOf(std::uint32_t cell) const;

private:
  class Reader;
  struct Block
  {
    int Index = 0;                          // flat, in the composite data
    std::vector<std::uint32_t> NodeOfPoint; // None of points that no shown cell has
    std::vector<std::uint32_t> CellOfCell;
  };

  std::vector<Block> Blocks;
};
}

#endif
