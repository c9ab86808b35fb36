// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Whether a box and a segment, a triangle or a flat polygon have a point in common, by separating
/// axes (S. Gottschalk, M. Lin, D. Manocha, "OBBTree", SIGGRAPH 1996).
///
/// Closed: touching counts. An axis separates only if it does by more than what rounding can make
/// of the numbers on it, some units in the last place; so nothing that touches is ever missed, at
/// any scale, and where coordinates are such that nothing is rounded (small integers, say) the
/// answer is exact. Points that are not finite give no meaningful answer. O(1), or O(points of the
/// polygon).
#ifndef skd_Geometry_Intersection_BoxOverlap_h
#define skd_Geometry_Intersection_BoxOverlap_h

#include "../Box.h"
#include "../Polygons/PolygonPlane.h"
#include "../Segment.h"
#include "../Tolerances.h"

namespace skd
{
namespace detail
{

/// A box seen from a point, and scaled by a power of two where products might leave the range of
/// double: differences of the same points are scaled alike.
struct RelativeBox
{
  Vector3 Min;
  Vector3 Max;
  double Scale = 1.0;

  /// `size`: the largest magnitude among the other differences that will be scaled.
  RelativeBox(const Box3& box, const Vector3& from, double size)
    : Min(box.Min - from)
    , Max(box.Max - from)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      size = std::max({ size, std::abs(this->Min[axis]), std::abs(this->Max[axis]) });
    }
    if (!(size > tolerances::LeastFactor && size < tolerances::LargestFactor) && size > 0.0 &&
      std::isfinite(size))
    {
      int exponent;
      std::frexp(size, &exponent);
      this->Scale = std::ldexp(1.0, -std::clamp(exponent, -1000, 1000));
      this->Min = this->Scale * this->Min;
      this->Max = this->Scale * this->Max;
    }
  }
};

inline double LargestOf(const Vector3& a)
{
  return std::max({ std::abs(a[0]), std::abs(a[1]), std::abs(a[2]) });
}

/// Whether the box is aside of what extends from `low` to `high` along an axis (0 is among that:
/// the point that the box is seen from).
inline bool IsAside(
  const RelativeBox& box, const Vector3& axis, double low, double high, double size)
{
  double boxLow = 0.0;
  double boxHigh = 0.0;
  double rounding = size;
  for (int i = 0; i < 3; ++i)
  {
    const double a = axis[i] * box.Min[i];
    const double b = axis[i] * box.Max[i];
    boxLow += std::min(a, b);
    boxHigh += std::max(a, b);
    rounding += std::max(std::abs(a), std::abs(b));
  }
  rounding *= 16.0 * std::numeric_limits<double>::epsilon();
  return boxLow > high + rounding || boxHigh < low - rounding;
}

/// The axis across an edge and a coordinate axis.
inline Vector3 Across(const Vector3& edge, int axis)
{
  Vector3 across{ { 0.0, 0.0, 0.0 } };
  across[(axis + 1) % 3] = -edge[(axis + 2) % 3];
  across[(axis + 2) % 3] = edge[(axis + 1) % 3];
  return across;
}

/// Whether the three axes across an edge separate the box from the edge and the points edge + rest.
inline bool EdgeSeparates(const RelativeBox& box, const Vector3& edge, const Vector3& rest)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const Vector3 across = Across(edge, axis);
    double at = 0.0;
    double size = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      at += across[i] * rest[i];
      size += std::abs(across[i] * rest[i]);
    }
    if (IsAside(box, across, std::min(at, 0.0), std::max(at, 0.0), size))
    {
      return true;
    }
  }
  return false;
}

inline bool NormalSeparates(const RelativeBox& box, const Vector3& u, const Vector3& v)
{
  // A component of the normal is a difference of two products, that may all but cancel.
  const Vector3 normal = Cross(u, v);
  double size = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    const double extent = std::max(std::abs(box.Min[i]), std::abs(box.Max[i]));
    size += extent * (std::abs(u[j] * v[k]) + std::abs(u[k] * v[j]));
  }
  return IsAside(box, normal, 0.0, 0.0, size);
}

}

inline bool Overlaps(const Box3& box, const Segment<3>& segment)
{
  Box3 bounds(segment.A, segment.A);
  bounds.Add(segment.B);
  if (!box.Overlaps(bounds))
  {
    return false;
  }
  const Vector3 edge = segment.B - segment.A;
  const detail::RelativeBox relative(box, segment.A, detail::LargestOf(edge));
  return !detail::EdgeSeparates(relative, relative.Scale * edge, { { 0.0, 0.0, 0.0 } });
}

/// The triangle may have no area: it is a segment then, or a point.
inline bool Overlaps(const Box3& box, const Vector3& a, const Vector3& b, const Vector3& c)
{
  Box3 bounds(a, a);
  bounds.Add(b);
  bounds.Add(c);
  if (!box.Overlaps(bounds))
  {
    return false;
  }
  if (box.Contains(a) || box.Contains(b) || box.Contains(c))
  {
    return true;
  }
  const double size = std::max(detail::LargestOf(b - a), detail::LargestOf(c - a));
  const detail::RelativeBox fromA(box, a, size);
  const Vector3 u = fromA.Scale * (b - a);
  const Vector3 v = fromA.Scale * (c - a);
  if (detail::NormalSeparates(fromA, u, v) || detail::EdgeSeparates(fromA, u, v) ||
    detail::EdgeSeparates(fromA, v, u))
  {
    return false;
  }
  const detail::RelativeBox fromB(box, b, size);
  return !detail::EdgeSeparates(fromB, fromB.Scale * (c - b), fromB.Scale * (a - b));
}

namespace detail
{

/// A point of the plane in the box, if the plane comes within `tolerance` of the box.
inline std::optional<Vector3> PointInPlane(
  const Box3& box, const PolygonPlane& plane, double tolerance)
{
  Vector3 below;
  Vector3 above;
  for (int axis = 0; axis < 3; ++axis)
  {
    const bool isUp = plane.Normal[axis] > 0.0;
    below[axis] = isUp ? box.Min[axis] : box.Max[axis];
    above[axis] = isUp ? box.Max[axis] : box.Min[axis];
  }
  const double length = Norm(plane.Normal);
  const double low = plane.Height(below) * length;
  const double high = plane.Height(above) * length;
  if (!(low <= tolerance && high >= -tolerance))
  {
    return std::nullopt;
  }
  return high > low ? Lerp(below, above, std::clamp(-low / (high - low), 0.0, 1.0)) : below;
}

}

/// Of a polygon taken for flat (PlanarPolygon.h), which may be concave. Either the box meets an
/// edge, or what it cuts out of the plane is inside of the polygon altogether, or outside.
template <class Points>
bool OverlapsPolygon(const Box3& box, const Points& points, int size)
{
  Box3 bounds;
  for (int i = 0; i < size; ++i)
  {
    const Segment<3> edge{ points[i], points[i + 1 == size ? 0 : i + 1] };
    if (Overlaps(box, edge))
    {
      return true;
    }
    bounds.Add(edge.A);
  }
  if (!box.Overlaps(bounds))
  {
    return false;
  }
  const PolygonPlane plane(points, size);
  const double coordinate = std::max(detail::LargestOf(bounds.Min), detail::LargestOf(bounds.Max));
  const double rounding = 16.0 * std::numeric_limits<double>::epsilon() * coordinate;
  const std::optional<Vector3> inPlane = detail::PointInPlane(box, plane, rounding);
  return inPlane && IsInPolygonAlong(points, size, *inPlane, plane.DominantAxis());
}

}

#endif
