// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A convex polygon cut by half planes, with no allocation: what overlaps in the plane and, by
/// central projection, on the sphere come down to. Sutherland and Hodgman, CACM 1974.
#ifndef skd_Geometry_Overlap_ConvexClip_h
#define skd_Geometry_Overlap_ConvexClip_h

#include "../Vector.h"

#include <array>
#include <limits>

namespace skd
{

/// Corners counter-clockwise, in a frame of its own.
struct ConvexPolygon
{
  static constexpr int Most = 64; ///< corners: cut into less those that may come to have more

  int Size = 0;
  std::array<Vector<2>, Most> Corners;

  void Add(const Vector<2>& corner) { this->Corners[this->Size++] = corner; }
};

/// Where A x + B y + C is positive. Corners within the tolerance of the border are on it.
struct HalfPlane
{
  double A;
  double B;
  double C;
  double Tolerance;

  double operator()(const Vector<2>& x) const
  {
    const double side = this->A * x[0] + this->B * x[1] + this->C;
    return std::abs(side) <= this->Tolerance ? 0.0 : side;
  }
};

/// What counts as rounding, relative to the coordinates in a frame.
constexpr double ClipTolerance = 8.0 * std::numeric_limits<double>::epsilon();

/// The left of the line from a to b, homogeneous points (x, y, w): of a plane w is 1. The opposite
/// way gives the same numbers with opposite signs, so that what is on both sides of a line fits
/// together to the last bit. `extent` bounds the coordinates of all that is in the frame.
inline HalfPlane LeftOf(const Vector3& a, const Vector3& b, double extent)
{
  const Vector3 line = Cross(a, b);
  return { line[0], line[1], line[2],
    ClipTolerance * extent * (std::abs(line[0]) + std::abs(line[1])) };
}

namespace detail
{

/// Where an edge crosses a line, from its nearer end: the same from both sides of edge and line.
inline Vector<2> CrossingOf(const Vector<2>& p, double atP, const Vector<2>& q, double atQ)
{
  return std::abs(atP) <= std::abs(atQ) ? p + (atP / (atP - atQ)) * (q - p)
                                        : q + (atQ / (atQ - atP)) * (p - q);
}

}

enum class ClipResult
{
  Nothing, ///< is left
  All,
  Some
};

/// Keeps what is in the half plane; corners stay as they are. Only contact is nothing. A polygon
/// gets one corner more at most.
inline ClipResult Clip(ConvexPolygon& polygon, const HalfPlane& halfPlane)
{
  std::array<double, ConvexPolygon::Most> sides;
  bool isAnyIn = false;
  bool isAnyOut = false;
  for (int i = 0; i < polygon.Size; ++i)
  {
    sides[i] = halfPlane(polygon.Corners[i]);
    isAnyIn |= sides[i] > 0.0;
    isAnyOut |= sides[i] < 0.0;
  }
  if (!isAnyIn || !isAnyOut)
  {
    return isAnyIn ? ClipResult::All : ClipResult::Nothing;
  }
  std::array<Vector<2>, ConvexPolygon::Most> corners;
  const int size = polygon.Size;
  std::copy_n(polygon.Corners.begin(), size, corners.begin());
  polygon.Size = 0;
  for (int i = 0; i < size; ++i)
  {
    const int next = i + 1 == size ? 0 : i + 1;
    if (sides[i] >= 0.0)
    {
      polygon.Add(corners[i]);
    }
    if ((sides[i] < 0.0 && sides[next] > 0.0) || (sides[i] > 0.0 && sides[next] < 0.0))
    {
      polygon.Add(detail::CrossingOf(corners[i], sides[i], corners[next], sides[next]));
    }
  }
  return ClipResult::Some;
}

/// Keeps what is within a convex polygon of homogeneous corners, counter-clockwise.
inline ClipResult Clip(ConvexPolygon& polygon, const Vector3* around, int size, double extent)
{
  ClipResult result = ClipResult::All;
  for (int i = 0; i < size && result != ClipResult::Nothing; ++i)
  {
    const ClipResult cut =
      Clip(polygon, LeftOf(around[i], around[i + 1 == size ? 0 : i + 1], extent));
    result = cut == ClipResult::All ? result : cut;
  }
  return result;
}

}

#endif
