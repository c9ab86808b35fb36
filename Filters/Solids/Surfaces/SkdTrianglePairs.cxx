// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Surfaces/SkdTrianglePairs.h"

#include "Cells/Read/SkdForEach.h"
#include "Core/Geometry/Distance/ClosestTriangles.h"
#include "Core/Geometry/Intersection/NeighbourTriangles.h"
#include "Core/Geometry/Intersection/TriangleContact.h"
#include "Core/Search/Queries/ClippedPairs.h"
#include "Core/Search/Queries/MonotonePatches.h"
#include "Core/Search/Queries/OverlapParts.h"
#include "Core/Search/Tree/LazyTree.h"
#include "Core/Search/Tree/PackedRTree.h"
#include "Pipeline/SkdLoop.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

namespace skdtree
{
SkdGap SkdFindGap(const SkdPlacement& placement, const SkdTrianglePair& pair)
{
  const auto [first, second, dist2] =
    skd::ClosestPoints(placement.First.GetCornerPoints(pair.First),
      placement.GetSecond().GetCornerPoints(pair.Second));
  const double unscaled = 1.0 / placement.Scale;
  return { unscaled * first, unscaled * second, dist2 * unscaled * unscaled };
}

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
    if (this->IsOfOne && this->AreOnlyNeighbours(first, second))
    {
      return true;
    }
    return this->Visit(first, this->First.GetInPlane(first), second, found);
  }

  /// The same of one triangle of the first set and several of the other.
  bool VisitAll(std::uint32_t first, const std::vector<std::uint32_t>& others,
    std::vector<SkdTrianglePair>& found)
  {
    const skd::TriangleInPlane triangle = this->First.GetInPlane(first);
    return std::all_of(others.begin(), others.end(),
      [&](std::uint32_t second) { return this->Visit(first, triangle, second, found); });
  }

  /// The same of one triangle of a surface and others of it that are seldom neighbours.
  bool VisitEach(std::uint32_t first, const std::vector<std::uint32_t>& others,
    std::vector<SkdTrianglePair>& found)
  {
    return std::all_of(others.begin(), others.end(),
      [&](std::uint32_t second) { return this->VisitClosely(first, second, found); });
  }

  /// The same of one triangle of a surface and several others of it. Most share corners with it or
  /// have their other corners strictly on one side of its plane, where nothing but what is shared
  /// is common: that is looked at first, and inline, for all others at once.
  SKD_FLATTEN bool VisitWithin(std::uint32_t first, const std::vector<std::uint32_t>& others,
    std::vector<SkdTrianglePair>& found)
  {
    const skd::Vector3* const points = this->First.GetPoints().data();
    const SkdTriangleSet::Corners& a = this->First.GetCorners(first);
    const skd::FloatingPlane plane(points[a[0]], points[a[1]], points[a[2]]);
    for (const std::uint32_t second : others)
    {
      const SkdTriangleSet::Corners& b = this->First.GetCorners(second);
      // Bit i is set if the first triangle has corner i, too. Without branches, because
      // which corners two triangles share can hardly be predicted.
      const auto isShared = [&a](std::uint32_t corner) -> unsigned
      { return (corner == a[0]) | (corner == a[1]) | (corner == a[2]); };
      const unsigned shared = isShared(b[0]) | isShared(b[1]) << 1 | isShared(b[2]) << 2;
      if (!skd::AreOthersOnOneSide(
            plane, { points + b[0], points + b[1], points + b[2] }, shared) &&
        !this->VisitClosely(first, second, found))
      {
        return false;
      }
    }
    return true;
  }

