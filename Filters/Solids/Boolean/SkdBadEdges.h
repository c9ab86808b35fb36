// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdBadEdges_h
#define SkdBadEdges_h

#include "Solids/Boolean/SkdFacets.h"

namespace skdtree
{
/// The edges along which a surface does not pass as often in one direction as in the other: those
/// of gaps, and between triangles of opposite orientation.
struct SkdBadEdges
{
  vtkIdType Count = 0;
  vtkIdType Open = 0; ///< of these, that only one triangle has
  SkdSplitEdge First{ 0, 0 };
};

/// Of each of several surfaces, given that of each triangle of the set. Triangles that coincide
/// count as often as they are there. O(n).
std::vector<SkdBadEdges> SkdFindBadEdges(const SkdFacets& facets,
  const std::vector<std::uint32_t>& surfaceOf, std::uint32_t numberOfSurfaces);

/// Of a surface of some facets: `signs` is 1 of those that are in it, -1 reversed, 0 of others.
SkdBadEdges SkdFindBadEdges(const SkdFacets& facets, const std::vector<signed char>& signs);

/// The same of facets without a table of edges: one is made of those that are in it.
SkdBadEdges SkdFindBadEdges(
  const SkdMovedTriangles& set, const SkdFacets& facets, const std::vector<signed char>& signs);
}

#endif
