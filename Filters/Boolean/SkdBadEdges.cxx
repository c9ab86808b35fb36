// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Boolean/SkdBadEdges.h"

#include <map>

namespace
{
void Add(SkdBadEdges& bad, std::uint32_t low, std::uint32_t high)
{
  if (bad.Count++ == 0)
  {
    bad.First = { low, high };
  }
}
}

std::vector<SkdBadEdges> SkdFindBadEdges(const SkdFacets& facets,
  const std::vector<std::uint32_t>& surfaceOf, std::uint32_t numberOfSurfaces)
{
  std::vector<SkdBadEdges> bad(numberOfSurfaces);
  const auto isBetweenTwo = [&](const SkdEdgeUse* first, const SkdEdgeUse* last)
  {
    return last - first == 2 && first[0].IsForward != first[1].IsForward &&
      surfaceOf[facets.Parents[first[0].Triangle]] ==
      surfaceOf[facets.Parents[first[1].Triangle]] &&
      facets.Layers.empty();
  };
  std::map<std::uint32_t, int> sums; // of surfaces
  facets.Edges.ForEach(
    [&](std::uint32_t low, const SkdEdgeUse* first, const SkdEdgeUse* last)
    {
      if (isBetweenTwo(first, last)) // nearly always
      {
        return;
      }
      sums.clear();
      for (const SkdEdgeUse* use = first; use != last; ++use)
      {
        facets.ForEachLayer(use->Triangle,
          [&](std::uint32_t parent, int sign)
          { sums[surfaceOf[parent]] += use->IsForward ? sign : -sign; });
      }
      for (const auto& [surface, sum] : sums)
      {
        if (sum != 0)
        {
          Add(bad[surface], low, first->High);
        }
      }
    });
  return bad;
}

SkdBadEdges SkdFindBadEdges(const SkdFacets& facets, const std::vector<signed char>& signs)
{
  SkdBadEdges bad;
  facets.Edges.ForEach(
    [&](std::uint32_t low, const SkdEdgeUse* first, const SkdEdgeUse* last)
    {
      int sum = 0;
      for (const SkdEdgeUse* use = first; use != last; ++use)
      {
        sum += use->IsForward ? signs[use->Triangle] : -signs[use->Triangle];
      }
      if (sum != 0)
      {
        Add(bad, low, first->High);
      }
    });
  return bad;
}
