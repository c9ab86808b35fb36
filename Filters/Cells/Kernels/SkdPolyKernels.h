// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The exact tests of cells of any number of points: polygons, strips, polylines, polyvertices and
/// polyhedra. They are accurate at any scale, and thread-safe.
#ifndef SkdPolyKernels_h
#define SkdPolyKernels_h

#include "Cells/Kernels/SkdCellAnswers.h"
#include "Cells/Kernels/SkdPolyCell.h"
#include "Core/Geometry/Box.h"

#include <optional>

namespace skd
{
class SegmentView;
}

namespace skdtree
{
namespace SkdPolyKernels
{
/// The nearest point within limit2. Locate() computes the parametric coordinates of polygons and
/// polyhedra.
SkdCellPoint Closest(const SkdPolyCell& cell, const skd::Vector3& x, double limit2);

std::optional<SkdLineHit> Intersect(
  const SkdPolyCell& cell, const skd::SegmentView& view, const SkdHitTolerance& hitTolerance);

/// Completes VTK's parametric coordinates and, unless nullptr, the weights at a point found by
/// Closest().
void Locate(const SkdPolyCell& cell, SkdCellPoint& found, double* weights);

/// The parametric coordinates of a polyhedron as in VTK.
skd::Vector3 PCoordsInBounds(const skd::Box3& bounds, const skd::Vector3& x);
}
}

#endif
