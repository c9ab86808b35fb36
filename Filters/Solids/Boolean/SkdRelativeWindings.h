// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdRelativeWindings_h
#define SkdRelativeWindings_h

#include "Solids/Boolean/SkdArrangement.h"

namespace skdtree
{
/// The winding number of one of several surfaces, if it is not 0.
struct SkdWindingOf
{
  std::uint32_t Surface;
  int Number;

  bool operator<(const SkdWindingOf& other) const { return this->Surface < other.Surface; }
};

/// Of a region: those of all surfaces around it, ascending.
using SkdRegionWindings = std::vector<SkdWindingOf>;

/// Adds winding numbers to others.
void SkdAddWinding(SkdRegionWindings& to, const SkdWindingOf& winding);

/// Winding numbers relative to those of one region of each component: of all regions that facets
/// connect. O(n) for n facets, O(n log n) for those between different regions.
struct SkdRelativeWindings
{
  SkdRelativeWindings(
    const SkdArrangement& arrangement, const std::vector<std::uint32_t>& surfaceOf);

  std::vector<SkdRegionWindings> OfRegions;
  std::vector<std::uint32_t> ComponentOf; ///< of each region
  std::uint32_t NumberOfComponents = 0;
};
}

#endif
