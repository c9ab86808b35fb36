// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdBorderCrossings_h
#define SkdBorderCrossings_h

#include "Solids/Boolean/SkdPieceParts.h"
#include "Solids/Boolean/SkdRoundedFacets.h"

namespace skdtree
{
/// Where the borders of two parts of each pair have corners that are one to within their tolerance,
/// makes these one. Else splits facets where the borders cross, or a point of one is on an edge of
/// the other to within their tolerance: all that have such an edge. They pass edges as often in
/// both directions as before. The parts of a pair lie in one plane. The result has the facets of
/// the boundary only, by ascending parent, and no table of edges; none if nothing is changed. O(m
/// log n) for the edges of each pair, of which each is near few others.
std::optional<SkdRoundedFacets> SkdSplitBorders(const SkdMovedTriangles& set,
  const SkdFacets& facets, const SkdFacetSigns& signs, const SkdPieceParts& parts,
  const std::vector<std::pair<std::uint32_t, std::uint32_t>>& pairs);
}

#endif
