// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The nearest point of a quad, taken as the bilinear patch of its four points (VTK's order).
///
/// Where the squared distance is certainly convex in (r, s) over the whole patch, which it is for
/// quads that are not badly shaped when x is not far off, its one minimum is walked down to
/// (ConvexPatchMinimum.h). Else every stationary point is found (PatchStationaryPoints.h). The four
/// edges are segments of their own: shared edges give the same answer from all sides.
#ifndef skd_Geometry_Distance_BilinearPatch_h
#define skd_Geometry_Distance_BilinearPatch_h

#include "../Tolerances.h"
#include "ClosestPointOnTriangle.h"
#include "ConvexPatchMinimum.h"
#include "PatchStationaryPoints.h"

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

/// The nearest point of one edge: 0 from p0 to p1, 1 from p1 to p2, 2 from p3 to p2, 3 from p0 to
/// p3.
inline PatchPoint ClosestPointOnPatchEdge(const Vector3* points, int edge, const Vector3& x)
{
  static constexpr int ends[4][2] = { { 0, 1 }, { 1, 2 }, { 3, 2 }, { 0, 3 } };
  const SegmentPoint<3> near =
    ClosestPointOnSegment(points[ends[edge][0]], points[ends[edge][1]], x);
  const bool isAlongR = edge % 2 == 0;
  const double side = edge == 1 || edge == 2 ? 1.0 : 0.0;
  return { near.Point, isAlongR ? near.R : side, isAlongR ? side : near.R, near.Dist2 };
}

/// The patch's point at given parameters: on its edge if it is on one.
inline PatchPoint PatchPointAt(
  const Vector3* points, const PatchView& view, const PatchParameters& at, const Vector3& x)
{
  if (at.S <= 0.0 || at.S >= 1.0)
  {
    return ClosestPointOnPatchEdge(points, at.S <= 0.0 ? 0 : 2, x);
  }
  if (at.R <= 0.0 || at.R >= 1.0)
  {
    return ClosestPointOnPatchEdge(points, at.R <= 0.0 ? 3 : 1, x);
  }
  const Vector3 point = points[0] + at.R * (view.U + at.S * view.W) + at.S * view.V;
  return { point, at.R, at.S, Norm2(view.At(at)) };
}

/// The nearest of the edges and of all points inside where the distance may be least.
inline PatchPoint ClosestOfAllOnPatch(
  const Vector3* points, const PatchView& view, const Vector3& x)
{
  PatchPoint nearest = ClosestPointOnPatchEdge(points, 0, x);
  for (int edge = 1; edge < 4; ++edge)
  {
    const PatchPoint candidate = ClosestPointOnPatchEdge(points, edge, x);
    nearest = candidate.Dist2 < nearest.Dist2 ? candidate : nearest;
  }
  const auto consider = [&](const PatchParameters& start)
  {
    const PatchParameters at = view.Polished(start);
    if (Norm2(view.At(at)) < nearest.Dist2)
    {
      nearest = PatchPointAt(points, view, at, x);
    }
  };
  VisitStationaryPoints(view, consider);
  // Slivers: what the polynomial lost by cancellation, the triangles that they resemble have kept.
  const TrianglePoint low = ClosestPointOnTriangle(points[0], points[1], points[3], x);
  const TrianglePoint high = ClosestPointOnTriangle(points[2], points[3], points[1], x);
  consider({ low.R, low.S });
  consider({ 1.0 - high.R, 1.0 - high.S });
  return nearest;
}

/// The patch's nearest point to x, for any four points: warped, concave, crossed or collapsed.
/// When no point is within sqrt(limit2), Dist2 may be infinite instead (the rest is then nothing).
/// Lengths may range over 1e-50 to 1e50. A NaN gives Dist2 = NaN or infinity.
inline PatchPoint ClosestPointOnPatch(
  const Vector3* points, const Vector3& x, double limit2 = std::numeric_limits<double>::infinity())
{
  const PatchView view(points, x);
  if (view.IsFartherThan(limit2))
  {
    return { points[0], 0.0, 0.0, std::numeric_limits<double>::infinity() };
  }
  const PatchProducts products(view);
  if (products.IsConvex())
  {
    PatchParameters at = products.ConvexMinimum();
    if (Norm2(view.At(at)) < tolerances::OnPatch2 * (products.UU + products.VV))
    {
      at = view.Polished(at); // x is on the patch: to the last digits
    }
    return PatchPointAt(points, view, at, x);
  }
  return ClosestOfAllOnPatch(points, view, x);
}

}

#endif
