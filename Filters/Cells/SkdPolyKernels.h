// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The exact tests of cells of any number of points: polygons, strips, polylines, polyvertices and
/// polyhedra. What the mathematics promises holds for them at any scale, and in any thread.
#ifndef SkdPolyKernels_h
#define SkdPolyKernels_h

#include "Cells/SkdKernels.h"
#include "Core/Geometry/Cells/Polyhedron.h"

/// Such a cell, its points gathered. Faces and FacesEnd are those of PolyhedronView.
struct SkdPolyCell
{
  SkdShape Shape;
  const skd::Vector3* Points;
  int Size; ///< at least 1
  const std::uint32_t* Faces;
  const std::uint32_t* FacesEnd;

  skd::PolyhedronView AsPolyhedron() const
  {
    return { this->Points, this->Size, this->Faces, this->FacesEnd };
  }
};

namespace SkdPolyKernels
{
/// The nearest point, nothing farther than limit2 matters. Parametric coordinates of polygons and
/// polyhedra are left to Locate().
SkdCellPoint Closest(const SkdPolyCell& cell, const skd::Vector3& x, double limit2);

std::optional<SkdLineHit> Intersect(
  const SkdPolyCell& cell, const skd::SegmentView& view, const SkdReach& reach);

/// Completes the parametric coordinates, VTK's, and unless nullptr the weights at a point that
/// Closest() has found.
void Locate(const SkdPolyCell& cell, SkdCellPoint& found, double* weights);

/// What VTK takes for the parametric coordinates of a polyhedron.
skd::Vector3 PCoordsInBounds(const skd::Box3& bounds, const skd::Vector3& x);
}

#endif
