// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdOrientedBoundary_h
#define SkdOrientedBoundary_h

#include "Cells/Search/SkdCellTree.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <array>

namespace skdtree
{
class SkdSignedSource;

/// The triangles of a boundary, oriented outward, with their tree.
///
/// Triangles that share an edge with no third one are oriented consistently; the largest triangle
/// of each component decides its orientation. Components with the inside on both sides or on
/// neither (of overlapping bodies) have an arbitrary orientation.
class SkdOrientedBoundary
{
public:
  SkdOrientedBoundary(const SkdSignedSource& boundary, double epsilon);

  /// The fraction of a box, which is not flat along all axes, that is inside: of its volume, area
  /// or length. Exact to rounding if the boundary is closed and does not intersect itself.
  /// Thread-safe.
  double GetFraction(const skd::Box3& box) const;

private:
  std::array<skd::Vector3, 3> GetTriangle(vtkIdType triangle) const;
  bool PutCornerAway(const skd::Box3& box, vtkIdList* triangles, unsigned& corner) const;

  const SkdSignedSource& Boundary;
  vtkSmartPointer<vtkPolyData> Surface;
  SkdCellTree Tree;
  std::vector<bool> Reversed; // whether a triangle's normal points in
};
}

#endif
