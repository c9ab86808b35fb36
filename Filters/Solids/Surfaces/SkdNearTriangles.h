// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdNearTriangles.h
 * @brief One-shot intersection of two surfaces: the triangles of each that may intersect the other.
 */

#ifndef SkdNearTriangles_h
#define SkdNearTriangles_h

#include "Solids/Surfaces/SkdPlacement.h"

#include <optional>
#include <vector>

namespace skdtree
{
/// Some triangles of a placed set, ascending, and their boxes after the placement.
struct SkdNearTriangles
{
  std::vector<std::uint32_t> Triangles;
  std::vector<skd::Box3> Boxes;
};

struct SkdNearSets
{
  SkdNearTriangles First;
  SkdNearTriangles Second; ///< its boxes are larger by the clearance, and a little more
  bool HasCopies = false;  ///< some triangles are left out: see SkdFindCopies
};

/// The triangles of both sets of a placement that share a cell of a coarse grid with the other set,
/// or may be within `clearance` (in the placement's scale) of it. Empty if the sets are small, or
/// unless these are much fewer than all. O(n), some ten nanoseconds a triangle.
std::optional<SkdNearSets> SkdFindNear(const SkdPlacement& placement, double clearance);

/// The same of one set: those of its triangles before one number and those from it on that may
/// intersect each other. Empty if they cover too many cells of the grid.
std::optional<SkdNearSets> SkdFindNear(const SkdMovedTriangles& set, std::uint32_t middle);
}

#endif
