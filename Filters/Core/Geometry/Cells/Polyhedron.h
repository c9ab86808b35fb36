// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A polyhedron: which points it holds, and the nearest point of its faces.
///
/// A face is the fan of triangles around the mean of its points, so that the two cells of a warped
/// face have the same; one of three points is that triangle. Only the distance to a flat face that
/// is so concave that the fan folds over is taken from the polygon itself.
#ifndef skd_Geometry_Cells_Polyhedron_h
#define skd_Geometry_Cells_Polyhedron_h

#include "../Distance/ClosestPointOnTriangle.h"
#include "../Distance/Distance.h"
#include "../Intersection/SegmentTriangle.h"
#include "../Polygons/PlanarPolygon.h"
#include "PolyhedronView.h"

#include <cstdint>

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

/// Whether some triangle of the fan is flipped against the others.
inline bool IsFolded(const PolyhedronFace& face)
{
  const Vector3 normal = PolygonPlane(face, face.Size).Normal;
  bool isFolded = false;
  ForEachTriangle(face,
    [&](const FaceTriangle& t)
    {
      const Vector3 across = Cross(t.Points[1] - t.Points[0], t.Points[2] - t.Points[0]);
      isFolded |= Dot(across, normal) < 0.0;
    });
  return isFolded;
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

/// The nearest of the faces' triangles.
struct NearestTriangle
{
  TrianglePoint Nearest;
  FaceTriangle Triangle;
  PolyhedronFace Face;
};

inline void KeepNearer(NearestTriangle& nearest, const PolyhedronFace& face, const Vector3& x)
{
  ForEachTriangle(face,
    [&](const FaceTriangle& triangle)
    {
      const FaceTriangle t = Ordered(triangle);
      const TrianglePoint found = ClosestPointOnTriangle(t.Points[0], t.Points[1], t.Points[2], x);
      if (found.Dist2 < nearest.Nearest.Dist2)
      {
        nearest = { found, t, face };
      }
    });
}

inline Box3 BoundsOf(const PolyhedronFace& face)
{
  Box3 bounds;
  for (int i = 0; i < face.Size; ++i)
  {
    bounds.Add(face[i]);
  }
  return bounds;
}

/// Calls visit(face) for faces whose box is within the limit, that visit returns anew.
template <class Visit>
void ForEachFaceWithin(const PolyhedronView& cell, const Vector3& x, double limit2, Visit visit)
{
  cell.ForEachFace(
    [&](const PolyhedronFace& face)
    {
      if (face.Size > 0 && MinDistance2(x, BoundsOf(face)) <= limit2)
      {
        limit2 = std::min(limit2, visit(face));
      }
    });
}

/// Dist2 is infinite when no triangle is within the limit.
inline NearestTriangle FindNearestTriangle(
  const PolyhedronView& cell, const Vector3& x, double limit2)
{
  NearestTriangle nearest{};
  nearest.Nearest.Dist2 = std::numeric_limits<double>::infinity();
  ForEachFaceWithin(cell, x, limit2,
    [&](const PolyhedronFace& face)
    {
      KeepNearer(nearest, face, x);
      return nearest.Nearest.Dist2;
    });
  return nearest;
}

/// The nearest point of the faces; Dist2 is infinite when none is within the limit.
inline PolygonPoint ClosestPointOnFaces(const PolyhedronView& cell, const Vector3& x, double limit2)
{
  PolygonPoint nearest{ x, std::numeric_limits<double>::infinity(), 0, 0.0, false };
  const auto keep = [&](const Vector3& point, double dist2)
  {
    if (dist2 < nearest.Dist2)
    {
      nearest.Point = point;
      nearest.Dist2 = dist2;
    }
    return nearest.Dist2;
  };
  ForEachFaceWithin(cell, x, limit2,
    [&](const PolyhedronFace& face)
    {
      if (face.Size > 3 && detail::IsFolded(face))
      {
        const PolygonPoint found = ClosestPointOnPolygon(face, face.Size, x);
        return keep(found.Point, found.Dist2);
      }
      NearestTriangle found{};
      found.Nearest.Dist2 = std::numeric_limits<double>::infinity();
      KeepNearer(found, face, x);
      return keep(found.Nearest.Point, found.Nearest.Dist2);
    });
  return nearest;
}

}

#endif
