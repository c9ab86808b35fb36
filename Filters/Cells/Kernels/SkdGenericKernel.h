// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdGenericKernel_h
#define SkdGenericKernel_h

#include "Cells/Kernels/SkdCellAnswers.h"
#include "Cells/Kernels/SkdCellSource.h"
#include "Core/Geometry/Box.h"
#include "Core/Geometry/Segment.h"

#include <limits>
#include <optional>

namespace skdtree
{
/// The exact tests of cells without a kernel of their own, by the cell itself.
namespace SkdGenericKernel
{
/// Outside a volume cell the nearest point is sought on its faces: what EvaluatePosition gives
/// there comes from clamped parametric coordinates and need not be nearest. What is farther than
/// limit2, a squared distance, need not be either.
SkdCellPoint Closest(
  vtkCell* cell, const skd::Vector3& x, double limit2 = std::numeric_limits<double>::infinity());

/// `bounds`: of the whole cell, which may reach beyond its points.
std::optional<SkdLineHit> Intersect(
  vtkCell* cell, const skd::Box3& bounds, const skd::Segment<3>& segment, double tolerance);

/// The sub-id, parametric coordinates and, unless nullptr, weights at a point of the cell found by
/// Closest: pass in its sub-id and parametric coordinates.
void Locate(
  vtkCell* cell, const skd::Vector3& point, int& subId, skd::Vector3& pcoords, double* weights);
}
}

#endif
