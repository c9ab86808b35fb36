// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_Measures_SolidAngle_h
#define skd_Geometry_Measures_SolidAngle_h

#include "../Tolerances.h"
#include "../Vector.h"

#include <cmath>

namespace skd
{

/// How a point sees a triangle.
struct TriangleSolidAngle
{
  double Angle;
  bool IsOn; ///< the point is on the triangle within rounding error
};

/// The solid angle under which x sees the triangle, in (-2 pi, 2 pi]: positive where the triangle
/// turns clockwise, that is, from within a surface whose normals point outward. 0 in the plane of
/// the triangle but outside of it, and of a triangle without area. A. van Oosterom, J. Strackee,
/// "The Solid Angle of a Plane Triangle", IEEE Trans. Biomed. Eng. 30 (1983) 125-126.
inline TriangleSolidAngle SeeAngle(
  const Vector3& p0, const Vector3& p1, const Vector3& p2, const Vector3& x)
{
  const Vector3 a = p0 - x;
  const Vector3 b = p1 - x;
  const Vector3 c = p2 - x;
  const double lengthA = Norm(a);
  const double lengthB = Norm(b);
  const double lengthC = Norm(c);
  const double volume = Dot(a, Cross(b, c));
  const double cosine =
    lengthA * lengthB * lengthC + Dot(a, b) * lengthC + Dot(b, c) * lengthA + Dot(c, a) * lengthB;
  const double length = lengthA + lengthB + lengthC;
  const double rounding = tolerances::TripleProduct * length * length * length;
  return { volume == 0.0 ? 0.0 : 2.0 * std::atan2(volume, cosine),
    std::abs(volume) <= rounding && cosine <= rounding };
}

inline double SolidAngle(const Vector3& p0, const Vector3& p1, const Vector3& p2, const Vector3& x)
{
  return SeeAngle(p0, p1, p2, x).Angle;
}

}

#endif
