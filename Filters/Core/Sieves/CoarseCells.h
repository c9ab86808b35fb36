// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Sieves_CoarseCells_h
#define skd_Sieves_CoarseCells_h

#include "../Geometry/Box.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace skd
{

/// At most 64 x 64 x 64 cells over a box, and a bit for each: whether anything marked is in it.
/// Says of boxes that they overlap none of those that were marked, in a few instructions and
/// without a tree: two boxes that overlap within the region have a cell in common, because what
/// maps coordinates to cells is monotone, rounding and all.
class CoarseCells
{
public:
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
      const double factor = this->Counts[axis] / width;
      this->Factors[axis] = factor < LargestFactor ? factor : 0.0; // else all is one cell
    }
    this->Rows.assign(static_cast<std::size_t>(this->Counts[1] * this->Counts[2]), 0);
  }

  Range RangeOf(const Box3& box) const
  {
    Range range{ {}, {}, !this->IsWithin(box) };
    for (int axis = 0; axis < 3 && !range.IsEmpty; ++axis)
    {
      range.First[axis] = this->CellOf(box.Min[axis], axis);
      range.Last[axis] = this->CellOf(box.Max[axis], axis);
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
  static constexpr double LargestFactor = 1e300;

  bool IsWithin(const Box3& box) const
  {
    bool isWithin = true;
    for (int axis = 0; axis < 3; ++axis)
    {
      isWithin = isWithin && box.Min[axis] <= this->Region.Max[axis] &&
        box.Max[axis] >= this->Region.Min[axis];
    }
    return isWithin;
  }

  std::uint8_t CellOf(double x, int axis) const
  {
    const double cell = (x - this->Region.Min[axis]) * this->Factors[axis];
    const double last = this->Counts[axis] - 1;
    return static_cast<std::uint8_t>(cell < last ? (cell > 0.0 ? cell : 0.0) : last);
  }

  static std::uint64_t Columns(const Range& range)
  {
    return (~std::uint64_t(0) << range.First[0]) & (~std::uint64_t(0) >> (63 - range.Last[0]));
  }

  /// Until `body` returns false, which is then returned.
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
