// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdSolidGroups.h
 * @brief Which operations on many solids can be done two solids at a time, and on which.
 */

#ifndef SkdSolidGroups_h
#define SkdSolidGroups_h

#include "Solids/Boolean/SkdBooleanRule.h"
#include "Solids/Boolean/SkdSolids.h"
#include "Solids/Surfaces/SkdTriangleSet.h"

#include <array>
#include <functional>
#include <optional>

namespace skdtree
{
/// Solids, by their triangles.
using SkdSolidGroup = std::vector<std::vector<std::uint32_t>>;

/// The two operands of an operation, each made of some solids.
struct SkdOperands
{
  std::array<SkdSolidGroup, 2> Groups;
  SkdBooleanOperation Within; ///< what makes an operand of the solids of its group
};

/// Whether an operation is one on two operands, with a result that is small where many solids
/// overlap. A symmetric difference of many has all facets of their arrangement: two at a time would
/// split these again and again (five times slower, for 20 turned cubes).
bool SkdCanCombineInPairs(SkdBooleanOperation operation, bool areInputs);

/// The operands: all of the first and the second input; else the first solid and the others. A
/// group of solids is united, or intersected for the intersection of all solids. A solid to be
/// united whose pieces are closed, face outward and do not intersect themselves, is in a group by
/// its pieces, unless what two of them cover is outside. `findPairs` returns the pairs of two
/// triangles of one piece that touch, and maybe others; it is called with the piece that each
/// triangle is of. Empty if a solid is not closed, or if the operation does not have such operands
/// or they are of few solids. O(n).
std::optional<SkdOperands> SkdFindOperands(const SkdTriangleSet& set, const SkdSolids& solids,
  bool areInputs, const SkdBooleanRule& rule,
  const std::function<std::vector<SkdTrianglePair>(const std::vector<std::uint32_t>&)>& findPairs);
}

#endif
