// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Surfaces/SkdNearTriangles.h"

#include "Bodies/SkdWeld.h"
#include "Core/Search/LeafFilters/CoarseCells.h"

#include <algorithm>
#include <cmath>

namespace skdtree
{
namespace
{
/// Boxes are inflated by the clearance and generous rounding errors: relative to the clearance, and
/// to the largest coordinate.
constexpr double ClearanceMargin = 1.000001;
constexpr double CoordinateMargin = 1e-10;

using Cells = skd::CoarseCells;

/// Consecutive triangles of a placed set.
struct Triangles
{
  const SkdMovedTriangles& Set;
  std::uint32_t Begin;
  std::uint32_t End;

  std::uint32_t Count() const { return this->End - this->Begin; }
};

Triangles AllOf(const SkdMovedTriangles& set)
{
  return { set, 0, static_cast<std::uint32_t>(set.GetSet().GetTriangles().size()) };
}

/// Where the set is placed, or around it.
skd::Box3 BoundsOf(const SkdPlacement& placement, const SkdMovedTriangles& set, bool isMoved)
{
  const skd::Box3& bounds = set.GetSet().GetBounds();
  const double extent = set.GetSet().GetLargestCoordinate();
  const skd::Box3 there = isMoved ? placement.Motion->Forward(bounds) : bounds;
  const double shift = isMoved ? Norm(placement.Motion->Shift) : 0.0;
  const double rounding = 32.0 * std::numeric_limits<double>::epsilon() * (2.0 * extent + shift);
  const skd::Box3 around = isMoved ? there.Inflated(rounding) : there;
  return { placement.Scale * around.Min, placement.Scale * around.Max };
}

/// The mean of the longest sides of some triangles' boxes, spread over the set.
double MeanSize(const Triangles& triangles)
{
  constexpr std::uint32_t some = 64;
  const std::uint32_t step = 1 + triangles.Count() / some;
  double sum = 0.0;
  int count = 0;
  for (std::uint32_t i = triangles.Begin; i < triangles.End; i += step, ++count)
  {
    const skd::Box3 box = triangles.Set.GetBox(i);
    sum += std::max({ box.Max[0] - box.Min[0], box.Max[1] - box.Min[1], box.Max[2] - box.Min[2] });
  }
  return sum / count;
}

/// The points of a set as cells see them, with a margin.
class PointsByCells
{
public:
  PointsByCells(const SkdMovedTriangles& set, const Cells& cells, double margin)
    : Lows(CellPositionsOf(set, cells, -margin))
    , Highs(margin > 0.0 ? CellPositionsOf(set, cells, margin) : CellPositionList())
  {
  }

  const Cells::CellPosition* GetLows() const { return this->Lows.data(); }
  const Cells::CellPosition* GetHighs() const
  {
    return this->Highs.empty() ? this->Lows.data() : this->Highs.data();
  }

private:
  using CellPositionList = skd::RawVector<Cells::CellPosition>;

  static CellPositionList CellPositionsOf(
    const SkdMovedTriangles& set, const Cells& cells, double shift)
  {
    const SkdTriangleSet::PointList& points = set.GetPoints();
    const skd::Vector3 shifts{ { shift, shift, shift } };
    CellPositionList positions(points.size());
    std::transform(points.begin(), points.end(), positions.begin(),
      [&](const skd::Vector3& x) { return cells.CellPositionOf(x + shifts); });
    return positions;
  }

  CellPositionList Lows;
  CellPositionList Highs; // empty where these are the lows
};

/// Triangles as cells see them.
class TrianglesByCells
{
public:
  TrianglesByCells(const Triangles& triangles, const Cells& cells, const PointsByCells& points)
    : Original(triangles)
    , TheCells(cells)
    , AtLows(points.GetLows())
    , AtHighs(points.GetHighs())
  {
  }

  std::uint32_t GetBegin() const { return this->Original.Begin; }
  std::uint32_t GetEnd() const { return this->Original.End; }

