// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdWinding.h
 * @brief The generalized winding number of a surface, with the tree for its summation.
 */

#ifndef SkdWinding_h
#define SkdWinding_h

#include "Core/Search/Queries/WindingNumber.h"

#include <vector>

class vtkPolyData;

namespace skdtree
{
/// An inside test for surfaces with gaps, self-intersections or duplicate faces; see
/// Core/Search/Queries/WindingNumber.h. Immutable and thread-safe. The surface itself is not kept.
class SkdWinding
{
public:
  /// Of triangles: of bodies that touch, SkdBoundary's surface, whose equal faces are left out
  /// (their solid angles cancel only if they are oriented against each other). `isReversed` marks
  /// those to be reversed, one value a triangle (see SkdFindReversed), or is empty.
  explicit SkdWinding(vtkPolyData* triangles, const std::vector<bool>& isReversed = {});
  explicit SkdWinding(const std::vector<skd::WindingNumber::Triangle>& triangles);

  SkdWinding(const SkdWinding&) = delete;
  void operator=(const SkdWinding&) = delete;

  /// 1 inside a closed surface with outward normals, 0 outside, -1 inside one with inward normals;
  /// values in between near gaps. 0 without triangles, NaN for a point that is not finite. The
  /// error is at most `tolerance`, and never crosses 1/2 or -1/2: see skd::WindingNumber::Decide.
  skd::WindingNumber::Sum Ask(const double x[3], double tolerance) const;

  /// The number of Ask(), whatever tolerance is the fastest.
  double At(const double x[3]) const;

  /// At least the share of directions in which x sees the triangles, overlapping ones counted
  /// repeatedly, but at most 1/2.
  double BoundShare(const double x[3]) const
  {
    return this->Number.BoundMagnitudes({ { x[0], x[1], x[2] } });
  }

  /// Whether the number is at least 1/2, or at most -1/2, so that inward orientation is accepted.
  bool IsInside(const double x[3]) const;

private:
  skd::Tree<3> Tree;
  skd::WindingNumber Number; // refers to Tree
};
}

#endif
