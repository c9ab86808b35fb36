// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdTrianglePairs.h
 * @brief Pairs of triangles of two sets, or of one, that touch or come near: a traversal of both
 * trees (Algorithm 5.4), or a packed R-tree for one-shot searches, with exact signs.
 */

#ifndef SkdTrianglePairs_h
#define SkdTrianglePairs_h

#include "Surfaces/SkdNearTriangles.h"
#include "Surfaces/SkdPlacement.h"

class SkdLoop;

/// Two triangles that touch; or, with a contact of no points, that are near.
struct SkdTrianglePair
{
  std::uint32_t First;
  std::uint32_t Second;
  skd::TriangleContact Contact;
};

/// What is looked for.
struct SkdPairSearch
{
  enum Extent
  {
    All,
    LowestOnly, ///< the pair that is the first in the order of cells, then of triangles
    WhetherOnly ///< any pair that touches or is near, not always the same
  };
  Extent Wanted = All;
  double Clearance = 0.0; ///< before scaling; 0: those that touch, only
};

/// The pairs of a placement. Within one surface, triangles that share corners are a pair only if
/// they have more in common; each pair occurs once, with First < Second.
class SkdTrianglePairs
{
public:
  explicit SkdTrianglePairs(const SkdPlacement& placement)
    : Placement(placement)
  {
  }

  /// Pairs sorted by (First, Second), independent of the number of threads. Uses the trees of
  /// complete sets.
  std::vector<SkdTrianglePair> Find(const SkdPairSearch& search, SkdLoop& loop) const;

  /// The same for the triangles that may intersect others, of two sets that are only read.
  std::vector<SkdTrianglePair> FindNear(
    const SkdNearSets& near, const SkdPairSearch& search, SkdLoop& loop) const;

private:
  static constexpr vtkIdType NumberOfParts = 512; // of a walk

  class Search;
  struct Moved;
  struct Block;
  struct Trees;

  template <class ToFirst>
  std::vector<SkdTrianglePair> FindByTrees(
    const Trees& trees, const ToFirst& toFirst, const SkdPairSearch& search, SkdLoop& loop) const;

  /// Empty if sizes differ so much that trees are faster.
  std::optional<std::vector<SkdTrianglePair>> FindByPackedRTree(
    const SkdNearSets& near, const SkdPairSearch& search, SkdLoop& loop) const;

  const SkdPlacement& Placement;
};

/// The triangles of one side of pairs, each once, ascending.
std::vector<std::uint32_t> SkdTrianglesOf(
  const std::vector<SkdTrianglePair>& pairs, std::uint32_t SkdTrianglePair::*side);

#endif
