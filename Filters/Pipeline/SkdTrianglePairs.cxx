// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/SkdTrianglePairs.h"

#include "Core/Geometry/ClosestTriangles.h"
#include "Core/Queries/OverlappingPairs.h"
#include "Core/Tree/WalkPairs.h"
#include "Pipeline/SkdLoop.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

//------------------------------------------------------------------------------
/// A search on its way, shared by all its parts.
class SkdTrianglePairs::Search
{
public:
  Search(const SkdPlacement& placement, const SkdPairSearch& search)
    : First(placement.First)
    , Second(placement.GetSecond())
    , IsOfOne(placement.IsOfOne())
    , Wanted(search.Wanted)
    , Clearance2(std::pow(search.Clearance * placement.Scale, 2))
    , Lowest(std::numeric_limits<std::uint64_t>::max())
  {
  }

  /// Looks at two triangles whose boxes overlap. False when no more is wanted.
  bool Visit(std::uint32_t first, std::uint32_t second, std::vector<SkdTrianglePair>& found)
  {
    if (this->IsOfOne && second < first)
    {
      std::swap(first, second);
    }
    const std::uint64_t key = (static_cast<std::uint64_t>(first) << 32) | second;
    if (this->Wanted != SkdPairSearch::All && key >= this->Lowest)
    {
      return this->Wanted == SkdPairSearch::LowestOnly;
    }
    SkdTrianglePair pair{ first, second, {} };
    if (this->IsPair(pair))
    {
      this->Keep(key, pair, found);
    }
    return true;
  }

private:
  bool IsPair(SkdTrianglePair& pair) const
  {
    if (this->Clearance2 == 0.0 && this->AreSurelyApart(pair))
    {
      return false;
    }
    const skd::SeenTriangle first = this->First.Get(pair.First);
    const skd::SeenTriangle second = this->Second.Get(pair.Second);
    if (first.Axis < 0 || second.Axis < 0)
    {
      return false;
    }
    skd::SharedCorners shared = skd::NoSharedCorners;
    const int numberShared = this->IsOfOne ? this->FindShared(pair, shared) : 0;
    pair.Contact = skd::FindContact(first, second, shared);
    if (pair.Contact.Count > numberShared || numberShared == 3)
    {
      return true;
    }
    const bool isNear = this->Clearance2 > 0.0 && numberShared == 0 &&
      skd::ClosestPoints(first.Corners, second.Corners).Dist2 <= this->Clearance2;
    return isNear;
  }

  bool AreSurelyApart(const SkdTrianglePair& pair) const
  {
    const auto first = this->First.GetCornerPoints(pair.First);
    const auto second = this->Second.GetCornerPoints(pair.Second);
    return skd::AreSurelyOnOneSide(first, second) || skd::AreSurelyOnOneSide(second, first);
  }

  int FindShared(const SkdTrianglePair& pair, skd::SharedCorners& shared) const
  {
    const SkdTriangleSet::Corners& first = this->First.GetCorners(pair.First);
    const SkdTriangleSet::Corners& second = this->Second.GetCorners(pair.Second);
    int count = 0;
    for (std::int8_t i = 0; i < 3; ++i)
    {
      for (std::int8_t k = 0; k < 3; ++k)
      {
        if (first[i] == second[k])
        {
          shared[i] = k;
          ++count;
        }
      }
    }
    return count;
  }

  void Keep(std::uint64_t key, const SkdTrianglePair& pair, std::vector<SkdTrianglePair>& found)
  {
    if (this->Wanted != SkdPairSearch::All)
    {
      found.clear();
      std::uint64_t lowest = this->Lowest;
      const std::uint64_t next = this->Wanted == SkdPairSearch::LowestOnly ? key : 0;
      while (next < lowest && !this->Lowest.compare_exchange_weak(lowest, next))
      {
      }
    }
    found.push_back(pair);
  }

  const SkdPlacedTriangles& First;
  const SkdPlacedTriangles& Second;
  const bool IsOfOne;
  const SkdPairSearch::Extent Wanted;
  const double Clearance2;
  std::atomic<std::uint64_t> Lowest; // 0 when any was wanted and one is there
};

/// A box of the second set as a box around where it is moved to, with a margin.
struct SkdTrianglePairs::Moved
{
  const skd::RigidMotion& Motion;
  double Margin;

  skd::Box3 operator()(const skd::Box3& box) const
  {
    return this->Motion.Forward(box).Inflated(this->Margin);
  }
};

