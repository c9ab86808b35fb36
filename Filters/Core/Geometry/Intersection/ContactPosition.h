// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Where edges cross, to a few units in the last place of the coordinates: the parameter comes from
/// exact areas and volumes, so it is as good for slivers and grazing edges as for any other. A
/// coordinate that all points of what is crossed have is that of the crossing, without rounding.
#ifndef skd_Geometry_Intersection_ContactPosition_h
#define skd_Geometry_Intersection_ContactPosition_h

#include "../Predicates/Orient3D.h"
#include "../Segment.h"

namespace skd
{

/// Where an edge that has its ends on different sides of the plane of a, b, c crosses it.
inline Vector3 CrossingWithPlane(
  const Segment<3>& edge, const Vector3& a, const Vector3& b, const Vector3& c)
{
  const AccuratePlane plane(a, b, c);
  const double start = plane.VolumeTo(edge.A);
  const double end = plane.VolumeTo(edge.B);
  Vector3 x = edge.At(start / (start - end));
  for (int axis = 0; axis < 3; ++axis)
  {
    x[axis] = a[axis] == b[axis] && b[axis] == c[axis] ? a[axis] : x[axis];
  }
  return x;
}

/// Where an edge crosses another in a point that is inside of both, exactly.
inline Vector3 CrossingWithEdge(const Segment<3>& edge, const Segment<3>& other)
{
  const int first = LargestAxis(Cross(edge.B - edge.A, other.B - other.A));
  for (const int axis : { first, (first + 1) % 3, (first + 2) % 3 })
  {
    const double start = AreaOf(other.A, other.B, edge.A, axis);
    const double end = AreaOf(other.A, other.B, edge.B, axis);
    if ((start > 0.0 && end < 0.0) || (start < 0.0 && end > 0.0)) // not seen edge-on
    {
      Vector3 x = edge.At(start / (start - end));
      for (int i = 0; i < 3; ++i)
      {
        x[i] = other.A[i] == other.B[i] ? other.A[i] : x[i];
      }
      return x;
    }
  }
  return edge.A;
}

}

#endif
