// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The nearest point of a polyhedron's faces (Polyhedron.h has their triangles). Only the distance
/// to a flat face that is so concave that the fan folds over is taken from the polygon itself.
#ifndef skd_Geometry_Cells_ClosestPointOnPolyhedron_h
#define skd_Geometry_Cells_ClosestPointOnPolyhedron_h

#include "../Distance/ClosestPointOnTriangle.h"
#include "../Distance/Distance.h"
#include "../Polygons/PlanarPolygon.h"
#include "Polyhedron.h"

namespace skd
{

namespace detail
{

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
