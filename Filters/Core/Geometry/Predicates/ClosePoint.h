// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Constructed points in pairs of doubles, with an error bound: tells points that are on a line but
/// for rounding much faster than exact numbers (ExactPoint.h) do.
#ifndef skd_Predicates_ClosePoint_h
#define skd_Predicates_ClosePoint_h

#include "TripleProduct.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace skd
{

/// A point, each coordinate of which is known to within an error.
struct ClosePoint
{
  /// More than any of the operations here does to its result, relative to the largest term of it.
  static constexpr double Rounding = 0x1p-96;

  /// Below this, low parts may be out of range.
  static constexpr double LeastProduct = 1e-200;

  std::array<DoubleDouble, 3> X;
  double Error; ///< infinite: nothing is known

  explicit ClosePoint(const Vector3& x)
    : X{ { { x[0], 0.0 }, { x[1], 0.0 }, { x[2], 0.0 } } }
    , Error(0.0)
  {
  }
};

inline DoubleDouble operator-(const DoubleDouble& a)
{
  return { -a.High, -a.Low };
}

/// Where the edge from p to q, whose ends are on different sides, crosses the plane of a, b, c.
inline ClosePoint CloseCrossingWithPlane(
  const Vector3& p, const Vector3& q, const Vector3& a, const Vector3& b, const Vector3& c)
{
  std::array<DoubleDouble, 3> u;
  std::array<DoubleDouble, 3> v;
  for (int i = 0; i < 3; ++i)
  {
    u[i] = ExactSum(b[i], -a[i]);
    v[i] = ExactSum(c[i], -a[i]);
  }
  DoubleDouble atP{ 0.0, 0.0 };
  DoubleDouble atQ{ 0.0, 0.0 };
  double most = 0.0; // of all products
  for (int i = 0; i < 3; ++i)
  {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    const DoubleDouble normal = u[j] * v[k] + -(u[k] * v[j]);
    const DoubleDouble ofP = ExactSum(p[i], -a[i]);
    const DoubleDouble ofQ = ExactSum(q[i], -a[i]);
    atP = atP + ofP * normal;
    atQ = atQ + ofQ * normal;
    most += std::max(std::abs(ofP.High), std::abs(ofQ.High)) *
      (std::abs(u[j].High * v[k].High) + std::abs(u[k].High * v[j].High));
  }
  const DoubleDouble whole = atP + -atQ;
  const double doubt = ClosePoint::Rounding * most / std::abs(whole.High);
  ClosePoint at(p);
  if (!(doubt < 1e-3 && most > ClosePoint::LeastProduct && atP.High * whole.High >= 0.0))
  {
    at.Error = std::numeric_limits<double>::infinity();
    return at;
  }
  const double first = atP.High / whole.High;
  const DoubleDouble left = atP + -(first * whole);
  const DoubleDouble along = ExactSum(first, left.High / whole.High);
  for (int i = 0; i < 3; ++i)
  {
    const DoubleDouble edge = ExactSum(q[i], -p[i]);
    at.X[i] = at.X[i] + edge * along;
    at.Error = std::max(at.Error,
      4.0 * (doubt + ClosePoint::Rounding) * std::abs(edge.High) +
        ClosePoint::Rounding * std::abs(p[i]));
  }
  return at;
}

/// The sign of the area of a, b, c as seen along an axis; 0: not known.
inline int CloseOrient2D(const ClosePoint& a, const ClosePoint& b, const ClosePoint& c, int axis)
{
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  const auto from = [&a](const ClosePoint& p, int i) { return p.X[i] + -a.X[i]; };
  const DoubleDouble products[2] = { from(b, u) * from(c, v), from(b, v) * from(c, u) };
  const double largest = std::max({ std::abs(a.X[u].High), std::abs(a.X[v].High),
    std::abs(b.X[u].High), std::abs(b.X[v].High), std::abs(c.X[u].High), std::abs(c.X[v].High) });
  const double error = std::max({ a.Error, b.Error, c.Error }) + ClosePoint::Rounding * largest;
  const double sum = std::abs(from(b, u).High) + std::abs(from(b, v).High) +
    std::abs(from(c, u).High) + std::abs(from(c, v).High);
  const double size = std::abs(products[0].High) + std::abs(products[1].High);
  const double bound = 4.0 * error * (sum + 4.0 * error) + ClosePoint::Rounding * size;
  const double area = (products[0] + -products[1]).High;
  return bound > ClosePoint::LeastProduct && std::abs(area) > bound ? (area > 0.0 ? 1 : -1) : 0;
}

}

#endif
