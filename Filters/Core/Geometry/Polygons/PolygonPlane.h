// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The plane of a polygon, and what is inside of it there (PlanarPolygon.h says which polygons).
#ifndef skd_Geometry_Polygons_PolygonPlane_h
#define skd_Geometry_Polygons_PolygonPlane_h

#include "../Predicates/Sign.h"
#include "../Vector.h"

#include <algorithm>

namespace skd
{

/// The mean of the points, the same to the last bit for the reverse order (with the same first).
template <class Points>
Vector3 MeanOfPoints(const Points& points, int size)
{
  const Vector3 first = points[0];
  Vector3 sum{ { 0.0, 0.0, 0.0 } };
  for (int i = 1; 2 * i <= size; ++i)
  {
    const Vector3 one = points[i] - first;
    sum = sum + (2 * i == size ? one : one + (points[size - i] - first));
  }
  return first + (1.0 / size) * sum;
}

/// The plane of a polygon.
struct PolygonPlane
{
  Vector3 Origin;
  Vector3 Normal;   ///< as long as twice the area
  bool IsUncertain; ///< the polygon is thin: rounding may have changed the normal

  template <class Points>
  PolygonPlane(const Points& points, int size)
    : Origin(MeanOfPoints(points, size))
    , Normal{ { 0.0, 0.0, 0.0 } }
  {
    double size2 = 0.0;
    Vector3 last = points[size - 1] - this->Origin;
    for (int i = 0; i < size; ++i)
    {
      const Vector3 next = points[i] - this->Origin;
      this->Normal = this->Normal + Cross(last, next);
      size2 = std::max(size2, Norm2(next));
      last = next;
    }
    this->IsUncertain = !(Norm2(this->Normal) * 4096.0 > size2 * size2);
  }

  /// By how many normals x is above the plane: NaN or infinite if there is no plane.
  double Height(const Vector3& x) const
  {
    return Dot(this->Normal, x - this->Origin) / Norm2(this->Normal);
  }

  int DominantAxis() const { return LargestAxis(this->Normal); }
};

/// Whether x is inside the polygon, both seen along an axis. Signs are exact; the boundary is in.
template <class Points>
bool IsInPolygonAlong(const Points& points, int size, const Vector3& x, int axis)
{
  const int axisX = (axis + 1) % 3;
  const int axisY = (axis + 2) % 3;
  bool isInside = false;
  Vector3 p = points[size - 1] - x;
  for (int i = 0; i < size; ++i)
  {
    const Vector3 q = points[i] - x;
    if ((p[axisY] > 0.0) != (q[axisY] > 0.0))
    {
      const int side = SignOfDifference(p[axisX], q[axisY], p[axisY], q[axisX]);
      if (side == 0)
      {
        return true;
      }
      isInside ^= (side > 0) == (q[axisY] > p[axisY]);
    }
    p = q;
  }
  return isInside;
}

}

#endif
