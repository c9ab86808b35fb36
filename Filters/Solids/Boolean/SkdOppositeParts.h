// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdOppositeParts_h
#define SkdOppositeParts_h

#include "Solids/Boolean/SkdPieceParts.h"

#include <functional>

namespace skdtree
{
/// Pairs of parts that lie on each other face to face, in one plane but for rounding, and have a
/// point of their borders in common or facets that are `facing` each other (SkdFindFacingFacets),
/// but for those that `areApart` is true of: walls of a gap that is no wider than rounding, which
/// turned solids that touch leave. No part is in two pairs; with `areSeveral` one may be in more,
/// with parts that are in no others. A nanosecond or two for each pair of parts at each point of a
/// border, and O(m n) where they are parallel, for the pieces that they have; very many at one
/// point, or of one pair, are left.
std::vector<std::pair<std::uint32_t, std::uint32_t>> SkdFindOppositeParts(
  const SkdMovedTriangles& set, const SkdFacets& facets, const SkdFacetSigns& signs,
  const SkdPieceParts& parts, const SkdFaceSets& faces,
  const std::vector<std::pair<std::uint32_t, std::uint32_t>>& facing, bool areSeveral,
  const std::function<bool(std::uint32_t, std::uint32_t)>& areApart);
}

#endif
