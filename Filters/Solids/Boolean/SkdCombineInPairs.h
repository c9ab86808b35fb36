// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdCombineInPairs.h
 * @brief Boolean operations on very many solids that overlap: two at a time.
 *
 * Where k solids overlap, the arrangement of all has k^3 facets, nearly all of them within some
 * solid. A balanced tree of unions of two drops what is within as it goes. Each union is exact for
 * its operands, but its new points are rounded: the result is that of the arrangement of all to
 * within this rounding.
 */

#ifndef SkdCombineInPairs_h
#define SkdCombineInPairs_h

#include "Solids/Boolean/SkdBooleanRule.h"
#include "Solids/Boolean/SkdFaceSets.h"
#include "Solids/Boolean/SkdRoundedFacets.h"
#include "Solids/Boolean/SkdSolids.h"

#include <array>
#include <functional>

class vtkAlgorithm;

namespace skdtree
{
/// Solids, by their triangles, that are united before an operation.
using SkdSolidGroup = std::vector<std::vector<std::uint32_t>>;

/// Whether an operation is one on two operands, each the union of some solids.
bool SkdHasUnitedOperands(SkdBooleanOperation operation, bool areInputs);

/// The two operands of an operation, each the union of some solids: all of the first and the second
/// input; else the first solid and the others, or of a union any halves. A solid whose pieces are
/// closed, face outward and do not intersect themselves, is in a group by its pieces, unless what
/// two of them cover is outside. `findPairs` returns the pairs of two triangles of one piece that
/// touch, and maybe others; it is called with the piece that each triangle is of. Empty if a solid
/// is not closed, or if the operation does not have such operands or they are of few solids. O(n).
std::optional<std::array<SkdSolidGroup, 2>> SkdFindSolidGroups(const SkdTriangleSet& set,
  const SkdSolids& solids, bool areInputs, const SkdBooleanRule& rule,
  const std::function<std::vector<SkdTrianglePair>(const std::vector<std::uint32_t>&)>& findPairs);

/// The result, in terms of the set that the solids are of: facets are pieces of its triangles.
struct SkdCombinedSolids
{
  SkdRoundedFacets Boundary;
  std::array<SkdBoundaryMeasures, 2> Groups; ///< of the union of each
  SkdBoundaryMeasures Union;                 ///< of both
  vtkIdType NumberSplit = 0;                 ///< triangles, each time that one is split
};

/// Unites the solids of each group by a balanced tree, those that are near each other first, and
/// combines the two results. Pieces of one face are joined after each step (SkdJoinPieces). Empty
/// after an abort, or if winding numbers could not be found. O(m log n) for n solids, where m is
/// about the size of the unions.
std::optional<SkdCombinedSolids> SkdCombineInPairs(const SkdPlacement& placement,
  SkdFaceSets& faces, const std::array<SkdSolidGroup, 2>& groups, const SkdBooleanRule& rule,
  vtkAlgorithm* filter);
}

#endif