private:
  SKD_NOINLINE bool VisitClosely(
    std::uint32_t first, std::uint32_t second, std::vector<SkdTrianglePair>& found)
  {
    return this->Visit(first, second, found);
  }

  bool Visit(std::uint32_t first, const skd::TriangleInPlane& triangle, std::uint32_t second,
    std::vector<SkdTrianglePair>& found)
  {
    const std::uint64_t key = (static_cast<std::uint64_t>(first) << 32) | second;
    if (this->Wanted != SkdPairSearch::All && key >= this->Lowest)
    {
      return this->Wanted == SkdPairSearch::LowestOnly;
    }
    SkdTrianglePair pair{ first, second, {} };
    if (this->IsPair(pair, triangle))
    {
      this->Keep(key, pair, found);
    }
    return true;
  }

  bool IsPair(SkdTrianglePair& pair, const skd::TriangleInPlane& first) const
  {
    const auto second = this->Second.GetCornerPoints(pair.Second);
    skd::SharedCorners shared = skd::NoSharedCorners;
    const int numberShared = this->IsOfOne ? this->FindShared(pair, shared) : 0;
    pair.Contact = skd::FindContact(first, second, shared);
    const int count = pair.Contact.Count;
    return count > numberShared || (count == 3 && numberShared == 3) ||
      (this->Clearance2 > 0.0 && numberShared == 0 &&
        skd::ClosestPoints(first.Corners, second).Dist2 <= this->Clearance2 &&
        this->First.HasArea(pair.First) && this->Second.HasArea(pair.Second));
  }

  /// Whether two triangles of one surface share corners, and surely nothing else: true of most that
  /// are looked at, so this comes first.
  bool AreOnlyNeighbours(std::uint32_t first, std::uint32_t second) const
  {
    const SkdTriangleSet::Corners& a = this->First.GetCorners(first);
    const SkdTriangleSet::Corners& b = this->First.GetCorners(second);
    unsigned sharedOfFirst = 0;
    unsigned sharedOfSecond = 0;
    for (unsigned i = 0; i < 3; ++i)
    {
      const unsigned same = (a[i] == b[0]) | (a[i] == b[1]) << 1 | (a[i] == b[2]) << 2;
      sharedOfFirst |= (same != 0) << i;
      sharedOfSecond |= same;
    }
    const skd::Vector3* points = this->First.GetPoints().data();
    return sharedOfFirst != 0 &&
      skd::HaveOnlyCornersInCommon({ points + a[0], points + a[1], points + a[2] }, sharedOfFirst,
        { points + b[0], points + b[1], points + b[2] }, sharedOfSecond);
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

  const SkdMovedTriangles& First;
  const SkdMovedTriangles& Second;
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

struct SkdTrianglePairs::Block
{
  Search& State;
  std::vector<SkdTrianglePair>& Found;
  const std::vector<std::uint32_t>& First; // that are in the trees, or empty: all
  const std::vector<std::uint32_t>& Second;

  bool operator()(std::uint32_t a, std::uint32_t b) const
  {
    return this->State.Visit(this->First.empty() ? a : this->First[a],
      this->Second.empty() ? b : this->Second[b], this->Found);
  }
};

namespace
{
bool IsBefore(const SkdTrianglePair& a, const SkdTrianglePair& b)
{
  return a.First != b.First ? a.First < b.First : a.Second < b.Second;
}

/// Merges sorted pairs into others.
void Add(const std::vector<SkdTrianglePair>& pairs, std::vector<SkdTrianglePair>& to)
{
  const auto middle = static_cast<std::ptrdiff_t>(to.size());
  to.insert(to.end(), pairs.begin(), pairs.end());
  std::inplace_merge(to.begin(), to.begin() + middle, to.end(), IsBefore);
}

constexpr std::size_t PacketsOfPart = 16; // of the search within one surface
constexpr std::size_t MaxSize = std::numeric_limits<std::size_t>::max();

template <class TriangleOf>
std::vector<skd::Box3> ListBoxes(
  const SkdMovedTriangles& set, std::size_t count, const TriangleOf& triangleOf)
{
  std::vector<skd::Box3> boxes(count);
  SkdForEach(static_cast<vtkIdType>(count),
    [&](vtkIdType i) { boxes[i] = set.GetBox(triangleOf(static_cast<std::uint32_t>(i))); });
  return boxes;
}

/// Where no pairs need to be looked for, in a tree of some triangles.
template <class TriangleOf>
skd::MonotonePatches FindPatches(const SkdMovedTriangles& set, const skd::PackedRTree& tree,
  std::size_t count, const TriangleOf& triangleOf)
{
  return skd::MonotonePatches(
    tree, count, set.GetPoints(),
    [&](std::uint32_t i) -> const SkdTriangleSet::Corners&
    { return set.GetCorners(triangleOf(i)); },
    [](std::size_t n, const auto& body) { SkdForEach(n, body); });
}

/// Of a triangle and others that it may be a pair with.
void LeaveOutKnown(
  std::uint32_t triangle, const SkdKnownPairs* known, std::vector<std::uint32_t>& others)
{
  if (known && triangle < known->End)
  {
    others.erase(std::remove_if(others.begin(), others.end(),
                   [known](std::uint32_t other) { return other < known->End; }),
      others.end());
  }
}

/// Sorts pairs, and leaves each once.
void SortOnce(std::vector<SkdTrianglePair>& pairs)
{
  vtkSMPTools::Sort(pairs.begin(), pairs.end(), IsBefore);
  pairs.erase(
    std::unique(pairs.begin(), pairs.end(),
      [](const auto& a, const auto& b) { return a.First == b.First && a.Second == b.Second; }),
    pairs.end());
}

/// All that were found, or the lowest; none of more than are wanted, or than `most` with repeated
/// ones.
std::vector<SkdTrianglePair> Gather(
  std::vector<std::vector<SkdTrianglePair>> found, const SkdPairSearch& search, std::size_t most)
{
  std::size_t count = 0;
  for (const std::vector<SkdTrianglePair>& some : found)
  {
    count += some.size();
  }
  std::vector<SkdTrianglePair> all;
  all.reserve(count <= most ? count : 0);
  for (std::size_t i = 0; i < found.size() && count <= most; ++i)
  {
    all.insert(all.end(), found[i].begin(), found[i].end());
    found[i] = {};
  }
  SortOnce(all);
  if (count > most || all.size() > search.Most)
  {
    *search.AreMore = true;
    return {};
  }
  all.resize(
    search.Wanted == SkdPairSearch::All ? all.size() : std::min<std::size_t>(1, all.size()));
  return all;
}
}

//------------------------------------------------------------------------------
// Boxes are moved with a margin for what rounding does to the points: the largest coordinate before
// the motion and the shift bound all numbers on the way.
std::vector<SkdTrianglePair> SkdTrianglePairs::FindByTrees(
  const SkdPairSearch& search, SkdLoop& loop) const
{
  const auto& motion = this->Placement.Motion;
  if (!motion)
  {
    return this->FindByTrees(skd::SameWorld{ search.Clearance }, search, loop);
  }
  const double extent =
    2.0 * this->Placement.GetSecond().GetSet().GetLargestCoordinate() + Norm(motion->Shift);
  const double rounding = 32.0 * std::numeric_limits<double>::epsilon() * extent;
  return this->FindByTrees(Moved{ *motion, search.Clearance + rounding }, search, loop);
}

template <class ToFirst>
std::vector<SkdTrianglePair> SkdTrianglePairs::FindByTrees(
  const ToFirst& toFirst, const SkdPairSearch& search, SkdLoop& loop) const
{
  using Tree = skd::LazyTree<3>;
  constexpr vtkIdType enough = 512;
  const SkdTriangleSet& first = this->Placement.First.GetSet();
  const SkdTriangleSet& second = this->Placement.GetSecond().GetSet();
  Search state(this->Placement, search);
  const auto blockOf = [&](std::vector<SkdTrianglePair>& found) {
    return Block{ state, found, first.GetSearched(), second.GetSearched() };
  };

  std::vector<SkdTrianglePair> none; // for splitting finds nothing
  const skd::OverlapParts<3, Tree, Tree, ToFirst, Block> parts(
    first.GetTree(), second.GetTree(), toFirst, enough, blockOf(none), this->Placement.IsOfOne());
  std::vector<std::vector<SkdTrianglePair>> found(parts.size());
  std::atomic<std::size_t> count{ 0 }; // of pairs, of parts that are done
  loop.SetTotal(enough);
  loop.For(static_cast<vtkIdType>(parts.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (auto part = static_cast<std::size_t>(begin);
           part < static_cast<std::size_t>(end) && count <= search.Most; ++part)
      {
        parts.Visit(part, part + 1, blockOf(found[part]));
        count += found[part].size();
      }
    });
  return Gather(std::move(found), search, search.Most);
}

/// A search in a packed R-tree, in parts. It stops after too many looks: that is for trees; and
/// when there are more pairs than wanted.
class SkdTrianglePairs::PackedSearch
{
public:
  PackedSearch(
    std::size_t numberOfParts, std::size_t numberOfTriangles, std::size_t mostPairs = MaxSize)
    : Found(numberOfParts)
    , Most(64 * numberOfTriangles)
    , MostPairs(mostPairs)
  {
  }

  /// Calls visit(part, found) for all parts.
  template <class VisitPart>
  void ForEachPart(SkdLoop& loop, const VisitPart& visit)
  {
    const auto parts = static_cast<vtkIdType>(this->Found.size());
    loop.SetTotal(parts);
    loop.For(parts,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (auto part = static_cast<std::size_t>(begin);
             part < static_cast<std::size_t>(end) && this->Pairs <= this->MostPairs; ++part)
        {
          visit(part, this->Found[part]);
          this->Pairs += this->Found[part].size();
        }
      });
  }

  /// False if these are too many.
  bool Affords(std::size_t looks) { return (this->Looks += looks) <= this->Most; }

  bool IsWhole() const { return this->Pairs <= this->MostPairs; }

  std::optional<std::vector<SkdTrianglePair>> Take(const SkdPairSearch& search)
  {
    return this->Looks > this->Most
      ? std::nullopt
      : std::make_optional(Gather(std::move(this->Found), search, this->MostPairs));
  }

private:
  std::vector<std::vector<SkdTrianglePair>> Found;
  std::size_t Most;
  std::size_t MostPairs;
  std::atomic<std::size_t> Looks{ 0 };
  std::atomic<std::size_t> Pairs{ 0 }; // of parts that are done
};

