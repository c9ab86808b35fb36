// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file GridBoxes.h
 * @brief boxes with corners on a grid, and which of its cells an operation on them leaves
 */
#ifndef skdtest_GridBoxes_h
#define skdtest_GridBoxes_h

#include "Support/Point.h"
#include "vtkSkdTreeBooleanOperation.h"

#include <bitset>

namespace skdtest
{

/// Of cells on a side.
constexpr int GridSize = 5;
using GridCells = std::bitset<GridSize * GridSize * GridSize>;

/// A box with corners on the grid, and which of its cells are within.
struct GridBox
{
  explicit GridBox(Random& random)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const int low = random.Index(GridSize - 1);
      this->Low[axis] = low;
      this->High[axis] = low + 1 + random.Index(GridSize - 1 - low);
    }
    for (int cell = 0; cell < static_cast<int>(this->Cells.size()); ++cell)
    {
      const int at[] = { cell % GridSize, cell / GridSize % GridSize, cell / GridSize / GridSize };
      bool isIn = true;
      for (int axis = 0; axis < 3; ++axis)
      {
        isIn = isIn && at[axis] >= this->Low[axis] && at[axis] < this->High[axis];
      }
      this->Cells[static_cast<std::size_t>(cell)] = isIn;
    }
  }

  Point Low, High;
  GridCells Cells;
};

inline GridCells CombineCells(const GridCells& a, const GridCells& b, int operation)
{
  return operation == vtkSkdTreeBooleanOperation::UNION   ? a | b
    : operation == vtkSkdTreeBooleanOperation::DIFFERENCE ? a & ~b
                                                          : a ^ b;
}

/// How many sides of cells bound them.
inline int AreaOf(const GridCells& cells)
{
  constexpr int steps[] = { 1, GridSize, GridSize * GridSize };
  int sides = 0;
  for (int cell = 0; cell < static_cast<int>(cells.size()); ++cell)
  {
    for (const int step : steps)
    {
      const auto isAt = [&](int other) { return cells[static_cast<std::size_t>(other)]; };
      const int at = cell / step % GridSize;
      sides += isAt(cell) && (at == 0 || !isAt(cell - step));
      sides += isAt(cell) && (at == GridSize - 1 || !isAt(cell + step));
    }
  }
  return sides;
}

/// By a matrix of thirds, whose results are rounded.
inline Point Turned(const Point& p)
{
  return { (2 * p[0] - 2 * p[1] + p[2]) / 3, (p[0] + 2 * p[1] + 2 * p[2]) / 3,
    (-2 * p[0] - p[1] + 2 * p[2]) / 3 };
}

}

#endif
