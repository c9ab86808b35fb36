// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdArrangement.h
 * @brief The arrangement of surfaces: their facets, and the regions of space between these.
 *
 * The method is that of Q. Zhou, E. Grinspun, D. Zorin, A. Jacobson, "Mesh Arrangements for Solid
 * Geometry", ACM Trans. Graph. 35 (2016) 39: surfaces are split along all their intersections, and
 * the order of facets around each edge tells which sides of them face the same region. That order
 * is exact here.
 */

#ifndef SkdArrangement_h
#define SkdArrangement_h

#include "Solids/Boolean/SkdFacets.h"

/// A facet separates two regions, in front of it (where its normal points) and behind it; they are
/// the same if an open surface does not separate them. Surfaces that are not connected by edges
/// have no regions in common, also where one is within the other.
struct SkdArrangement
{
  SkdFacets Facets;
  std::vector<std::uint32_t> Regions; ///< in front of and behind each facet
  std::uint32_t NumberOfRegions = 0;
  vtkIdType NumberSplit = 0; ///< triangles that are in pieces

  std::uint32_t GetFront(std::uint32_t facet) const { return this->Regions[2 * facet]; }
  std::uint32_t GetBack(std::uint32_t facet) const { return this->Regions[2 * facet + 1]; }
};

/// Splits a set along all its intersections with itself: `pairs` are all of them,
/// but for copies that the set leaves out. O(n) for n
/// facets, plus exact tests at edges in which more than two of them meet; a few microseconds for
/// each that is a piece of a triangle. Empty after an abort.
std::optional<SkdArrangement> SkdArrange(
  const SkdPlacement& placement, std::vector<SkdTrianglePair> pairs, SkdLoop& loop);

#endif
