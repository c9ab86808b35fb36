// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_Overlap_PlanarOverlap_h
#define skd_Geometry_Overlap_PlanarOverlap_h

#include "ConvexClip.h"
#include "Moments.h"

namespace skd
{

/// The area and first moment of a polygon about the origin of its frame; the third coordinate is 0.
inline Moments PlanarMoments(const ConvexPolygon& polygon)
{
  const Vector<2> first = polygon.Size > 0 ? polygon.Corners[0] : Vector<2>{ { 0.0, 0.0 } };
  double twice = 0.0;
  Vector<2> sixfold{ { 0.0, 0.0 } };
  for (int i = 2; i < polygon.Size; ++i)
  {
    const Vector<2> a = polygon.Corners[i - 1] - first;
    const Vector<2> b = polygon.Corners[i] - first;
    const double cross = a[0] * b[1] - a[1] * b[0];
    twice += cross;
    sixfold = sixfold + cross * (a + b);
  }
  const double area = 0.5 * twice;
  return { area,
    { { sixfold[0] / 6.0 + area * first[0], sixfold[1] / 6.0 + area * first[1], 0.0 } } };
}

/// Convex polygons of the plane z = 0, corners (x, y, 1) less an origin: a frame of homogeneous
/// points, as that of a sphere is (SphericalFrame).
struct PlanarFrame
{
  Vector3 Origin;

  explicit PlanarFrame(const Vector3& origin)
    : Origin(origin)
  {
  }

  Vector3 Projected(const Vector3& x) const
  {
    return { { x[0] - this->Origin[0], x[1] - this->Origin[1], 1.0 } };
  }
  Vector3 FromFrame(const Vector<2>& x) const
  {
    return { { x[0] + this->Origin[0], x[1] + this->Origin[1], this->Origin[2] } };
  }
  static skd::Moments Moments(const ConvexPolygon& polygon) { return PlanarMoments(polygon); }
};

}

#endif
