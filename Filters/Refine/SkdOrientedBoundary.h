// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdOrientedBoundary_h
#define SkdOrientedBoundary_h

#include "Cells/SkdCellTree.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <array>

class SkdSignedSource;

/// The triangles of a boundary, all turned so that their normals point out, with a tree of them.
///
/// Triangles that share an edge, which no third triangle uses, are turned alike; of those that hang
/// together so the largest is asked on which side the inside is. Triangles that have the inside on
/// both sides or on none (of bodies that overlap) are turned by guess.
class SkdOrientedBoundary
{
public:
  SkdOrientedBoundary(const SkdSignedSource& boundary, double epsilon);

  /// How much of a box that is not flat along all axes is inside: a volume, an area or a length,
  /// relative to that of the box. Exact but for rounding where the boundary is closed and does not
  /// meet itself. Thread-safe.
  double GetFraction(const skd::Box3& box) const;

private:
  std::array<skd::Vector3, 3> GetTriangle(vtkIdType triangle) const;
  void TurnAlike();
  bool IsInward(const std::vector<vtkIdType>& piece) const;
  bool PutCornerAway(const skd::Box3& box, vtkIdList* triangles, unsigned& corner) const;

  const SkdSignedSource& Boundary;
  vtkSmartPointer<vtkPolyData> Surface;
  SkdCellTree Tree;
  std::vector<char> Turned; // whether a triangle's normal points in
};

#endif
