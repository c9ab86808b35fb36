// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Queries_ClippedPairs_h
#define skd_Queries_ClippedPairs_h

#include "../../Geometry/Box.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace skd
{

/// Pairs of triangles of one surface that may have more in common than corners that they share,
/// for triangles whose boxes overlap far more often than they do: long ones that lie askew, and
/// fans of many around a point.
///
/// Space is cut into halves again and again, and triangles with it. What two have in common lies on
/// one side of each cut at least, so that it is in both their parts there; and these have smaller
/// boxes. (Stich et al., 2009, cut triangles so for hierarchies of boxes.) It ends where pairs of
/// parts get no fewer.
///
/// Of two triangles of one fan, the parts near its hub would be a pair always. If they have a point
/// besides the hub in common, they have all of the segment from there to the hub, and the points
/// beyond up to where one of them ends, on its edge across from the hub. So these edges, and not
/// all of the triangles, are looked for in the other triangles of a fan.
template <class PointList, class CornersOf>
class ClippedPairs
{
public:
  /// cornersOf(i) are the numbers of the corners, as an array, of triangle i; equal numbers are the
  /// same point. Points are finite, below half of the largest double.
  ClippedPairs(const PointList& points, std::size_t numberOfTriangles, const CornersOf& cornersOf);

  /// Into how many parts the search is divided.
  std::size_t size() const { return this->Cells.size(); }

  /// Calls visit(first, others) with triangles, first < all of others, a list that it may change.
  /// It goes on as long as visit returns true, and returns whether it always did. A pair can occur
  /// several times, in one part and in several.
  template <class Visit>
  bool VisitPart(std::size_t part, const Visit& visit) const
  {
    Candidates<Visit> candidates{ visit, {} };
    return this->VisitCell(this->Cells[part], MostLevels, candidates) && candidates.Flush();
  }

private:
  static constexpr std::uint32_t None = std::numeric_limits<std::uint32_t>::max();
  static constexpr std::uint32_t ManyAtPoint = 64; // triangles, that are a fan
  static constexpr double FewPairs = 2048.0;       // of a cell: as much work as to divide it
  static constexpr double Gain = 0.9;   // pairs that are left, at most, if it is worth dividing
  static constexpr int LevelsAhead = 5; // most, before there must be a gain
  static constexpr std::size_t ManyParts = std::size_t(1) << 20; // of these levels
  static constexpr int MostLevels = 60;
  static constexpr int LevelsOfParts = 2; // of up to eight cells of each

  /// What is in a cell of a triangle, or of its edge across from the hub of its fan.
  struct Part
  {
    Box3 Box;
    std::uint32_t Triangle;
    std::uint32_t Hub; // None: of no fan
    bool IsRim;
  };
  using Cell = std::vector<Part>; // by hubs, triangles before rims

  /// The parts of a cell that have one hub.
  struct Group
  {
    std::size_t Begin;
    std::size_t Rims; // where they begin
    std::size_t End;
    bool IsFan;
  };

  /// Pairs that are collected, so that each is visited about once.
  template <class Visit>
  struct Candidates
  {
    static constexpr std::size_t Many = std::size_t(1) << 20;

    const Visit& Found;
    std::vector<std::uint64_t> Keys;

    void Add(const Part& a, const Part& b)
    {
      if (a.Box.Overlaps(b.Box) && a.Triangle != b.Triangle)
      {
        this->Keys.push_back(static_cast<std::uint64_t>(std::min(a.Triangle, b.Triangle)) << 32 |
          std::max(a.Triangle, b.Triangle));
      }
    }

    bool Flush();
  };

  Part MakePart(std::uint32_t triangle, bool isRim) const;
  void FindHubs();
  Cell MakeRoot();

  void Divide(const Cell& cell, std::vector<Cell>& cells) const;
  void Halve(const Cell& cell, int axis, double middle, std::vector<Cell>& halves) const;
  Part Clipped(const Part& part, int axis, double middle, bool isUpper) const;

  /// Cells in place of one that together have far fewer pairs; none if there are no such.
  std::vector<Cell> FindBetter(const Cell& cell) const;

  static std::vector<Group> ListGroups(const Cell& cell);
  static double CountPairs(const Cell& cell);
  static std::size_t CountAll(const std::vector<Cell>& cells);

  template <class Visit>
  bool VisitCell(const Cell& cell, int levels, Candidates<Visit>& candidates) const;
  template <class Visit>
  static bool VisitPairs(const Cell& cell, Candidates<Visit>& candidates);

  const PointList& Points;
  const CornersOf& CornersOfTriangle;
  std::size_t Count;
  double Margin = 0.0;            // for the rounding of cuts
  std::vector<std::uint8_t> Hubs; // which corner of a triangle it is, 3: none
  std::vector<Cell> Cells;
};

template <class PointList, class CornersOf>
ClippedPairs<PointList, CornersOf>::ClippedPairs(
  const PointList& points, std::size_t numberOfTriangles, const CornersOf& cornersOf)
  : Points(points)
  , CornersOfTriangle(cornersOf)
  , Count(numberOfTriangles)
{
  this->FindHubs();
  this->Cells.push_back(this->MakeRoot());
  for (int level = 0; level < LevelsOfParts; ++level)
  {
    std::vector<Cell> next;
    for (Cell& cell : this->Cells)
    {
      std::vector<Cell> better = this->FindBetter(cell);
      if (better.empty())
      {
        better.push_back(std::move(cell));
      }
      std::move(better.begin(), better.end(), std::back_inserter(next));
    }
    this->Cells = std::move(next);
  }
}

template <class PointList, class CornersOf>
void ClippedPairs<PointList, CornersOf>::FindHubs()
{
  std::vector<std::uint32_t> numberAt(this->Points.size(), 0); // of triangles
  for (std::uint32_t i = 0; i < this->Count; ++i)
  {
    for (const std::uint32_t corner : this->CornersOfTriangle(i))
    {
      ++numberAt[corner];
    }
  }
  this->Hubs.resize(this->Count);
  for (std::uint32_t i = 0; i < this->Count; ++i)
  {
    const auto& corners = this->CornersOfTriangle(i);
    const auto most = std::max_element(corners.begin(), corners.end(),
      [&](std::uint32_t a, std::uint32_t b) { return numberAt[a] < numberAt[b]; });
    this->Hubs[i] =
      static_cast<std::uint8_t>(numberAt[*most] < ManyAtPoint ? 3 : most - corners.begin());
  }
}

template <class PointList, class CornersOf>
auto ClippedPairs<PointList, CornersOf>::MakePart(std::uint32_t triangle, bool isRim) const -> Part
{
  const auto& corners = this->CornersOfTriangle(triangle);
  const std::uint8_t hub = this->Hubs[triangle];
  Part part{ {}, triangle, hub == 3 ? None : corners[hub], isRim };
  for (std::uint8_t i = 0; i < 3; ++i)
  {
    if (!isRim || i != hub)
    {
      part.Box.Add(this->Points[corners[i]]);
    }
  }
  return part;
}

template <class PointList, class CornersOf>
auto ClippedPairs<PointList, CornersOf>::MakeRoot() -> Cell
{
  Cell root;
  double extent = 0.0;
  for (std::uint32_t i = 0; i < this->Count; ++i)
  {
    root.push_back(this->MakePart(i, false));
    if (this->Hubs[i] != 3)
    {
      root.push_back(this->MakePart(i, true));
    }
    const Box3 box = this->MakePart(i, false).Box;
    for (int axis = 0; axis < 3; ++axis)
    {
      extent = std::max({ extent, std::abs(box.Min[axis]), std::abs(box.Max[axis]) });
    }
  }
  std::sort(root.begin(), root.end(),
    [](const Part& a, const Part& b)
    { return std::tie(a.Hub, a.IsRim, a.Triangle) < std::tie(b.Hub, b.IsRim, b.Triangle); });
  this->Margin =
    16.0 * std::numeric_limits<double>::epsilon() * extent + std::numeric_limits<double>::min();
  return root;
}

//------------------------------------------------------------------------------
template <class PointList, class CornersOf>
auto ClippedPairs<PointList, CornersOf>::ListGroups(const Cell& cell) -> std::vector<Group>
{
  std::vector<Group> groups;
  for (std::size_t begin = 0; begin < cell.size(); begin = groups.back().End)
  {
    Group group{ begin, begin, begin, cell[begin].Hub != None };
    while (group.End < cell.size() && cell[group.End].Hub == cell[begin].Hub)
    {
      group.Rims += !cell[group.End].IsRim;
      ++group.End;
    }
    groups.push_back(group);
  }
  return groups;
}

template <class PointList, class CornersOf>
double ClippedPairs<PointList, CornersOf>::CountPairs(const Cell& cell)
{
  double all = 0.0; // of triangles
  double pairs = 0.0;
  for (const Group& group : ListGroups(cell))
  {
    const auto triangles = static_cast<double>(group.Rims - group.Begin);
    const auto rims = static_cast<double>(group.End - group.Rims);
    pairs += triangles * (all + (group.IsFan ? rims : 0.5 * triangles));
    all += triangles;
  }
  return pairs;
}

template <class PointList, class CornersOf>
auto ClippedPairs<PointList, CornersOf>::FindBetter(const Cell& cell) const -> std::vector<Cell>
{
  const double pairs = CountPairs(cell);
  const std::size_t most =
    std::max(3 * cell.size(), std::min(24 * cell.size(), ManyParts)); // parts of triangles
  std::vector<Cell> cells;
  if (pairs > FewPairs)
  {
    this->Divide(cell, cells);
  }
  for (int level = 1; level < LevelsAhead && CountAll(cells) <= most; ++level)
  {
    const double left = std::accumulate(cells.begin(), cells.end(), 0.0,
      [](double sum, const Cell& part) { return sum + CountPairs(part); });
    if (left < Gain * pairs)
    {
      return cells;
    }
    std::vector<Cell> next;
    for (std::size_t i = 0; i < cells.size() && CountAll(next) <= most; ++i)
    {
      this->Divide(cells[i], next);
    }
    cells = std::move(next);
  }
  return {};
}

template <class PointList, class CornersOf>
std::size_t ClippedPairs<PointList, CornersOf>::CountAll(const std::vector<Cell>& cells)
{
  return std::accumulate(cells.begin(), cells.end(), std::size_t(0),
    [](std::size_t sum, const Cell& cell) { return sum + cell.size(); });
}

/// Cut in the middle along the axes along which it is long.
template <class PointList, class CornersOf>
void ClippedPairs<PointList, CornersOf>::Divide(const Cell& cell, std::vector<Cell>& cells) const
{
  Box3 bounds;
  for (const Part& part : cell)
  {
    bounds.Add(part.Box);
  }
  const double longest = bounds.Length(bounds.LongestAxis());
  std::vector<Cell> parts;
  parts.push_back(cell);
  for (int axis = 0; axis < 3; ++axis)
  {
    if (bounds.Length(axis) > 0.5 * longest)
    {
      std::vector<Cell> halves;
      for (const Cell& part : parts)
      {
        this->Halve(part, axis, bounds.Centroid()[axis], halves);
      }
      parts = std::move(halves);
    }
  }
  std::move(parts.begin(), parts.end(), std::back_inserter(cells));
}

template <class PointList, class CornersOf>
void ClippedPairs<PointList, CornersOf>::Halve(
  const Cell& cell, int axis, double middle, std::vector<Cell>& halves) const
{
  Cell sides[2];
  for (const Part& part : cell)
  {
    const bool isIn[2] = { part.Box.Min[axis] <= middle, part.Box.Max[axis] > middle };
    for (int side = 0; side < 2; ++side)
    {
      const Part half = isIn[0] && isIn[1] ? this->Clipped(part, axis, middle, side == 1) : part;
      if (isIn[side] && !half.Box.IsEmpty())
      {
        sides[side].push_back(half);
      }
    }
  }
  for (Cell& side : sides)
  {
    if (CountPairs(side) > 0.0)
    {
      halves.push_back(std::move(side));
    }
  }
}

/// What of a part is on a side of a cut, in a box that rounding does not make too small.
template <class PointList, class CornersOf>
auto ClippedPairs<PointList, CornersOf>::Clipped(
  const Part& part, int axis, double middle, bool isUpper) const -> Part
{
  const auto& corners = this->CornersOfTriangle(part.Triangle);
  const int first = part.IsRim ? (this->Hubs[part.Triangle] + 1) % 3 : 0;
  const int count = part.IsRim ? 2 : 3;
  const auto corner = [&](int i) -> const Vector3&
  { return this->Points[corners[static_cast<std::size_t>((first + i % count) % 3)]]; };
  Box3 box;
  for (int i = 0; i < count; ++i)
  {
    const Vector3& p = corner(i);
    const Vector3& q = corner(i + 1);
    const double atP = p[axis] - middle;
    const double atQ = q[axis] - middle;
    if (isUpper ? atP >= 0.0 : atP <= 0.0)
    {
      box.Add(p);
    }
    if ((atP < 0.0 && atQ > 0.0) || (atP > 0.0 && atQ < 0.0))
    {
      box.Add(p + (atP / (atP - atQ)) * (q - p));
    }
  }
  box = box.Inflated(this->Margin);
  Part clipped = part;
  clipped.Box = { Greatest(part.Box.Min, box.Min), Least(part.Box.Max, box.Max) };
  double& bound = isUpper ? clipped.Box.Min[axis] : clipped.Box.Max[axis];
  bound = isUpper ? std::max(bound, middle) : std::min(bound, middle);
  return clipped;
}

//------------------------------------------------------------------------------
template <class PointList, class CornersOf>
template <class Visit>
bool ClippedPairs<PointList, CornersOf>::Candidates<Visit>::Flush()
{
  std::sort(this->Keys.begin(), this->Keys.end());
  this->Keys.erase(std::unique(this->Keys.begin(), this->Keys.end()), this->Keys.end());
  std::vector<std::uint32_t> others;
  bool goesOn = true;
  for (std::size_t i = 0; i < this->Keys.size() && goesOn;)
  {
    const std::uint64_t first = this->Keys[i] >> 32;
    others.clear();
    for (; i < this->Keys.size() && this->Keys[i] >> 32 == first; ++i)
    {
      others.push_back(static_cast<std::uint32_t>(this->Keys[i]));
    }
    goesOn = this->Found(static_cast<std::uint32_t>(first), others);
  }
  this->Keys.clear();
  return goesOn;
}

template <class PointList, class CornersOf>
template <class Visit>
bool ClippedPairs<PointList, CornersOf>::VisitCell(
  const Cell& cell, int levels, Candidates<Visit>& candidates) const
{
  const std::vector<Cell> better = levels > 0 ? this->FindBetter(cell) : std::vector<Cell>();
  return better.empty()
    ? VisitPairs(cell, candidates)
    : std::all_of(better.begin(), better.end(),
        [&](const Cell& part) { return this->VisitCell(part, levels - 1, candidates); });
}

template <class PointList, class CornersOf>
template <class Visit>
bool ClippedPairs<PointList, CornersOf>::VisitPairs(const Cell& cell, Candidates<Visit>& candidates)
{
  const auto addPairs = [&](std::size_t i, std::size_t begin, std::size_t end)
  {
    for (std::size_t k = begin; k < end; ++k)
    {
      candidates.Add(cell[i], cell[k]);
    }
    return candidates.Keys.size() < candidates.Many || candidates.Flush();
  };
  const std::vector<Group> groups = ListGroups(cell);
  bool goesOn = true;
  for (const Group& group : groups)
  {
    for (std::size_t i = group.Begin; i < group.Rims && goesOn; ++i)
    {
      goesOn = group.IsFan || addPairs(i, i + 1, group.Rims);
      for (const Group* other = &group + 1; other != groups.data() + groups.size() && goesOn;
           ++other)
      {
        goesOn = addPairs(i, other->Begin, other->Rims);
      }
    }
    for (std::size_t i = group.Rims; i < group.End && goesOn; ++i)
    {
      goesOn = addPairs(i, group.Begin, group.Rims);
    }
  }
  return goesOn;
}

}

#endif
