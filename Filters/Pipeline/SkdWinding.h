// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdWinding.h
 * @brief The generalised winding number of a surface, with the tree that it is summed over.
 */

#ifndef SkdWinding_h
#define SkdWinding_h

#include "Core/Queries/WindingNumber.h"

#include <vector>

class vtkPolyData;

/// Tells inside from outside where a surface has gaps, meets itself or is there twice; see
/// Core/Queries/WindingNumber.h. Constant once made: any number of threads may ask. The surface
/// itself is not kept.
class SkdWinding
{
public:
  /// Of triangles: of bodies that touch, SkdBoundary's surface, whose equal faces are left out
  /// (their solid angles cancel only if they are turned against each other). `isTurned` tells which
  /// are to be turned around, one value a triangle (see SkdFindTurned), or is empty: none is.
  explicit SkdWinding(vtkPolyData* triangles, const std::vector<bool>& isTurned = {});

  SkdWinding(const SkdWinding&) = delete;
  void operator=(const SkdWinding&) = delete;

  /// 1 inside a closed surface whose normals point out, 0 outside, -1 inside one that is inside
  /// out; between these near gaps. 0 without triangles, NaN of a point that is not finite. Off by
  /// at most `tolerance`, and never on the wrong side of 1/2 or -1/2: see
  /// skd::WindingNumber::Decide.
  skd::WindingNumber::Sum Ask(const double x[3], double tolerance) const;

  /// The number of Ask(), whatever tolerance is the fastest.
  double At(const double x[3]) const;

  /// Whether the number is at least 1/2, or at most -1/2: triangles that all point inward do no
  /// harm.
  bool IsInside(const double x[3]) const;

private:
  SkdWinding(const std::vector<skd::WindingNumber::Triangle>& triangles);

  skd::Tree<3> Tree;
  skd::WindingNumber Number; // refers to Tree
};

#endif