  Cells::Range RangeOf(std::uint32_t triangle) const
  {
    const auto [a, b, c] = this->Original.Set.GetCorners(triangle);
    return this->TheCells.RangeOf({ this->AtLows[a], this->AtLows[b], this->AtLows[c] },
      { this->AtHighs[a], this->AtHighs[b], this->AtHighs[c] });
  }

private:
  const Triangles Original;
  const Cells& TheCells;
  const Cells::CellPosition* AtLows;
  const Cells::CellPosition* AtHighs;
};

/// Keeps the work bounded where sizes differ much: stops when triangles cover many cells.
class CoarseGrid
{
public:
  CoarseGrid(const Cells& cells, std::size_t triangles)
    : Marked(cells)
    , Other(cells)
    , RowsLeft(16 * triangles + 4096)
  {
  }

  /// Appends those within the region to `inside`.
  bool MarkAll(const TrianglesByCells& set, std::vector<std::uint32_t>& inside)
  {
    return this->ForEachRange(set,
      [&](std::uint32_t i, const Cells::Range& range)
      {
        this->Marked.Mark(range);
        inside.push_back(i);
      });
  }

  /// Those of the other set that are in marked cells; marks theirs.
  bool FindMarked(const TrianglesByCells& set, std::vector<std::uint32_t>& found)
  {
    return this->ForEachRange(set,
      [&](std::uint32_t i, const Cells::Range& range)
      {
        if (this->Marked.HasMarks(range))
        {
          this->Other.Mark(range);
          found.push_back(i);
        }
      });
  }

