// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_Measures_MeasureInBox_h
#define skd_Geometry_Measures_MeasureInBox_h

#include "../Box.h"

#include <array>

namespace skd
{

/// How much of a box is inside of a closed surface of triangles: a volume, of a box that is flat
/// along one axis an area, along two a length. Exact but for rounding.
///
/// Only the triangles that meet the closed box matter, oriented so that their normals point out,
/// and whether one corner of the box is inside, which must not be on the surface. By the divergence
/// theorem three times over. Seen from that corner, with the box in [-length, 0]:
///
///   z +-------* corner   volume = integral of (x + length) over the surface in the box
///     |\       \                   + length x (area on the side x = 0),
///     | +-------+          area = integral of (y + length) over the surface's cut with that side
///     | | x = 0 |                  + length x (length on the edge x = y = 0),
///     +-| side  |        length = the crossings of that edge, and what the corner says.
///      \+-------+
///
/// A corner of a triangle at exactly 0 counts as below it, for all triangles alike; so a surface
/// may be on the box's sides and run through its edges. Cost: O(triangles), no allocation.
class MeasureInBox
{
public:
  /// Bit i of `corner`: whether the corner is on the upper side of axis i. For a flat axis the side
  /// does not matter.
  MeasureInBox(const Box3& box, unsigned corner)
  {
    this->Arrange(box);
    for (int i = 0; i < 3; ++i)
    {
      const int axis = this->Axes[i];
      const bool isUpper = (corner >> axis & 1u) != 0 || box.Length(axis) == 0.0;
      this->Corner[i] = isUpper ? box.Max[axis] : box.Min[axis];
      this->Signs[i] = isUpper ? 1.0 : -1.0;
      this->Lengths[i] = box.Length(axis);
    }
    this->IsMirrored = this->Signs[0] * this->Signs[1] * this->Signs[2] < 0.0;
  }

  /// The normal of a, b, c by the right hand points out.
  void Add(const Vector3& a, const Vector3& b, const Vector3& c)
  {
    std::array<Vector3, 3> t{ this->See(a), this->See(b), this->See(c) };
    if (this->IsMirrored)
    {
      std::swap(t[1], t[2]);
    }
    if (this->Dimension == 3)
    {
      this->OfVolume += this->IntegralOver(t);
    }
    this->AddCut(t);
  }

  double Measure(bool isCornerInside) const
  {
    const double length = this->OfLength + (isCornerInside ? this->Lengths[2] : 0.0);
    if (this->Dimension == 1)
    {
      return length;
    }
    const double area = this->OfArea + this->Lengths[1] * length;
    return this->Dimension == 2 ? area : this->OfVolume + this->Lengths[0] * area;
  }

private:
  /// A triangle clipped by six planes has nine corners at most.
  struct Polygon
  {
    Vector3 Points[10];
    int Size = 0;
    void Add(const Vector3& p) { this->Points[this->Size++] = p; }
  };

