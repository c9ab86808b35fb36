// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdJoinPieces.h
 * @brief Pieces of one face that stay together are one face again.
 */

#ifndef SkdJoinPieces_h
#define SkdJoinPieces_h

#include "Solids/Boolean/SkdFaceSets.h"
#include "Solids/Boolean/SkdRoundedFacets.h"

namespace skdtree
{
/// The pieces of flat faces joined and triangulated anew: without points that only they had, and
/// without points on straight lines between faces, on all sides of these. A point leaves such
/// a line only by what its rounding was. A face that could not be triangulated without its points
/// keeps them. Faces that are not cut stay as they are.
///
/// `origins` are, of each triangle of the placed set, twice the triangle of the set of `faces` that
/// it is of, and 1 more if it is reversed; empty if these sets are the same. Faces that are cut
/// become one where they have an edge in common and lie in one plane (SkdFaceSets::Unite).
///
/// The result has the facets of the boundary only, by ascending parent; its facets bound what they
/// bounded before, to within rounding, and pass each edge as often in both directions. It has no
/// table of edges. `given` are the facets, if they are to be forgotten when others take their
/// place. Empty if nothing is to be joined. O(n log n) for the facets of faces that are cut, and
/// O(n) with a few nanoseconds for others.
std::optional<SkdRoundedFacets> SkdJoinPieces(const SkdPlacement& placement,
  const SkdFacets& facets, const SkdFacetSigns& signs, const std::vector<std::uint32_t>& origins,
  SkdFaceSets& faces, SkdRoundedFacets* given = nullptr);
}

#endif
