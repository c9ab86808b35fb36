// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdGridFields_h
#define SkdGridFields_h

#include "Meshing/Refine/SkdGrid.h"

#include <string>
#include <vector>

class vtkCellData;

namespace skdtree
{
/// The values of a field in the cells of a grid.
struct SkdGridField
{
  std::string Name;
  int Components = 1;
  std::vector<std::vector<double>> Values; ///< by level, tuple after tuple; NaN: none
};

/// Fields of doubles from the leaves to all cells: a refined cell has the mean of its children,
/// weighted by how much of each is covered (the array of this name), so that each level has the
/// same integrals. The coverage is a field as well. O(cells).
std::vector<SkdGridField> SkdSpreadFields(const SkdGrid& grid,
  const std::vector<SkdGridCell>& leaves, vtkCellData* ofLeaves, const char* coverage);
}

#endif
