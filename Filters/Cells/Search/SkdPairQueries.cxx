// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// Queries about two trees of cells (Algorithm 5.4).
#include "Cells/Search/SkdCellTree.h"

#include "Core/Search/LeafFilters/CompactTree.h"
#include "Core/Search/Queries/OverlapParts.h"
#include "Core/Search/Tree/LazyTree.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <limits>
#include <type_traits>

namespace skdtree
{
namespace
{
using CellPairs = std::vector<SkdCellTree::CellPair>;

/// Keeps the pairs that are sure or that isPair(a, b) wants.
template <class IsPair>
struct Keeper
{
  const IsPair& Decide;
  CellPairs& Found;

  bool operator()(std::uint32_t a, std::uint32_t b, bool isSure) const
  {
    if (isSure || this->Decide(a, b))
    {
      this->Found.emplace_back(a, b);
    }
    return true;
  }
};

/// The walk over two trees in parts that are the same whatever the number of threads, in parallel.
/// walkPart(start, found) walks one of them by AVX2, if it can; else it returns false.
template <class First, class Second, class ToFirst, class IsPair, class WalkPart>
std::vector<CellPairs> WalkInParts(const First& first, const Second& second, const ToFirst& toFirst,
  const IsPair& isPair, double excess, const WalkPart& walkPart)
{
  using Parts = skd::OverlapParts<3, First, Second, ToFirst, Keeper<IsPair>>;
  constexpr std::size_t enough = 256;
  CellPairs none; // for splitting finds nothing
  const Parts parts(first, second, toFirst, enough, { isPair, none }, false, excess);
  std::vector<CellPairs> found(parts.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(parts.size()), 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        if (!walkPart(parts.StartOf(i), found[i]))
        {
          parts.Visit(i, i + 1, { isPair, found[i] });
        }
      }
    });
  return found;
}
}

//------------------------------------------------------------------------------
/// isPair(a, b) decides about two cells whose safety boxes overlap, or nearly; what it looks at is
/// smaller than these by at most `excess`.
template <class ToFirst, class IsPair>
std::vector<CellPairs> SkdCellTree::FindPairs(
  const SkdCellTree& other, const ToFirst& toFirst, const IsPair& isPair, double excess) const
{
  const auto walkPart = [&](const skd::TreePair<3>& start, CellPairs& found)
  {
    bool isDone = false;
    if constexpr (std::is_same_v<ToFirst, skd::SameWorld>)
    {
      const Keeper<IsPair> keep{ isPair, found };
      const auto take = [&keep, &found](const SkdWidePair* pairs, int count)
      {
        if (found.empty())
        {
          found.reserve(static_cast<std::size_t>(count));
        }
        std::for_each(pairs, pairs + count,
          [&keep](const SkdWidePair& pair) { keep(pair.First, pair.Second, pair.IsSure); });
      };
      this->WalkWide(
        [&](const SkdWideTree& mine)
        {
          isDone = other.WalkWide(
            [&](const SkdWideTree& theirs) {
              SkdWideWalks::OverlappingPairs(mine, theirs, &start, excess, SkdWidePairs::Of(take));
            });
        });
    }
    return isDone;
  };
  const auto withOther = [&](const auto& mine)
  {
    return other.Lazy ? WalkInParts(mine, *other.Lazy, toFirst, isPair, excess, walkPart)
                      : WalkInParts(mine, other.View, toFirst, isPair, excess, walkPart);
  };
  return this->Lazy ? withOther(*this->Lazy) : withOther(this->View);
}

//------------------------------------------------------------------------------
std::vector<CellPairs> SkdCellTree::FindBoundsPairs(const SkdCellTree& other) const
{
  const bool isWide = this->Store.HasCurvedExtents() || other.Store.HasCurvedExtents();
  const double excess =
    isWide ? std::numeric_limits<double>::infinity() : this->BoxExcess() + other.BoxExcess();
  return this->FindPairs(
    other, skd::SameWorld(),
    [&](std::uint32_t a, std::uint32_t b)
    { return this->Store.BoundsOf(a).Overlaps(other.Store.BoundsOf(b)); },
    excess);
}

//------------------------------------------------------------------------------
std::vector<std::pair<vtkIdType, vtkIdType>> SkdCellTree::FindOverlappingPairs(
  const SkdCellTree& other, const skd::RigidMotion& motion) const
{
  const auto move = [&motion](const skd::Box3& box) { return motion.Forward(box); };
  const std::vector<CellPairs> parts = this->FindPairs(
    other, move,
    [&](std::uint32_t a, std::uint32_t b)
    { return this->SafetyBoxOf(a).Overlaps(motion.Forward(other.SafetyBoxOf(b))); },
    0.0);
  std::vector<std::pair<vtkIdType, vtkIdType>> pairs;
  for (const CellPairs& part : parts)
  {
    for (const CellPair& pair : part)
    {
      pairs.emplace_back(this->Store.IdOf(pair.first), other.Store.IdOf(pair.second));
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}
}