/// What is walked; `near` is nullptr where trees are of all triangles.
struct SkdTrianglePairs::Trees
{
  const skd::LazyTree<3>& First;
  const skd::LazyTree<3>& Second;
  const SkdNearSets* Near;
};

struct SkdTrianglePairs::Leaf
{
  Search& State;
  const SkdNearSets* Near;
  std::vector<SkdTrianglePair>& Found;

  bool operator()(std::uint32_t a, std::uint32_t b) const
  {
    return this->Near ? this->State.Visit(this->Near->First.Triangles[a],
                          this->Near->Second.Triangles[b], this->Found)
                      : this->State.Visit(a, b, this->Found);
  }
};

namespace
{
void SortPairs(std::vector<SkdTrianglePair>& pairs)
{
  vtkSMPTools::Sort(pairs.begin(), pairs.end(),
    [](const SkdTrianglePair& a, const SkdTrianglePair& b)
    { return a.First != b.First ? a.First < b.First : a.Second < b.Second; });
}
}

//------------------------------------------------------------------------------
// Boxes are moved with a margin for what rounding does to the points: the largest coordinate before
// the motion and the shift bound all numbers on the way.
std::vector<SkdTrianglePair> SkdTrianglePairs::Find(
  const SkdPairSearch& search, SkdLoop& loop) const
{
  const Trees trees{ this->Placement.First.GetSet().GetTree(),
    this->Placement.GetSecond().GetSet().GetTree(), nullptr };
  const auto& motion = this->Placement.Motion;
  if (!motion)
  {
    return this->FindSeen(trees, skd::SameWorld{ search.Clearance }, search, loop);
  }
  const double reach = 2.0 * this->Placement.GetSecond().GetSet().GetReach() + Norm(motion->Shift);
  const double rounding = 32.0 * std::numeric_limits<double>::epsilon() * reach;
  return this->FindSeen(trees, Moved{ *motion, search.Clearance + rounding }, search, loop);
}

//------------------------------------------------------------------------------
std::vector<SkdTrianglePair> SkdTrianglePairs::FindNear(
  const SkdNearSets& near, const SkdPairSearch& search, SkdLoop& loop) const
{
  const Trees trees{ near.First.Tree, near.Second.Tree, &near };
  return this->FindSeen(
    trees, skd::SameWorld{ search.Clearance * this->Placement.Scale }, search, loop);
}

//------------------------------------------------------------------------------
template <class ToFirst>
std::vector<SkdTrianglePair> SkdTrianglePairs::FindSeen(
  const Trees& trees, const ToFirst& toFirst, const SkdPairSearch& search, SkdLoop& loop) const
{
  using Query = skd::OverlappingPairs<3, ToFirst, Leaf>;
  using Walk = skd::PairWalk<skd::LazyTree<3>, skd::LazyTree<3>, Query>;
  const skd::LazyTree<3>& first = trees.First;
  const skd::LazyTree<3>& second = trees.Second;
  Search state(this->Placement, search);
  const auto inWalk = [&](std::vector<SkdTrianglePair>& found, const auto& body)
  {
    Leaf leaf{ state, trees.Near, found };
    Query query(first.GetFrame(), second.GetFrame(), toFirst, leaf);
    Walk walk = this->Placement.IsOfOne() ? Walk(first, query) : Walk(first, second, query);
    body(walk);
  };

  std::vector<SkdTrianglePair> all;
  std::vector<typename Walk::Pair> starts;
  inWalk(all, [&](Walk& walk) { starts = walk.Split(NumberOfParts); });
  std::vector<std::vector<SkdTrianglePair>> found(starts.size());
  loop.For(static_cast<vtkIdType>(starts.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      inWalk(found[begin],
        [&](Walk& walk)
        {
          for (vtkIdType i = begin; i < end; ++i)
          {
            walk.RunFrom(starts[i]);
          }
        });
    });
  for (const std::vector<SkdTrianglePair>& some : found)
  {
    all.insert(all.end(), some.begin(), some.end());
  }
  SortPairs(all);
  all.resize(
    search.Wanted == SkdPairSearch::All ? all.size() : std::min<std::size_t>(1, all.size()));
  return all;
}

//------------------------------------------------------------------------------
std::vector<std::uint32_t> SkdTrianglesOf(
  const std::vector<SkdTrianglePair>& pairs, std::uint32_t SkdTrianglePair::*side)
{
  std::vector<std::uint32_t> triangles;
  triangles.reserve(pairs.size());
  for (const SkdTrianglePair& pair : pairs)
  {
    triangles.push_back(pair.*side);
  }
  std::sort(triangles.begin(), triangles.end());
  triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
  return triangles;
}
