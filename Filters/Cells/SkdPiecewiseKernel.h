// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The exact tests of linear cells that are put together: a pentagonal or hexagonal prism of
/// wedges, a quadratic polygon (straight between its points, as VTK has it) of its points in turn.
#ifndef SkdPiecewiseKernel_h
#define SkdPiecewiseKernel_h

#include "Cells/SkdKernels.h"

class vtkCell;

namespace SkdPiecewiseKernel
{
bool Knows(int cellType);

SkdCellPoint Closest(vtkCell* cell, const skd::Vector3& x);

std::optional<SkdLineHit> Intersect(
  vtkCell* cell, const skd::Segment<3>& segment, const SkdReach& reach);

/// The parametric coordinates and, unless nullptr, weights at a point that Closest gave.
void Locate(vtkCell* cell, SkdCellPoint& found, double* weights);
}

#endif
