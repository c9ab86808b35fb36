// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdMeshExtent_h
#define SkdMeshExtent_h

#include "Core/Geometry/Box.h"

#include <algorithm>

namespace skdtree
{
/// What the tolerances of a tree are relative to: of all cells in it, or of all cells of the mesh
/// that these are a part of. A new one is empty.
struct SkdMeshExtent
{
  skd::Box3 Bounds;               ///< of the cells
  double LargestCoordinate = 0.0; ///< of their points, without its sign

  void Add(const SkdMeshExtent& other)
  {
    this->Bounds.Add(other.Bounds);
    this->LargestCoordinate = std::max(this->LargestCoordinate, other.LargestCoordinate);
  }

  bool operator==(const SkdMeshExtent& other) const
  {
    const auto isSame = [](const skd::Vector3& a, const skd::Vector3& b)
    { return std::equal(a.X, a.X + 3, b.X); };
    return isSame(this->Bounds.Min, other.Bounds.Min) &&
      isSame(this->Bounds.Max, other.Bounds.Max) &&
      this->LargestCoordinate == other.LargestCoordinate;
  }
};
}

#endif
