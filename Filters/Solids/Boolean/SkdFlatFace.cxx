// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Boolean/SkdFlatFace.h"

#include "Core/Geometry/Box.h"
#include "Core/Geometry/Polygons/ConstrainedTriangulation.h"
#include "Core/Geometry/Polygons/DelaunayEdge.h"
#include "Core/Geometry/Predicates/Orient3D.h"

#include <algorithm>
#include <cmath>
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
std::vector<SkdFlatFace::Corners> SkdFlatFace::Triangulate()
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
      return {};
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
/// The triangles on the left of some sides, and all that are reached from these across others.
class Inside
{
public:
  /// `edges` are ascending.
  Inside(const std::vector<std::array<int, 3>>& all, const std::vector<Ends>& edges)
    : All(all)
    , Edges(edges)
    , IsIn(all.size(), false)
  {
    for (std::uint32_t triangle = 0; triangle < all.size(); ++triangle)
    {
      for (std::size_t i = 0; i < 3; ++i)
      {
        this->Sides.push_back({ SideOf(all[triangle], i), triangle });
      }
    }
    std::sort(this->Sides.begin(), this->Sides.end());
  }

  /// False if an edge is missing, the other side of one is reached, or a corner below `least`.
  bool Find(int least)
  {
    bool isWhole = true;
    for (const Ends& edge : this->Edges)
    {
      isWhole = this->Enter(edge) && isWhole;
    }
    for (std::size_t at = 0; isWhole && at < this->Found.size(); ++at)
    {
      for (std::size_t i = 0; i < 3; ++i)
      {
        const Ends side = SideOf(this->All[this->Found[at]], i);
        const Ends other{ side.second, side.first };
        isWhole = isWhole && side.first >= least && !this->IsEdge(other);
        if (isWhole && !this->IsEdge(side))
        {
          this->Enter(other);
        }
      }
    }
    return isWhole;
  }

  const std::vector<std::uint32_t>& GetFound() const { return this->Found; }

private:
  struct Side
  {
    Ends Of;
    std::uint32_t Triangle;
    bool operator<(const Side& other) const { return this->Of < other.Of; }
  };

  static Ends SideOf(const std::array<int, 3>& corners, std::size_t i)
  {
    return { corners[i], corners[(i + 1) % 3] };
  }

  bool IsEdge(const Ends& side) const
  {
    return std::binary_search(this->Edges.begin(), this->Edges.end(), side);
  }

  /// The triangle on the left of a side.
  bool Enter(const Ends& side)
  {
    const auto at = std::lower_bound(this->Sides.begin(), this->Sides.end(), Side{ side, 0 });
    const bool isThere = at != this->Sides.end() && at->Of == side;
    if (isThere && !this->IsIn[at->Triangle])
    {
      this->IsIn[at->Triangle] = true;
      this->Found.push_back(at->Triangle);
    }
    return isThere;
  }

  const std::vector<std::array<int, 3>>& All;
  const std::vector<Ends>& Edges;
  std::vector<bool> IsIn;
  std::vector<Side> Sides; // ascending
  std::vector<std::uint32_t> Found;
};
}

std::vector<SkdFlatFace::Corners> SkdFlatFace::TakeInside(
  const std::vector<std::array<int, 3>>& all) const
{
  const std::vector<Ends> edges = this->ListEnds();
  Inside inside(all, edges);
  std::vector<Corners> taken;
  if (!inside.Find(3))
  {
    return taken;
  }
  for (const std::uint32_t triangle : inside.GetFound())
  {
    const std::array<int, 3>& numbers = all[triangle];
    taken.push_back(
      { this->PointOf[numbers[0]], this->PointOf[numbers[1]], this->PointOf[numbers[2]] });
  }
  return taken;
}
}
