// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Surfaces/SkdSplitRegions.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <numeric>

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

std::uint32_t FindFirst(std::vector<std::uint32_t>& same, std::uint32_t i)
{
  while (same[i] != i)
  {
    same[i] = same[same[i]];
    i = same[i];
  }
  return i;
}
}

std::vector<std::uint32_t> SkdFindSplitRegions(
  const std::vector<SkdTriangleSet::Corners>& triangles, std::vector<SkdSplitEdge> borders)
{
  std::vector<std::uint32_t> same(triangles.size());
  std::iota(same.begin(), same.end(), 0u);
  vtkSMPTools::Sort(borders.begin(), borders.end());
  const std::vector<EdgeOf> edges = ListEdges(triangles);
  for (std::size_t i = 1; i < edges.size(); ++i)
  {
    if (edges[i].Edge == edges[i - 1].Edge &&
      !std::binary_search(borders.begin(), borders.end(), edges[i].Edge))
    {
      const std::uint32_t a = FindFirst(same, edges[i - 1].Triangle);
      const std::uint32_t b = FindFirst(same, edges[i].Triangle);
      same[std::max(a, b)] = std::min(a, b);
    }
  }
  std::vector<std::uint32_t> regions(same.size());
  std::uint32_t count = 0;
  for (std::uint32_t i = 0; i < same.size(); ++i) // the first of a region comes before the others
  {
    const std::uint32_t first = FindFirst(same, i);
    regions[i] = first == i ? count++ : regions[first];
  }
  return regions;
}
