// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdOrientedWalls_h
#define SkdOrientedWalls_h

#include "Cells/SkdCellTree.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <array>

class SkdSignedSource;

/// The walls of a boundary, all turned so that their normals point out, with a tree of them.
///
/// Walls that share an edge, which no third wall uses, are turned alike; of those that hang
/// together so the largest is asked on which side the inside is. Walls that have the inside on both
/// sides or on none (of bodies that overlap) are turned by guess.
class SkdOrientedWalls
{
public:
  SkdOrientedWalls(const SkdSignedSource& boundary, double epsilon);

  /// How much of a box that is not flat along all axes is inside: a volume, an area or a length,
  /// relative to that of the box. Exact but for rounding where the boundary is closed and does not
  /// meet itself. Thread-safe.
  double GetFraction(const skd::Box3& box) const;

private:
  std::array<skd::Vector3, 3> GetWall(vtkIdType wall) const;
  void TurnAlike();
  bool IsInward(const std::vector<vtkIdType>& piece) const;
  bool PutCornerAway(const skd::Box3& box, vtkIdList* walls, unsigned& corner) const;

  const SkdSignedSource& Boundary;
  vtkSmartPointer<vtkPolyData> Walls;
  SkdCellTree Tree;
  std::vector<char> Turned; // whether a wall's normal points in
};

#endif
