// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Boolean/SkdFacets.h"

#include "Cells/Read/SkdForEach.h"

#include <numeric>

namespace
{
using Corners = SkdTriangleSet::Corners;
}

SkdFacetEdges::SkdFacetEdges(const std::vector<Corners>& triangles, std::size_t numberOfPoints)
  : Starts(numberOfPoints + 1, 0)
  , Uses(3 * triangles.size())
{
  const auto forEachUse = [&](const auto& visit)
  {
    for (std::uint32_t triangle = 0; triangle < triangles.size(); ++triangle)
    {
      for (int i = 0; i < 3; ++i)
      {
        visit(triangle, triangles[triangle][i], triangles[triangle][i == 2 ? 0 : i + 1]);
      }
    }
  };
  forEachUse(
    [&](std::uint32_t, std::uint32_t a, std::uint32_t b) { ++this->Starts[std::min(a, b) + 1]; });
  std::partial_sum(this->Starts.begin(), this->Starts.end(), this->Starts.begin());
  std::vector<std::size_t> next(this->Starts.begin(), this->Starts.end() - 1);
  forEachUse(
    [&](std::uint32_t triangle, std::uint32_t a, std::uint32_t b) {
      this->Uses[next[std::min(a, b)]++] = { std::max(a, b), triangle, a < b };
    });
  SkdForEach(static_cast<vtkIdType>(numberOfPoints),
    [&](vtkIdType low)
    {
      std::sort(this->Uses.begin() + static_cast<std::ptrdiff_t>(this->Starts[low]),
        this->Uses.begin() + static_cast<std::ptrdiff_t>(this->Starts[low + 1]));
    });
}

SkdFacets::SkdFacets(
  const SkdSplitSegments& segments, SkdSplitResult split, const SkdOverlaps& overlaps)
  : NewPoints(std::move(split.Points))
{
  const SkdPlacedTriangles& set = *segments.GetSide(0).Set;
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
  this->Edges = SkdFacetEdges(this->Corners, set.GetPoints().size() + this->NewPoints.size());
}
