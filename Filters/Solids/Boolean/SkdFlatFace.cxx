// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Boolean/SkdFlatFace.h"

#include "Core/Geometry/Box.h"
#include "Core/Geometry/Polygons/ConstrainedTriangulation.h"
#include "Core/Geometry/Polygons/DelaunayEdge.h"
#include "Core/Geometry/Predicates/Orient3D.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace skdtree
{
namespace
{
using Ends = std::pair<int, int>;

/// Of those that are equal to within rounding the first.
int LargestAxisOf(const skd::Vector3& normal)
{
  constexpr double more = 1.0 + 1e-9;
  int largest = 0;
  for (int axis = 1; axis < 3; ++axis)
  {
    largest = std::abs(normal[axis]) > more * std::abs(normal[largest]) ? axis : largest;
  }
  return largest;
}
}

//------------------------------------------------------------------------------
// Returns whether as many edges leave each point as reach it, and no edge is there twice or in both
// directions.
bool SkdFlatFace::ListPoints()
{
  std::sort(this->Edges.begin(), this->Edges.end());
  std::vector<std::uint32_t> from;
  std::vector<std::uint32_t> to;
  bool isSimple = this->Edges.size() > 2;
  for (const Edge& edge : this->Edges)
  {
    from.push_back(edge.first);
    to.push_back(edge.second);
    isSimple = isSimple && edge.first != edge.second &&
      !std::binary_search(this->Edges.begin(), this->Edges.end(), Edge{ edge.second, edge.first });
  }
  std::sort(to.begin(), to.end());
  isSimple = isSimple && from == to &&
    std::adjacent_find(this->Edges.begin(), this->Edges.end()) == this->Edges.end();
  from.erase(std::unique(from.begin(), from.end()), from.end());
  this->Points = std::move(from);
  return isSimple;
}

// Numbers follow the coordinates: which of several Delaunay triangulations is found depends on the
// order in which points are added, and must not depend on how a mesh has numbered them.
void SkdFlatFace::SetPositions(const std::vector<skd::Vector3>& positions)
{
  std::vector<std::size_t> order(positions.size());
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  std::sort(order.begin(), order.end(),
    [&](std::size_t a, std::size_t b)
    {
      return std::lexicographical_compare(
        positions[a].X, positions[a].X + 3, positions[b].X, positions[b].X + 3);
    });
  this->Numbers.resize(positions.size());
  this->PointOf.assign(3, 0);
  this->Positions.resize(3); // around all, see Surround
  for (const std::size_t i : order)
  {
    this->Numbers[i] = static_cast<int>(this->Positions.size());
    this->PointOf.push_back(this->Points[i]);
    this->Positions.push_back(positions[i]);
  }
}

int SkdFlatFace::NumberOf(std::uint32_t point) const
{
  const auto at = std::lower_bound(this->Points.begin(), this->Points.end(), point);
  return this->Numbers[static_cast<std::size_t>(at - this->Points.begin())];
}

// The edges by the numbers of their ends, ascending.
std::vector<std::pair<int, int>> SkdFlatFace::ListEnds() const
{
  std::vector<Ends> ends;
  for (const Edge& edge : this->Edges)
  {
    ends.emplace_back(this->NumberOf(edge.first), this->NumberOf(edge.second));
  }
  std::sort(ends.begin(), ends.end());
  return ends;
}

//------------------------------------------------------------------------------
// The first three positions are a triangle that has all others well inside, and turns left.
void SkdFlatFace::Surround(int axis, int sign)
{
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  skd::Box3 box;
  std::for_each(this->Positions.begin() + 3, this->Positions.end(),
    [&box](const skd::Vector3& x) { box.Add(x); });
  const skd::Vector3 middle = 0.5 * (box.Min + box.Max);
  const double size = std::max(box.Max[u] - box.Min[u], box.Max[v] - box.Min[v]);
  const auto at = [&](double alongU, double alongV)
  {
    skd::Vector3 x = middle;
    x[u] += alongU * size;
    x[v] += alongV * size;
    return x;
  };
  this->Positions[0] = at(-4.0, -2.0);
  this->Positions[1] = at(4.0, -2.0);
  this->Positions[2] = at(0.0, 4.0);
  if (sign < 0)
  {
    std::swap(this->Positions[0], this->Positions[1]);
  }
}

//------------------------------------------------------------------------------
std::optional<SkdFlatFace::Triangles> SkdFlatFace::Triangulate()
{
  const int axis = LargestAxisOf(this->Normal);
  const int sign = this->Normal[axis] < 0.0 ? -1 : 1;
  this->Surround(axis, sign);
  const auto& x = this->Positions;
  const auto orient = [&](int a, int b, int c)
  { return sign * skd::Orient2D(x[a], x[b], x[c], axis); };
  const auto isBetter = [&](int a, int b, int c, int d)
  { return skd::IsOtherEdgeDelaunay(x[a], x[b], x[c], x[d]); };
  const auto count = static_cast<int>(x.size());
  skd::ConstrainedTriangulation<decltype(orient), decltype(isBetter)> made(count, orient, isBetter);
  for (int i = 3; i < count; ++i)
  {
    if (made.Add(i) != i)
    {
      return std::nullopt;
    }
  }
  for (const Ends& edge : this->ListEnds())
  {
    made.Constrain(edge.first, edge.second);
  }
  return this->TakeInside(made.GetTriangles());
}

//------------------------------------------------------------------------------
namespace
{
/// How often edges go around each triangle, to the left.
class Windings
{
public:
  /// `edges` are ascending.
  Windings(const std::vector<std::array<int, 3>>& all, const std::vector<Ends>& edges)
    : All(all)
    , Edges(edges)
    , Numbers(all.size(), Unknown)
    , AreEdges(3 * all.size(), false)
  {
    this->Sides.reserve(3 * all.size());
    for (std::size_t triangle = 0; triangle < all.size(); ++triangle)
    {
      for (std::size_t i = 0; i < 3; ++i)
      {
        const Ends side{ all[triangle][i], all[triangle][(i + 1) % 3] };
        this->Sides.push_back({ KeyOf(side), 3 * triangle + i });
      }
    }
    std::sort(this->Sides.begin(), this->Sides.end());
  }

  /// False if an edge is missing. Triangles with corners below `least` are outside of all.
  bool Find(int least)
  {
    const bool isWhole = this->MarkEdges();
    std::vector<std::size_t> found;
    for (std::size_t triangle = 0; triangle < this->All.size() && found.empty(); ++triangle)
    {
      const auto& corners = this->All[triangle];
      if (*std::min_element(corners.begin(), corners.end()) < least)
      {
        this->Numbers[triangle] = 0;
        found.push_back(triangle);
      }
    }
    for (std::size_t at = 0; isWhole && at < found.size(); ++at)
    {
      this->Cross(found[at], found);
    }
    return isWhole;
  }

  int Get(std::size_t triangle) const { return this->Numbers[triangle]; }

private:
  static constexpr int Unknown = std::numeric_limits<int>::max();

  struct Side
  {
    std::uint64_t Key;  // its ends as one number
    std::size_t Number; // thrice that of the triangle, and more
    bool operator<(const Side& other) const { return this->Key < other.Key; }
  };

  static std::uint64_t KeyOf(const Ends& side)
  {
    return static_cast<std::uint64_t>(side.first) << 32 | static_cast<std::uint32_t>(side.second);
  }

  bool MarkEdges()
  {
    return std::all_of(this->Edges.begin(), this->Edges.end(),
      [this](const Ends& edge)
      {
        const Side* left = this->FindLeft(edge);
        if (left)
        {
          this->AreEdges[left->Number] = true;
        }
        return left != nullptr;
      });
  }

  const Side* FindLeft(const Ends& side) const
  {
    const auto at =
      std::lower_bound(this->Sides.begin(), this->Sides.end(), Side{ KeyOf(side), 0 });
    return at != this->Sides.end() && at->Key == KeyOf(side) ? &*at : nullptr;
  }

  /// To the neighbors of a triangle, which are added.
  void Cross(std::size_t triangle, std::vector<std::size_t>& found)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      const auto& corners = this->All[triangle];
      const Side* beyond = this->FindLeft({ corners[(i + 1) % 3], corners[i] });
      if (beyond && this->Numbers[beyond->Number / 3] == Unknown)
      {
        this->Numbers[beyond->Number / 3] = this->Numbers[triangle] +
          this->AreEdges[beyond->Number] - this->AreEdges[3 * triangle + i];
        found.push_back(beyond->Number / 3);
      }
    }
  }

  const std::vector<std::array<int, 3>>& All;
  const std::vector<Ends>& Edges;
  std::vector<int> Numbers;   // of each triangle
  std::vector<bool> AreEdges; // of each side, by its number
  std::vector<Side> Sides;    // ascending
};
}

std::optional<SkdFlatFace::Triangles> SkdFlatFace::TakeInside(
  const std::vector<std::array<int, 3>>& all) const
{
  const std::vector<Ends> edges = this->ListEnds();
  Windings windings(all, edges);
  if (!windings.Find(3))
  {
    return std::nullopt;
  }
  Triangles taken;
  for (std::size_t triangle = 0; triangle < all.size(); ++triangle)
  {
    const int winding = windings.Get(triangle);
    if (winding != 0 && std::abs(winding) != 1)
    {
      return std::nullopt;
    }
    if (winding != 0)
    {
      const std::array<int, 3>& of = all[triangle];
      const Corners corners{ this->PointOf[of[0]], this->PointOf[of[1]], this->PointOf[of[2]] };
      winding > 0 ? taken.Left.push_back(corners)
                  : taken.Right.push_back({ corners[0], corners[2], corners[1] });
    }
  }
  return taken;
}
}
