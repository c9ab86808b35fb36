// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_Distance_ClosestTriangles_h
#define skd_Geometry_Distance_ClosestTriangles_h

#include "ClosestPointOnTriangle.h"
#include "ClosestSegments.h"

#include <array>

namespace skd
{

/// The points where two triangles come nearest.
struct NearestPoints
{
  Vector3 First;
  Vector3 Second;
  double Dist2;
};

/// Of triangles that do not touch: nearest are a corner of one and a point of the other, or points
/// of two edges. (Triangles that touch may cross without either; their distance is 0.)
inline NearestPoints ClosestPoints(
  const std::array<Vector3, 3>& first, const std::array<Vector3, 3>& second)
{
  NearestPoints nearest{ first[0], second[0], Distance2(first[0], second[0]) };
  const auto keep = [&nearest](const Vector3& a, const Vector3& b, double dist2)
  {
    if (dist2 < nearest.Dist2)
    {
      nearest = { a, b, dist2 };
    }
  };
  for (int i = 0; i < 3; ++i)
  {
    const TrianglePoint b = ClosestPointOnTriangle(second[0], second[1], second[2], first[i]);
    keep(first[i], b.Point, b.Dist2);
    const TrianglePoint a = ClosestPointOnTriangle(first[0], first[1], first[2], second[i]);
    keep(a.Point, second[i], a.Dist2);
    for (int k = 0; k < 3; ++k)
    {
      const Segment<3> edge{ first[i], first[(i + 1) % 3] };
      const Segment<3> other{ second[k], second[(k + 1) % 3] };
      const SegmentPair pair = ClosestPoints(edge, other);
      keep(edge.At(pair.T), other.At(pair.R), pair.Dist2);
    }
  }
  return nearest;
}

}

#endif
