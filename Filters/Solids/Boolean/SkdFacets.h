// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdFacets.h
 * @brief The facets of an arrangement: the pieces of split triangles, none twice.
 */

#ifndef SkdFacets_h
#define SkdFacets_h

#include "Core/Geometry/EdgeTable.h"
#include "Solids/Boolean/SkdNewPoints.h"
#include "Solids/Boolean/SkdOverlaps.h"

#include <algorithm>

namespace skdtree
{
using SkdEdgeUse = skd::EdgeUse<>;

/// Facets meet in common edges and points only. Points below the number of the set's points are
/// these, further ones new. Memory: 56 bytes a facet.
struct SkdFacets
{
  std::vector<SkdTriangleSet::Corners> Corners;
  std::vector<std::uint32_t> Parents; ///< the lowest triangle that each is a piece of
  std::vector<SkdFacetLayer> Layers;  ///< the others, by ascending facet
  SkdNewPoints NewPoints;
  skd::EdgeTable<> Edges;

  SkdFacets() = default;

  /// The pieces of triangles with an area. Where triangles of one plane overlap, those of the
  /// lowest one; these need not be the same as those of others.
  SkdFacets(const SkdSplitSegments& segments, SkdSplitResult split, const SkdOverlaps& overlaps);

  std::size_t GetNumberOfFacets() const { return this->Corners.size(); }

  /// Calls visit(parent, sign) for all triangles that a facet is a piece of.
  template <class Visit>
  void ForEachLayer(std::uint32_t facet, const Visit& visit) const
  {
    visit(this->Parents[facet], 1);
    const auto isLower = [](const SkdFacetLayer& layer, std::uint32_t wanted)
    { return layer.Facet < wanted; };
    auto at = std::lower_bound(this->Layers.begin(), this->Layers.end(), facet, isLower);
    for (; at != this->Layers.end() && at->Facet == facet; ++at)
    {
      visit(at->Parent, at->Sign);
    }
  }

  skd::Vector3 GetPosition(const SkdMovedTriangles& set, std::uint32_t point) const
  {
    const SkdTriangleSet::PointList& given = set.GetPoints();
    return point < given.size() ? given[point] : this->NewPoints[point - given.size()].Position;
  }

  /// Whether it is not all of its parent. Without a call, which a comparison of arrays is.
  bool IsPiece(const SkdMovedTriangles& set, std::uint32_t facet) const
  {
    const SkdTriangleSet::Corners& a = this->Corners[facet];
    const SkdTriangleSet::Corners& b = set.GetCorners(this->Parents[facet]);
    return ((a[0] ^ b[0]) | (a[1] ^ b[1]) | (a[2] ^ b[2])) != 0;
  }

  std::array<skd::Vector3, 3> GetPositions(const SkdMovedTriangles& set, std::uint32_t facet) const
  {
    const SkdTriangleSet::Corners& corners = this->Corners[facet];
    return { this->GetPosition(set, corners[0]), this->GetPosition(set, corners[1]),
      this->GetPosition(set, corners[2]) };
  }
};

/// The least of the areas that a point divides a triangle into, as a part of its own: below 0
/// beside it. NaN of a triangle without area.
double SkdLeastWeight(const std::array<skd::Vector3, 3>& triangle, const skd::Vector3& x);

/// A point of a triangle by the areas that it divides it into.
SkdSplitPoint SkdPointIn(
  const SkdMovedTriangles& set, std::uint32_t triangle, const skd::Vector3& x);
}

#endif