//------------------------------------------------------------------------------
std::optional<std::vector<SkdTrianglePair>> SkdTrianglePairs::FindByPackedRTree(
  const SkdNearSets& near, const SkdPairSearch& search, SkdLoop& loop,
  const SkdIndexPairs& more) const
{
  constexpr std::size_t size = 16; // of a part, in triangles of the first set
  const std::size_t count = near.First.Triangles.size();
  const skd::PackedRTree boxes(near.Second.Boxes);
  Search state(this->Placement, search);
  const auto partsOf = [](std::size_t all) { return (all + size - 1) / size; };
  PackedSearch parts(partsOf(count) + partsOf(more.size()), count + near.Second.Triangles.size());
  const auto visitMore = [&](std::size_t part, std::vector<SkdTrianglePair>& found)
  {
    for (std::size_t i = part * size; i < std::min(more.size(), (part + 1) * size); ++i)
    {
      state.Visit(more[i].first, more[i].second, found);
    }
  };
  parts.ForEachPart(loop,
    [&](std::size_t part, std::vector<SkdTrianglePair>& found)
    {
      if (part >= partsOf(count))
      {
        visitMore(part - partsOf(count), found);
        return;
      }
      std::vector<std::uint32_t> others; // that a triangle's box overlaps
      bool goesOn = true;
      for (std::size_t i = part * size; i < std::min(count, (part + 1) * size) && goesOn; ++i)
      {
        std::size_t looks = 0;
        others.clear();
        boxes.ForEachOverlapping(near.First.Boxes[i],
          [&](std::uint32_t k)
          {
            ++looks;
            if (near.First.Boxes[i].Overlaps(near.Second.Boxes[k]))
            {
              others.push_back(near.Second.Triangles[k]);
            }
          });
        goesOn = parts.Affords(looks) &&
          (others.empty() || state.VisitAll(near.First.Triangles[i], others, found));
      }
    });
  return parts.Take(search);
}

