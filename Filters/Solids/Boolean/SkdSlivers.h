// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdSlivers.h
 * @brief Facets that are flat to within rounding: needles are collapsed and caps are flipped, as in
 * Botsch and Kobbelt, "A robust procedure to eliminate degenerate faces from triangle meshes",
 * 2001.
 *
 * Turned solids that touch have faces and edges that lie in one plane, or on one line, but for
 * rounding. They cross each other anywhere, and what is between them are slivers, whose planes mean
 * nothing: pieces beside them could not be joined, and further operations would split them again.
 */

#ifndef SkdSlivers_h
#define SkdSlivers_h

#include "Solids/Boolean/SkdRoundedFacets.h"

namespace skdtree
{
/// Whether pieces are slivers (see below), of facets that have a sign.
bool SkdHaveSlivers(
  const SkdPlacement& placement, const SkdFacets& facets, const SkdFacetSigns& signs);

/// Takes slivers out of a boundary: pieces whose least height is below 16 units in the last place
/// of their largest coordinate, but not triangles of the set, whose edges stay as well. Does
/// nothing to `rounded` if there are none; else it is these facets, or itself if it is there,
/// without slivers and by ascending parent. They pass each edge in both directions as often as
/// before. O(n), a few nanoseconds for each facet, and O(n log n) where there are slivers.
void SkdRemoveSlivers(const SkdPlacement& placement, const SkdFacets& facets,
  const SkdFacetSigns& signs, std::optional<SkdRoundedFacets>& rounded);
}

#endif
