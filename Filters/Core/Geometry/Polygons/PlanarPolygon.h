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
#include "../Predicates/Sign.h"

#include <algorithm>

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

  int DominantAxis() const
  {
    int axis = std::abs(this->Normal[1]) > std::abs(this->Normal[0]) ? 1 : 0;
    return std::abs(this->Normal[2]) > std::abs(this->Normal[axis]) ? 2 : axis;
  }
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