// Triangles whose pairs are known are looked at where others may be.
std::vector<std::uint32_t> SkdTrianglePairs::ListUnknown(const SkdKnownPairs& known) const
{
  const auto n = static_cast<std::uint32_t>(this->Placement.First.GetSet().GetTriangles().size());
  skd::Box3 others;
  for (std::uint32_t triangle = known.End; triangle < n; ++triangle)
  {
    others.Add(this->Placement.First.GetBox(triangle));
  }
  std::vector<std::uint32_t> unknown;
  for (std::uint32_t triangle = 0; triangle < n; ++triangle)
  {
    if (triangle >= known.End || others.Overlaps(this->Placement.First.GetBox(triangle)))
    {
      unknown.push_back(triangle);
    }
  }
  return unknown;
}

/// Pairs of two triangles one of which is not of those whose pairs are known.
std::optional<std::vector<SkdTrianglePair>> SkdTrianglePairs::FindUnknown(
  const SkdKnownPairs& known, const SkdPairSearch& search, SkdLoop& loop) const
{
  const auto near = SkdFindNear(this->Placement.First, known.End);
  return near ? this->FindByPackedRTree(*near, search, loop, *known.Doubtful) : std::nullopt;
}

template <class TriangleOf>
std::optional<std::vector<SkdTrianglePair>> SkdTrianglePairs::FindByClipping(std::size_t count,
  const TriangleOf& triangleOf, const SkdPairSearch& search, SkdLoop& loop,
  const SkdKnownPairs* known) const
{
  const SkdMovedTriangles& set = this->Placement.First;
  const auto cornersOf = [&](std::uint32_t i) -> const SkdTriangleSet::Corners&
  { return set.GetCorners(triangleOf(i)); };
  const skd::ClippedPairs<SkdTriangleSet::PointList, decltype(cornersOf)> pairs(
    set.GetPoints(), count, cornersOf);
  Search state(this->Placement, search);
  constexpr std::size_t times = 16; // that a pair may be found
  PackedSearch parts(
    pairs.size(), count, search.Most > MaxSize / times ? MaxSize : times * search.Most);
  parts.ForEachPart(loop,
    [&](std::size_t part, std::vector<SkdTrianglePair>& found)
    {
      pairs.VisitPart(part,
        [&](std::uint32_t first, std::vector<std::uint32_t>& others)
        {
          std::transform(others.begin(), others.end(), others.begin(), triangleOf);
          LeaveOutKnown(triangleOf(first), known, others);
          return state.VisitEach(triangleOf(first), others, found);
        });
      SortOnce(found);
    });
  return parts.IsWhole() ? parts.Take(search) : std::nullopt;
}

