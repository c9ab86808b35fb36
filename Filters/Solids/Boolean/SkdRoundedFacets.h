// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdRoundedFacets.h
 * @brief The facets of a boundary as they are stored: points that are equal, or differ by rounding,
 * are one.
 */

#ifndef SkdRoundedFacets_h
#define SkdRoundedFacets_h

#include "Solids/Boolean/SkdBooleanRule.h"

namespace skdtree
{
/// Of each point of an arrangement the lowest one that has the same coordinates when stored, or
/// nearly (as a rule, if they differ by a few units in the last place of their largest coordinate);
/// given points stay different. Empty if all are. O(n), a few nanoseconds for each point that is
/// given.
std::vector<std::uint32_t> SkdFindEqualPoints(
  const SkdPlacement& placement, const SkdFacets& facets);

/// A boundary whose points of equal coordinates, or nearly, are one. Facets keep their numbers.
struct SkdRoundedFacets
{
  SkdFacets Facets; ///< without layers and a table of edges
  SkdFacetSigns Signs;
  vtkIdType NumberFolded = 0; ///< facets that are no longer in it

  /// Frees all but how many were folded.
  void ForgetFacets() { *this = SkdRoundedFacets{ {}, {}, this->NumberFolded }; }
};

/// A boundary as it is, without a table of edges.
SkdRoundedFacets SkdMakeRounded(const SkdFacets& facets, const SkdFacetSigns& signs);

/// Facets with equal corners leave the boundary, and facets that are laid on each other face to
/// face: it passes each edge in both directions as before. With `keepsOne`, for facets that bound
/// nothing, of those that are laid on each other the first stays. O(n log n).
SkdRoundedFacets SkdUniteEqualPoints(
  SkdRoundedFacets rounded, const std::vector<std::uint32_t>& lowest, bool keepsOne);
}

#endif
