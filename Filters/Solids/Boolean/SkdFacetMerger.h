// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdFacetMerger_h
#define SkdFacetMerger_h

#include "Bodies/SkdTriangulation.h"
#include "Solids/Boolean/SkdFacets.h"

namespace skdtree
{
/// Merges facets of one triangle into convex polygons, across edges one after the other as long as
/// what results is convex (S. Hertel, K. Mehlhorn, "Fast Triangulation of Simple Polygons", FCT
/// 1983): at most four times as many polygons as possible. Angles are convex to within rounding.
/// Polygons are such that VTK's filters can triangulate them without losing an edge.
class SkdFacetMerger
{
public:
  using Polygon = std::vector<std::uint32_t>; ///< the points of its outline

  /// `fixedEdges` are edges, ascending, across which nothing is merged.
  SkdFacetMerger(const SkdMovedTriangles& set, const SkdFacets& facets,
    const std::vector<SkdSplitEdge>& fixedEdges)
    : Set(set)
    , Facets(facets)
    , FixedEdges(fixedEdges)
  {
  }

  /// The polygons of some facets of the same triangle, in its orientation. O(k^2) for k facets.
  std::vector<Polygon> Merge(const std::vector<std::uint32_t>& facets);

private:
  struct View;

  bool MergeTwo(Polygon& into, Polygon& other, const View& view);
  bool IsConvexAt(const Polygon& polygon, std::size_t corner, const View& view) const;
  bool IsCutByVtk(const Polygon& polygon);

  const SkdMovedTriangles& Set;
  const SkdFacets& Facets;
  const std::vector<SkdSplitEdge>& FixedEdges;
  SkdTriangulation Triangulation;
};
}

#endif
