// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Adaptation_SurfaceMesh_h
#define skd_Adaptation_SurfaceMesh_h

#include "../../Geometry/Rows.h"
#include "../../Geometry/Vector.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace skd
{

/// An edge of polygons. Of one that a single cell has, the border, Cells[1] is None.
struct MeshEdge
{
  static constexpr std::uint32_t None = 0xffffffff;

  std::array<std::uint32_t, 2> Points;
  std::array<std::uint32_t, 2> Cells;
};

/// What a point may do.
enum class PointFreedom : unsigned char
{
  Free,       ///< move along the surface
  AlongCurve, ///< slide along the border or a crease
  Fixed
};

/// A surface of triangles, quadrilaterals and other polygons, whose points move while its cells
/// stay what they are.
struct SurfaceMesh
{
  std::vector<Vector3> Points;
  IndexRows Cells; ///< corners in order, each once in a cell
  IndexRows CellsOfPoint;
  std::vector<MeshEdge> Edges; ///< ascending; without those of three cells and more
  std::vector<std::pair<std::uint32_t, std::uint32_t>> NonManifoldEdges;
  std::vector<PointFreedom> Freedom; ///< all Free, until somebody says otherwise

  /// Finds all that follows from Points and Cells. O(N log N).
  void FindEdges();
};

inline void SurfaceMesh::FindEdges()
{
  this->CellsOfPoint = this->Cells.Inverse(this->Points.size());
  this->Freedom.assign(this->Points.size(), PointFreedom::Free);
  std::vector<std::array<std::uint32_t, 3>> sides;
  for (std::uint32_t cell = 0; cell < this->Cells.size(); ++cell)
  {
    const IndexRows::Row corners = this->Cells[cell];
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
      const std::uint32_t a = corners[i];
      const std::uint32_t b = corners[i + 1 < corners.size() ? i + 1 : 0];
      sides.push_back({ std::min(a, b), std::max(a, b), cell });
    }
  }
  std::sort(sides.begin(), sides.end());
  for (std::size_t first = 0, last = 0; first < sides.size(); first = last)
  {
    const auto& side = sides[first];
    while (last < sides.size() && sides[last][0] == side[0] && sides[last][1] == side[1])
    {
      ++last;
    }
    if (last - first > 2)
    {
      this->NonManifoldEdges.emplace_back(side[0], side[1]);
      continue;
    }
    const std::uint32_t other = last - first == 2 ? sides[first + 1][2] : MeshEdge::None;
    this->Edges.push_back({ { side[0], side[1] }, { side[2], other } });
  }
}

}

#endif
