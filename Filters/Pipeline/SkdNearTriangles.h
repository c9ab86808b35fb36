// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdNearTriangles.h
 * @brief Two surfaces that meet once: the triangles of each that may meet any of the other, alone
 * in trees.
 */

#ifndef SkdNearTriangles_h
#define SkdNearTriangles_h

#include "Core/Tree/LazyTree.h"
#include "Pipeline/SkdPlacement.h"

#include <optional>
#include <vector>

/// Some triangles of a placed set, ascending, and a tree of their boxes where they are placed.
struct SkdNearTriangles
{
  std::vector<std::uint32_t> Triangles;
  skd::LazyTree<3> Tree{ skd::TreeInput<3>{} };
};

struct SkdNearSets
{
  SkdNearTriangles First;
  SkdNearTriangles Second;
};

/// Of both sets of a placement those triangles that share a cell of a coarse raster with the other
/// set, or may be within `clearance` (in the placement's scale) of it. Nothing when they are not
/// much fewer than all. O(n), some ten nanoseconds a triangle.
std::optional<SkdNearSets> SkdFindNear(const SkdPlacement& placement, double clearance);

#endif
