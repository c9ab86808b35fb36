// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The unit sphere seen from its centre on the plane that touches it at a point (the gnomonic
/// projection): arcs of great circles are straight there, so convex polygons are cut as those of a
/// plane are. Areas and moments are by edge integrals on the sphere itself.
#ifndef skd_Geometry_Overlap_SphericalFrame_h
#define skd_Geometry_Overlap_SphericalFrame_h

#include "ConvexClip.h"
#include "Moments.h"

#include <cmath>

namespace skd
{

namespace detail
{

/// angle / sin(angle) - 1, given sine and cosine: to rounding, also of small angles. These by
/// Taylor's series of arcsin(s) / s - 1 in s^2.
inline double ArcExcess(double sine2, double cosine)
{
  constexpr double small = 1e-3; // the series' next term, 231/13312 s^12, is below a rounding
  if (sine2 < small && cosine > 0.0)
  {
    return sine2 *
      (1.0 / 6.0 +
        sine2 *
          (3.0 / 40.0 + sine2 * (5.0 / 112.0 + sine2 * (35.0 / 1152.0 + sine2 * (63.0 / 2816.0)))));
  }
  const double sine = std::sqrt(sine2);
  return std::atan2(sine, cosine) / sine - 1.0;
}

/// 2 atan2(y, x), x mostly positive: of small angles by Taylor's series of the arctangent, which
/// costs a fraction of a call.
inline double TwiceAngle(double y, double x)
{
  constexpr double small = 0.02; // the series' next term, t^13/13, is below a rounding
  const double t = y / x;
  if (x > 0.0 && std::abs(t) < small)
  {
    const double t2 = t * t;
    return 2.0 * t *
      (1.0 - t2 * (1.0 / 3.0 - t2 * (0.2 - t2 * (1.0 / 7.0 - t2 * (1.0 / 9.0 - t2 / 11.0)))));
  }
  return 2.0 * std::atan2(y, x);
}

}

/// Of a convex polygon on the touching plane, the area on the unit sphere, and the integral of
/// x - (the touching point), in the axes of the frame. With n the touching point and a, b the ends
/// of an edge, both in turn,
///   area = sum of the signed triangles n a b (Van Oosterom, Strackee, IEEE TBME 1983),
///     tan(triangle / 2) = det(n, a, b) / (|a||b| + |a| + |b| + a . b),
///   integral of x = sum of angle(a, b) / 2 times the unit normal of a, b (Stokes' theorem),
///     which is (1/2 + share) a x b with
///     1/2 + share = angle / (2 sin(angle) |a||b|), since |a x b| = sin(angle) |a||b|.
/// With a and b as they are on the plane, (a, 1) and (b, 1), a x b is (-edge[1], edge[0], cross).
/// Around the polygon the edges sum to 0, so 1/2 is left out of the first two components, and
/// share is of the order of the polygon's size squared: small polygons lose no digits.
inline Moments SphericalMoments(const ConvexPolygon& polygon)
{
  std::array<double, ConvexPolygon::Most> norm2;
  std::array<double, ConvexPolygon::Most> norm;
  for (int i = 0; i < polygon.Size; ++i)
  {
    norm2[i] = Norm2(polygon.Corners[i]);
    norm[i] = std::sqrt(1.0 + norm2[i]);
  }
  Moments sum;
  for (int i = 0; i < polygon.Size; ++i)
  {
    const int next = i + 1 == polygon.Size ? 0 : i + 1;
    const Vector<2>& a = polygon.Corners[i];
    const Vector<2>& b = polygon.Corners[next];
    const double cross = a[0] * b[1] - a[1] * b[0];
    const double dot = a[0] * b[0] + a[1] * b[1];
    const double excess = detail::TwiceAngle(cross, (1.0 + norm[i]) * (1.0 + norm[next]) + dot);
    const Vector<2> edge = b - a;
    const double norms = norm[i] * norm[next];
    const double more = norm2[i] + norm2[next] + norm2[i] * norm2[next]; // norms^2 - 1
    const double sine2 = (Norm2(edge) + cross * cross) / (1.0 + more);
    const double excessOfArc = detail::ArcExcess(sine2, (1.0 + dot) / norms);
    const double share = 0.5 * (excessOfArc - more / (norms + 1.0)) / norms;
    sum.Measure += excess;
    sum.First =
      sum.First + Vector3{ { -share * edge[1], share * edge[0], (0.5 + share) * cross - excess } };
  }
  return sum;
}

/// The frame of a point of the unit sphere.
struct SphericalFrame
{
  Vector3 Origin;
  Vector3 E1;
  Vector3 E2;

  /// Axes without a branch: Duff et al., JCGT 2017.
  explicit SphericalFrame(const Vector3& n)
    : Origin(n)
  {
    const double sign = std::copysign(1.0, n[2]);
    const double a = -1.0 / (sign + n[2]);
    const double b = n[0] * n[1] * a;
    this->E1 = { { 1.0 + sign * n[0] * n[0] * a, sign * b, -sign * n[0] } };
    this->E2 = { { b, sign + n[1] * n[1] * a, -n[1] } };
  }

  /// Homogeneous; w is positive before the sphere's centre. Of differences: near points keep their
  /// digits.
  Vector3 Projected(const Vector3& x) const
  {
    const Vector3 offset = x - this->Origin;
    return { { Dot(offset, this->E1), Dot(offset, this->E2), 1.0 + Dot(offset, this->Origin) } };
  }

  /// A direction, or a moment, in the axes of the world.
  Vector3 Rotated(const Vector3& v) const
  {
    return v[0] * this->E1 + (v[1] * this->E2 + v[2] * this->Origin);
  }

  Vector3 FromFrame(const Vector<2>& x) const
  {
    const Vector3 direction = this->Origin + (x[0] * this->E1 + x[1] * this->E2);
    return (1.0 / Norm(direction)) * direction;
  }

  skd::Moments Moments(const ConvexPolygon& polygon) const
  {
    skd::Moments moments = SphericalMoments(polygon);
    moments.First = this->Rotated(moments.First);
    return moments;
  }
};

}

#endif
