// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Surfaces/SkdSplitRegions.h"

#include "Core/Geometry/DisjointSets.h"
#include "vtkSMPTools.h"

#include <algorithm>

namespace
{
struct EdgeOf
{
  SkdSplitEdge Edge;
  std::uint32_t Triangle;

  bool operator<(const EdgeOf& other) const
  {
    return this->Edge != other.Edge ? this->Edge < other.Edge : this->Triangle < other.Triangle;
  }
};

std::vector<EdgeOf> ListEdges(const std::vector<SkdTriangleSet::Corners>& triangles)
{
  std::vector<EdgeOf> edges;
  edges.reserve(3 * triangles.size());
  for (std::uint32_t triangle = 0; triangle < triangles.size(); ++triangle)
  {
    for (int i = 0; i < 3; ++i)
    {
      edges.push_back(
        { SkdMakeSplitEdge(triangles[triangle][i], triangles[triangle][(i + 1) % 3]), triangle });
    }
  }
  vtkSMPTools::Sort(edges.begin(), edges.end());
  return edges;
}
}

std::vector<std::uint32_t> SkdFindSplitRegions(
  const std::vector<SkdTriangleSet::Corners>& triangles, std::vector<SkdSplitEdge> borders)
{
  skd::DisjointSets<> regions(triangles.size());
  vtkSMPTools::Sort(borders.begin(), borders.end());
  const std::vector<EdgeOf> edges = ListEdges(triangles);
  for (std::size_t i = 1; i < edges.size(); ++i)
  {
    if (edges[i].Edge == edges[i - 1].Edge &&
      !std::binary_search(borders.begin(), borders.end(), edges[i].Edge))
    {
      regions.Unite(edges[i - 1].Triangle, edges[i].Triangle);
    }
  }
  return regions.Number();
}
