// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_PieceContact_h
#define skd_Geometry_PieceContact_h

#include "ClosestTriangles.h"
#include "SegmentFacet.h"
#include "TriangleContact.h"

namespace skd
{

/// A point, a segment or a triangle.
struct Piece
{
  std::array<Vector3, 3> Points; ///< the last one repeated where there are less than three
  int Size;

  static Piece Of(const Vector3& a) { return { { a, a, a }, 1 }; }
  static Piece Of(const Vector3& a, const Vector3& b) { return { { a, b, b }, 2 }; }
  static Piece Of(const Vector3& a, const Vector3& b, const Vector3& c)
  {
    return { { a, b, c }, 3 };
  }
};

namespace detail
{

inline bool Crosses(const Piece& segment, const Piece& triangle)
{
  const Vector3 p[3] = { triangle.Points[0], triangle.Points[1], triangle.Points[2] };
  return segment.Size == 2 && triangle.Size == 3 &&
    MeetFacet(Segment<3>{ segment.Points[0], segment.Points[1] }, p).has_value();
}

/// The same times a power of two that makes the larger of two pieces about 1 in size: products of
/// four lengths stay in the range of double then. Nothing is rounded.
inline double ScaleOf(const Piece& first, const Piece& second)
{
  double size = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int i = 0; i < 3; ++i)
    {
      size = std::max({ size, std::abs(first.Points[i][axis] - first.Points[0][axis]),
        std::abs(second.Points[i][axis] - first.Points[0][axis]) });
    }
  }
  return size > 0.0 && std::isfinite(size) ? std::ldexp(1.0, -std::ilogb(size)) : 1.0;
}

inline Piece Scaled(Piece piece, double factor)
{
  for (Vector3& point : piece.Points)
  {
    point = factor * point;
  }
  return piece;
}

}

/// Whether two pieces have a point in common: exact for triangles that have an area; points,
/// segments and triangles without one count as touching where they come as near as `slack`.
/// O(1).
inline bool Touch(const Piece& first, const Piece& second, double slack)
{
  if (first.Size == 3 && second.Size == 3)
  {
    const SeenTriangle a(first.Points);
    const SeenTriangle b(second.Points);
    if (a.Axis >= 0 && b.Axis >= 0)
    {
      return FindContact(a, b, NoSharedCorners).Count > 0;
    }
  }
  const double scale = detail::ScaleOf(first, second);
  const Piece a = detail::Scaled(first, scale);
  const Piece b = detail::Scaled(second, scale);
  return detail::Crosses(a, b) || detail::Crosses(b, a) ||
    ClosestPoints(a.Points, b.Points).Dist2 <= scale * slack * (scale * slack);
}

}

#endif
