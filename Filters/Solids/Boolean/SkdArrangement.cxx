// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Boolean/SkdArrangement.h"

#include "Core/Geometry/DisjointSets.h"
#include "Core/Geometry/Predicates/Orient3D.h"
#include "Pipeline/SkdLoop.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace skdtree
{
namespace
{
/// The order of facets around an edge, by exact signs: only the corners of the triangles that they
/// are pieces of, which are given points, and the line of the edge are compared.
class EdgeFan
{
public:
  /// `ids` are the new points of the facets in the points of the segments.
  EdgeFan(const SkdMovedTriangles& set, const SkdSplitPoints& points, const SkdFacets& facets,
    const std::vector<std::uint32_t>& ids)
    : Set(set)
    , Points(points)
    , Facets(facets)
    , Ids(ids)
  {
  }

  /// Sorts the uses of an edge as its facets follow each other around it: counterclockwise as seen
  /// from its higher end, from the first on. O(k log k) exact tests.
  void Sort(std::uint32_t low, std::vector<SkdEdgeUse>& uses) const;

private:
  int SideOf(std::uint32_t low, const SkdEdgeUse& use, std::uint32_t plane) const;
  int OrientationOf(std::uint32_t low, const SkdEdgeUse& from, const SkdEdgeUse& to) const;
  int SideOfLine(std::uint32_t a, std::uint32_t b, const skd::Vector3& x, int axis) const;
  skd::ExactPoint ExactOf(std::uint32_t point) const;

  const SkdMovedTriangles& Set;
  const SkdSplitPoints& Points;
  const SkdFacets& Facets;
  const std::vector<std::uint32_t>& Ids;
};

void EdgeFan::Sort(std::uint32_t low, std::vector<SkdEdgeUse>& uses) const
{
  struct SortedUse
  {
    SkdEdgeUse Use;
    int Half; // 0: less than half a turn from the first, 1: half a turn, 2: more
  };
  std::vector<SortedUse> sorted;
  for (std::size_t i = 1; i < uses.size(); ++i)
  {
    sorted.push_back({ uses[i], 1 - this->OrientationOf(low, uses[0], uses[i]) });
  }
  std::sort(sorted.begin(), sorted.end(),
    [&](const SortedUse& a, const SortedUse& b)
    {
      if (a.Half != b.Half)
      {
        return a.Half < b.Half;
      }
      const int order = this->OrientationOf(low, a.Use, b.Use);
      return order != 0 ? order > 0 : a.Use.Triangle < b.Use.Triangle;
    });
  for (std::size_t i = 1; i < uses.size(); ++i)
  {
    uses[i] = sorted[i - 1].Use;
  }
}

/// 1 if the shortest turn from one facet to another is counterclockwise, 0 if they are in a plane.
int EdgeFan::OrientationOf(std::uint32_t low, const SkdEdgeUse& from, const SkdEdgeUse& to) const
{
  const int side = this->SideOf(low, to, this->Facets.Parents[from.Triangle]);
  return from.IsForward ? side : -side;
}

/// On which side of the plane of a triangle a facet is that meets it in an edge: 1 in front, -1
/// behind, 0 in it. A corner of the facet's triangle that is not in the plane has an exact side,
/// and is on the facet's side of the edge or on the other one.
int EdgeFan::SideOf(std::uint32_t low, const SkdEdgeUse& use, std::uint32_t plane) const
{
  const std::uint32_t triangle = this->Facets.Parents[use.Triangle];
  if (triangle == plane)
  {
    return 0; // exact signs would tell it slowly
  }
  const std::array<skd::Vector3, 3> x = this->Set.GetCornerPoints(triangle);
  const std::array<skd::Vector3, 3> p = this->Set.GetCornerPoints(plane);
  const int axis = this->Set.Get(triangle).Axis;
  const int facing = skd::Orient2D(x[0], x[1], x[2], axis);
  for (const skd::Vector3& corner : x)
  {
    const int above = skd::Orient3D(p[0], p[1], p[2], corner);
    if (above != 0)
    {
      const int left = this->SideOfLine(low, use.High, corner, axis);
      return above * (use.IsForward ? left : -left) * facing;
    }
  }
  return 0;
}

int EdgeFan::SideOfLine(std::uint32_t a, std::uint32_t b, const skd::Vector3& x, int axis) const
{
  const int sign = skd::FilteredOrient2D(this->Facets.GetPosition(this->Set, a),
    this->Facets.GetPosition(this->Set, b), x, axis, this->Points.GetError());
  return sign != 0
    ? sign
    : skd::ExactArea(this->ExactOf(a), this->ExactOf(b), skd::ExactPoint(x), axis).Sign();
}

skd::ExactPoint EdgeFan::ExactOf(std::uint32_t point) const
{
  const auto& given = this->Set.GetPoints();
  return point < given.size() ? skd::ExactPoint(given[point])
                              : this->Points.GetExact(this->Ids[point - given.size()]);
}

//------------------------------------------------------------------------------
/// The uses of an edge.
struct EdgeUses
{
  std::uint32_t Low;
  const SkdEdgeUse* First;
  const SkdEdgeUse* Last;
};

/// The patch of each facet: those that are connected by edges that only two of them have, one in
/// each direction, so that both sides of a patch are each in one region. Lists the other edges.
std::vector<std::uint32_t> FindPatches(const SkdFacets& facets, std::vector<EdgeUses>& others)
{
  skd::DisjointSets<> patches(facets.GetNumberOfFacets());
  facets.Edges.ForEach(
    [&](std::uint32_t low, const SkdEdgeUse* first, const SkdEdgeUse* last)
    {
      if (last - first == 2 && first[0].IsForward != first[1].IsForward)
      {
        patches.Unite(first[0].Triangle, first[1].Triangle);
        return;
      }
      others.push_back({ low, first, last });
    });
  return patches.Number();
}

void FindRegions(const EdgeFan& fan, bool goesOn, SkdArrangement& arrangement)
{
  std::vector<EdgeUses> edges;
  const std::vector<std::uint32_t> patchOf = FindPatches(arrangement.Facets, edges);
  const auto patches = std::max_element(patchOf.begin(), patchOf.end());
  skd::DisjointSets<> sides(patchOf.empty() ? 0 : 2 * (*patches + std::size_t(1)));
  const auto ofPatch = [&patchOf](std::uint32_t side) { return 2 * patchOf[side / 2] + side % 2; };
  std::vector<SkdEdgeUse> uses;
  for (const EdgeUses& edge : edges)
  {
    uses.assign(edge.First, edge.Last);
    if (goesOn && uses.size() == 1)
    {
      continue;
    }
    if (uses.size() > 2) // the order of two does not matter
    {
      fan.Sort(edge.Low, uses);
    }
    for (std::size_t i = 0; i < uses.size(); ++i)
    {
      const SkdEdgeUse& next = uses[i + 1 == uses.size() ? 0 : i + 1];
      sides.Unite(ofPatch(SkdSideLeft(uses[i])), ofPatch(SkdSideEntered(next)));
    }
  }
  const std::vector<std::uint32_t> regions = sides.Number(); // patches are by their first facets
  arrangement.Regions.resize(2 * patchOf.size());
  for (std::uint32_t side = 0; side < arrangement.Regions.size(); ++side)
  {
    arrangement.Regions[side] = regions[ofPatch(side)];
  }
  for (const std::uint32_t region : regions)
  {
    arrangement.NumberOfRegions = std::max(arrangement.NumberOfRegions, region + 1);
  }
}

void Keep(const std::vector<SkdTrianglePair>& pairs, double scale, SkdPairCache& cache)
{
  cache.Scale = scale;
  cache.Known.Pairs.clear();
  std::copy_if(pairs.begin(), pairs.end(), std::back_inserter(cache.Known.Pairs),
    [&cache](const SkdTrianglePair& pair) { return pair.Second < cache.Known.End; });
  cache.Known.Doubtful.reset();
  cache.NumberOfTriangles = 0;
}

/// Triangles of a set at random, on average one in so many.
std::vector<std::uint32_t> PickTriangles(const SkdTriangleSet& set, std::size_t oneIn)
{
  const std::vector<std::uint32_t>& searched = set.GetSearched();
  const std::size_t n = searched.empty() ? set.GetTriangles().size() : searched.size();
  std::minstd_rand random; // the same numbers everywhere
  std::vector<std::uint32_t> picked;
  for (std::size_t i = random() % oneIn; i < n; i += 1 + random() % (2 * oneIn - 1))
  {
    picked.push_back(searched.empty() ? static_cast<std::uint32_t>(i) : searched[i]);
  }
  return picked;
}
}

void SkdUpdateDoubtful(const SkdPlacement& placement, vtkAlgorithm* filter, SkdPairCache& cache)
{
  constexpr double progress = 0.2; // the search of pairs goes on from there
  constexpr double room = 1e3;     // so that farther motions have no larger roundings
  const SkdTriangleSet& set = placement.First.GetSet();
  const std::size_t n = set.GetTriangles().size();
  const bool isKnown = cache.NumberOfTriangles == n && cache.Rounding <= cache.MostRounding &&
    cache.PointOf == set.GetMerging();
  if (!isKnown)
  {
    cache.MostRounding = room * cache.Rounding;
    cache.PointOf = set.GetMerging();
    cache.NumberOfTriangles = n;
    SkdLoop loop(filter, 0, progress, progress, 64);
    cache.Known.Doubtful = SkdFindDoubtfulPairs(
      placement.First, cache.Known.End, 2.0 * cache.MostRounding * placement.Scale, loop);
  }
}

std::optional<SkdSelfPairs> SkdFindSelfPairs(SkdTriangleSet& set, const SkdPlacement& placement,
  SkdLoop& loop, vtkAlgorithm* filter, SkdPairCache* cache, std::size_t most,
  const std::vector<std::uint32_t>* among)
{
  SkdPairSearch search;
  search.Among = among;
  bool areMore = false;
  search.AreMore = &areMore;
  if (!cache)
  {
    search.Most = most;
  }
  // What is left out as a copy, or taken as 0, depends on all of the set.
  const bool mayKeep = cache && set.GetCopiesLeftOut().empty() && !placement.HasTinyPoints;
  const bool areKnown = mayKeep && cache->Scale == placement.Scale;
  if (areKnown)
  {
    SkdUpdateDoubtful(placement, filter, *cache);
  }
  auto pairs = SkdTrianglePairs(placement).FindSelfIntersections(
    search, loop, areKnown ? &cache->Known : nullptr);
  if (!pairs)
  {
    set.Complete();
    pairs = SkdTrianglePairs(placement).FindByTrees(search, loop);
  }
  if (SkdIsAborted(filter))
  {
    if (cache)
    {
      cache->NumberOfTriangles = 0; // what was to be found may not be there
    }
    return std::nullopt;
  }
  if (areMore)
  {
    return SkdSelfPairs{ {}, {}, true };
  }
  if (mayKeep && !areKnown)
  {
    Keep(*pairs, placement.Scale, *cache);
  }
  SkdSelfPairs found{ *std::move(pairs), {}, false };
  found.Duplicates = SkdTakeDuplicates(placement.First, found.Pairs);
  const std::vector<SkdDuplicate>& copies = set.GetCopiesLeftOut();
  found.Duplicates.insert(found.Duplicates.end(), copies.begin(), copies.end());
  std::sort(found.Duplicates.begin(), found.Duplicates.end());
  return found;
}

bool SkdSegmentsMeetOften(
  const SkdPlacement& placement, std::size_t leastPairs, std::size_t perPair, SkdLoop& loop)
{
  constexpr std::size_t enough = 256; // pairs
  constexpr std::size_t fewest = 16;  // triangles
  auto oneIn = static_cast<std::size_t>(std::sqrt(static_cast<double>(leastPairs) / enough));
  for (oneIn = std::max<std::size_t>(1, oneIn);; oneIn *= 2)
  {
    const std::vector<std::uint32_t> picked = PickTriangles(placement.First.GetSet(), oneIn);
    if (picked.size() < fewest)
    {
      return true;
    }
    bool areMore = false;
    SkdPairSearch search;
    search.Among = &picked;
    search.Most = 4 * enough;
    search.AreMore = &areMore;
    auto pairs = SkdTrianglePairs(placement).FindSelfIntersections(search, loop);
    if (pairs && !areMore)
    {
      SkdTakeDuplicates(placement.First, *pairs);
      const SkdContactPoints contacts(placement, *pairs);
      const std::size_t most = perPair * pairs->size() / oneIn;
      return SkdSplitSegments(placement, *pairs, contacts, most).IsTooMany();
    }
  }
}

std::vector<SkdTrianglePair> SkdFindPairsWithin(SkdTriangleSet& set, const SkdPlacement& placement,
  const std::vector<std::uint32_t>& pieceOf, SkdLoop& loop)
{
  const skd::Rows<std::uint32_t> pieces(
    pieceOf.empty() ? 0 : 1 + *std::max_element(pieceOf.begin(), pieceOf.end()),
    [&](const auto& add)
    {
      for (std::uint32_t triangle = 0; triangle < pieceOf.size(); ++triangle)
      {
        if (set.IsSearched(triangle))
        {
          add(pieceOf[triangle], triangle);
        }
      }
    });
  const SkdTrianglePairs search(placement);
  std::vector<SkdTrianglePair> pairs;
  for (std::size_t piece = 0; piece < pieces.size(); ++piece)
  {
    const std::vector<std::uint32_t> among(pieces[piece].begin(), pieces[piece].end());
    if (among.size() < 2)
    {
      continue;
    }
    SkdPairSearch within;
    within.Among = &among;
    const auto found = search.FindSelfIntersections(within, loop);
    if (!found)
    {
      set.Complete();
      return search.FindByTrees(SkdPairSearch(), loop);
    }
    pairs.insert(pairs.end(), found->begin(), found->end());
  }
  return pairs;
}

std::optional<SkdArrangement> SkdArrange(const SkdPlacement& placement, const SkdSelfPairs& found,
  SkdLoop& loop, std::size_t mostEvents, bool goesOn)
{
  const std::vector<SkdTrianglePair>& pairs = found.Pairs;
  const SkdContactPoints contacts(placement, pairs);
  SkdSplitSegments segments(placement, pairs, contacts, mostEvents);
  if (segments.IsTooMany())
  {
    return SkdArrangement{ {}, {}, 0, 0, true };
  }
  std::optional<SkdSplitResult> done = SkdSplitTriangles(segments, 0, loop);
  if (!done)
  {
    return std::nullopt;
  }
  SkdSplitResult& split = *done;
  SkdOverlaps overlaps = SkdFindOverlaps(pairs, contacts, segments, split);
  segments.ForgetSegments();
  if (!found.Duplicates.empty())
  {
    overlaps.Add(found.Duplicates, split);
  }
  const std::vector<std::uint32_t> ids = std::move(split.Ids);
  const vtkIdType numberSplit = split.NumberSplit;
  SkdArrangement arrangement{ SkdFacets(segments, std::move(split), overlaps), {}, 0, numberSplit,
    false };
  FindRegions(
    EdgeFan(placement.First, segments.GetPoints(), arrangement.Facets, ids), goesOn, arrangement);
  return arrangement;
}

std::optional<SkdArrangedPart> SkdArrangePart(const SkdPlacement& placement,
  const std::vector<SkdTrianglePair>& pairs, SkdLoop& loop, std::size_t mostEvents)
{
  const SkdContactPoints contacts(placement, pairs);
  const SkdSplitSegments segments(placement, pairs, contacts, mostEvents);
  if (segments.IsTooMany())
  {
    return std::nullopt;
  }
  std::optional<SkdSplitResult> split = SkdSplitTriangles(segments, 0, loop);
  if (!split)
  {
    return std::nullopt;
  }
  const std::vector<std::uint32_t> ids = std::move(split->Ids);
  SkdArrangedPart part;
  part.NumberSplit = split->NumberSplit;
  const SkdOverlaps none{ std::vector<bool>(split->Triangles.size(), false), {} };
  part.Facets = SkdFacets(segments, *std::move(split), none);
  const EdgeFan fan(placement.First, segments.GetPoints(), part.Facets, ids);
  part.Facets.Edges.ForEach(
    [&](std::uint32_t low, const SkdEdgeUse* first, const SkdEdgeUse* last)
    {
      if (last - first > 2)
      {
        part.Fans.emplace_back(first, last);
        fan.Sort(low, part.Fans.back());
      }
    });
  return part;
}
}
