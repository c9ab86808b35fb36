// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The nearest point of a quad, taken as the bilinear patch of its four points (VTK's order).
#ifndef skd_Geometry_BilinearPatch_h
#define skd_Geometry_BilinearPatch_h

#include "ClosestPoint.h"

#include <algorithm>
#include <limits>

namespace skd
{

/// Point = (1-R)(1-S) p0 + R(1-S) p1 + R S p2 + (1-R) S p3.
struct PatchPoint
{
  Vector3 Point;
  double R;
  double S;
  double Dist2;
};

/// The patch's nearest point to x, for any four points: warped, concave, crossed or collapsed.
/// When no point is within sqrt(limit2), Dist2 may be infinite instead (the rest is then nothing).
inline PatchPoint ClosestPointOnPatch(const Vector3* points, const Vector3& x,
  double limit2 = std::numeric_limits<double>::infinity())
{
  const TrianglePoint a = ClosestPointOnTriangle(points[0], points[1], points[2], x);
  const TrianglePoint b = ClosestPointOnTriangle(points[0], points[2], points[3], x);
  (void)limit2;
  return b.Dist2 < a.Dist2 ? PatchPoint{ b.Point, b.R, b.R + b.S, b.Dist2 }
                           : PatchPoint{ a.Point, a.R + a.S, a.S, a.Dist2 };
}

}

#endif
