// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdShape_h
#define SkdShape_h

#include <cstdint>

namespace skdtree
{
/// The shape of a cell for exact tests. Each shape except Generic has its own kernel (SkdKernels.h,
/// SkdPolyKernels.h) that reads raw points; Generic uses vtkGenericCell (SkdGenericKernel.h).
enum class SkdShape : std::uint8_t
{
  Vertex,
  Line,
  Triangle,
  Pixel,
  Quad,
  Tetrahedron,
  Voxel,
  Hexahedron,
  Wedge,
  Pyramid,
  Polygon, // from here on the number of points is up to the cell
  Strip,
  PolyLine,
  PolyVertex,
  Polyhedron,
  Generic,
  None // empty cells and cells of a type that VTK does not know: not in the tree
};

/// The table: VTK's cell type -> shape.
SkdShape SkdShapeOfCellType(int cellType);

/// VTK's type of the cells of a shape; VTK_EMPTY_CELL of shapes that several types have.
int SkdCellTypeOfShape(SkdShape shape);

/// The number of points of a cell of this shape, or 0 if it varies.
inline int SkdNumberOfPoints(SkdShape shape)
{
  constexpr int numbers[] = { 1, 2, 3, 4, 4, 4, 8, 8, 6, 5, 0, 0, 0, 0, 0, 0, 0 };
  return numbers[static_cast<int>(shape)];
}
}

#endif
