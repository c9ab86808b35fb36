// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Boolean/SkdSlivers.h"

#include "Core/Geometry/DisjointSets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <unordered_map>

namespace skdtree
{
namespace
{
using Corners = SkdTriangleSet::Corners;
using Edge = std::pair<std::uint32_t, std::uint32_t>; // the lower end first
constexpr std::uint32_t None = 0xffffffffu;

/// The size of a facet: its edges are from a corner to the next.
struct Shape
{
  static constexpr double Bits48 = 1.0 / (std::uint64_t(1) << 48);

  std::array<double, 3> Lengths;
  double Height; // least
  double Rounding;

  explicit Shape(const std::array<skd::Vector3, 3>& x)
  {
    double largest = 0.0;
    for (std::size_t i = 0; i < 3; ++i)
    {
      this->Lengths[i] = Norm(x[(i + 1) % 3] - x[i]);
      largest = std::max({ largest, std::abs(x[i][0]), std::abs(x[i][1]), std::abs(x[i][2]) });
    }
    const double longest = *std::max_element(this->Lengths.begin(), this->Lengths.end());
    this->Height = longest > 0.0 ? Norm(Cross(x[1] - x[0], x[2] - x[0])) / longest : 0.0;
    this->Rounding = Bits48 * largest;
  }

  /// Not where a square of the area is too small for a number.
  bool IsSliver() const
  {
    constexpr double least = 1e-60;
    return this->Height <= this->Rounding &&
      *std::max_element(this->Lengths.begin(), this->Lengths.end()) > least;
  }
  std::size_t GetLongest() const
  {
    return std::max_element(this->Lengths.begin(), this->Lengths.end()) - this->Lengths.begin();
  }
  std::size_t GetShortest() const
  {
    return std::min_element(this->Lengths.begin(), this->Lengths.end()) - this->Lengths.begin();
  }
};

/// Facets of a boundary, which knows some of them by their edges.
class Boundary
{
public:
  Boundary(const SkdMovedTriangles& set, SkdFacets& facets, SkdFacetSigns& signs)
    : Set(set)
    , Facets(facets)
    , Signs(signs)
  {
  }

  /// As the boundary has them.
  Corners GetCorners(std::uint32_t facet) const
  {
    Corners corners = this->Facets.Corners[facet];
    if (this->Signs[facet] < 0)
    {
      std::swap(corners[1], corners[2]);
    }
    return corners;
  }

  Shape GetShape(const Corners& corners) const
  {
    return Shape({ this->At(corners[0]), this->At(corners[1]), this->At(corners[2]) });
  }

  /// Knows the facets with any of these points.
  void Know(const std::vector<bool>& isPoint)
  {
    for (std::uint32_t facet = 0; facet < this->Signs.size(); ++facet)
    {
      const Corners& corners = this->Facets.Corners[facet];
      if (this->Signs[facet] != 0 &&
        (isPoint[corners[0]] || isPoint[corners[1]] || isPoint[corners[2]]))
      {
        this->Enter(facet);
      }
    }
  }

  /// The highest of the known facets that have an edge in this direction, of equal ones the first;
  /// None if there is none.
  std::uint32_t FindHighest(std::uint32_t from, std::uint32_t to) const
  {
    std::uint32_t highest = None;
    double height = -1.0;
    const auto found = this->FacetsAt.find(KeyOf(from, to));
    if (found != this->FacetsAt.end())
    {
      for (const std::uint32_t facet : found->second)
      {
        const double its = this->GetShape(this->GetCorners(facet)).Height;
        const bool isHigher = its > height || (its == height && facet < highest);
        highest = isHigher ? facet : highest;
        height = isHigher ? its : height;
      }
    }
    return highest;
  }

  void TakeOut(std::uint32_t facet)
  {
    const Corners corners = this->GetCorners(facet);
    for (std::size_t i = 0; i < 3; ++i)
    {
      std::vector<std::uint32_t>& at = this->FacetsAt[KeyOf(corners[i], corners[(i + 1) % 3])];
      at.erase(std::remove(at.begin(), at.end(), facet), at.end());
    }
    this->Signs[facet] = 0;
  }

  /// A known facet that these corners would be laid on, face to face, or None.
  std::uint32_t FindOpposite(const Corners& corners) const
  {
    const auto found = this->FacetsAt.find(KeyOf(corners[1], corners[0]));
    std::uint32_t opposite = None;
    if (found != this->FacetsAt.end())
    {
      for (const std::uint32_t facet : found->second)
      {
        const Corners& its = this->Facets.Corners[facet];
        const bool isOpposite = std::find(its.begin(), its.end(), corners[2]) != its.end();
        opposite = isOpposite ? std::min(opposite, facet) : opposite;
      }
    }
    return opposite;
  }

