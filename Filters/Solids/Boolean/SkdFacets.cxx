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

double SkdLeastWeight(const std::array<skd::Vector3, 3>& triangle, const skd::Vector3& x)
{
  const skd::Vector3 normal = Cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
  double least = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < 3; ++i)
  {
    const skd::Vector3 area = Cross(triangle[(i + 1) % 3] - x, triangle[(i + 2) % 3] - x);
    least = std::min(least, Dot(normal, area));
  }
  return least / Dot(normal, normal);
}

SkdSplitPoint SkdPointIn(
  const SkdMovedTriangles& set, std::uint32_t triangle, const skd::Vector3& x)
{
  const auto at = set.GetCornerPoints(triangle);
  const skd::Vector3 normal = Cross(at[1] - at[0], at[2] - at[0]);
  std::array<double, 3> areas;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const double area = Dot(normal, Cross(at[(i + 1) % 3] - x, at[(i + 2) % 3] - x));
    areas[i] = std::max(area, 0.0);
  }
  const double sum = areas[0] + areas[1] + areas[2];
  for (double& area : areas)
  {
    area = sum > 0.0 ? area / sum : 1.0 / 3.0;
  }
  return { x, set.GetCorners(triangle), areas, triangle };
}
}
