// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdBooleanFacets_h
#define SkdBooleanFacets_h

#include "Solids/Boolean/SkdBadEdges.h"
#include "Solids/Boolean/SkdBooleanRule.h"

namespace skdtree
{
/// For each facet of an arrangement 1 if it bounds a part of space as it is, -1 if reversed, 0 if
/// it does not.
using SkdFacetSigns = std::vector<signed char>;

/// The boundary of the regions for which `isSolid` (of their winding numbers) returns true.
template <class IsSolid>
SkdFacetSigns SkdFindBoundary(const SkdArrangement& arrangement,
  const std::vector<SkdRegionWindings>& windings, const IsSolid& isSolid)
{
  std::vector<signed char> solid(windings.size());
  for (std::size_t region = 0; region < windings.size(); ++region)
  {
    solid[region] = isSolid(windings[region]) ? 1 : 0;
  }
  SkdFacetSigns signs(arrangement.Facets.GetNumberOfFacets());
  for (std::uint32_t facet = 0; facet < signs.size(); ++facet)
  {
    signs[facet] = static_cast<signed char>(
      solid[arrangement.GetBack(facet)] - solid[arrangement.GetFront(facet)]);
  }
  return signs;
}

/// The volume within a boundary, and its area.
struct SkdBoundaryMeasures
{
  double Volume = 0.0;
  double Area = 0.0;
};
SkdBoundaryMeasures SkdMeasureBoundary(
  const SkdMovedTriangles& set, const SkdFacets& facets, const SkdFacetSigns& signs);
}

#endif
