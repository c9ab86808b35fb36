// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdEdgeSums_h
#define SkdEdgeSums_h

#include "Core/Geometry/Vector.h"

#include <cstdint>

class vtkPolyData;

namespace skdtree
{
/// Whether surfaces pass each edge as often in one direction as in the other, also where their
/// triangles are on several processes: sums over the sides of all triangles of two numbers that
/// depend on the ends of each, with its sign. Both are 0 then, and else with a probability of
/// 2^-128, wherever triangles are and in whatever order they are added.
struct SkdEdgeSums
{
  std::uint64_t First = 0;
  std::uint64_t Second = 0;

  /// A side of a triangle.
  void Add(const skd::Vector3& from, const skd::Vector3& to);
  void Add(const SkdEdgeSums& other)
  {
    this->First += other.First;
    this->Second += other.Second;
  }
  bool AreZero() const { return this->First == 0 && this->Second == 0; }
};

/// Of all polygons of a surface.
SkdEdgeSums SkdSumEdges(vtkPolyData* surface);
}

#endif
