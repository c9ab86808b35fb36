// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Boolean/SkdRigidPair.h"

#include "Bodies/SkdEdgeTable.h"
#include "Cells/Search/SkdBuildTree.h"
#include "Core/Geometry/DisjointSets.h"
#include "Core/Geometry/MarkedNumbers.h"
#include "Core/Search/Queries/OverlapParts.h"
#include "Core/Search/Tree/LazyTree.h"
#include "Solids/Boolean/SkdSolids.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace skdtree
{
namespace
{
constexpr std::uint32_t None = SkdRigidPair::None;

/// Points that are stored as one (SkdFindEqualPoints), or are taken as one where pieces are joined,
/// are nearer than this, relative to the largest coordinate.
constexpr double Nearness = 1e-12;

/// Areas are told by the largest of three projections, which a rotation changes by less than this.
constexpr double TurnedArea = 0.5;

/// A triangle that is wider than so many roundings has an area wherever it is.
constexpr double RoundingsOfWidth = 256.0;

constexpr std::size_t TrianglesOfOneCluster = 64;

bool IsMirroring(const skd::RigidMotion& motion)
{
  return Dot(Cross(motion.Rows[0], motion.Rows[1]), motion.Rows[2]) < 0.0;
}

/// A tree whose elements are all shifted: its boxes are compared with those of another in single
/// precision, as of two trees that are at rest.
class ShiftedTree
{
public:
  ShiftedTree(const skd::LazyTree<3>& tree, const skd::Vector3& shift)
    : Tree(tree)
    , Frame(tree.GetFrame())
  {
    this->Frame.Centre = this->Frame.Centre + shift;
  }

  bool IsEmpty() const { return this->Tree.IsEmpty(); }
  const skd::Node<3>& Open(std::uint32_t node) const { return this->Tree.Open(node); }
  std::uint32_t Element(std::uint32_t position) const { return this->Tree.Element(position); }
  const skd::Frame<3>& GetFrame() const { return this->Frame; }
  skd::Box3 GetBounds() const
  {
    const skd::Vector3 shift = this->Frame.Centre - this->Tree.GetFrame().Centre;
    return { this->Tree.GetBounds().Min + shift, this->Tree.GetBounds().Max + shift };
  }

private:
  const skd::LazyTree<3>& Tree;
  skd::Frame<3> Frame;
};

bool IsShift(const skd::RigidMotion& motion)
{
  return motion.Rows[0] == skd::Vector3{ { 1, 0, 0 } } &&
    motion.Rows[1] == skd::Vector3{ { 0, 1, 0 } } && motion.Rows[2] == skd::Vector3{ { 0, 0, 1 } };
}

/// Pairs that are given as one number each, which is compared at once.
SkdIndexPairs ListAscending(std::vector<std::uint64_t> numbers)
{
  std::sort(numbers.begin(), numbers.end());
  SkdIndexPairs pairs;
  pairs.reserve(numbers.size());
  for (const std::uint64_t pair : numbers)
  {
    pairs.emplace_back(static_cast<std::uint32_t>(pair >> 32), static_cast<std::uint32_t>(pair));
  }
  return pairs;
}

int NumberOf(const SkdRegionWindings& windings, std::uint32_t surface)
{
  const auto at = std::find_if(windings.begin(), windings.end(),
    [surface](const SkdWindingOf& winding) { return winding.Surface == surface; });
  return at == windings.end() ? 0 : at->Number;
}
}

struct SkdRigidPair::Trees
{
  skd::LazyTree<3> First;
  skd::LazyTree<3> Second; // where it was read
};

SkdRigidPair::SkdRigidPair(SkdTriangleSet&& set, SkdTriangleSet::Extents ofFirst)
  : Set(std::move(set))
  , OfFirst(ofFirst)
{
}

SkdRigidPair::~SkdRigidPair() = default;

/// Whether each triangle is a cell, none is there twice or was lost by the motion.
bool SkdRigidPair::MayBe(const SkdPairState& state, SkdTriangleSet& set)
{
  const std::size_t n = set.GetTriangles().size();
  return state.Placement.Scale == 1.0 && !state.Placement.HasTinyPoints &&
    set.GetCells().size() == n && state.AsRead.GetTriangles().size() == n &&
    set.GetCopiesLeftOut().empty() && !state.Windings.empty();
}

std::unique_ptr<SkdRigidPair> SkdRigidPair::Make(
  const SkdPairState& state, SkdTriangleSet& set, SkdPairCache& cache, vtkAlgorithm* filter)
{
  if (!MayBe(state, set) || cache.Scale != state.Placement.Scale || !cache.Known.Pairs.empty())
  {
    return nullptr;
  }
  SkdUpdateDoubtful(state.Placement, filter, cache);
  if (!cache.Known.Doubtful || !cache.Known.Doubtful->empty())
  {
    return nullptr;
  }
  std::unique_ptr<SkdRigidPair> pair(new SkdRigidPair(std::move(set), {}));
  pair->Middle = cache.Known.End;
  pair->MostRounding = cache.MostRounding;
  pair->IsMirrored = state.IsMirrored;
  const bool isWide =
    TurnedArea * pair->Set.GetLeastWidth() > RoundingsOfWidth * pair->MostRounding;
  if (!isWide || !pair->TakePoints(state) || !pair->FindNeighbours() ||
    !pair->FindComponents(state))
  {
    set = std::move(pair->Set);
    return nullptr;
  }
  pair->FindClusters();
  pair->BuildTrees();
  return pair;
}

/// False if a point is of both surfaces, or if the motion made points one that were not so before.
bool SkdRigidPair::TakePoints(const SkdPairState& state)
{
  std::uint32_t first = 0;
  for (std::uint32_t triangle = 0; triangle < this->Middle; ++triangle)
  {
    const SkdTriangleSet::Corners& corners = this->Set.GetTriangles()[triangle];
    first = std::max({ first, corners[0] + 1, corners[1] + 1, corners[2] + 1 });
  }
  this->FirstPoint = first;
  const std::vector<std::uint32_t>& pointOf = this->Set.GetMerging();
  const auto n = static_cast<std::uint32_t>(this->Set.GetPoints().size());
  this->AsRead.resize(n - first);
  std::uint32_t next = first;
  for (std::uint32_t read = 0; read < pointOf.size(); ++read)
  {
    const std::uint32_t point = pointOf[read];
    const skd::Vector3& x = state.AsRead.GetPoints()[read];
    const bool isOfSource = point >= first;
    if (isOfSource != state.AsRead.IsOfBlocksFrom(read, state.FirstOfSource))
    {
      return false;
    }
    if (isOfSource && point == next)
    {
      this->AsRead[next++ - first] = x;
    }
    else if (isOfSource && !(this->AsRead[point - first] == x))
    {
      return false;
    }
  }
  this->OfFirst = this->Set.FindExtents(first);
  this->OfFirst.LeastArea *= TurnedArea;
  const auto& triangles = this->Set.GetTriangles();
  return next == n &&
    std::none_of(triangles.begin() + this->Middle, triangles.end(),
      [&](const SkdTriangleSet::Corners& corners) {
        return std::min({ corners[0], corners[1], corners[2] }) < first;
      });
}

/// False unless two triangles have each edge, in opposite directions.
bool SkdRigidPair::FindNeighbours()
{
  const std::vector<SkdTriangleSet::Corners> triangles(
    this->Set.GetTriangles().begin(), this->Set.GetTriangles().end());
  this->Neighbours.assign(triangles.size(), { None, None, None });
  bool areTwo = true;
  SkdMakeEdgeTable(triangles, this->Set.GetPoints().size())
    .ForEach(
      [&](std::uint32_t, const SkdEdgeUse* first, const SkdEdgeUse* last)
      {
        if (last - first != 2 || first[0].IsForward == first[1].IsForward)
        {
          areTwo = false;
          return;
        }
        this->Neighbours[first[0].Triangle][first[0].Side] = first[1].Triangle;
        this->Neighbours[first[1].Triangle][first[1].Side] = first[0].Triangle;
      });
  return areTwo;
}

/// In the world in which each surface was read.
void SkdRigidPair::MeasureTriangles()
{
  const auto n = static_cast<std::uint32_t>(this->Set.GetTriangles().size());
  this->AreasBefore.assign(1, SkdAreaSum());
  this->AreasBefore.reserve(n + std::size_t(1));
  for (const bool isOfSource : { false, true })
  {
    const auto at = [&](std::uint32_t corner) {
      return isOfSource ? this->AsRead[corner - this->FirstPoint] : this->Set.GetPoints()[corner];
    };
    const std::uint32_t begin = isOfSource ? this->Middle : 0;
    const std::uint32_t end = isOfSource ? n : this->Middle;
    const int sign = isOfSource && this->IsMirrored ? -1 : 1; // corners are as in the set
    if (begin < end)
    {
      this->Origins[isOfSource] = at(this->Set.GetTriangles()[begin][0]);
    }
    for (std::uint32_t triangle = begin; triangle < end; ++triangle)
    {
      const auto [a, b, c] = this->Set.GetTriangles()[triangle];
      this->AreasBefore.push_back(this->AreasBefore.back());
      this->AreasBefore.back().Add(
        SkdAreaSum({ at(a), at(b), at(c) }, this->Origins[isOfSource], sign), 1);
    }
  }
}

SkdAreaSum SkdRigidPair::Place(const SkdAreaSum& sum, bool isOfSource) const
{
  const skd::Vector3& read = this->Origins[isOfSource];
  const skd::Vector3 origin = isOfSource ? this->Motion.Forward(read) : read;
  SkdAreaSum placed = sum;
  placed.Normal = isOfSource ? this->Motion.Rotate(sum.Normal) : sum.Normal;
  const skd::Vector3 to = this->Set.GetPoints()[0];
  placed.Height += Dot(origin - to, placed.Normal);
  return placed;
}

/// False if winding numbers do not tell what is in front of each component.
bool SkdRigidPair::FindComponents(const SkdPairState& state)
{
  const auto n = static_cast<std::uint32_t>(this->Neighbours.size());
  skd::DisjointSets<> sets(n);
  for (std::uint32_t triangle = 0; triangle < n; ++triangle)
  {
    for (const std::uint32_t other : this->Neighbours[triangle])
    {
      sets.Unite(triangle, other);
    }
  }
  this->ComponentOf = sets.Number();
  this->MeasureTriangles();
  const auto most = std::max_element(this->ComponentOf.begin(), this->ComponentOf.end());
  this->Components.resize(this->ComponentOf.empty() ? 0 : *most + std::size_t(1));
  this->TrianglesOf = skd::IndexRows(this->Components.size(),
    [&](const auto& add)
    {
      for (std::uint32_t triangle = 0; triangle < n; ++triangle)
      {
        add(this->ComponentOf[triangle], triangle);
      }
    });
  for (std::uint32_t number = 0; number < this->Components.size(); ++number)
  {
    Component& component = this->Components[number];
    const auto triangles = this->TrianglesOf[number];
    component.IsOfSource = this->IsOfSource(triangles[0]);
    double most = -1.0;
    SkdAreaSum sum;
    for (const std::uint32_t triangle : triangles)
    {
      const SkdAreaSum area = this->SumAreas(triangle, triangle + 1);
      sum.Add(area, 1);
      component.Largest = area.Size > most ? triangle : component.Largest;
      most = std::max(most, area.Size);
    }
    component.Volume = sum.Height / 6.0;
    component.Area = sum.Size / 2.0;
  }
  std::vector<bool> isKnown(this->Components.size(), false);
  const SkdFacets& facets = state.Arrangement.Facets;
  for (std::uint32_t facet = 0; facet < facets.GetNumberOfFacets(); ++facet)
  {
    const std::uint32_t number = this->ComponentOf[facets.Parents[facet]];
    Component& component = this->Components[number];
    const int inFront =
      NumberOf(state.Windings[state.Arrangement.GetFront(facet)], component.IsOfSource);
    if (isKnown[number] && component.InFront != inFront)
    {
      return false;
    }
    isKnown[number] = true;
    component.InFront = inFront;
  }
  return std::all_of(isKnown.begin(), isKnown.end(), [](bool is) { return is; });
}

void SkdRigidPair::FindClusters()
{
  const auto n = static_cast<std::uint32_t>(this->Neighbours.size());
  this->ClusterOf.assign(n, None);
  for (std::uint32_t start = 0; start < n; ++start)
  {
    std::vector<std::uint32_t> cluster;
    const auto number = static_cast<std::uint32_t>(this->TrianglesOfCluster.size());
    const auto add = [&](std::uint32_t triangle)
    {
      if (this->ClusterOf[triangle] == None && cluster.size() < TrianglesOfOneCluster)
      {
        this->ClusterOf[triangle] = number;
        cluster.push_back(triangle);
      }
    };
    add(start);
    for (std::size_t at = 0; at < cluster.size(); ++at)
    {
      const std::array<std::uint32_t, 3> beside = this->Neighbours[cluster[at]];
      std::for_each(beside.begin(), beside.end(), add);
    }
    if (!cluster.empty())
    {
      this->TrianglesOfCluster.Add(cluster.begin(), cluster.end());
    }
  }
  for (std::uint32_t triangle = 0; triangle < n; ++triangle)
  {
    if (triangle + 1 == n || this->ClusterOf[triangle] != this->ClusterOf[triangle + 1])
    {
      this->EndsOfRuns.push_back(triangle + 1);
    }
  }
  std::vector<std::uint32_t> beside;
  for (std::uint32_t cluster = 0; cluster < this->TrianglesOfCluster.size(); ++cluster)
  {
    beside.clear();
    for (const std::uint32_t triangle : this->TrianglesOfCluster[cluster])
    {
      for (const std::uint32_t other : this->Neighbours[triangle])
      {
        beside.push_back(this->ClusterOf[other]);
      }
    }
    std::sort(beside.begin(), beside.end());
    beside.erase(std::unique(beside.begin(), beside.end()), beside.end());
    beside.erase(std::remove(beside.begin(), beside.end(), cluster), beside.end());
    this->ClustersBeside.Add(beside.begin(), beside.end());
  }
}

void SkdRigidPair::BuildTrees()
{
  std::array<std::vector<skd::Box3>, 2> boxes;
  const auto n = static_cast<std::uint32_t>(this->Set.GetTriangles().size());
  for (std::uint32_t triangle = 0; triangle < n; ++triangle)
  {
    const bool isOfSource = this->IsOfSource(triangle);
    skd::Box3 box;
    for (const std::uint32_t corner : this->Set.GetTriangles()[triangle])
    {
      box.Add(isOfSource ? this->AsRead[corner - this->FirstPoint] : this->Set.GetPoints()[corner]);
    }
    boxes[isOfSource].push_back(box);
  }
  this->Both.reset(new Trees{ SkdBuildLazyTree(skd::MakeTreeInput(boxes[0], 0.0)),
    SkdBuildLazyTree(skd::MakeTreeInput(boxes[1], 0.0)) });
}

bool SkdRigidPair::Move(const skd::RigidMotion& motion)
{
  if (IsMirroring(motion) != this->IsMirrored)
  {
    return false;
  }
  this->Motion = motion;
  return this->Set.PlacePoints(
    this->FirstPoint, this->AsRead, motion, this->OfFirst, this->BoundsOfSource);
}

SkdRigidPair::Near SkdRigidPair::FindNear() const
{
  Near near;
  const double margin = Nearness * (this->Set.GetLargestCoordinate() + Norm(this->Motion.Shift));
  const auto& points = this->Set.GetPoints();
  const auto boxOf = [&](std::uint32_t triangle)
  {
    skd::Box3 box;
    for (const std::uint32_t corner : this->Set.GetTriangles()[triangle])
    {
      box.Add(points[corner]);
    }
    return box;
  };
  skd::MarkedNumbers nearTriangles(this->Set.GetTriangles().size());
  std::vector<std::uint64_t> pairs;
  std::uint32_t known = None; // triangle of the second surface: mostly it is met again at once
  skd::Box3 second;
  skd::Box3 grown;
  const auto visit = [&](std::uint32_t a, std::uint32_t b)
  {
    b += this->Middle;
    if (b != known)
    {
      second = boxOf(b);
      grown = second.Inflated(margin);
      known = b;
    }
    const skd::Box3 first = boxOf(a);
    if (first.Overlaps(grown))
    {
      nearTriangles.Mark(a);
      nearTriangles.Mark(b);
      if (first.Overlaps(second))
      {
        pairs.push_back(static_cast<std::uint64_t>(a) << 32 | b);
      }
    }
    return true;
  };
  const auto search = [&](const auto& second, const auto& toFirst)
  {
    using Second = std::decay_t<decltype(second)>;
    using ToFirst = std::decay_t<decltype(toFirst)>;
    const skd::OverlapParts<3, skd::LazyTree<3>, Second, ToFirst, decltype(visit)> parts(
      this->Both->First, second, toFirst, 1, visit, false);
    parts.Visit(0, parts.size(), visit);
  };
  if (IsShift(this->Motion))
  {
    search(ShiftedTree(this->Both->Second, this->Motion.Shift), skd::SameWorld{ 2.0 * margin });
  }
  else
  {
    search(this->Both->Second, skd::MovedWorld{ this->Motion, 2.0 * margin });
  }
  near.Triangles = nearTriangles.List();
  near.Pairs = ListAscending(std::move(pairs));
  return near;
}
}
