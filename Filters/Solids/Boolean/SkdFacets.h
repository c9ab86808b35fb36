// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdFacets.h
 * @brief The facets of an arrangement: the pieces of split triangles, each place once.
 */

#ifndef SkdFacets_h
#define SkdFacets_h

#include "Solids/Boolean/SkdOverlaps.h"

#include <algorithm>

/// A triangle at one of its edges.
struct SkdEdgeUse
{
  std::uint32_t High; ///< the higher end of the edge
  std::uint32_t Triangle;
  bool IsForward; ///< the triangle has the edge from its lower to its higher end

  bool operator<(const SkdEdgeUse& other) const
  {
    return this->High != other.High ? this->High < other.High : this->Triangle < other.Triangle;
  }
};

/// The edges of triangles, each with all triangles that have it. O(n), 12 bytes an edge and
/// triangle.
class SkdFacetEdges
{
public:
  SkdFacetEdges() = default;
  SkdFacetEdges(const std::vector<SkdTriangleSet::Corners>& triangles, std::size_t numberOfPoints);

  /// Calls visit(low, first, last) for each edge: its lower end, and its uses by ascending
  /// triangle.
  template <class Visit>
  void ForEach(const Visit& visit) const
  {
    for (std::uint32_t low = 0; low + 1 < this->Starts.size(); ++low)
    {
      const SkdEdgeUse* const end = this->Uses.data() + this->Starts[low + 1];
      for (const SkdEdgeUse* first = this->Uses.data() + this->Starts[low]; first != end;)
      {
        const SkdEdgeUse* last = first + 1;
        while (last != end && last->High == first->High)
        {
          ++last;
        }
        visit(low, first, last);
        first = last;
      }
    }
  }

private:
  std::vector<std::size_t> Starts; // of the uses of edges by their lower end
  std::vector<SkdEdgeUse> Uses;
};

/// Facets meet in common edges and points only. Points below the number of the set's points are
/// these, further ones new. Memory: 56 bytes a facet.
struct SkdFacets
{
  std::vector<SkdTriangleSet::Corners> Corners;
  std::vector<std::uint32_t> Parents; ///< the lowest triangle that each is a piece of
  std::vector<SkdFacetLayer> Layers;  ///< the others, by ascending facet
  std::vector<SkdSplitPoint> NewPoints;
  SkdFacetEdges Edges;

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

  skd::Vector3 GetPosition(const SkdPlacedTriangles& set, std::uint32_t point) const
  {
    const SkdTriangleSet::PointList& given = set.GetPoints();
    return point < given.size() ? given[point] : this->NewPoints[point - given.size()].Position;
  }

  std::array<skd::Vector3, 3> GetPositions(const SkdPlacedTriangles& set, std::uint32_t facet) const
  {
    const SkdTriangleSet::Corners& corners = this->Corners[facet];
    return { this->GetPosition(set, corners[0]), this->GetPosition(set, corners[1]),
      this->GetPosition(set, corners[2]) };
  }
};

#endif
