// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The nearest point of a polygon and its mean value coordinates. The polygon is flat, or taken for
/// flat: its plane goes through the mean of its points, across Newell's normal. It may be concave;
/// its inside is what an odd number of turns goes around. One of no area is its edges.
///
/// `Points` is whatever gives point i as points[i]: an array, or a face of a polyhedron.
#ifndef skd_Geometry_Polygons_PlanarPolygon_h
#define skd_Geometry_Polygons_PlanarPolygon_h

#include "../Distance/ClosestPointOnSegment.h"
#include "PolygonPlane.h"

#include <algorithm>
#include <limits>

namespace skd
{

/// Point is in the plane if IsInner, else (1 - R) points[Edge] + R points[Edge + 1].
struct PolygonPoint
{
  Vector3 Point;
  double Dist2;
  int Edge;
  double R;
  bool IsInner;
};

template <class Points>
PolygonPoint ClosestPointOnPolygonEdges(const Points& points, int size, const Vector3& x)
{
  PolygonPoint nearest{ points[0], std::numeric_limits<double>::infinity(), 0, 0.0, false };
  for (int i = 0; i < size; ++i)
  {
    const SegmentPoint<3> edge = ClosestPointOnSegment(points[i], points[(i + 1) % size], x);
    if (edge.Dist2 < nearest.Dist2)
    {
      nearest = { edge.Point, edge.Dist2, i, edge.R, false };
    }
  }
  return nearest;
}

/// Any finite points, at least one.
template <class Points>
PolygonPoint ClosestPointOnPolygon(const Points& points, int size, const Vector3& x)
{
  const PolygonPlane plane(points, size);
  const Vector3 across = plane.Height(x) * plane.Normal;
  const Vector3 foot = x - across;
  const bool isInner = IsFinite(foot) && IsInPolygonAlong(points, size, foot, plane.DominantAxis());
  if (isInner && !plane.IsUncertain)
  {
    return { foot, Norm2(across), 0, 0.0, true };
  }
  const PolygonPoint edge = ClosestPointOnPolygonEdges(points, size, x);
  const bool isFootNearer = isInner && Norm2(across) < edge.Dist2;
  return isFootNearer ? PolygonPoint{ foot, Norm2(across), 0, 0.0, true } : edge;
}

namespace detail
{

/// tan(angle / 2) of the angle from a to b about the origin, in the plane across a unit normal.
inline double HalfTangent(const Vector3& a, const Vector3& b, const Vector3& normal)
{
  const double lengths = Norm(a) * Norm(b);
  const double cosine = Dot(a, b);
  const double sine = Dot(normal, Cross(a, b));
  return cosine >= 0.0 ? sine / (lengths + cosine) : (lengths - cosine) / sine;
}

inline Vector3 Flattened(const Vector3& a, const Vector3& normal)
{
  return a - Dot(a, normal) * normal;
}

}

/// The mean value coordinates of x, a point of the polygon, that is not on an edge: M. S. Floater,
/// "Mean value coordinates", Computer Aided Geometric Design 20 (2003) 19-27. They sum to 1 and
/// give x exactly. False, and no weights, where there are none.
template <class Points>
bool MeanValueWeights(const Points& points, int size, const Vector3& x, double* weights)
{
  const PolygonPlane plane(points, size);
  const Vector3 normal = (1.0 / Norm(plane.Normal)) * plane.Normal;
  const auto flattened = [&](int i) { return detail::Flattened(points[i] - x, normal); };
  double sum = 0.0;
  Vector3 at = flattened(0);
  double before = detail::HalfTangent(flattened(size - 1), at, normal);
  for (int i = 0; i < size; ++i)
  {
    const Vector3 next = flattened((i + 1) % size);
    const double after = detail::HalfTangent(at, next, normal);
    weights[i] = (before + after) / Norm(at);
    sum += weights[i];
    before = after;
    at = next;
  }
  if (!(std::abs(sum) > 0.0) || !std::isfinite(sum))
  {
    return false;
  }
  std::for_each(weights, weights + size, [sum](double& weight) { weight /= sum; });
  return true;
}

}

#endif
