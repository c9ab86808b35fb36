// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Boolean/SkdNearArrangement.h"

#include "Core/Search/Tree/RawVector.h"
#include "Pipeline/SkdLoop.h"
#include "Solids/Boolean/SkdJoinPieces.h"
#include "Solids/Boolean/SkdSlivers.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace skdtree
{
namespace
{
constexpr double Progress = 0.2; // if all must be arranged, that goes on from there
constexpr double DoneProgress = 0.8;
}

std::unique_ptr<SkdNearArrangement> SkdNearArrangement::Make(const SkdRigidPair& pair,
  const SkdPlacement& placement, const SkdNearLimits& limits, vtkAlgorithm* filter)
{
  std::unique_ptr<SkdNearArrangement> near(new SkdNearArrangement(pair, placement));
  if (!near->Arrange(limits, filter))
  {
    return nullptr;
  }
  filter->UpdateProgress(DoneProgress);
  return SkdIsAborted(filter) ? nullptr : std::move(near);
}

bool SkdNearArrangement::Arrange(const SkdNearLimits& limits, vtkAlgorithm* filter)
{
  SkdRigidPair::Near near = this->Pair.FindNear();
  this->Triangles = std::move(near.Triangles);
  if (2 * this->Triangles.size() > this->Pair.GetSet().GetTriangles().size())
  {
    return false; // it does not pay
  }
  this->Set = this->Pair.GetSet().Subset(this->Triangles, this->Points);
  this->Set.LeaveOutCopies(1);
  if (this->Set.GetPoints().size() != this->Points.size())
  {
    return false; // points of both surfaces are one
  }
  this->Placement.emplace(SkdMakePlacement(this->Set, nullptr, std::nullopt));
  skd::RawVector<std::uint32_t> numbers(this->Pair.GetSet().GetTriangles().size()); // of these
  for (std::uint32_t i = 0; i < this->Triangles.size(); ++i)
  {
    numbers[this->Triangles[i]] = i;
  }
  for (auto& [first, second] : near.Pairs)
  {
    first = numbers[first];
    second = numbers[second];
  }
  SkdLoop loop(filter, 0, Progress, Progress, 8);
  const auto pairs =
    SkdTrianglePairs(*this->Placement).FindByPackedRTree({}, SkdPairSearch(), loop, near.Pairs);
  if (!pairs || SkdIsAborted(filter) || pairs->size() > limits.Pairs ||
    std::any_of(pairs->begin(), pairs->end(),
      [](const SkdTrianglePair& pair) { return pair.Contact.Count > 2; }))
  {
    return false;
  }
  SkdLoop splitLoop(filter, 0, Progress, Progress, 64);
  auto part =
    SkdArrangePart(*this->Placement, *pairs, splitLoop, pairs->size() + limits.MoreEvents);
  if (!part)
  {
    return false;
  }
  this->Part = *std::move(part);
  const SkdFacets& facets = this->Part.Facets;
  if (!SkdFindEqualPoints(*this->Placement, facets).empty() ||
    SkdHaveSlivers(*this->Placement, facets, SkdFacetSigns(facets.GetNumberOfFacets(), 1)))
  {
    return false; // what rounding makes of these may concern others
  }
  auto sides = SkdFindNearSides(this->Pair, this->Whole, this->Triangles, this->Points, this->Part);
  if (!sides)
  {
    return false;
  }
  this->Sides = *std::move(sides);
  return true;
}

/// Of a facet that the other surface winds around so often.
signed char SkdNearArrangement::SignOf(
  const SkdBooleanRule& rule, std::uint32_t number, int other) const
{
  const SkdRigidPair::Component& component = this->Pair.GetComponents()[number];
  const auto isSolid = [&](int own)
  {
    SkdRegionWindings windings;
    for (const std::uint32_t surface : { 0u, 1u })
    {
      const int winding = (surface == 1) == component.IsOfSource ? own : other;
      if (winding != 0)
      {
        windings.push_back({ surface, winding });
      }
    }
    return rule.IsSolid(windings);
  };
  return static_cast<signed char>(isSolid(component.InFront + 1) - isSolid(component.InFront));
}

/// Consecutive triangles are mostly of one component and on one side of the other surface, or of
/// two in turn.
class SkdNearArrangement::SignCache
{
public:
  SignCache(const SkdNearArrangement& near, const SkdBooleanRule& rule)
    : Near(near)
    , Rule(rule)
  {
  }

  signed char Get(std::uint32_t component, int other)
  {
    Entry& entry = this->Last[static_cast<unsigned>(other) % this->Last.size()];
    if (entry.Component != component || entry.Other != other)
    {
      entry = { component, other, this->Near.SignOf(this->Rule, component, other) };
    }
    return entry.Sign;
  }

private:
  struct Entry
  {
    std::uint32_t Component = SkdRigidPair::None;
    int Other = 0;
    signed char Sign = 0;
  };

  const SkdNearArrangement& Near;
  const SkdBooleanRule& Rule;
  std::array<Entry, 4> Last;
};

SkdFacetSigns SkdNearArrangement::FindSigns(const SkdBooleanRule& rule) const
{
  SkdFacetSigns signs(this->Sides.OfFacets.size());
  SignCache cache(*this, rule);
  for (std::uint32_t facet = 0; facet < signs.size(); ++facet)
  {
    const std::uint32_t triangle = this->Triangles[this->Part.Facets.Parents[facet]];
    signs[facet] = cache.Get(this->Pair.GetComponentOf(triangle), this->Sides.OfFacets[facet]);
  }
  return signs;
}

/// Edges at the border of the part are between two facets on one side of the other surface.
SkdBadEdges SkdNearArrangement::FindBadEdges(const SkdFacetSigns& signs) const
{
  SkdBadEdges bad;
  this->Part.Facets.Edges.ForEach(
    [&](std::uint32_t low, const SkdEdgeUse* first, const SkdEdgeUse* last)
    {
      int sum = 0;
      int count = 0;
      for (const SkdEdgeUse* use = first; use != last; ++use)
      {
        sum += use->IsForward ? signs[use->Triangle] : -signs[use->Triangle];
        count += signs[use->Triangle] != 0;
      }
      if (sum != 0 && last - first > 1)
      {
        bad.First = bad.Count++ == 0
          ? SkdSplitEdge{ this->PointOf(low), this->PointOf(first->High) }
          : bad.First;
        bad.Open += count == 1;
      }
    });
  return bad;
}

std::uint32_t SkdNearArrangement::PointOf(std::uint32_t point) const
{
  const auto given = static_cast<std::uint32_t>(this->Points.size());
  const auto ofWhole = static_cast<std::uint32_t>(this->Pair.GetSet().GetPoints().size());
  return point < given ? this->Points[point] : point - given + ofWhole;
}

/// What consecutive triangles are added to.
struct SkdNearArrangement::Merging
{
  SkdNearBoundary& To;
  SignCache Signs;
  std::array<SkdAreaSum, 2> Sums{}; // of each surface
  std::uint32_t Next = 0;           // triangle
  const std::uint32_t* EndOfRun;    // of clusters, at that one or before it
};

/// The facets of a boundary by those of the part, and what they enclose.
SkdNearBoundary SkdNearArrangement::Merge(
  const SkdFacets& facets, const SkdFacetSigns& signs, const SkdBooleanRule& rule) const
{
  SkdNearBoundary merged;
  const auto n = static_cast<std::uint32_t>(this->Pair.GetSet().GetTriangles().size());
  const std::size_t most = n - this->Triangles.size() + facets.GetNumberOfFacets();
  merged.Facets.Facets.Corners.reserve(most);
  merged.Facets.Facets.Parents.reserve(most);
  merged.Facets.Signs.reserve(most);
  Merging merging{ merged, SignCache(*this, rule), {}, 0, this->Pair.GetEndsOfRuns().data() };
  std::uint32_t facet = 0;
  for (std::uint32_t i = 0; i < this->Triangles.size(); ++i)
  {
    this->AddWhole(this->Triangles[i], merging);
    merging.Next = this->Triangles[i] + 1;
    for (; facet < signs.size() && facets.Parents[facet] == i; ++facet)
    {
      const auto [a, b, c] = facets.Corners[facet];
      merged.Facets.Facets.Corners.push_back(
        { this->PointOf(a), this->PointOf(b), this->PointOf(c) });
      merged.Facets.Facets.Parents.push_back(this->Triangles[i]);
      merged.Facets.Signs.push_back(signs[facet]);
    }
  }
  this->AddWhole(n, merging);
  merged.Facets.Facets.NewPoints = this->PointsOfWhole(facets.NewPoints.Get());
  merged.Measures = this->Measure(facets, signs, merging.Sums);
  return merged;
}

/// The component of a triangle that is not in the part, and how often the other surface winds
/// around it.
std::pair<std::uint32_t, int> SkdNearArrangement::KindOf(std::uint32_t triangle) const
{
  const int ofCluster = this->Sides.OfClusters[this->Pair.GetClusterOf(triangle)];
  return { this->Pair.GetComponentOf(triangle),
    ofCluster == SkdNearSides::Near ? this->Sides.OfTriangles[triangle] : ofCluster };
}

/// Adds the triangles up to one that are not in the part.
void SkdNearArrangement::AddWhole(std::uint32_t end, Merging& merging) const
{
  const auto* const all = this->Pair.GetSet().GetTriangles().data();
  SkdFacets& to = merging.To.Facets.Facets;
  SkdFacetSigns& signs = merging.To.Facets.Signs;
  while (merging.Next < end)
  {
    const std::uint32_t begin = merging.Next;
    const std::pair<std::uint32_t, int> kind = this->KindOf(begin);
    do
    {
      while (*merging.EndOfRun <= merging.Next)
      {
        ++merging.EndOfRun;
      }
      const int ofCluster = this->Sides.OfClusters[this->Pair.GetClusterOf(merging.Next)];
      merging.Next =
        ofCluster == SkdNearSides::Near ? merging.Next + 1 : std::min(*merging.EndOfRun, end);
    } while (merging.Next < end && this->KindOf(merging.Next) == kind);
    const signed char sign = merging.Signs.Get(kind.first, kind.second);
    if (sign != 0)
    {
      const std::size_t count = merging.Next - begin;
      to.Corners.insert(to.Corners.end(), all + begin, all + merging.Next);
      to.Parents.resize(to.Parents.size() + count);
      std::iota(to.Parents.end() - static_cast<std::ptrdiff_t>(count), to.Parents.end(), begin);
      signs.insert(signs.end(), count, sign);
      merging.Sums[this->Pair.IsOfSource(begin)].Add(
        this->Pair.SumAreas(begin, merging.Next), sign);
    }
  }
}

std::vector<SkdSplitPoint> SkdNearArrangement::PointsOfWhole(
  std::vector<SkdSplitPoint> points) const
{
  for (SkdSplitPoint& point : points)
  {
    point.Parent = this->Triangles[point.Parent];
    for (std::uint32_t& corner : point.Corners)
    {
      corner = this->Points[corner];
    }
  }
  return points;
}

/// Of facets of the part, and others that are summed up.
SkdBoundaryMeasures SkdNearArrangement::Measure(const SkdFacets& facets, const SkdFacetSigns& signs,
  const std::array<SkdAreaSum, 2>& others) const
{
  if (this->Pair.GetSet().GetPoints().empty())
  {
    return {};
  }
  SkdAreaSum sum = this->Pair.Place(others[0], false);
  sum.Add(this->Pair.Place(others[1], true), 1);
  const skd::Vector3 origin = this->Pair.GetSet().GetPoints()[0];
  for (std::uint32_t facet = 0; facet < signs.size(); ++facet)
  {
    if (signs[facet] != 0)
    {
      sum.Add(
        SkdAreaSum(facets.GetPositions(this->Placement->First, facet), origin, 1), signs[facet]);
    }
  }
  return { sum.Height / 6.0, sum.Size / 2.0 };
}

// Slivers among joined pieces may be taken out with triangles beside them, which are not in the
// part: then all of the boundary is joined.
SkdNearBoundary SkdNearArrangement::Select(
  const SkdBooleanRule& rule, bool joins, SkdFaceSets& faces) const
{
  const SkdFacets& facets = this->Part.Facets;
  const SkdFacetSigns signs = this->FindSigns(rule);
  std::optional<SkdRoundedFacets> joined;
  if (joins)
  {
    std::vector<std::uint32_t> origins;
    for (const std::uint32_t triangle : this->Triangles)
    {
      origins.push_back(2 * triangle);
    }
    joined = SkdJoinPieces(*this->Placement, facets, signs, origins, faces);
  }
  const bool mayConcernOthers = joined &&
    (joined->NumberFolded > 0 || SkdHaveSlivers(*this->Placement, joined->Facets, joined->Signs));
  SkdNearBoundary boundary = joined && !mayConcernOthers
    ? this->Merge(joined->Facets, joined->Signs, rule)
    : this->Merge(facets, signs, rule);
  if (mayConcernOthers)
  {
    faces.Separate(); // as they were: each triangle is a cell (SkdRigidPair)
    auto all = SkdJoinPieces(this->Whole, boundary.Facets.Facets, boundary.Facets.Signs, {}, faces);
    if (all)
    {
      boundary.Facets = *std::move(all);
      boundary.Facets.NumberFolded = 0; // as of joined pieces in any case
    }
  }
  boundary.Bad = this->FindBadEdges(signs);
  return boundary;
}
}
