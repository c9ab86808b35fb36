// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdTrianglePairs.h
 * @brief Pairs of triangles of two sets, or of one, that touch or come near: a traversal of both
 * trees (Algorithm 5.4), or a packed R-tree for one-shot searches, with exact signs.
 */

#ifndef SkdTrianglePairs_h
#define SkdTrianglePairs_h

#include "Core/Geometry/Intersection/TriangleFeature.h"
#include "Solids/Surfaces/SkdDoubtfulPairs.h"
#include "Solids/Surfaces/SkdNearTriangles.h"
#include "Solids/Surfaces/SkdPlacement.h"

#include <limits>

namespace skdtree
{
class SkdLoop;

/// Two triangles that touch; or, with a contact of no points, that are near.
struct SkdTrianglePair
{
  std::uint32_t First;
  std::uint32_t Second;
  skd::TriangleContact Contact;
};

/// Where two triangles come nearest that do not touch, before scaling.
struct SkdGap
{
  skd::Vector3 First;
  skd::Vector3 Second;
  double Dist2;
};
SkdGap SkdFindGap(const SkdPlacement& placement, const SkdTrianglePair& pair);

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

  ///@{
  /// Within one surface: it may stop when there are more than so many, and then returns none, but
  /// sets `AreMore`; and, of FindSelfIntersections alone, which triangles are searched, ascending
  /// (all but copies left out if nullptr).
  std::size_t Most = std::numeric_limits<std::size_t>::max();
  bool* AreMore = nullptr;
  const std::vector<std::uint32_t>* Among = nullptr;
  ///@}
};

/// What is known of one surface: all pairs of its triangles below `End`, sorted; and, if it is
/// known, which ones from there on can be pairs.
struct SkdKnownPairs
{
  std::uint32_t End = 0;
  std::vector<SkdTrianglePair> Pairs;
  std::optional<SkdIndexPairs> Doubtful;
};

/// The pairs of a placement. Within one surface, triangles that share corners are a pair only if
/// they have more in common; each pair occurs once, with First < Second. Pairs are sorted by
/// (First, Second), independent of the number of threads.
///
/// There are two ways. To sort a triangle into a tree costs about 16 times as much as to look at it
/// once, so surfaces that meet for the first time, and in few places, need a packed R-tree of the
/// triangles near each other only. Surfaces that are searched again keep their trees; small ones,
/// and those that overlap much, use trees at once, since a packed R-tree gains nothing there.
/// (Pairs of cells of any type by their bounds are vtkSkdTreeCellLocator::FindPairs, on locators'
/// trees.)
class SkdTrianglePairs
{
public:
  explicit SkdTrianglePairs(const SkdPlacement& placement)
    : Placement(placement)
  {
  }

  /// Walks the trees of complete sets together.
  std::vector<SkdTrianglePair> FindByTrees(const SkdPairSearch& search, SkdLoop& loop) const;

  /// Searches a packed R-tree of the second set's triangles that may intersect the first set. Sets
  /// need not be complete. Empty if boxes overlap so much that trees are faster. Looks at some
  /// `more` pairs of triangles, too.
  std::optional<std::vector<SkdTrianglePair>> FindByPackedRTree(const SkdNearSets& near,
    const SkdPairSearch& search, SkdLoop& loop, const SkdIndexPairs& more = {}) const;

  /// Of one surface that is searched for the first time: searches a packed R-tree of all its
  /// triangles. The clearance must be 0. The set's points must be merged; a tree is not needed.
  /// Where boxes overlap much, triangles are cut (ClippedPairs.h). Empty if there are far more
  /// pairs than wanted. With some pairs `known`, which all are wanted and no copies left out, only
  /// the others are searched.
  std::optional<std::vector<SkdTrianglePair>> FindSelfIntersections(
    const SkdPairSearch& search, SkdLoop& loop, const SkdKnownPairs* known = nullptr) const;

private:
  class Search;
  class PackedSearch;
  struct Moved;
  struct Block;

  std::vector<std::uint32_t> ListUnknown(const SkdKnownPairs& known) const;
  std::optional<std::vector<SkdTrianglePair>> FindUnknown(
    const SkdKnownPairs& known, const SkdPairSearch& search, SkdLoop& loop) const;

  /// Where boxes of triangles overlap much, by parts of these. Empty if there are far more pairs
  /// than wanted.
  template <class TriangleOf>
  std::optional<std::vector<SkdTrianglePair>> FindByClipping(std::size_t count,
    const TriangleOf& triangleOf, const SkdPairSearch& search, SkdLoop& loop,
    const SkdKnownPairs* known) const;

  template <class ToFirst>
  std::vector<SkdTrianglePair> FindByTrees(
    const ToFirst& toFirst, const SkdPairSearch& search, SkdLoop& loop) const;

  const SkdPlacement& Placement;
};

/// The triangles of one side of pairs, each once, ascending.
std::vector<std::uint32_t> SkdTrianglesInPairs(
  const std::vector<SkdTrianglePair>& pairs, std::uint32_t SkdTrianglePair::*side);
}

#endif
