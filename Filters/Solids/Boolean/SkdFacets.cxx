// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Boolean/SkdFacets.h"

#include "Bodies/SkdEdgeTable.h"

namespace skdtree
{
SkdFacets::SkdFacets(
  const SkdSplitSegments& segments, SkdSplitResult split, const SkdOverlaps& overlaps)
  : Corners(std::move(split.Triangles))
  , Parents(std::move(split.Parents))
  , NewPoints(std::move(split.Points))
{
  const SkdMovedTriangles& set = *segments.GetSide(0).Set;
  std::uint32_t count = 0; // nearly always all are facets, and stay where they are
  auto layer = overlaps.Layers.begin();
  for (std::uint32_t piece = 0; piece < this->Corners.size(); ++piece)
  {
    const bool isFacet = !overlaps.IsHigher[piece] && set.HasArea(this->Parents[piece]);
    for (; layer != overlaps.Layers.end() && layer->Facet == piece; ++layer)
    {
      if (isFacet)
      {
        this->Layers.push_back({ count, layer->Parent, layer->Sign });
      }
    }
    if (isFacet)
    {
      this->Corners[count] = this->Corners[piece];
      this->Parents[count++] = this->Parents[piece];
    }
  }
  this->Corners.resize(count);
  this->Parents.resize(count);
  this->Edges = SkdMakeEdgeTable(this->Corners, set.GetPoints().size() + this->NewPoints.size());
}
}
