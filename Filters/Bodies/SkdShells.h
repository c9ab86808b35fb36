// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdShells.h
 * @brief The closed shells that a closed surface of triangles is made of.
 */

#ifndef SkdShells_h
#define SkdShells_h

#include "Bodies/SkdTriangulation.h"
#include "Core/Geometry/Vector.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <array>
#include <cstdint>
#include <vector>

namespace skdtree
{
class SkdEdgePairs;

/// Components of triangles that are connected by edges of two triangles. An edge of more than two
/// triangles is divided into pairs of triangles: those with opposite directions along it if
/// possible, else in their order. So every shell of a surface without open edges is closed.
class SkdShells
{
public:
  struct Shell
  {
    double Volume = 0.0;     ///< signed, six times, of its triangles when they are oriented alike
    bool IsCoherent = true;  ///< its triangles are oriented alike as they are
    bool IsOneSided = false; ///< they cannot be, as on a Klein bottle
    std::array<skd::Vector3, 6> Extremes{}; ///< its lowest and highest points along each axis

    /// For a consistently oriented shell: 1 if its normals point outward, else -1.
    int GetSign() const { return this->Volume < 0.0 ? -1 : 1; }
  };

  /// An even number of triangles has each edge. O(n), about a tenth of what the boundary and its
  /// tree take.
  SkdShells(const std::vector<skd::Vector3>& points, const std::vector<SkdTriangleIds>& triangles);

  const std::vector<Shell>& Get() const { return this->Shells; }
  int GetShellOf(vtkIdType triangle) const { return this->ShellOf[triangle]; }
  const std::vector<int>& GetShellsOf() const { return this->ShellOf; }
  bool HasOneSided() const;

  /// One value a triangle: 1 for those that must be reversed for normals to point out of each
  /// single shell. nullptr if there are none.
  vtkUnsignedCharArray* GetReversed() const { return this->Reversed; }

private:
  void Follow(std::uint32_t first, const SkdEdgePairs& pairing);
  void Measure(
    const std::vector<skd::Vector3>& points, const std::vector<SkdTriangleIds>& triangles);
  void OrientOutward();

  std::vector<Shell> Shells;
  std::vector<int> ShellOf;
  vtkSmartPointer<vtkUnsignedCharArray> Reversed;
};

/// A number for each shell, the same for shells that are connected by touching shells: exact
/// contact tests, tree against tree, of shells whose boxes overlap. Most of the time is spent
/// reading the triangles again.
std::vector<int> SkdFindShellGroups(const std::vector<skd::Vector3>& points,
  const std::vector<SkdTriangleIds>& triangles, const SkdShells& shells);
}

#endif
