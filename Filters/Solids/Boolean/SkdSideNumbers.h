// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdSideNumbers.h
 * @brief Inside and outside of surfaces that are not closed, by generalized winding numbers.
 *
 * A. Jacobson, L. Kavan, O. Sorkine-Hornung, "Robust Inside-Outside Segmentation using Generalized
 * Winding Numbers", ACM Trans. Graph. 32 (2013) 33; over an arrangement as in Zhou et al. 2016
 * (SkdArrangement.h).
 */

#ifndef SkdSideNumbers_h
#define SkdSideNumbers_h

#include "Solids/Boolean/SkdArrangement.h"

namespace skdtree
{
/// The winding numbers of one surface on both sides of each facet, rounded: 0 below one half.
struct SkdSideNumbers
{
  std::uint32_t Surface;
  std::vector<int> Numbers; ///< in front of each facet, and behind it

  int Get(std::uint32_t facet, bool isBehind) const
  {
    return this->Numbers[2 * facet + (isBehind ? 1 : 0)];
  }
};

/// The numbers are found near the middle of each facet. Facets that edges of two connect have the
/// same, if but for a millionth of their area they do: only slivers differ then, by rounding. Near
/// a gap in the surface facets differ. O(n log n), a microsecond or two for a facet.
SkdSideNumbers SkdFindSideNumbers(const SkdMovedTriangles& set, const SkdArrangement& arrangement,
  const std::vector<std::uint32_t>& surfaceOf, std::uint32_t surface);
}

#endif
