// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file EdgeTable.h
 * @brief The edges of triangles, each with all triangles that have it.
 */

#ifndef skd_Geometry_EdgeTable_h
#define skd_Geometry_EdgeTable_h

#include "Rows.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace skd
{

/// A triangle at one of its edges. `Index` is the type of point ids.
template <class Index = std::uint32_t>
struct EdgeUse
{
  Index High; ///< the higher end of the edge
  std::uint32_t Triangle;
  std::uint8_t Side; ///< the edge is from this corner of the triangle to the next
  bool IsForward;    ///< the triangle has the edge from its lower to its higher end

  bool operator<(const EdgeUse& other) const
  {
    if (this->High != other.High)
    {
      return this->High < other.High;
    }
    return this->Triangle != other.Triangle ? this->Triangle < other.Triangle
                                            : this->Side < other.Side;
  }
};

/// Built in O(n) by counting the edges at their lower ends: 12 bytes an edge and triangle for ids
/// of four bytes. Edges of a triangle that has a point twice are edges as well, also from a point
/// to itself. The only table of edges: Bodies/SkdEdgeTable.h makes it by VTK's threads.
template <class Index = std::uint32_t>
class EdgeTable
{
public:
  using Use = EdgeUse<Index>;

  EdgeTable() = default;

  /// `triangles[i][k]` is a corner; loop(n, f) calls f(i) for all i below n, maybe in parallel.
  template <class Triangle, class Loop>
  EdgeTable(const std::vector<Triangle>& triangles, std::size_t numberOfPoints, const Loop& loop);

  /// Calls visit(low, first, last) for each edge, in ascending order: its lower end, and its uses
  /// by ascending triangle.
  template <class Visit>
  void ForEach(const Visit& visit) const
  {
    for (std::size_t low = 0; low < this->Uses.size(); ++low)
    {
      const typename Rows<Use>::Row uses = this->Uses[low];
      for (const Use* first = uses.begin(); first != uses.end();)
      {
        const Use* last = first + 1;
        while (last != uses.end() && last->High == first->High)
        {
          ++last;
        }
        visit(static_cast<Index>(low), first, last);
        first = last;
      }
    }
  }

private:
  template <class Triangle, class Visit>
  static void ForEachSide(const std::vector<Triangle>& triangles, const Visit& visit)
  {
    for (std::uint32_t triangle = 0; triangle < triangles.size(); ++triangle)
    {
      for (std::uint8_t i = 0; i < 3; ++i)
      {
        const auto a = static_cast<Index>(triangles[triangle][i]);
        const auto b = static_cast<Index>(triangles[triangle][i == 2 ? 0 : i + 1]);
        visit(static_cast<std::size_t>(std::min(a, b)), Use{ std::max(a, b), triangle, i, a < b });
      }
    }
  }

  Rows<Use> Uses; // of edges by their lower end
};

template <class Index>
template <class Triangle, class Loop>
EdgeTable<Index>::EdgeTable(
  const std::vector<Triangle>& triangles, std::size_t numberOfPoints, const Loop& loop)
  : Uses(numberOfPoints, [&](const auto& add) { ForEachSide(triangles, add); })
{
  this->Uses.SortEach(loop);
}

}

#endif
