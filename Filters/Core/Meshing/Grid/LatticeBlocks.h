// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Grid_LatticeBlocks_h
#define skd_Grid_LatticeBlocks_h

#include "Lattice.h"

#include <algorithm>
#include <tuple>

namespace skd
{

/// The lattice points from Low up to, not including, High along each axis.
struct LatticeBlock
{
  LatticePoint Low;
  LatticePoint High;

  std::int64_t NumberOfPoints() const
  {
    return (this->High[0] - this->Low[0]) * (this->High[1] - this->Low[1]) *
      (this->High[2] - this->Low[2]);
  }
};

namespace detail
{

/// Joins blocks that follow each other along an axis and are of one size across it.
inline void JoinAlong(int axis, std::vector<LatticeBlock>& blocks)
{
  const int a = (axis + 1) % 3;
  const int b = (axis + 2) % 3;
  const auto across = [=](const LatticeBlock& block)
  { return std::make_tuple(block.Low[b], block.High[b], block.Low[a], block.High[a]); };
  std::sort(blocks.begin(), blocks.end(),
    [&](const LatticeBlock& left, const LatticeBlock& right)
    {
      return std::make_pair(across(left), left.Low[axis]) <
        std::make_pair(across(right), right.Low[axis]);
    });
  std::size_t last = 0;
  for (std::size_t i = 1; i < blocks.size(); ++i)
  {
    if (across(blocks[i]) == across(blocks[last]) && blocks[i].Low[axis] == blocks[last].High[axis])
    {
      blocks[last].High[axis] = blocks[i].High[axis];
    }
    else
    {
      blocks[++last] = blocks[i];
    }
  }
  blocks.resize(std::min(blocks.size(), last + 1));
}

}

/// Blocks that cover each of the points once, and nothing else: rows along x, joined along y, and
/// these along z. Not the fewest there could be. The same whatever the order of the points, no two
/// of which are equal. O(n log n).
inline std::vector<LatticeBlock> JoinIntoBlocks(const std::vector<LatticePoint>& points)
{
  std::vector<LatticeBlock> blocks;
  blocks.reserve(points.size());
  for (const LatticePoint& point : points)
  {
    blocks.push_back({ point, { point[0] + 1, point[1] + 1, point[2] + 1 } });
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    detail::JoinAlong(axis, blocks);
  }
  return blocks;
}

}

#endif
