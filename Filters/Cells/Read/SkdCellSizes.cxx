// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/Read/SkdCellSizes.h"

#include "Cells/Read/SkdShape.h"

#include "vtkCell.h"
#include "vtkCellType.h"
#include "vtkGenericCell.h"
#include "vtkSmartPointer.h"

#include <array>
#include <limits>

namespace skdtree
{
namespace
{
constexpr vtkIdType Any = std::numeric_limits<vtkIdType>::max();

/// Of types that VTK has no class for: no number of points is right.
constexpr SkdCellSizes NoSizes{ Any, 0 };

/// The number of points of a cell of this type, or 0 if it varies.
vtkIdType SizeWhenMade(int cellType)
{
  const auto cell = vtkSmartPointer<vtkCell>::Take(vtkGenericCell::InstantiateCell(cellType));
  return cell ? cell->GetNumberOfPoints() : 0;
}

/// The shapes of Lagrange and Bezier cells, in the order of VTK's types of them.
enum class HigherOrder
{
  Curve,
  Triangle,
  Quadrilateral,
  Tetrahedron,
  Hexahedron,
  Wedge,
  Other
};

/// VTK numbers the types of Lagrange cells in the order of HigherOrder, then a pyramid without a
/// class, then those of Bezier cells in the same order, so the distance from the first of a family
/// is the shape.
HigherOrder HigherOrderOf(int cellType)
{
  constexpr int shapes = static_cast<int>(HigherOrder::Other);
  for (const int first : { VTK_LAGRANGE_CURVE, VTK_BEZIER_CURVE })
  {
    const int shape = cellType - first;
    if (shape >= 0 && shape < shapes)
    {
      return static_cast<HigherOrder>(shape);
    }
  }
  return HigherOrder::Other;
}

SkdCellSizes FindSizes(int cellType)
{
  constexpr vtkIdType leastOfHigherOrder[] = { 2, 3, 4, 4, 8, 6 };
  const HigherOrder kind = HigherOrderOf(cellType);
  if (kind != HigherOrder::Other)
  {
    return { leastOfHigherOrder[static_cast<int>(kind)], Any };
  }
  const SkdShape shape = SkdShapeOfCellType(cellType);
  if (shape == SkdShape::None)
  {
    return cellType == VTK_EMPTY_CELL ? SkdCellSizes{ 0, 0 } : NoSizes;
  }
  const vtkIdType fixed =
    shape == SkdShape::Generic ? SizeWhenMade(cellType) : SkdNumberOfPoints(shape);
  if (fixed > 0)
  {
    return { fixed, fixed };
  }
  switch (cellType)
  {
    case VTK_POLY_VERTEX:
      return { 1, Any };
    case VTK_POLY_LINE:
      return { 2, Any };
    case VTK_POLYGON:
    case VTK_TRIANGLE_STRIP:
      return { 3, Any };
    case VTK_POLYHEDRON:
    case VTK_CONVEX_POINT_SET:
      return { 4, Any };
    case VTK_QUADRATIC_POLYGON:
      return { 6, Any };
    default:
      return { 0, Any };
  }
}

constexpr vtkIdType OfTriangle(vtkIdType n)
{
  return (n + 1) * (n + 2) / 2;
}

/// The points of a cell of degree n along all axes.
vtkIdType SizeOfDegree(HigherOrder kind, vtkIdType n)
{
  switch (kind)
  {
    case HigherOrder::Triangle:
      return OfTriangle(n);
    case HigherOrder::Quadrilateral:
      return (n + 1) * (n + 1);
    case HigherOrder::Tetrahedron:
      return OfTriangle(n) * (n + 3) / 3;
    case HigherOrder::Hexahedron:
      return (n + 1) * (n + 1) * (n + 1);
    case HigherOrder::Wedge:
      return OfTriangle(n) * (n + 1);
    default:
      return n + 1;
  }
}

/// VTK's three special cells: of degree 2, with more points in the middle of faces and of the cell.
bool IsSpecial(HigherOrder kind, vtkIdType size)
{
  return (kind == HigherOrder::Triangle && size == 7) ||
    (kind == HigherOrder::Tetrahedron && size == 15) || (kind == HigherOrder::Wedge && size == 21);
}

bool FitsSomeDegree(HigherOrder kind, vtkIdType size)
{
  vtkIdType n = kind == HigherOrder::Curve ? size - 1 : 1;
  while (SizeOfDegree(kind, n) < size)
  {
    ++n;
  }
  return SizeOfDegree(kind, n) == size || IsSpecial(kind, size);
}

// Degrees are stored as doubles, of any value.
bool FitsDegrees(HigherOrder kind, vtkIdType size, const double* n)
{
  const auto points = static_cast<double>(size);
  switch (kind)
  {
    case HigherOrder::Quadrilateral:
      return n[0] >= 1.0 && n[1] >= 1.0 && (n[0] + 1.0) * (n[1] + 1.0) == points;
    case HigherOrder::Hexahedron:
      return n[0] >= 1.0 && n[1] >= 1.0 && n[2] >= 1.0 &&
        (n[0] + 1.0) * (n[1] + 1.0) * (n[2] + 1.0) == points;
    case HigherOrder::Wedge:
      return n[0] >= 1.0 && n[1] == n[0] && n[2] >= 1.0 &&
        ((n[0] + 1.0) * (n[0] + 2.0) / 2.0 * (n[2] + 1.0) == points ||
          (n[0] == 2.0 && n[2] == 2.0 && IsSpecial(kind, size)));
    default:
      return FitsSomeDegree(kind, size);
  }
}
}

//------------------------------------------------------------------------------
SkdCellSizes SkdSizesOfCellType(int cellType)
{
  static const auto table = []
  {
    std::array<SkdCellSizes, VTK_NUMBER_OF_CELL_TYPES> sizes;
    for (int type = 0; type < VTK_NUMBER_OF_CELL_TYPES; ++type)
    {
      sizes[static_cast<std::size_t>(type)] = FindSizes(type);
    }
    return sizes;
  }();
  const bool isKnown = cellType >= 0 && cellType < VTK_NUMBER_OF_CELL_TYPES;
  return isKnown ? table[static_cast<std::size_t>(cellType)] : NoSizes;
}

//------------------------------------------------------------------------------
bool SkdFitsCellType(int cellType, vtkIdType size, const double* degrees)
{
  const SkdCellSizes sizes = SkdSizesOfCellType(cellType);
  if (size < sizes.Least || size > sizes.Most)
  {
    return false;
  }
  const HigherOrder kind = HigherOrderOf(cellType);
  if (kind == HigherOrder::Other)
  {
    return cellType != VTK_QUADRATIC_POLYGON || size % 2 == 0;
  }
  return degrees ? FitsDegrees(kind, size, degrees) : FitsSomeDegree(kind, size);
}
}
