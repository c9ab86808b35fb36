// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdShells.h
 * @brief The closed shells that a closed surface of triangles is made of.
 */

#ifndef SkdShells_h
#define SkdShells_h

#include "Core/Geometry/Vector.h"
#include "Pipeline/SkdFeatureNormals.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <array>
#include <cstdint>
#include <vector>

/// Triangles that hang together by edges, each edge being one of two of them. Where more than two
/// meet in an edge they are taken in pairs: those that run against each other along it, if all can
/// be, else in their order. So every shell of a surface without open edges is closed.
class SkdShells
{
public:
  struct Shell
  {
    double Volume = 0.0;     ///< signed, six times, of its triangles when they are turned alike
    bool IsCoherent = true;  ///< its triangles are turned alike as they are
    bool IsOneSided = false; ///< they cannot be, as on a Klein bottle
    std::array<skd::Vector3, 6> Extremes{}; ///< its lowest and highest points along each axis

    /// Of one that is coherent: 1 when its normals point out, else -1.
    int GetSign() const { return this->Volume < 0.0 ? -1 : 1; }
  };

  /// An even number of triangles has each edge. O(n), about a tenth of what the boundary and its
  /// tree take.
  SkdShells(const std::vector<skd::Vector3>& points, const std::vector<SkdTriangleIds>& triangles);

  const std::vector<Shell>& Get() const { return this->Shells; }
  int GetShellOf(vtkIdType triangle) const { return this->ShellOf[triangle]; }
  const std::vector<int>& GetShellsOf() const { return this->ShellOf; }
  bool HasOneSided() const;

  /// One value a triangle: 1 of those that must be turned for all normals to point out of their
  /// shells, each taken for itself. nullptr if none must.
  vtkUnsignedCharArray* GetTurned() const { return this->Turned; }

private:
  class Pairing;

  void Follow(std::uint32_t first, const Pairing& pairing);
  void Measure(
    const std::vector<skd::Vector3>& points, const std::vector<SkdTriangleIds>& triangles);
  void TurnOutward();

  std::vector<Shell> Shells;
  std::vector<int> ShellOf;
  vtkSmartPointer<vtkUnsignedCharArray> Turned;
};

/// A number for each shell, the same for those that are connected by shells that touch: found tree
/// against tree by exact contact, of those whose boxes overlap. To read the triangles again is most
/// of what it takes, where shells that cross each other do so in many places.
std::vector<int> SkdFindShellGroups(const std::vector<skd::Vector3>& points,
  const std::vector<SkdTriangleIds>& triangles, const SkdShells& shells);

#endif
