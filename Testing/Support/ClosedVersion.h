// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ClosedVersion.h
 * @brief leaky surfaces closed in two ways, to mark points that are inside of what was meant
 */
#ifndef skdtest_ClosedVersion_h
#define skdtest_ClosedVersion_h

#include "Support/MeshBuilder.h"

namespace skdtest
{

/// A surface of triangles without its gaps.
struct ClosedVersion
{
  /// Each triangle once, and fans over the gaps: the edges that an odd number of triangles use are
  /// loops, and each loop is joined to its middle. So every edge is used an even number of times.
  explicit ClosedVersion(const Mesh& triangles);

  Mesh Whole;
  Mesh Fans; // alone
};

/// What a ball cannot reach from outside without touching the surface: of the points of a lattice
/// over its bounds and somewhat more, those that are farther than the radius from it, and whether
/// the ball's centre gets there in steps of the lattice, which is a radius wide.
struct BallRadius
{
  BallRadius(vtkPolyData* surface, double radius);

  std::vector<Point> Points;
  std::vector<bool> IsCovered;
};

}

#endif
