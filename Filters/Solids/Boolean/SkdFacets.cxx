// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Boolean/SkdFacets.h"

#include "Bodies/SkdEdgeTable.h"

namespace skdtree
{
SkdFacets::SkdFacets(
  const SkdSplitSegments& segments, SkdSplitResult split, const SkdOverlaps& overlaps)
  : NewPoints(std::move(split.Points))
{
  const SkdMovedTriangles& set = *segments.GetSide(0).Set;
  this->Corners.reserve(split.Triangles.size());
  this->Parents.reserve(split.Triangles.size());
  auto layer = overlaps.Layers.begin();
  for (std::uint32_t piece = 0; piece < split.Triangles.size(); ++piece)
  {
    const bool isFacet = !overlaps.IsHigher[piece] && set.HasArea(split.Parents[piece]);
    for (; layer != overlaps.Layers.end() && layer->Facet == piece; ++layer)
    {
      if (isFacet)
      {
        const auto facet = static_cast<std::uint32_t>(this->Corners.size());
        this->Layers.push_back({ facet, layer->Parent, layer->Sign });
      }
    }
    if (isFacet)
    {
      this->Corners.push_back(split.Triangles[piece]);
      this->Parents.push_back(split.Parents[piece]);
    }
  }
  this->Edges = SkdMakeEdgeTable(this->Corners, set.GetPoints().size() + this->NewPoints.size());
}
}
