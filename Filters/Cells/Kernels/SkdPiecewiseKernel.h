// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The exact tests of composed linear cells: a pentagonal or hexagonal prism of wedges, a quadratic
/// polygon (straight between its points, as in VTK) of its points in order.
#ifndef SkdPiecewiseKernel_h
#define SkdPiecewiseKernel_h

#include "Cells/Kernels/SkdCellAnswers.h"
#include "Core/Geometry/Segment.h"

#include <optional>

class vtkCell;

namespace skdtree
{
namespace SkdPiecewiseKernel
{
bool Knows(int cellType);

SkdCellPoint Closest(vtkCell* cell, const skd::Vector3& x);

std::optional<SkdLineHit> Intersect(
  vtkCell* cell, const skd::Segment<3>& segment, const SkdHitTolerance& hitTolerance);

/// The parametric coordinates and, unless nullptr, weights at a point that Closest gave.
void Locate(vtkCell* cell, SkdCellPoint& found, double* weights);
}
}

#endif
