// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdCellCheck_h
#define SkdCellCheck_h

#include "vtkType.h"

#include <string>
#include <vector>

class vtkDataSet;

namespace skdtree
{
/// The cells of a data set that must not be read, in particular by VTK. A cell is broken if
/// - its points are not in the list of all cells' points: offsets that decrease or end beyond it,
/// - it uses a point id out of range,
/// - VTK has no class for its type: types that it declares or reserves only, and unknown ones,
/// - it has too few points for its type, or more than its type has; of a cell of vtkPolyData that
///   has none nothing is missing: it is empty,
/// - it is a polyhedron whose faces are not polygons of its points.
struct SkdBrokenCells
{
  std::vector<vtkIdType> Ids; ///< ascending

  /// How many of them are faults and the first of these. No fault are hidden cells: those of
  /// blanked grids and AMR have no type but all their points where VTK has appended the grids.
  vtkIdType Faults = 0;
  vtkIdType FirstFault = -1;
  std::string Fault; ///< of the first, as a predicate: "has 3 points, ..."

  /// "2 of 9 cells are broken and ignored; the first is cell 4, has 3 points, ...".
  std::string Tell(vtkDataSet* data) const;
};

/// Checks each cell once, in parallel: one or two nanoseconds each, a few times more for polyhedra.
/// Implicit cells, such as those of images, are not checked.
SkdBrokenCells SkdFindBrokenCells(vtkDataSet* data);
}

#endif
