// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdDoubtfulPairs.h
 * @brief Pairs of triangles of a surface that may intersect once the surface is moved.
 */

#ifndef SkdDoubtfulPairs_h
#define SkdDoubtfulPairs_h

#include "Solids/Surfaces/SkdPlacement.h"

#include <optional>
#include <utility>
#include <vector>

namespace skdtree
{
class SkdLoop;

/// Pairs of triangles, the lower first.
using SkdIndexPairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

/// Of the triangles of a set from one number on, all pairs but those that surely have nothing in
/// common but the corners they share: where they are, and also after a rigid motion that rounds
/// coordinates by no more than `rounding`, in the placement's scale. Ascending; of an ordinary
/// surface these are few. Points must be merged. Empty if boxes overlap so much that it would take
/// long, or after an abort.
std::optional<SkdIndexPairs> SkdFindDoubtfulPairs(
  const SkdMovedTriangles& set, std::uint32_t begin, double rounding, SkdLoop& loop);
}

#endif
