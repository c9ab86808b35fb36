// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdOwnBoxes_h
#define SkdOwnBoxes_h

#include "Meshing/Refine/SkdGrid.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace skdtree
{
/// Where a process refines its grid: the own base cells and those that are at most so many layers
/// away, each row of them as a line along the diagonal of its box. `boxes` remains the same object
/// if it has these already.
void SkdUpdateOwnBoxes(const SkdGrid& grid, int layers, vtkSmartPointer<vtkPolyData>& boxes);
}

#endif
