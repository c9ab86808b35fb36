// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Boolean/SkdBadEdges.h"

#include "Bodies/SkdEdgeTable.h"
#include "Core/Geometry/UnpairedEdges.h"

#include <algorithm>
#include <map>

namespace skdtree
{
namespace
{
/// The triangles at an edge.
struct Passes
{
  int Sum = 0; // in one direction less the other
  int Count = 0;

  void Add(int sign)
  {
    this->Sum += sign;
    ++this->Count;
  }
};

void Add(SkdBadEdges& bad, std::uint32_t low, std::uint32_t high, const Passes& passes)
{
  if (passes.Sum == 0)
  {
    return;
  }
  if (bad.Count++ == 0)
  {
    bad.First = { low, high };
  }
  bad.Open += passes.Count == 1;
}

SkdBadEdges FindBadEdges(const skd::EdgeTable<>& edges, const std::vector<signed char>& signs)
{
  SkdBadEdges bad;
  edges.ForEach(
    [&](std::uint32_t low, const SkdEdgeUse* first, const SkdEdgeUse* last)
    {
      int sum = 0;
      for (const SkdEdgeUse* use = first; use != last; ++use)
      {
        sum += use->IsForward ? signs[use->Triangle] : -signs[use->Triangle];
      }
      if (sum != 0)
      {
        const auto count = std::count_if(
          first, last, [&signs](const SkdEdgeUse& use) { return signs[use.Triangle] != 0; });
        Add(bad, low, first->High, { sum, static_cast<int>(count) });
      }
    });
  return bad;
}

/// True of nearly all results, and found in less than half of the time that a table takes.
bool AreAllPaired(
  const SkdFacets& facets, const std::vector<signed char>& signs, std::size_t numberOfPoints)
{
  if (numberOfPoints > skd::UnpairedEdges::MostPoints)
  {
    return false;
  }
  skd::UnpairedEdges edges(numberOfPoints);
  for (std::size_t facet = 0; facet < signs.size(); ++facet)
  {
    if (signs[facet] != 0)
    {
      const auto [a, b, c] = facets.Corners[facet];
      edges.AddTriangle(
        signs[facet] > 0 ? SkdTriangleSet::Corners{ a, b, c } : SkdTriangleSet::Corners{ c, b, a });
    }
  }
  return edges.AreNone();
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
  std::map<std::uint32_t, Passes> passesOf; // of surfaces
  facets.Edges.ForEach(
    [&](std::uint32_t low, const SkdEdgeUse* first, const SkdEdgeUse* last)
    {
      if (isBetweenTwo(first, last)) // nearly always
      {
        return;
      }
      passesOf.clear();
      for (const SkdEdgeUse* use = first; use != last; ++use)
      {
        facets.ForEachLayer(use->Triangle,
          [&](std::uint32_t parent, int sign)
          { passesOf[surfaceOf[parent]].Add(use->IsForward ? sign : -sign); });
      }
      for (const auto& [surface, passes] : passesOf)
      {
        Add(bad[surface], low, first->High, passes);
      }
    });
  return bad;
}

SkdBadEdges SkdFindBadEdges(const SkdFacets& facets, const std::vector<signed char>& signs)
{
  return FindBadEdges(facets.Edges, signs);
}

SkdBadEdges SkdFindBadEdges(
  const SkdMovedTriangles& set, const SkdFacets& facets, const std::vector<signed char>& signs)
{
  const std::size_t numberOfPoints = set.GetPoints().size() + facets.NewPoints.size();
  if (AreAllPaired(facets, signs, numberOfPoints))
  {
    return {};
  }
  std::vector<SkdTriangleSet::Corners> corners;
  std::vector<signed char> used;
  for (std::size_t facet = 0; facet < signs.size(); ++facet)
  {
    if (signs[facet] != 0)
    {
      corners.push_back(facets.Corners[facet]);
      used.push_back(signs[facet]);
    }
  }
  return FindBadEdges(SkdMakeEdgeTable(corners, numberOfPoints), used);
}
}