  /// Puts a piece of a parent, with the corners as the boundary has them, where one was taken out:
  /// or takes out one that it would be laid on, face to face. Returns whether it is there.
  bool Put(std::uint32_t facet, const Corners& corners, std::uint32_t parent, signed char sign)
  {
    const std::uint32_t laid = this->FindOpposite(corners);
    if (laid != None)
    {
      this->TakeOut(laid);
      return false;
    }
    this->Facets.Corners[facet] =
      sign < 0 ? Corners{ corners[0], corners[2], corners[1] } : corners;
    this->Facets.Parents[facet] = parent;
    this->Signs[facet] = sign;
    this->Enter(facet);
    return true;
  }

private:
  static std::uint64_t KeyOf(std::uint32_t from, std::uint32_t to)
  {
    return static_cast<std::uint64_t>(from) << 32 | to;
  }

  skd::Vector3 At(std::uint32_t point) const { return this->Facets.GetPosition(this->Set, point); }

  void Enter(std::uint32_t facet)
  {
    const Corners corners = this->GetCorners(facet);
    for (std::size_t i = 0; i < 3; ++i)
    {
      this->FacetsAt[KeyOf(corners[i], corners[(i + 1) % 3])].push_back(facet);
    }
  }

  const SkdMovedTriangles& Set;
  SkdFacets& Facets;
  SkdFacetSigns& Signs;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> FacetsAt; // by directed edges
};

/// Whether a facet may be a sliver: without roots.
bool MayBeSliver(const std::array<skd::Vector3, 3>& x)
{
  const skd::Vector3 first = x[1] - x[0];
  const skd::Vector3 last = x[2] - x[0];
  const skd::Vector3 area = Cross(first, last);
  const double side = Dot(first, first) + Dot(last, last); // the longest is no longer than twice
  const double largest = Dot(x[0], x[0]) + Dot(x[1], x[1]) + Dot(x[2], x[2]);
  return Dot(area, area) <= 2.0 * Shape::Bits48 * Shape::Bits48 * largest * side;
}

/// Pieces in the boundary that are slivers, by ascending number.
std::vector<std::uint32_t> FindSlivers(
  const SkdMovedTriangles& set, const SkdFacets& facets, const SkdFacetSigns& signs)
{
  std::vector<std::uint32_t> slivers;
  for (std::uint32_t facet = 0; facet < signs.size(); ++facet)
  {
    if (signs[facet] != 0 && facets.IsPiece(set, facet))
    {
      const auto x = facets.GetPositions(set, facet);
      if (MayBeSliver(x) && Shape(x).IsSliver())
      {
        slivers.push_back(facet);
      }
    }
  }
  return slivers;
}

class SliverRemoval
{
public:
  SliverRemoval(const SkdMovedTriangles& set, SkdRoundedFacets& rounded)
    : Set(set)
    , Rounded(rounded)
  {
  }

  void Run(std::vector<std::uint32_t> slivers)
  {
    constexpr int most = 16; // rounds: what one leaves may be slivers again
    bool hasChanged = true;
    for (int round = 0; hasChanged && !slivers.empty() && round < most; ++round)
    {
      hasChanged = this->CollapseNeedles(slivers) || this->FlipCaps(slivers);
      slivers = FindSlivers(this->Set, this->Rounded.Facets, this->Rounded.Signs);
    }
    this->SortByParent();
  }

private:
  /// Whether there were any.
  bool CollapseNeedles(const std::vector<std::uint32_t>& slivers)
  {
    const SkdFacets& facets = this->Rounded.Facets;
    std::vector<Edge> edges;
    for (const std::uint32_t sliver : slivers)
    {
      const Shape shape(facets.GetPositions(this->Set, sliver));
      const std::size_t shortest = shape.GetShortest();
      if (shape.Lengths[shortest] <= shape.Rounding)
      {
        const Corners& corners = facets.Corners[sliver];
        edges.push_back(std::minmax(corners[shortest], corners[(shortest + 1) % 3]));
      }
    }
    this->LeaveOutGiven(edges);
    if (edges.empty())
    {
      return false;
    }
    skd::DisjointSets<> points(this->Set.GetPoints().size() + facets.NewPoints.size());
    for (const Edge& edge : edges)
    {
      points.Unite(edge.first, edge.second);
    }
    this->Rounded = SkdUniteEqualPoints(std::move(this->Rounded), points.Representatives(), false);
    return true;
  }

  /// The edges of the set's triangles, which stay.
  void LeaveOutGiven(std::vector<Edge>& edges) const
  {
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    std::vector<bool> isGiven(edges.size(), false);
    const auto n = static_cast<std::uint32_t>(this->Set.GetSet().GetTriangles().size());
    for (std::uint32_t triangle = 0; !edges.empty() && triangle < n; ++triangle)
    {
      const Corners& corners = this->Set.GetCorners(triangle);
      for (std::size_t i = 0; i < 3; ++i)
      {
        const Edge edge = std::minmax(corners[i], corners[(i + 1) % 3]);
        const auto at = std::lower_bound(edges.begin(), edges.end(), edge);
        if (at != edges.end() && *at == edge)
        {
          isGiven[static_cast<std::size_t>(at - edges.begin())] = true;
        }
      }
    }
    std::size_t left = 0;
    for (std::size_t i = 0; i < edges.size(); ++i)
    {
      if (!isGiven[i])
      {
        edges[left++] = edges[i];
      }
    }
    edges.resize(left);
  }

