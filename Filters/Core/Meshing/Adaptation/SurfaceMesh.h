// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Adaptation_SurfaceMesh_h
#define skd_Adaptation_SurfaceMesh_h

#include "../../Geometry/Vector.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace skd
{

/// Rows of different lengths in one list.
class IndexRows
{
public:
  struct Row
  {
    const std::uint32_t* First;
    const std::uint32_t* Last;

    const std::uint32_t* begin() const { return this->First; }
    const std::uint32_t* end() const { return this->Last; }
    std::size_t size() const { return static_cast<std::size_t>(this->Last - this->First); }
    std::uint32_t operator[](std::size_t i) const { return this->First[i]; }
  };

  std::size_t size() const { return this->Offsets.size() - 1; }
  Row operator[](std::size_t i) const
  {
    const std::uint32_t* items = this->Items.data();
    return { items + this->Offsets[i], items + this->Offsets[i + 1] };
  }

  template <class Iterator>
  void Add(Iterator first, Iterator last)
  {
    this->Items.insert(this->Items.end(), first, last);
    this->Offsets.push_back(this->Items.size());
  }

  /// For each of n items the rows that have it, ascending.
  IndexRows Inverse(std::size_t n) const;

private:
  std::vector<std::size_t> Offsets{ 0 };
  std::vector<std::uint32_t> Items;
};

inline IndexRows IndexRows::Inverse(std::size_t n) const
{
  IndexRows inverse;
  inverse.Offsets.assign(n + 1, 0);
  for (const std::uint32_t item : this->Items)
  {
    ++inverse.Offsets[item + 1];
  }
  for (std::size_t i = 0; i < n; ++i)
  {
    inverse.Offsets[i + 1] += inverse.Offsets[i];
  }
  inverse.Items.resize(this->Items.size());
  std::vector<std::size_t> next(inverse.Offsets.begin(), inverse.Offsets.end() - 1);
  for (std::size_t row = 0; row < this->size(); ++row)
  {
    for (const std::uint32_t item : (*this)[row])
    {
      inverse.Items[next[item]++] = static_cast<std::uint32_t>(row);
    }
  }
  return inverse;
}

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
