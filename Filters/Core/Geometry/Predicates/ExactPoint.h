// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Exact constructed points, which have no floating-point coordinates: intersections of an edge and
/// a plane, or of segments between such points. Used where a filter cannot decide.
#ifndef skd_Predicates_ExactPoint_h
#define skd_Predicates_ExactPoint_h

#include "../Vector.h"
#include "BigNumber.h"

#include <array>
#include <limits>

namespace skd
{

/// The point X / W, W > 0.
struct ExactPoint
{
  std::array<BigNumber, 3> X;
  BigNumber W;

  explicit ExactPoint(const Vector3& x)
    : X{ { BigNumber(x[0]), BigNumber(x[1]), BigNumber(x[2]) } }
    , W(1.0)
  {
  }

  /// Where the line through p and q has a value of 0, if it has atP and atQ (times the W of each)
  /// at these: numbers that differ.
  ExactPoint(const ExactPoint& p, const BigNumber& atP, const ExactPoint& q, const BigNumber& atQ)
    : W(p.W * atQ - q.W * atP)
  {
    const bool isNegated = this->W.Sign() < 0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const BigNumber x = p.X[axis] * atQ - q.X[axis] * atP;
      this->X[axis] = isNegated ? -x : x;
    }
    this->W = isNegated ? -this->W : this->W;
  }

  /// To a few units in the last place of each coordinate.
  Vector3 Rounded() const
  {
    return { { BigNumber::Ratio(this->X[0], this->W), BigNumber::Ratio(this->X[1], this->W),
      BigNumber::Ratio(this->X[2], this->W) } };
  }
};

/// Twice the area of a, b, c as seen along an axis (as Orient2D has its sign), times the W of each.
inline BigNumber ExactArea(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c, int axis)
{
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  const auto minor = [&](const ExactPoint& p, const ExactPoint& q)
  { return p.X[u] * q.X[v] - p.X[v] * q.X[u]; };
  return a.W * minor(b, c) + b.W * minor(c, a) + c.W * minor(a, b);
}

/// (b - a) x (c - a) . (d - a), of points as they are.
inline BigNumber ExactVolume(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d)
{
  using Triple = std::array<BigNumber, 3>;
  const auto from = [&](const Vector3& p)
  {
    Triple difference;
    for (int axis = 0; axis < 3; ++axis)
    {
      difference[axis] = BigNumber(p[axis]) - BigNumber(a[axis]);
    }
    return difference;
  };
  const Triple x = from(b);
  const Triple y = from(c);
  const Triple z = from(d);
  return z[0] * (x[1] * y[2] - x[2] * y[1]) + z[1] * (x[2] * y[0] - x[0] * y[2]) +
    z[2] * (x[0] * y[1] - x[1] * y[0]);
}

/// Where the edge from p to q, whose ends are on different sides, crosses the plane of a, b, c.
inline ExactPoint ExactCrossingWithPlane(
  const Vector3& p, const Vector3& q, const Vector3& a, const Vector3& b, const Vector3& c)
{
  return { ExactPoint(p), ExactVolume(a, b, c, p), ExactPoint(q), ExactVolume(a, b, c, q) };
}

/// Where the line through p and q crosses that through r and s, of the same plane, which are not
/// parallel as seen along the axis.
inline ExactPoint ExactCrossing(
  const ExactPoint& p, const ExactPoint& q, const ExactPoint& r, const ExactPoint& s, int axis)
{
  return { p, ExactArea(r, s, p, axis), q, ExactArea(r, s, q, axis) };
}

/// Where two edges cross in a point that is inside of both.
inline ExactPoint ExactCrossingOfEdges(
  const Vector3& p, const Vector3& q, const Vector3& r, const Vector3& s)
{
  ExactPoint start(p);
  const ExactPoint end(q);
  for (int axis = 0; axis < 3; ++axis)
  {
    const BigNumber atStart = ExactArea(ExactPoint(r), ExactPoint(s), start, axis);
    const BigNumber atEnd = ExactArea(ExactPoint(r), ExactPoint(s), end, axis);
    if (atStart.Sign() * atEnd.Sign() < 0) // not seen edge-on
    {
      return { start, atStart, end, atEnd };
    }
  }
  return start;
}

/// The sign of a - b along an axis.
inline int ExactCompare(const ExactPoint& a, const ExactPoint& b, int axis)
{
  return (a.X[axis] * b.W - b.X[axis] * a.W).Sign();
}

/// The sign of the area of a, b, c as seen along an axis, of points known to `error` in each
/// coordinate only; 0: not known.
inline int FilteredOrient2D(
  const Vector3& a, const Vector3& b, const Vector3& c, int axis, double error)
{
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  const double ab[2] = { b[u] - a[u], b[v] - a[v] };
  const double ac[2] = { c[u] - a[u], c[v] - a[v] };
  const double area = ab[0] * ac[1] - ab[1] * ac[0];
  const double sum = std::abs(ab[0]) + std::abs(ab[1]) + std::abs(ac[0]) + std::abs(ac[1]);
  const double bound = 4.0 * error * (sum + 4.0 * error) +
    4.0 * std::numeric_limits<double>::epsilon() *
      (std::abs(ab[0] * ac[1]) + std::abs(ab[1] * ac[0]));
  return std::abs(area) > bound ? (area > 0.0 ? 1 : -1) : 0;
}

}

#endif
