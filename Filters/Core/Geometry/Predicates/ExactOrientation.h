// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Exact signs of determinants of coordinates: the side of a plane on which a point lies, the
/// orientation of two lines. See Orient3D.h for the range of coordinates.
#ifndef skd_Predicates_ExactOrientation_h
#define skd_Predicates_ExactOrientation_h

#include "../Tolerances.h"
#include "Orient3D.h"

namespace skd
{

/// The sign of (a - d) . ((b - d) x (c - d)): positive where a, b, c turn clockwise seen from d.
inline int Orientation(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d)
{
  return -Orient3D(a, b, c, d);
}

/// The sign of component `axis` of (b - a) x (d - c).
inline int SignOfCross(
  const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d, int axis)
{
  const int j = (axis + 1) % 3;
  const int k = (axis + 2) % 3;
  const double left = (b[j] - a[j]) * (d[k] - c[k]);
  const double right = (b[k] - a[k]) * (d[j] - c[j]);
  if (std::abs(left - right) > tolerances::CrossProduct * (std::abs(left) + std::abs(right)))
  {
    return left > right ? 1 : -1;
  }
  using Difference = Expansion<2>;
  const auto exactLeft = Difference::Difference(b[j], a[j]) * Difference::Difference(d[k], c[k]);
  const auto exactRight = Difference::Difference(b[k], a[k]) * Difference::Difference(d[j], c[j]);
  return (exactLeft - exactRight).Sign();
}

/// The sign of ((b - a) x (d - c)) . (e, e^2, e^3) for any e > 0 that is small enough: 0 only when
/// the two directions are parallel.
inline int SignOfCrossAlongMove(
  const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (const int sign = SignOfCross(a, b, c, d, axis))
    {
      return sign;
    }
  }
  return 0;
}

}

#endif