  void KeepMarked(const TrianglesByCells& set, std::vector<std::uint32_t>& inside) const
  {
    const auto isAlone = [&](std::uint32_t i) { return !this->Other.HasMarks(set.RangeOf(i)); };
    inside.erase(std::remove_if(inside.begin(), inside.end(), isAlone), inside.end());
  }

private:
  /// Calls visit(triangle, its cells) for those within the region; false if there are too many
  /// cells.
  template <class Visit>
  bool ForEachRange(const TrianglesByCells& set, const Visit& visit)
  {
    for (std::uint32_t i = set.GetBegin(); i < set.GetEnd(); ++i)
    {
      const Cells::Range range = set.RangeOf(i);
      if (!range.IsEmpty)
      {
        if (!this->Affords(range))
        {
          return false;
        }
        visit(i, range);
      }
    }
    return true;
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

void AddBoxes(const SkdMovedTriangles& set, double margin, SkdNearTriangles& near)
{
  near.Boxes.reserve(near.Triangles.size());
  for (const std::uint32_t triangle : near.Triangles)
  {
    const skd::Box3 box = set.GetBox(triangle);
    near.Boxes.push_back(margin > 0.0 ? box.Inflated(margin) : box);
  }
}

/// Whether many triangles may be the same: false of ordinary surfaces, by the corners of boxes.
bool MayHaveCopies(const SkdNearTriangles& near)
{
  std::size_t slots = 64;
  while (slots < near.Boxes.size())
  {
    slots *= 2;
  }
  std::vector<std::uint32_t> counts(slots, 0);
  bool areMany = false;
  for (const skd::Box3& box : near.Boxes)
  {
    areMany = ++counts[SkdWeld::HashOf(box.Min) & (slots - 1)] > SkdManyCopies || areMany;
  }
  return areMany;
}

/// Leaves out all but the first SkdManyCopies of each triangle, as SkdTriangleSet::Complete does.
bool LeaveOutCopies(const SkdMovedTriangles& set, SkdNearTriangles& near)
{
  if (!MayHaveCopies(near))
  {
    return false;
  }
  SkdWeld weld(3 * near.Triangles.size());
  skd::RawVector<SkdTriangleSet::Corners> triangles(near.Triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    const auto corners = set.GetCornerPoints(near.Triangles[i]);
    std::transform(corners.begin(), corners.end(), triangles[i].begin(),
      [&](const skd::Vector3& x) { return static_cast<std::uint32_t>(weld.GetId(x.X)); });
  }
  std::vector<bool> isCopy(triangles.size(), false);
  const auto copies = SkdFindCopies(triangles, weld.GetPoints().size(), SkdManyCopies);
  for (const SkdDuplicate& copy : copies)
  {
    isCopy[copy.Triangle] = true;
  }
  std::size_t count = 0;
  for (std::size_t i = 0; i < isCopy.size(); ++i)
  {
    if (!isCopy[i])
    {
      near.Triangles[count] = near.Triangles[i];
      near.Boxes[count++] = near.Boxes[i];
    }
  }
  near.Triangles.resize(count);
  near.Boxes.resize(count);
  return !copies.empty();
}

struct SetPair
{
  Triangles First;
  Triangles Second;
  skd::Box3 Region; ///< that both are in, the second with a margin
  double Margin;

  std::size_t Count() const { return std::size_t(this->First.Count()) + this->Second.Count(); }
};

/// False when triangles cover too many cells.
bool FilterByCoarseGrid(const SetPair& pair, SkdNearSets& near)
{
  const double size = std::max(MeanSize(pair.First), MeanSize(pair.Second)) + pair.Margin;
  const Cells cells(pair.Region, size);
  const PointsByCells points(pair.First.Set, cells, 0.0);
  std::optional<PointsByCells> others; // of another set, or with a margin
  if (&pair.First.Set != &pair.Second.Set || pair.Margin > 0.0)
  {
    others.emplace(pair.Second.Set, cells, pair.Margin);
  }
  const TrianglesByCells byCellsFirst(pair.First, cells, points);
  const TrianglesByCells byCellsSecond(pair.Second, cells, others ? *others : points);
  CoarseGrid grid(cells, pair.Count());
  if (!grid.MarkAll(byCellsFirst, near.First.Triangles) ||
    !grid.FindMarked(byCellsSecond, near.Second.Triangles))
  {
    return false;
  }
  grid.KeepMarked(byCellsFirst, near.First.Triangles);
  return true;
}

skd::Box3 BoundsOf(const Triangles& triangles)
{
  skd::Box3 bounds;
  for (std::uint32_t i = triangles.Begin; i < triangles.End; ++i)
  {
    for (const std::uint32_t corner : triangles.Set.GetCorners(i))
    {
      bounds.Add(triangles.Set.GetPoints()[corner]);
    }
  }
  return bounds;
}
}

//------------------------------------------------------------------------------
std::optional<SkdNearSets> SkdFindNear(const SkdPlacement& placement, double clearance)
{
  const SkdMovedTriangles& first = placement.First;
  const SkdMovedTriangles& second = placement.GetSecond();
  SetPair pair{ AllOf(first), AllOf(second), {}, 0.0 };
  SkdNearSets near;
  if (pair.First.Count() == 0 || pair.Second.Count() == 0)
  {
    return near;
  }
  skd::Box3 region = BoundsOf(placement, first, false);
  skd::Box3 other = BoundsOf(placement, second, placement.Motion.has_value());
  const double extent = std::max(skd::LargestCoordinate(region), skd::LargestCoordinate(other));
  const double margin =
    clearance > 0.0 ? ClearanceMargin * clearance + CoordinateMargin * extent : 0.0;
  other = other.Inflated(margin);
  region = { skd::Greatest(region.Min, other.Min), skd::Least(region.Max, other.Max) };
  if (region.IsEmpty())
  {
    return near;
  }
  constexpr std::size_t few = 4096; // for a coarse grid to pay
  pair.Region = region;
  pair.Margin = margin;
  if (pair.Count() < few || !FilterByCoarseGrid(pair, near) ||
    4 * (near.First.Triangles.size() + near.Second.Triangles.size()) > 3 * pair.Count())
  {
    return std::nullopt;
  }
  AddBoxes(first, 0.0, near.First);
  AddBoxes(second, margin, near.Second);
  const bool hasFirst = LeaveOutCopies(first, near.First);
  near.HasCopies = LeaveOutCopies(second, near.Second) || hasFirst;
  return near;
}

//------------------------------------------------------------------------------
std::optional<SkdNearSets> SkdFindNear(const SkdMovedTriangles& set, std::uint32_t middle)
{
  const Triangles all = AllOf(set);
  SetPair pair{ { set, 0, middle }, { set, middle, all.End }, BoundsOf({ set, 0, middle }), 0.0 };
  const skd::Box3 other = BoundsOf(pair.Second);
  SkdNearSets near;
  if (!pair.Region.Overlaps(other))
  {
    return near;
  }
  pair.Region = { skd::Greatest(pair.Region.Min, other.Min),
    skd::Least(pair.Region.Max, other.Max) };
  if (!FilterByCoarseGrid(pair, near))
  {
    return std::nullopt;
  }
  AddBoxes(set, 0.0, near.First);
  AddBoxes(set, 0.0, near.Second);
  return near;
}
}
