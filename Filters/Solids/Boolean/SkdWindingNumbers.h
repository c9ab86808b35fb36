// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdWindingNumbers.h
 * @brief How often each surface of an arrangement winds around its regions.
 */

#ifndef SkdWindingNumbers_h
#define SkdWindingNumbers_h

#include "Solids/Boolean/SkdAxisLine.h"
#include "Solids/Boolean/SkdRelativeWindings.h"

#include <functional>

namespace skdtree
{
/// The winding numbers of all regions. `surfaceOf` is the surface of each triangle of the set; all
/// of them are closed. The numbers of regions that facets connect follow from each other; those of
/// one region of each connected set of facets are counted along a line. All of it is exact. O(n),
/// and O(log n) for each set of facets that is in the box of another one. Empty if no line could be
/// found that passes no edge, which should not happen.
std::vector<SkdRegionWindings> SkdFindWindingNumbers(const SkdPlacement& placement,
  const SkdArrangement& arrangement, const std::vector<std::uint32_t>& surfaceOf);

/// Counts, for each of some positions, the numbers that triangles on other processes cause just
/// before it; nothing where the line passes through an edge of theirs or crosses one there.
/// `isOpen`: more may be asked by this process. Empty if that is so on no process.
using SkdAskWindings = std::function<std::optional<std::vector<std::optional<SkdRegionWindings>>>(
  const std::vector<SkdPositionOnLine>& positions, bool isOpen)>;

/// The same of surfaces that go on on other processes: `ask` is called equally often on all.
std::vector<SkdRegionWindings> SkdFindWindingNumbers(const SkdPlacement& placement,
  const SkdArrangement& arrangement, const std::vector<std::uint32_t>& surfaceOf,
  const SkdAskWindings& ask);

/// The part of space that each region is in, numbered from 0: regions of sets of facets that are
/// not connected are the same part where no facet is between them. Surfaces may be open. Cost and
/// empty result as above.
std::vector<std::uint32_t> SkdFindPartsOfSpace(const SkdPlacement& placement,
  const SkdArrangement& arrangement, const std::vector<std::uint32_t>& surfaceOf);
}

#endif
