// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The convex hull of a few points, by exact signs: points are added one at a time, and the
/// triangles that see one are replaced by those between their outline and it. O(n^2), for n up to
/// some hundred. A triangle sees a point only if that is strictly before it, so triangles of one
/// plane fit together, and none is without area. Coordinates are scaled by a power of two before
/// signs are taken: they are exact at any size (see Orient3D.h), unless magnitudes differ by 1e80.
#ifndef skd_Geometry_Polygons_ConvexHull_h
#define skd_Geometry_Polygons_ConvexHull_h

#include "../Box.h"
#include "../Predicates/Orient3D.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

namespace skd
{

struct ConvexHull
{
  using Triangle = std::array<std::uint32_t, 3>;

  int Dimension =
    -1; ///< of the hull: 3, 2 where points are in a plane, 1 on a line, 0 all the same
  std::vector<Triangle> Triangles;    ///< of dimension 3: counterclockwise, seen from outside
  std::vector<std::uint32_t> Outline; ///< of dimension 2: the corners in turn; less: the ends
};

namespace detail
{

class HullMaker
{
public:
  HullMaker(const Vector3* points, std::size_t size)
    : Points(points, points + size)
  {
    int exponent = 0;
    Box3 bounds;
    for (const Vector3& x : this->Points)
    {
      bounds.Add(x);
    }
    std::frexp(LargestCoordinate(bounds), &exponent);
    for (Vector3& x : this->Points)
    {
      x = { { std::ldexp(x[0], -exponent), std::ldexp(x[1], -exponent),
        std::ldexp(x[2], -exponent) } };
    }
  }

  ConvexHull Make()
  {
    ConvexHull hull;
    const auto size = static_cast<std::uint32_t>(this->Points.size());
    hull.Dimension = this->FindStart();
    if (hull.Dimension == 3)
    {
      this->Begin();
      for (std::uint32_t i = 0; i < size; ++i)
      {
        this->Add(i);
      }
      hull.Triangles = std::move(this->Triangles);
    }
    else if (hull.Dimension == 2)
    {
      hull.Outline = this->OutlineInPlane();
    }
    else
    {
      hull.Outline = this->Ends();
    }
    return hull;
  }

private:
  using Triangle = ConvexHull::Triangle;

  template <class IsWanted>
  bool FindNext(int start, const IsWanted& isWanted)
  {
    const auto found = std::find_if(this->Points.begin(), this->Points.end(), isWanted);
    this->Start[start] = static_cast<std::uint32_t>(found - this->Points.begin());
    return found != this->Points.end();
  }

  const Vector3& At(int start) const { return this->Points[this->Start[start]]; }

  /// Looks for points that span as much as all do. Returns the dimension of that.
  int FindStart()
  {
    if (this->Points.empty())
    {
      return -1;
    }
    this->Start[0] = 0;
    const auto differs = [this](const Vector3& x)
    { return x[0] != this->At(0)[0] || x[1] != this->At(0)[1] || x[2] != this->At(0)[2]; };
    if (!this->FindNext(1, differs))
    {
      return 0;
    }
    const auto turnsLeft = [this](const Vector3& x)
    {
      for (this->Axis = 0; this->Axis < 3; ++this->Axis)
      {
        if (Orient2D(this->At(0), this->At(1), x, this->Axis) != 0)
        {
          return true;
        }
      }
      return false;
    };
    if (!this->FindNext(2, turnsLeft))
    {
      return 1;
    }
    const auto isOff = [this](const Vector3& x)
    { return Orient3D(this->At(0), this->At(1), this->At(2), x) != 0; };
    return this->FindNext(3, isOff) ? 3 : 2;
  }

  void Begin()
  {
    const auto [a, b, c, d] = this->Start;
    const bool isBefore = Orient3D(this->At(0), this->At(1), this->At(2), this->At(3)) > 0;
    this->Triangles = isBefore
      ? std::vector<Triangle>{ { a, c, b }, { a, b, d }, { b, c, d }, { c, a, d } }
      : std::vector<Triangle>{ { a, b, c }, { b, a, d }, { c, b, d }, { a, c, d } };
  }

  void Add(std::uint32_t i)
  {
    const auto sees = [&](const Triangle& t)
    {
      return Orient3D(this->Points[t[0]], this->Points[t[1]], this->Points[t[2]], this->Points[i]) >
        0;
    };
    const auto firstVisible =
      std::stable_partition(this->Triangles.begin(), this->Triangles.end(), std::not_fn(sees));
    const std::vector<Triangle> visible(firstVisible, this->Triangles.end());
    this->Triangles.erase(firstVisible, this->Triangles.end());
    for (const Triangle& triangle : visible)
    {
      for (int k = 0; k < 3; ++k)
      {
        const std::uint32_t a = triangle[k];
        const std::uint32_t b = triangle[k == 2 ? 0 : k + 1];
        if (!HasEdge(visible, b, a))
        {
          this->Triangles.push_back({ a, b, i });
        }
      }
    }
  }

  static bool HasEdge(const std::vector<Triangle>& triangles, std::uint32_t a, std::uint32_t b)
  {
    return std::any_of(triangles.begin(), triangles.end(),
      [=](const Triangle& t)
      { return (t[0] == a && t[1] == b) || (t[1] == a && t[2] == b) || (t[2] == a && t[0] == b); });
  }

  std::vector<std::uint32_t> InOrder() const
  {
    std::vector<std::uint32_t> order(this->Points.size());
    for (std::uint32_t i = 0; i < order.size(); ++i)
    {
      order[i] = i;
    }
    std::sort(order.begin(), order.end(),
      [this](std::uint32_t a, std::uint32_t b)
      {
        const double* x = this->Points[a].X;
        const double* y = this->Points[b].X;
        const bool isLess = std::lexicographical_compare(x, x + 3, y, y + 3);
        return isLess || (a < b && !std::lexicographical_compare(y, y + 3, x, x + 3));
      });
    return order;
  }

  std::vector<std::uint32_t> Ends() const
  {
    const std::vector<std::uint32_t> order = this->InOrder();
    return order.empty() ? order : std::vector<std::uint32_t>{ order.front(), order.back() };
  }

  // Andrew's two chains. In lexicographic order of all coordinates points of a plane are in order
  // along a line of it; a plane along which these were none is looked at along another axis.
  std::vector<std::uint32_t> OutlineInPlane() const
  {
    std::vector<std::uint32_t> order = this->InOrder();
    std::vector<std::uint32_t> outline;
    for (int chain = 0; chain < 2; ++chain)
    {
      const std::size_t first = outline.size();
      for (const std::uint32_t i : order)
      {
        while (outline.size() >= first + 2 &&
          Orient2D(this->Points[outline[outline.size() - 2]], this->Points[outline.back()],
            this->Points[i], this->Axis) <= 0)
        {
          outline.pop_back();
        }
        outline.push_back(i);
      }
      outline.pop_back(); // where the other chain begins
      std::reverse(order.begin(), order.end());
    }
    return outline;
  }

  std::vector<Vector3> Points;
  std::array<std::uint32_t, 4> Start{};
  int Axis = 0; // seen along which the plane of a flat set is no line
  std::vector<Triangle> Triangles;
};

}

/// Of finite points. What is equal to an earlier point is no corner.
inline ConvexHull ConvexHullOf(const Vector3* points, std::size_t size)
{
  return detail::HullMaker(points, size).Make();
}

}

#endif