  /// Of each cap the corner at its longest edge becomes one of the facet on the other side of that,
  /// which is divided; what is laid on another facet leaves with it. Returns whether there were
  /// any.
  bool FlipCaps(std::vector<std::uint32_t> caps)
  {
    std::vector<bool> isCorner(
      this->Set.GetPoints().size() + this->Rounded.Facets.NewPoints.size(), false);
    for (const std::uint32_t cap : caps)
    {
      for (const std::uint32_t corner : this->Rounded.Facets.Corners[cap])
      {
        isCorner[corner] = true;
      }
    }
    Boundary boundary(this->Set, this->Rounded.Facets, this->Rounded.Signs);
    boundary.Know(isCorner);
    const std::size_t most = 8 * caps.size() + 64;
    std::size_t flips = 0;
    for (std::size_t i = 0; i < caps.size() && flips < most; ++i)
    {
      flips += this->Flip(boundary, caps[i], caps);
    }
    this->Rounded.NumberFolded += static_cast<vtkIdType>(flips);
    return flips > 0;
  }

  /// Adds what are caps then.
  bool Flip(Boundary& boundary, std::uint32_t cap, std::vector<std::uint32_t>& caps) const
  {
    if (this->Rounded.Signs[cap] == 0)
    {
      return false;
    }
    const Corners corners = boundary.GetCorners(cap);
    const Shape shape = boundary.GetShape(corners);
    const std::size_t longest = shape.GetLongest();
    const std::uint32_t laid = boundary.FindOpposite(corners);
    if (laid != None)
    {
      boundary.TakeOut(cap);
      boundary.TakeOut(laid);
      return true;
    }
    if (!shape.IsSliver() || shape.Lengths[shape.GetShortest()] <= shape.Rounding)
    {
      return false;
    }
    const std::uint32_t from = corners[longest];
    const std::uint32_t to = corners[(longest + 1) % 3];
    const std::uint32_t apex = corners[(longest + 2) % 3];
    const std::uint32_t other = boundary.FindHighest(to, from);
    if (other == None)
    {
      return false;
    }
    const Corners beyond = boundary.GetCorners(other);
    const std::uint32_t tip = beyond[0] ^ beyond[1] ^ beyond[2] ^ from ^ to;
    const std::uint32_t parent = this->Rounded.Facets.Parents[other];
    const signed char sign = this->Rounded.Signs[other];
    boundary.TakeOut(cap);
    boundary.TakeOut(other);
    if (tip != apex)
    {
      const auto put = [&](std::uint32_t facet, const Corners& piece)
      {
        if (boundary.Put(facet, piece, parent, sign) && boundary.GetShape(piece).IsSliver())
        {
          caps.push_back(facet);
        }
      };
      put(cap, { from, tip, apex });
      put(other, { tip, to, apex });
    }
    return true;
  }

  void SortByParent()
  {
    const std::vector<std::uint32_t>& parents = this->Rounded.Facets.Parents;
    std::vector<std::uint32_t> order(parents.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(),
      [&parents](std::uint32_t a, std::uint32_t b) { return parents[a] < parents[b]; });
    Permute(order, this->Rounded.Signs);
    Permute(order, this->Rounded.Facets.Corners);
    Permute(order, this->Rounded.Facets.Parents);
  }

  template <class T>
  static void Permute(const std::vector<std::uint32_t>& order, std::vector<T>& items)
  {
    std::vector<T> permuted;
    permuted.reserve(order.size());
    for (const std::uint32_t i : order)
    {
      permuted.push_back(items[i]);
    }
    items = std::move(permuted);
  }

  const SkdMovedTriangles& Set;
  SkdRoundedFacets& Rounded;
};
}

bool SkdHaveSlivers(
  const SkdPlacement& placement, const SkdFacets& facets, const SkdFacetSigns& signs)
{
  return !FindSlivers(placement.First, facets, signs).empty();
}

void SkdRemoveSlivers(const SkdPlacement& placement, const SkdFacets& facets,
  const SkdFacetSigns& signs, std::optional<SkdRoundedFacets>& rounded)
{
  const SkdMovedTriangles& set = placement.First;
  std::vector<std::uint32_t> slivers =
    FindSlivers(set, rounded ? rounded->Facets : facets, rounded ? rounded->Signs : signs);
  if (slivers.empty())
  {
    return;
  }
  if (!rounded)
  {
    rounded = SkdMakeRounded(facets, signs);
  }
  SliverRemoval(set, *rounded).Run(std::move(slivers));
}
}