  /// The axes in a cyclic order, flat ones first.
  void Arrange(const Box3& box)
  {
    this->Dimension = 0;
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Dimension += box.Length(axis) > 0.0;
    }
    int first = 0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const bool isFlat = !(box.Length(axis) > 0.0);
      const bool isLast = box.Length((axis + 2) % 3) > 0.0;
      first = (this->Dimension == 2 && isFlat) || (this->Dimension == 1 && isLast) ? axis : first;
    }
    this->Axes = { first, (first + 1) % 3, (first + 2) % 3 };
  }

  Vector3 See(const Vector3& p) const
  {
    Vector3 relative;
    for (int i = 0; i < 3; ++i)
    {
      relative[i] = this->Signs[i] * (p[this->Axes[i]] - this->Corner[i]);
    }
    return relative;
  }

  /// Keeps what is at most (sign 1) or at least (-1) `limit` along an axis.
  static Polygon Clip(const Polygon& polygon, int axis, double limit, double sign)
  {
    Polygon inside;
    for (int i = 0; i < polygon.Size; ++i)
    {
      const Vector3& p = polygon.Points[i];
      const Vector3& q = polygon.Points[i + 1 == polygon.Size ? 0 : i + 1];
      const double below = sign * (limit - p[axis]);
      const double belowNext = sign * (limit - q[axis]);
      if (below >= 0.0)
      {
        inside.Add(p);
      }
      if ((below > 0.0 && belowNext < 0.0) || (below < 0.0 && belowNext > 0.0))
      {
        Vector3 crossing = Lerp(p, q, below / (below - belowNext));
        crossing[axis] = limit;
        inside.Add(crossing);
      }
    }
    return inside;
  }

  /// Of (x + length) n_x over what of the triangle is in the box.
  double IntegralOver(const std::array<Vector3, 3>& t) const
  {
    Polygon in;
    for (const Vector3& p : t)
    {
      in.Add(p);
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      in = Clip(Clip(in, axis, 0.0, 1.0), axis, -this->Lengths[axis], -1.0);
    }
    double integral = 0.0;
    for (int i = 1; i + 1 < in.Size; ++i)
    {
      const Vector3 u = in.Points[i] - in.Points[0];
      const Vector3 v = in.Points[i + 1] - in.Points[0];
      const double height =
        (in.Points[0][0] + in.Points[i][0] + in.Points[i + 1][0]) / 3.0 + this->Lengths[0];
      integral += 0.5 * (u[1] * v[2] - u[2] * v[1]) * height;
    }
    return integral;
  }

  /// Where the edge from a corner below to one above meets x = 0: the same for both its triangles.
  static Vector3 Crossing(const Vector3& below, const Vector3& above)
  {
    return Lerp(below, above, -below[0] / (above[0] - below[0]));
  }

  /// The triangle's cut with the side x = 0, so directed that the inside is to its left.
  void AddCut(const std::array<Vector3, 3>& t)
  {
    const int above = (t[0][0] > 0.0) + (t[1][0] > 0.0) + (t[2][0] > 0.0);
    if (above == 0 || above == 3)
    {
      return;
    }
    int lone = 0;
    while ((t[lone][0] > 0.0) != (above == 1))
    {
      ++lone;
    }
    const Vector3& a = t[lone];
    const Vector3& b = t[(lone + 1) % 3];
    const Vector3& c = t[(lone + 2) % 3];
    if (above == 1)
    {
      this->AddSegment(Crossing(b, a), Crossing(c, a));
    }
    else
    {
      this->AddSegment(Crossing(a, c), Crossing(a, b));
    }
  }

  /// What a directed segment of the surface's cut with the side x = 0 adds: to the area there what
  /// the integral of (y + length) dz along the segment is (Green's theorem), and, if the segment
  /// crosses the edge y = 0 at a z, to the length inside on that edge. That length is the whole
  /// edge if its corner, at z = 0, is inside; and each crossing below the corner turns all that is
  /// still below it, z + length long, from outside to inside (where y falls along the segment, as
  /// the inside is to its left) or back.
  void AddSegment(const Vector3& p, const Vector3& q)
  {
    if (this->Dimension >= 2)
    {
      this->OfArea += this->IntegralAlong(p, q);
    }
    if ((p[1] > 0.0) != (q[1] > 0.0))
    {
      // Ends that neighbours share are the same to the last bit, so none is lost or counted twice.
      const Vector3& below = p[1] > 0.0 ? q : p;
      const Vector3& over = p[1] > 0.0 ? p : q;
      const double z = below[2] - below[1] / (over[1] - below[1]) * (over[2] - below[2]);
      const double sign = p[1] > 0.0 ? 1.0 : -1.0;
      this->OfLength += z > 0.0 ? 0.0 : sign * std::max(z + this->Lengths[2], 0.0);
    }
  }

  /// Of (y + length) dz over what of the segment is in the side.
  double IntegralAlong(const Vector3& p, const Vector3& q) const
  {
    double first = 0.0;
    double last = 1.0;
    for (int axis = 1; axis < 3; ++axis)
    {
      const double length = q[axis] - p[axis];
      if (length == 0.0)
      {
        last = p[axis] > 0.0 || p[axis] < -this->Lengths[axis] ? -1.0 : last;
        continue;
      }
      const double atZero = -p[axis] / length;
      const double atLow = (-this->Lengths[axis] - p[axis]) / length;
      first = std::max(first, std::min(atZero, atLow));
      last = std::min(last, std::max(atZero, atLow));
    }
    if (!(first < last))
    {
      return 0.0;
    }
    const Vector3 from = Lerp(p, q, first);
    const Vector3 to = Lerp(p, q, last);
    return (0.5 * (from[1] + to[1]) + this->Lengths[1]) * (to[2] - from[2]);
  }

  std::array<int, 3> Axes{};
  int Dimension = 3;
  Vector3 Corner{};
  Vector3 Signs{};
  Vector3 Lengths{};
  bool IsMirrored = false;
  double OfVolume = 0.0;
  double OfArea = 0.0;
  double OfLength = 0.0;
};

}

#endif