//------------------------------------------------------------------------------
std::optional<std::vector<SkdTrianglePair>> SkdTrianglePairs::FindSelfIntersections(
  const SkdPairSearch& search, SkdLoop& loop, const SkdKnownPairs* known) const
{
  if (known && known->Doubtful)
  {
    if (auto found = this->FindUnknown(*known, search, loop))
    {
      Add(known->Pairs, *found);
      return found;
    }
  }
  const SkdTriangleSet& set = this->Placement.First.GetSet();
  const auto unknown = known ? this->ListUnknown(*known) : std::vector<std::uint32_t>();
  const std::vector<std::uint32_t>& all = search.Among ? *search.Among : set.GetSearched();
  const std::vector<std::uint32_t>& some = known ? unknown : all;
  const bool areAll = !known && some.empty();
  const std::size_t searched = areAll ? set.GetTriangles().size() : some.size();
  const auto triangleOf = [&some, areAll](std::uint32_t i) { return areAll ? i : some[i]; };
  const skd::PackedRTree tree(ListBoxes(this->Placement.First, searched, triangleOf));
  const std::size_t count = tree.GetNumberOfPackets();
  const skd::MonotonePatches patches =
    FindPatches(this->Placement.First, tree, searched, triangleOf);
  const auto isWanted = [&patches](std::size_t packet) { return !patches.Has(packet); };
  Search state(this->Placement, search);
  PackedSearch parts((count + PacketsOfPart - 1) / PacketsOfPart, searched, search.Most);
  parts.ForEachPart(loop,
    [&](std::size_t part, std::vector<SkdTrianglePair>& found)
    {
      skd::PackedRTree::OverlapLists lists;
      bool goesOn = true;
      for (std::size_t i = part * PacketsOfPart;
           i < std::min(count, (part + 1) * PacketsOfPart) && goesOn; ++i)
      {
        std::size_t looks = 0;
        goesOn = !isWanted(i) ||
          (tree.ForEachOverlapWithin(
             i, lists,
             [&](std::uint32_t triangle, std::vector<std::uint32_t>& others)
             {
               looks += others.size();
               if (!areAll)
               {
                 std::transform(others.begin(), others.end(), others.begin(), triangleOf);
               }
               LeaveOutKnown(triangleOf(triangle), known, others);
               return state.VisitWithin(triangleOf(triangle), others, found);
             },
             isWanted) &&
            parts.Affords(looks));
      }
    });
  auto found = parts.Take(search);
  found =
    found ? std::move(found) : this->FindByClipping(searched, triangleOf, search, loop, known);
  if (known && found)
  {
    Add(known->Pairs, *found);
  }
  return found;
}

//------------------------------------------------------------------------------
std::vector<std::uint32_t> SkdTrianglesInPairs(
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
}
