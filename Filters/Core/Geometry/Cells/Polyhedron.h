// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A polyhedron as triangles, and which points it holds.
///
/// A face is the fan of triangles around the mean of its points, so that the two cells of a warped
/// face have the same; one of three points is that triangle.
#ifndef skd_Geometry_Cells_Polyhedron_h
#define skd_Geometry_Cells_Polyhedron_h

#include "../Intersection/SegmentTriangle.h"
#include "../Polygons/PolygonPlane.h"
#include "PolyhedronView.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace skd
{

/// A triangle of a face: corners by their index in the face, Middle for the mean of its points.
struct FaceTriangle
{
  static constexpr int Middle = -1;
  Vector3 Points[3];
  int Corners[3];
};

/// Calls visit(triangle), each the same whichever way around the face is, but for its own way.
template <class Visit>
void ForEachTriangle(const PolyhedronFace& face, Visit visit)
{
  if (face.Size == 3)
  {
    visit(FaceTriangle{ { face[0], face[1], face[2] }, { 0, 1, 2 } });
    return;
  }
  const Vector3 middle = MeanOfPoints(face, face.Size);
  for (int i = 0; i < face.Size; ++i)
  {
    const int next = i + 1 == face.Size ? 0 : i + 1;
    visit(FaceTriangle{ { middle, face[i], face[next] }, { FaceTriangle::Middle, i, next } });
  }
}

/// The same for both cells of the face: the last two corners in lexicographic order.
inline FaceTriangle Ordered(FaceTriangle triangle)
{
  if (triangle.Points[2] < triangle.Points[1])
  {
    std::swap(triangle.Points[1], triangle.Points[2]);
    std::swap(triangle.Corners[1], triangle.Corners[2]);
  }
  return triangle;
}

/// False when the face is aside of the segment altogether.
inline bool MayCross(const SegmentView& view, const PolyhedronFace& face)
{
  int left = 0, right = 0, below = 0, above = 0;
  for (int i = 0; i < face.Size; ++i)
  {
    const Sheared sheared = view.See(face[i]);
    left += sheared.X < 0.0;
    right += sheared.X > 0.0;
    below += sheared.Y < 0.0;
    above += sheared.Y > 0.0;
  }
  return std::max({ left, right, below, above }) < face.Size;
}

namespace detail
{

/// From x out of the box to the nearest of its sides.
inline Segment<3> SegmentOutOf(const Box3& box, const Vector3& x)
{
  Segment<3> ray{ x, x };
  double least = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis)
  {
    const double down = x[axis] - box.Min[axis];
    const double up = box.Max[axis] - x[axis];
    if (std::min(down, up) < least)
    {
      least = std::min(down, up);
      ray.B = x;
      ray.B[axis] = down < up ? box.Min[axis] - box.Length(axis) : box.Max[axis] + box.Length(axis);
    }
  }
  return ray;
}

}

/// Whether x is inside: by the parity of exact crossings, so faces may be oriented either way.
/// Points within rounding of a face may count as either.
inline bool Contains(const PolyhedronView& cell, const Box3& bounds, const Vector3& x)
{
  if (!bounds.Contains(x))
  {
    return false;
  }
  const SegmentView view(detail::SegmentOutOf(bounds, x));
  bool isInside = false;
  cell.ForEachFace(
    [&](const PolyhedronFace& face)
    {
      if (!view.IsValid() || !MayCross(view, face))
      {
        return;
      }
      ForEachTriangle(face,
        [&](const FaceTriangle& t)
        {
          const auto hit = Intersect(view, t.Points[0], t.Points[1], t.Points[2]);
          isInside ^= hit && hit->Passes;
        });
    });
  return isInside;
}

}

#endif
