// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdCombineInPairs.h
 * @brief Boolean operations on very many solids that overlap: two at a time.
 *
 * Where k solids overlap, the arrangement of all has k^3 facets, nearly all of them within some
 * solid. A balanced tree of unions of two drops what is within as it goes, one of intersections
 * what is outside. Each step is exact for its operands, but its new points are rounded: the result
 * is that of the arrangement of all to within this rounding.
 */

#ifndef SkdCombineInPairs_h
#define SkdCombineInPairs_h

#include "Solids/Boolean/SkdBooleanRule.h"
#include "Solids/Boolean/SkdFaceSets.h"
#include "Solids/Boolean/SkdRoundedFacets.h"
#include "Solids/Boolean/SkdSolidGroups.h"

#include <array>
#include <optional>

class vtkAlgorithm;

namespace skdtree
{
/// The result, in terms of the set that the solids are of: facets are pieces of its triangles.
struct SkdCombinedSolids
{
  SkdRoundedFacets Boundary;
  std::array<SkdBoundaryMeasures, 2> Operands;
  SkdBoundaryMeasures Union; ///< of all solids
  vtkIdType NumberSplit = 0; ///< triangles, each time that one is split
};

/// Makes each operand of its solids by a balanced tree, those that are near each other first, and
/// combines the two. Pieces of one face are joined after each step (SkdJoinPieces). Empty after an
/// abort, or if winding numbers could not be found. O(m log n) for n solids, where m is about the
/// size of what is made on the way.
std::optional<SkdCombinedSolids> SkdCombineInPairs(const SkdPlacement& placement,
  SkdFaceSets& faces, const SkdOperands& operands, const SkdBooleanRule& rule,
  vtkAlgorithm* filter);
}

#endif
