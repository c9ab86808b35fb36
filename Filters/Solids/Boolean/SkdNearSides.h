// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdNearSides_h
#define SkdNearSides_h

#include "Solids/Boolean/SkdRigidPair.h"

namespace skdtree
{
/// How often the other surface winds around facets and triangles of two surfaces.
struct SkdNearSides
{
  static constexpr int Near = std::numeric_limits<int>::max(); ///< of a triangle that is arranged

  std::vector<int> OfFacets;
  std::vector<int> OfClusters;     ///< of a pair; of those with such a triangle Near
  skd::RawVector<int> OfTriangles; ///< that are in clusters with one; of others nothing
};

/// Of a pair of which some triangles are arranged: `triangles` and `points` are what the facets of
/// `part` are numbered by, in the pair's set, where `whole` places it. Facets at an edge of both
/// surfaces tell it by their order around that, and are of one side of the other surface with all
/// that no such edge separates from them. What has no such edge is told by a line. Empty if they
/// contradict each other or edges are not of two facets of each surface. O(n).
std::optional<SkdNearSides> SkdFindNearSides(const SkdRigidPair& pair, const SkdPlacement& whole,
  const std::vector<std::uint32_t>& triangles, const std::vector<std::uint32_t>& points,
  const SkdArrangedPart& part);
}

#endif
