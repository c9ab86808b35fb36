// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Grid_Bricks_h
#define skd_Grid_Bricks_h

#include "Lattice.h"

#include <algorithm>
#include <tuple>

namespace skd
{

/// The places from Low up to, not including, High along each axis.
struct Brick
{
  Place Low;
  Place High;

  std::int64_t NumberOfPlaces() const
  {
    return (this->High[0] - this->Low[0]) * (this->High[1] - this->Low[1]) *
      (this->High[2] - this->Low[2]);
  }
};

namespace detail
{

/// Joins bricks that follow each other along an axis and are of one size across it.
inline void JoinAlong(int axis, std::vector<Brick>& bricks)
{
  const int a = (axis + 1) % 3;
  const int b = (axis + 2) % 3;
  const auto across = [=](const Brick& brick)
  { return std::make_tuple(brick.Low[b], brick.High[b], brick.Low[a], brick.High[a]); };
  std::sort(bricks.begin(), bricks.end(),
    [&](const Brick& left, const Brick& right)
    {
      return std::make_pair(across(left), left.Low[axis]) <
        std::make_pair(across(right), right.Low[axis]);
    });
  std::size_t last = 0;
  for (std::size_t i = 1; i < bricks.size(); ++i)
  {
    if (across(bricks[i]) == across(bricks[last]) && bricks[i].Low[axis] == bricks[last].High[axis])
    {
      bricks[last].High[axis] = bricks[i].High[axis];
    }
    else
    {
      bricks[++last] = bricks[i];
    }
  }
  bricks.resize(std::min(bricks.size(), last + 1));
}

}

/// Bricks that cover each of the places once, and nothing else: rows along x, joined along y, and
/// these along z. Not the fewest there could be. The same whatever the order of the places, no two
/// of which are equal. O(n log n).
inline std::vector<Brick> MakeBricks(const std::vector<Place>& places)
{
  std::vector<Brick> bricks;
  bricks.reserve(places.size());
  for (const Place& place : places)
  {
    bricks.push_back({ place, { place[0] + 1, place[1] + 1, place[2] + 1 } });
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    detail::JoinAlong(axis, bricks);
  }
  return bricks;
}

}

#endif
