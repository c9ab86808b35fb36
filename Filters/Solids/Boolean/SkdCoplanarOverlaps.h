// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdCoplanarOverlaps_h
#define SkdCoplanarOverlaps_h

#include "Solids/Boolean/SkdPieceParts.h"
#include "Solids/Boolean/SkdRoundedFacets.h"

namespace skdtree
{
/// Where faces that lie in one plane but for rounding overlap and face alike, which of them is in
/// the boundary is decided by rounding, along lines across both. What they have in common becomes
/// that of the lowest, as it is of faces that are exactly in one plane (SkdOverlaps). Only faces
/// whose parts have an edge of the boundary in common are looked at.
///
/// Two steps may be needed: if a part's border has to be split where the other face ends, the
/// result is the boundary with that border split (SkdEdgeCuts), and else with the parts cut. It
/// has the facets of the boundary only, by ascending parent, and no table of edges; none if no part
/// overlaps. A part that cannot be cut stays. O(n log n) for the facets of parts that have such a
/// neighbour and the triangles of its face, if each is near few others.
std::optional<SkdRoundedFacets> SkdCutOverlaps(const SkdMovedTriangles& set,
  const SkdFacets& facets, const SkdFacetSigns& signs, const SkdPieceParts& parts);
}

#endif
