// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdCellCheck_h
#define SkdCellCheck_h

#include "vtkType.h"

#include <string>
#include <vector>

class vtkDataSet;

/// The cells of a data set that nothing may read, VTK least of all. A cell is broken if
/// - its points are not in the list of all cells' points: offsets that decrease or end beyond it,
/// - it names a point that the data set does not have,
/// - it has too few points for its type, or more than its type has; of a cell of vtkPolyData that
///   has none nothing is missing: it is empty,
/// - it is a polyhedron whose faces are not polygons of its points.
struct SkdBrokenCells
{
  std::vector<vtkIdType> Ids; ///< ascending
  std::string Fault;          ///< of the first, as a predicate: "has 3 points, ..."

  /// "2 of 9 cells are broken and left out; the first, cell 4, has 3 points, ...".
  std::string Tell(vtkDataSet* data) const;
};

/// Looks at each cell once, in parallel: a nanosecond or two each, of polyhedra a few times more.
/// Cells that no file can break, as those of images, are not looked at.
SkdBrokenCells SkdFindBrokenCells(vtkDataSet* data);

#endif
