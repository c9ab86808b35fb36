// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdArrangement.h
 * @brief The arrangement of surfaces: their facets, and the regions of space between these.
 *
 * The method is that of Q. Zhou, E. Grinspun, D. Zorin, A. Jacobson, "Mesh Arrangements for Solid
 * Geometry", ACM Trans. Graph. 35 (2016) 39: surfaces are split along all their intersections, and
 * the order of facets around each edge tells which sides of them face the same region. That order
 * is exact here.
 */

#ifndef SkdArrangement_h
#define SkdArrangement_h

#include "Solids/Boolean/SkdFacets.h"
#include "Solids/Surfaces/SkdTrianglePairs.h"

class vtkAlgorithm;

namespace skdtree
{
/// A facet separates two regions, in front of it (where its normal points) and behind it; they are
/// the same if an open surface does not separate them. Surfaces that are not connected by edges
/// have no regions in common, also where one is within the other.
struct SkdArrangement
{
  SkdFacets Facets;
  std::vector<std::uint32_t> Regions; ///< in front of and behind each facet
  std::uint32_t NumberOfRegions = 0;
  vtkIdType NumberSplit = 0; ///< triangles that are in pieces
  bool IsCrowd = false;      ///< it was not made, as its segments meet each other too often

  std::uint32_t GetFront(std::uint32_t facet) const { return this->Regions[2 * facet]; }
  std::uint32_t GetBack(std::uint32_t facet) const { return this->Regions[2 * facet + 1]; }
};

/// All intersections of a set with itself, but for copies that it leaves out, and its duplicates,
/// of which only the first are among the pairs.
struct SkdSelfPairs
{
  std::vector<SkdTrianglePair> Pairs;   ///< none if there are more than were wanted
  std::vector<SkdDuplicate> Duplicates; ///< ascending
  bool AreSome = false;                 ///< whether there are
};

/// What is cached of a set while its first triangles stay where they are and the others are moved:
/// pairs within the first, and which pairs of the others a motion may make.
struct SkdPairCache
{
  SkdKnownPairs Known;
  double Scale = 0.0;    ///< of the placement in which they were found; 0: none are kept
  double Rounding = 0.0; ///< of coordinates in this motion, before scaling

  /// What `Known.Doubtful` holds for: roundings up to this one, and points merged like these.
  double MostRounding = 0.0;
  std::vector<std::uint32_t> PointOf;
  std::size_t NumberOfTriangles = 0;
};

/// Completes the set if its triangles overlap so much that trees are faster. Those of `cache` are
/// not searched again, or are kept now; without it none are, and only then the search may stop when
/// there are more than `most`. Of some triangles `among` all if there is such a list. Empty after
/// an abort.
std::optional<SkdSelfPairs> SkdFindSelfPairs(SkdTriangleSet& set, const SkdPlacement& placement,
  SkdLoop& loop, vtkAlgorithm* filter, SkdPairCache* cache = nullptr,
  std::size_t most = std::numeric_limits<std::size_t>::max(),
  const std::vector<std::uint32_t>* among = nullptr);

/// Finds out once which pairs a motion may make (`cache.Known.Doubtful`; none if that is not
/// known): where triangles, their points and how these are merged are the same, that depends on
/// rounding alone.
void SkdUpdateDoubtful(const SkdPlacement& placement, vtkAlgorithm* filter, SkdPairCache& cache);

/// Those of two triangles of one piece, and maybe others.
std::vector<SkdTrianglePair> SkdFindPairsWithin(SkdTriangleSet& set, const SkdPlacement& placement,
  const std::vector<std::uint32_t>& pieceOf, SkdLoop& loop);

/// Whether segments along which triangles are split meet each other in more than `perPair` points
/// for each pair of triangles, of which there are `leastPairs` or more. Told by a sample, the same
/// at each call: of triangles picked one in k, k^2 times fewer pairs are found, and k^3 times fewer
/// triples, which such points are of. O(n).
bool SkdSegmentsMeetOften(
  const SkdPlacement& placement, std::size_t leastPairs, std::size_t perPair, SkdLoop& loop);

/// Splits a set along all its intersections with itself. O(n) for n facets, plus exact tests at
/// edges in which more than two of them meet; a few microseconds for each that is a piece of a
/// triangle. Empty after an abort. Is not made if segments along which triangles are split meet
/// each other in more than `mostEvents` points. With `goesOn` the set is a part of closed surfaces:
/// the sides of a triangle do not meet around an edge that it alone has.
std::optional<SkdArrangement> SkdArrange(const SkdPlacement& placement, const SkdSelfPairs& pairs,
  SkdLoop& loop, std::size_t mostEvents = std::numeric_limits<std::size_t>::max(),
  bool goesOn = false);

/// A part of an arrangement: its facets, and the order of these around the edges that more than two
/// of them have. Regions are not known, as they go on beyond the part.
struct SkdArrangedPart
{
  /// Facets counterclockwise around an edge as seen from its higher end.
  using Fan = std::vector<SkdEdgeUse>;

  SkdFacets Facets;
  std::vector<Fan> Fans;
  vtkIdType NumberSplit = 0; ///< triangles that are in pieces
};

/// Splits some triangles along all their intersections, which share no area. Empty after an abort,
/// or if segments meet each other in more than `mostEvents` points.
std::optional<SkdArrangedPart> SkdArrangePart(const SkdPlacement& placement,
  const std::vector<SkdTrianglePair>& pairs, SkdLoop& loop, std::size_t mostEvents);

///@{
/// The sides of a facet at an edge, twice its number and 1 more behind it: a turn around the edge,
/// counterclockwise as seen from its higher end, leaves a facet at the one and reaches the next one
/// at the other.
inline std::uint32_t SkdSideLeft(const SkdEdgeUse& use)
{
  return 2 * use.Triangle + (use.IsForward ? 0 : 1);
}

inline std::uint32_t SkdSideEntered(const SkdEdgeUse& use)
{
  return 2 * use.Triangle + (use.IsForward ? 1 : 0);
}
///@}
}

#endif
