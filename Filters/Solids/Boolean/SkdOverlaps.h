// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdOverlaps_h
#define SkdOverlaps_h

#include "Solids/Boolean/SkdDuplicates.h"
#include "Solids/Surfaces/SkdSplitTriangles.h"

namespace skdtree
{
/// A further triangle that a piece or facet lies in: with its orientation (1) or the opposite (-1).
struct SkdFacetLayer
{
  std::uint32_t Facet;
  std::uint32_t Parent;
  int Sign;

  bool operator<(const SkdFacetLayer& other) const
  {
    return this->Facet != other.Facet ? this->Facet < other.Facet : this->Parent < other.Parent;
  }
};

/// The pieces of a set split along its intersections with itself that lie in several triangles of
/// one plane.
struct SkdOverlaps
{
  std::vector<bool> IsHigher;        ///< of each piece, whether it lies in a lower triangle, too
  std::vector<SkdFacetLayer> Layers; ///< the higher triangles that others lie in, ascending

  /// Adds duplicates, which were not among the pairs, to what their originals are in.
  void Add(const std::vector<SkdDuplicate>& duplicates, const SkdSplitResult& split);
};

/// Triangles overlap in convex polygons, which no piece leaves: exact signs tell the pieces in
/// them. Their triangulations by pieces of the one and of the other triangle may differ. O(k m) for
/// k pairs of overlapping triangles with m pieces each.
SkdOverlaps SkdFindOverlaps(const std::vector<SkdTrianglePair>& pairs,
  const SkdContactPoints& contacts, const SkdSplitSegments& segments, const SkdSplitResult& split);
}

#endif
