// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_LeafFilters_TriangleDistances_h
#define skd_LeafFilters_TriangleDistances_h

#include "../Tree/Tolerances.h"
#include "TrianglePacket.h"

#include <algorithm>

namespace skd
{

/// Lower and upper bounds of the distances of a packet's triangles from a point.
///
/// A point of each triangle near to the point is found in single precision. It bounds the distance
/// from above; from below the corners do, as seen along the line to that point, whatever rounding
/// made of it: no point of a triangle comes nearer than the plane across a line that all its
/// corners are behind. Where the point is the nearest, the two bounds meet.
class TriangleDistances
{
public:
  static constexpr int Width = TrianglePacket::Width;

  float Least[Width]; ///< in units, never above the true distance
  float Most[Width];  ///< never below it

  /// x in units of the grid.
  SKD_FLATTEN TriangleDistances(const TrianglePacket& packet, const Vector3& x)
  {
    // What rounding may do to corners (QuantizationGrid) and to sums of products relative to |x|.
    const double size = std::abs(x[0]) + std::abs(x[1]) + std::abs(x[2]);
    const float error =
      static_cast<float>(QuantizationGrid::CornerDistance + 0.3 + tolerances::DistanceSum * size);
    const float point[3] = { static_cast<float>(x[0]), static_cast<float>(x[1]),
      static_cast<float>(x[2]) };
    for (int first = 0; first < Width; first += NativeWidth)
    {
      this->Set<NativeWidth>(packet, point, error, first);
    }
  }

  /// No nearest triangle, of the first `count`, is farther: squared, the unit being so long.
  float LeastMost2(int count, float unit) const
  {
    const float most = *std::min_element(this->Most, this->Most + count) * unit;
    constexpr float slack = 1.0f + 1.0f / (1 << 19);
    return most * most * slack;
  }

  /// Bit i: lane i may be within the limit. Keys and limit are squared distances.
  unsigned Within(float limit, float unit, float* keys) const
  {
    const Lanes<Width> least = Lanes<Width>::Load(this->Least) * Lanes<Width>(unit);
    const Lanes<Width> least2 = least * least;
    least2.Store(keys);
    return LessEqual(least2, Lanes<Width>(limit));
  }

private:
  /// A point in each triangle: r u + s v from its corner a.
  template <int W>
  struct Barycentric
  {
    Lanes<W> R;
    Lanes<W> S;
  };

  template <int W>
  void Set(const TrianglePacket& packet, const float* x, float error, int first)
  {
    using L = Lanes<W>;
    const L zero(0.0f);
    const LanePoint<W> a = CornersOf<W>(packet, 0, first);
    const LanePoint<W> u = CornersOf<W>(packet, 1, first) - a;
    const LanePoint<W> v = CornersOf<W>(packet, 2, first) - a;
    const LanePoint<W> f = LanePoint<W>{ L(x[0]), L(x[1]), L(x[2]) } - a;
    const Barycentric<W> nearest = Nearest(u, v, f);

    const LanePoint<W> toX = f - nearest.R * u - nearest.S * v;
    const L least(tolerances::LeastLength2); // a root of 0 would not divide
    const L length = Sqrt(Max(Dot(toX, toX), least));
    const L height = Dot(toX, f) - Max(Max(Dot(toX, u), Dot(toX, v)), zero);
    Max(height / length - L(error), zero).Store(this->Least + first);
    (length + L(error)).Store(this->Most + first);
  }

  /// The point nearest to a + f, as well as single precision finds it, but always in the triangle.
  template <int W>
  static Barycentric<W> Nearest(const LanePoint<W>& u, const LanePoint<W>& v, const LanePoint<W>& f)
  {
    using L = Lanes<W>;
    const L zero(0.0f);
    const L one(1.0f);
    const L uu = Dot(u, u);
    const L vv = Dot(v, v);
    const L uv = Dot(u, v);
    const L fu = Dot(f, u);
    const L fv = Dot(f, v);
    const Barycentric<W> onEdge = NearestOnEdges(uu, vv, uv, fu, fv);
    const L scale = one / (uu * vv - uv * uv);
    const L r = (vv * fu - uv * fv) * scale;
    const L s = (uu * fv - uv * fu) * scale;
    const L inside = Min(Min(r, s), one - r - s);
    return { IfLessEqual(zero, inside, r, onEdge.R), IfLessEqual(zero, inside, s, onEdge.S) };
  }

  /// On that of the three edges which is nearest: costs are squared distances less that of a.
  template <int W>
  static Barycentric<W> NearestOnEdges(const Lanes<W>& uu, const Lanes<W>& vv, const Lanes<W>& uv,
    const Lanes<W>& fu, const Lanes<W>& fv)
  {
    using L = Lanes<W>;
    const L zero(0.0f);
    const L one(1.0f);
    const L two(2.0f);
    const auto part = [&](const L& a, const L& b) { return Min(Max(a / b, zero), one); };
    const L ww = (uu - uv) + (vv - uv); // w = v - u, from the end of u
    const L fw = (fv - fu) + (uu - uv);
    const L onU = part(fu, uu);
    const L onV = part(fv, vv);
    const L onW = part(fw, ww);
    const L costU = onU * (onU * uu - two * fu);
    const L costV = onV * (onV * vv - two * fv);
    const L costW = (uu - two * fu) + onW * (onW * ww - two * fw);
    const L cost = Min(costU, costV);
    const L r = IfLessEqual(costU, costV, onU, zero);
    const L s = IfLessEqual(costU, costV, zero, onV);
    return { IfLessEqual(cost, costW, r, one - onW), IfLessEqual(cost, costW, s, onW) };
  }
};

}

#endif
