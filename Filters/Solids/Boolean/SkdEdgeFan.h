// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdEdgeFan_h
#define SkdEdgeFan_h

#include "Solids/Boolean/SkdFacets.h"

namespace skdtree
{
/// The order of facets around an edge, by exact signs: only the corners of the triangles that they
/// are pieces of, which are given points, and the line of the edge are compared.
class SkdEdgeFan
{
public:
  /// `ids` are the new points of the facets in the points of the segments.
  SkdEdgeFan(const SkdMovedTriangles& set, const SkdSplitPoints& points, const SkdFacets& facets,
    const std::vector<std::uint32_t>& ids)
    : Set(set)
    , Points(points)
    , Facets(facets)
    , Ids(ids)
  {
  }

  /// Sorts the uses of an edge as its facets follow each other around it: counterclockwise as seen
  /// from its higher end, from the first on. O(k log k) exact tests.
  void Sort(std::uint32_t low, std::vector<SkdEdgeUse>& uses) const;

private:
  int SideOf(std::uint32_t low, const SkdEdgeUse& use, std::uint32_t plane) const;
  int OrientationOf(std::uint32_t low, const SkdEdgeUse& from, const SkdEdgeUse& to) const;
  int SideOfLine(std::uint32_t a, std::uint32_t b, const skd::Vector3& x, int axis) const;
  skd::ExactPoint ExactOf(std::uint32_t point) const;

  const SkdMovedTriangles& Set;
  const SkdSplitPoints& Points;
  const SkdFacets& Facets;
  const std::vector<std::uint32_t>& Ids;
};
}

#endif
