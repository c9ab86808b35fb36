// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/SkdNearTriangles.h"

#include "Core/Sieves/CoarseCells.h"

#include <algorithm>
#include <cmath>

namespace
{
using Cells = skd::CoarseCells;

/// A triangle that is within the region, and where.
struct Inside
{
  std::uint32_t Triangle;
  Cells::Range Range;
};

std::uint32_t CountOf(const SkdPlacedTriangles& set)
{
  return static_cast<std::uint32_t>(set.GetSet().GetTriangles().size());
}

/// Where the set is placed, or around it.
skd::Box3 BoundsOf(const SkdPlacement& placement, const SkdPlacedTriangles& set, bool isMoved)
{
  const skd::Box3& bounds = set.GetSet().GetBounds();
  const double reach = set.GetSet().GetReach();
  const skd::Box3 there = isMoved ? placement.Motion->Forward(bounds) : bounds;
  const double shift = isMoved ? Norm(placement.Motion->Shift) : 0.0;
  const double rounding = 32.0 * std::numeric_limits<double>::epsilon() * (2.0 * reach + shift);
  const skd::Box3 around = isMoved ? there.Inflated(rounding) : there;
  return { placement.Scale * around.Min, placement.Scale * around.Max };
}

/// The mean of the longest sides of some triangles' boxes, spread over the set.
double MeanSize(const SkdPlacedTriangles& set)
{
  constexpr std::uint32_t some = 64;
  const std::uint32_t step = 1 + CountOf(set) / some;
  double sum = 0.0;
  int count = 0;
  for (std::uint32_t i = 0; i < CountOf(set); i += step, ++count)
  {
    const skd::Box3 box = set.GetBox(i);
    sum += std::max({ box.Max[0] - box.Min[0], box.Max[1] - box.Min[1], box.Max[2] - box.Min[2] });
  }
  return sum / count;
}

/// Keeps the work bounded where sizes differ much: stops when triangles cover many cells.
class Raster
{
public:
  Raster(const skd::Box3& region, double size, std::size_t triangles)
    : Marked(region, size)
    , Other(region, size)
    , RowsLeft(16 * triangles + 4096)
  {
  }

  bool MarkAll(const SkdPlacedTriangles& set, double margin, std::vector<Inside>& inside)
  {
    for (std::uint32_t i = 0; i < CountOf(set); ++i)
    {
      const Cells::Range range = this->RangeOf(set, i, margin);
      if (!range.IsEmpty)
      {
        if (!this->Affords(range))
        {
          return false;
        }
        this->Marked.Mark(range);
        inside.push_back({ i, range });
      }
    }
    return true;
  }

  /// Those of the other set that are in marked cells; marks theirs.
  bool FindMarked(const SkdPlacedTriangles& set, double margin, std::vector<std::uint32_t>& found)
  {
    for (std::uint32_t i = 0; i < CountOf(set); ++i)
    {
      const Cells::Range range = this->RangeOf(set, i, margin);
      if (!range.IsEmpty)
      {
        if (!this->Affords(range))
        {
          return false;
        }
        if (this->Marked.HasMarks(range))
        {
          this->Other.Mark(range);
          found.push_back(i);
        }
      }
    }
    return true;
  }

  void KeepMarked(const std::vector<Inside>& inside, std::vector<std::uint32_t>& found) const
  {
    for (const Inside& one : inside)
    {
      if (this->Other.HasMarks(one.Range))
      {
        found.push_back(one.Triangle);
      }
    }
  }

private:
  Cells::Range RangeOf(const SkdPlacedTriangles& set, std::uint32_t triangle, double margin) const
  {
    const skd::Box3 box = set.GetBox(triangle);
    return this->Marked.RangeOf(margin > 0.0 ? box.Inflated(margin) : box);
  }

  bool Affords(const Cells::Range& range)
  {
    const std::size_t rows = range.CountRows();
    this->RowsLeft -= std::min(rows, this->RowsLeft);
    return this->RowsLeft > 0;
  }

  Cells Marked;
  Cells Other;
  std::size_t RowsLeft;
};

void BuildTree(const SkdPlacedTriangles& set, SkdNearTriangles& near)
{
  std::vector<skd::Box3> boxes;
  boxes.reserve(near.Triangles.size());
  for (const std::uint32_t triangle : near.Triangles)
  {
    boxes.push_back(set.GetBox(triangle));
  }
  near.Tree = skd::LazyTree<3>(skd::MakeTreeInput(boxes, 0.0));
}
}

//------------------------------------------------------------------------------
std::optional<SkdNearSets> SkdFindNear(const SkdPlacement& placement, double clearance)
{
  const SkdPlacedTriangles& first = placement.First;
  const SkdPlacedTriangles& second = placement.GetSecond();
  const std::size_t all = std::size_t(CountOf(first)) + CountOf(second);
  SkdNearSets near;
  if (CountOf(first) == 0 || CountOf(second) == 0)
  {
    return near;
  }
  skd::Box3 region = BoundsOf(placement, first, false);
  skd::Box3 other = BoundsOf(placement, second, placement.Motion.has_value());
  const double reach = std::max(skd::LargestCoordinate(region), skd::LargestCoordinate(other));
  const double margin = clearance > 0.0 ? 1.000001 * clearance + 1e-10 * reach : 0.0; // generous
  other = other.Inflated(margin);
  region = { skd::Greatest(region.Min, other.Min), skd::Least(region.Max, other.Max) };
  if (region.IsEmpty())
  {
    return near;
  }
  const double size = std::max(MeanSize(first), MeanSize(second)) + margin;
  Raster raster(region, size, all);
  std::vector<Inside> inside;
  if (!raster.MarkAll(first, 0.0, inside) ||
    !raster.FindMarked(second, margin, near.Second.Triangles))
  {
    return std::nullopt;
  }
  raster.KeepMarked(inside, near.First.Triangles);
  if (4 * (near.First.Triangles.size() + near.Second.Triangles.size()) > 3 * all)
  {
    return std::nullopt;
  }
  BuildTree(first, near.First);
  BuildTree(second, near.Second);
  return near;
}
