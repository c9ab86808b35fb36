// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdEdgePairs_h
#define SkdEdgePairs_h

#include "Bodies/SkdEdgeTable.h"
#include "Bodies/SkdTriangulation.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace skdtree
{
/// Of each edge of each triangle the triangle beyond: see SkdShells.
class SkdEdgePairs
{
  using Use = skd::EdgeUse<vtkIdType>;

public:
  SkdEdgePairs(std::size_t numberOfPoints, const std::vector<SkdTriangleIds>& triangles)
    : Beyond(3 * triangles.size())
  {
    for (std::uint32_t side = 0; side < this->Beyond.size(); ++side)
    {
      this->Beyond[side] = side / 3 << 1 | 1u; // itself, of an edge without a length
    }
    SkdMakeEdgeTable(triangles, numberOfPoints)
      .ForEach(
        [this](vtkIdType, const Use* first, const Use* last)
        {
          this->Same.assign(first, last);
          this->PairSame(this->Same.data(), this->Same.data() + this->Same.size());
        });
  }

  struct Neighbour
  {
    std::uint32_t Triangle;
    bool IsAlike; // both have their normals on the same side of the surface
  };
  Neighbour Get(std::uint32_t triangle, int edge) const
  {
    const std::uint32_t side = this->Beyond[3 * triangle + edge];
    return { side >> 1, (side & 1u) != 0 };
  }

private:
  void PairSame(Use* begin, Use* end)
  {
    const auto isForward = [](const Use& use) { return use.IsForward; };
    const auto forward = std::count_if(begin, end, isForward);
    if (2 * forward == end - begin)
    {
      Use* middle = std::stable_partition(begin, end, isForward);
      for (; middle != end; ++begin, ++middle)
      {
        this->Join(*begin, *middle);
      }
      return;
    }
    for (; end - begin > 1; begin += 2)
    {
      this->Join(begin[0], begin[1]);
    }
  }

  void Join(const Use& a, const Use& b)
  {
    const std::uint32_t alike = a.IsForward != b.IsForward ? 1 : 0;
    this->Beyond[3 * a.Triangle + a.Side] = b.Triangle << 1 | alike;
    this->Beyond[3 * b.Triangle + b.Side] = a.Triangle << 1 | alike;
  }

  std::vector<Use> Same;             // of one edge
  std::vector<std::uint32_t> Beyond; // twice a triangle, and whether it is alike
};
}

#endif
