// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_Intersection_ProjectedTriangle_h
#define skd_Geometry_Intersection_ProjectedTriangle_h

#include "../Predicates/Orient3D.h"

#include <array>
#include <cmath>

namespace skd
{

/// A triangle to be tested for contacts: corners, and its projection along an axis.
struct ProjectedTriangle
{
  std::array<Vector3, 3> Corners;
  int Axis; ///< along which it has an area; -1 of a triangle whose corners lie on one line

  explicit ProjectedTriangle(const std::array<Vector3, 3>& corners)
    : ProjectedTriangle(corners, FindAxis(corners))
  {
  }
  ProjectedTriangle(const std::array<Vector3, 3>& corners, int axis)
    : Corners(corners)
    , Axis(axis)
  {
  }

  const Vector3& operator[](int corner) const { return this->Corners[corner]; }

  /// The axis along which the area is largest, within rounding error; -1 if there is none along
  /// any, exactly.
  static int FindAxis(const std::array<Vector3, 3>& corners)
  {
    const int first = LargestAxis(Cross(corners[1] - corners[0], corners[2] - corners[0]));
    for (const int axis : { first, (first + 1) % 3, (first + 2) % 3 })
    {
      if (Orient2D(corners[0], corners[1], corners[2], axis) != 0)
      {
        return axis;
      }
    }
    return -1;
  }
};

/// A triangle to be tested for contacts with many others: corners, and the plane through them.
struct TriangleInPlane
{
  std::array<Vector3, 3> Corners;
  FloatingPlane Plane;

  explicit TriangleInPlane(const std::array<Vector3, 3>& corners)
    : Corners(corners)
    , Plane(corners[0], corners[1], corners[2])
  {
  }
};

}

#endif
