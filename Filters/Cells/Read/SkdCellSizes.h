// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdCellSizes_h
#define SkdCellSizes_h

#include "vtkType.h"

namespace skdtree
{
/// Numbers of points that a cell may have.
struct SkdCellSizes
{
  vtkIdType Least;
  vtkIdType Most;
};

/// Those of a cell of this VTK type, whatever its number. Some numbers between are none of a
/// Lagrange, Bezier or quadratic polygon's: see SkdFitsCellType. None, that is Least > Most, of
/// types that VTK has no class for: its functions call the missing object.
SkdCellSizes SkdSizesOfCellType(int cellType);

/// Whether a cell of this type may have this number of points. `degrees` are the three of a cell
/// whose data set has HigherOrderDegrees, else nullptr.
bool SkdFitsCellType(int cellType, vtkIdType size, const double* degrees);
}

#endif
