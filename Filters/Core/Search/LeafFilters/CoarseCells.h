// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_LeafFilters_CoarseCells_h
#define skd_LeafFilters_CoarseCells_h

#include "../../Geometry/Box.h"
#include "../Tree/ShortLanes.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace skd
{

/// A grid of at most 64 x 64 x 64 cells over a box, with a bit for each cell that is marked. It
/// excludes boxes that overlap no marked box, in a few instructions and without a tree: two boxes
/// that overlap within the region share a cell, because the map from coordinates to cells is
/// monotone, including rounding. For the same reason the cells of what encloses some points are
/// found from those of the points.
class CoarseCells
{
public:
  /// Where a point is along each axis: in a cell from 1 on, 0 below the region, Counts + 1 above.
  using CellPosition = FourBytes;
  using CellPositions = std::array<CellPosition, 3>;

  /// The cells that a box is in: none when it is beyond the region.
  struct Range
  {
    std::uint8_t First[3];
    std::uint8_t Last[3];
    bool IsEmpty;

    std::size_t CountRows() const
    {
      return static_cast<std::size_t>(this->Last[1] - this->First[1] + 1) *
        static_cast<std::size_t>(this->Last[2] - this->First[2] + 1);
    }
  };

  /// Cells of about this size, or larger where 64 along an axis do not do.
  CoarseCells(const Box3& region, double size)
    : Region(region)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const double width = region.Max[axis] - region.Min[axis];
      const double wanted = width / size;
      this->Counts[axis] = wanted < Most ? (wanted > 1.0 ? static_cast<int>(wanted) : 1) : Most;
      this->Factors[axis] = std::min(AlmostOne * this->Counts[axis] / width, LargestFactor);
      if (!(width <= std::numeric_limits<double>::max())) // all is one cell
      {
        this->Region.Min[axis] = 0.0;
        this->Factors[axis] = 0.0;
      }
    }
    this->Rows.assign(static_cast<std::size_t>(this->Counts[1] * this->Counts[2]), 0);
  }

  /// A coordinate that is NaN counts as below.
  CellPosition CellPositionOf(const Vector3& x) const
  {
    CellPosition position{ { 0, 0, 0, 1 } };
    for (int axis = 0; axis < 3; ++axis)
    {
      const double cell = (x[axis] - this->Region.Min[axis]) * this->Factors[axis] + 1.0;
      const double last = this->Counts[axis] + 1;
      position.At[axis] = static_cast<std::uint8_t>(std::min(std::max(0.0, cell), last));
    }
    return position;
  }

  Range RangeOf(const Box3& box) const
  {
    const CellPosition low = this->CellPositionOf(box.Min);
    const CellPosition high = this->CellPositionOf(box.Max);
    return this->RangeOf({ low, low, low }, { high, high, high });
  }

  /// That of the box of a triangle: `lows` are where its corners are, or how far down they extend,
  /// `highs` how far up.
  Range RangeOf(const CellPositions& lows, const CellPositions& highs) const
  {
    const CellPosition low = Least(Least(lows[0], lows[1]), lows[2]);
    const CellPosition high = Greatest(Greatest(highs[0], highs[1]), highs[2]);
    const CellPosition above{ { static_cast<std::uint8_t>(this->Counts[0] + 1),
      static_cast<std::uint8_t>(this->Counts[1] + 1),
      static_cast<std::uint8_t>(this->Counts[2] + 1), 0 } };
    Range range{ {}, {}, HaveEqual(low, above) || HaveEqual(high, CellPosition{ { 0, 0, 0, 0 } }) };
    for (int axis = 0; axis < 3 && !range.IsEmpty; ++axis)
    {
      range.First[axis] = std::max<std::uint8_t>(low.At[axis], 1) - 1;
      range.Last[axis] = std::min<std::uint8_t>(high.At[axis], above.At[axis] - 1) - 1;
    }
    return range;
  }

  void Mark(const Range& range)
  {
    const std::uint64_t columns = Columns(range);
    this->ForEachRow(range,
      [&](std::size_t row)
      {
        this->Rows[row] |= columns;
        return true;
      });
  }

  bool HasMarks(const Range& range) const
  {
    const std::uint64_t columns = Columns(range);
    return !this->ForEachRow(
      range, [&](std::size_t row) { return (this->Rows[row] & columns) == 0; });
  }

private:
  static constexpr int Most = 64;
  static constexpr double AlmostOne = 1.0 - 0x1p-49; // the region's end is in the last cell
  static constexpr double LargestFactor = 1e300;

  static std::uint64_t Columns(const Range& range)
  {
    return (~std::uint64_t(0) << range.First[0]) & (~std::uint64_t(0) >> (63 - range.Last[0]));
  }

  /// Stops when `body` returns false, and then returns false.
  template <class Body>
  bool ForEachRow(const Range& range, Body body) const
  {
    for (int z = range.First[2]; z <= range.Last[2]; ++z)
    {
      for (int y = range.First[1]; y <= range.Last[1]; ++y)
      {
        if (!body(static_cast<std::size_t>(z * this->Counts[1] + y)))
        {
          return false;
        }
      }
    }
    return true;
  }

  Box3 Region;
  int Counts[3];
  double Factors[3];
  std::vector<std::uint64_t> Rows; // a bit for each cell along the first axis
};

}

#endif
