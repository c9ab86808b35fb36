// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdFacingFacets_h
#define SkdFacingFacets_h

#include "Solids/Boolean/SkdBooleanRule.h"
#include "Solids/Boolean/SkdFacets.h"

#include <utility>
#include <vector>

namespace skdtree
{
class SkdFaceSets;

/// Whether triangles of one plane overlap by more than the tolerance, as seen along its normal.
bool SkdDoOverlap(const std::array<skd::Vector3, 3>& a, const std::array<skd::Vector3, 3>& b,
  const skd::Vector3& normal, double tolerance);

/// Pairs of facets of a boundary that lie on each other face to face, in one plane but for
/// rounding, ascending. They need not touch: a solid that lies in a face of another may be off it
/// by rounding, all around. Slivers are not looked at. `origins` as for SkdJoinPieces. O(n), a few
/// hundred instructions for each facet, and O(m log m) for those in a plane in which others face
/// the other way, if they overlap few of them.
std::vector<std::pair<std::uint32_t, std::uint32_t>> SkdFindFacingFacets(
  const SkdMovedTriangles& set, const SkdFacets& facets, const SkdFacetSigns& signs,
  const std::vector<std::uint32_t>& origins, const SkdFaceSets& faces);
}

#endif
