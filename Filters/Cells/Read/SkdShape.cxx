// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/Read/SkdShape.h"

#include "vtkCellType.h"
#include "vtkGenericCell.h"
#include "vtkSmartPointer.h"

#include <array>
#include <cstddef>
#include <iterator>

namespace skdtree
{
namespace
{
bool IsKnownToVTK(int cellType)
{
  const auto cell = vtkSmartPointer<vtkCell>::Take(vtkGenericCell::InstantiateCell(cellType));
  return cell != nullptr;
}

SkdShape FindShape(int cellType)
{
  switch (cellType)
  {
    case VTK_EMPTY_CELL:
      return SkdShape::None;
    case VTK_VERTEX:
      return SkdShape::Vertex;
    case VTK_LINE:
      return SkdShape::Line;
    case VTK_TRIANGLE:
      return SkdShape::Triangle;
    case VTK_TRIANGLE_STRIP:
      return SkdShape::Strip;
    case VTK_POLYGON:
      return SkdShape::Polygon;
    case VTK_POLY_LINE:
      return SkdShape::PolyLine;
    case VTK_POLY_VERTEX:
      return SkdShape::PolyVertex;
    case VTK_POLYHEDRON:
    case VTK_CONVEX_POINT_SET: // by its hull
      return SkdShape::Polyhedron;
    case VTK_PIXEL:
      return SkdShape::Pixel;
    case VTK_QUAD:
      return SkdShape::Quad;
    case VTK_TETRA:
      return SkdShape::Tetrahedron;
    case VTK_VOXEL:
      return SkdShape::Voxel;
    case VTK_HEXAHEDRON:
      return SkdShape::Hexahedron;
    case VTK_WEDGE:
      return SkdShape::Wedge;
    case VTK_PYRAMID:
      return SkdShape::Pyramid;
    default:
      return IsKnownToVTK(cellType) ? SkdShape::Generic : SkdShape::None;
  }
}

std::array<SkdShape, VTK_NUMBER_OF_CELL_TYPES> MakeShapeTable()
{
  std::array<SkdShape, VTK_NUMBER_OF_CELL_TYPES> table;
  for (int cellType = 0; cellType < VTK_NUMBER_OF_CELL_TYPES; ++cellType)
  {
    table[static_cast<std::size_t>(cellType)] = FindShape(cellType);
  }
  return table;
}
}

//------------------------------------------------------------------------------
SkdShape SkdShapeOfCellType(int cellType)
{
  static const std::array<SkdShape, VTK_NUMBER_OF_CELL_TYPES> table = MakeShapeTable();
  const bool isKnown = cellType >= 0 && cellType < VTK_NUMBER_OF_CELL_TYPES;
  return isKnown ? table[static_cast<std::size_t>(cellType)] : SkdShape::None;
}

//------------------------------------------------------------------------------
int SkdCellTypeOfShape(SkdShape shape)
{
  static constexpr std::uint8_t types[] = { VTK_VERTEX, VTK_LINE, VTK_TRIANGLE, VTK_PIXEL, VTK_QUAD,
    VTK_TETRA, VTK_VOXEL, VTK_HEXAHEDRON, VTK_WEDGE, VTK_PYRAMID, VTK_POLYGON, VTK_TRIANGLE_STRIP,
    VTK_POLY_LINE };
  const auto index = static_cast<std::size_t>(shape);
  return index < std::size(types) ? int(types[index]) : int(VTK_EMPTY_CELL);
}
}
