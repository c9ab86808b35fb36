// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdShape_h
#define SkdShape_h

#include <cstdint>

/// What the exact tests see in a cell. Each shape but Generic has a kernel of its own
/// (SkdKernels.h, SkdPolyKernels.h) that reads raw points; Generic goes through vtkGenericCell
/// (SkdGenericKernel.h).
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

/// The points of a cell of this shape, or 0 when that is up to the cell.
inline int SkdNumberOfPoints(SkdShape shape)
{
  constexpr int numbers[] = { 1, 2, 3, 4, 4, 4, 8, 8, 6, 5, 0, 0, 0, 0, 0, 0, 0 };
  return numbers[static_cast<int>(shape)];
}

#endif
