// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The nearest point of a triangle, with its parameters.
///
/// As ClosestPointOnSegment.h has it of segments; zero areas and needles included, lengths from
/// 1e-70 to 1e70. On an edge the point is that of the edge by itself.
#ifndef skd_Geometry_Distance_ClosestPointOnTriangle_h
#define skd_Geometry_Distance_ClosestPointOnTriangle_h

#include "ClosestPointOnSegment.h"

#include <limits>

namespace skd
{

/// Point = (1 - R - S) a + R b + S c.
struct TrianglePoint
{
  Vector3 Point;
  double R;
  double S;
  double Dist2;
};

/// Where the foot of the perpendicular from a + f to the plane of a, a + u, a + v lies.
struct TriangleFoot
{
  double R;
  double S;
  bool IsUncertain; ///< the angle at a is sharp

  TriangleFoot(const Vector3& u, const Vector3& v, const Vector3& f)
  {
    const Vector3 normal = Cross(u, v);
    const double normal2 = Norm2(normal);
    const double scale = 1.0 / normal2;
    this->R = scale * Dot(Cross(f, v), normal);
    this->S = scale * Dot(Cross(u, f), normal);
    this->IsUncertain = !(normal2 * 64.0 > Norm2(u) * Norm2(v));
    if (this->IsUncertain && normal2 > 0.0)
    {
      this->Refine(u, v, f, scale * normal);
    }
  }

  bool IsInside() const { return this->R >= 0.0 && this->S >= 0.0 && this->R + this->S <= 1.0; }

private:
  /// What rounding left of the residual in the plane is solved for again, while that leads nearer.
  void Refine(const Vector3& u, const Vector3& v, const Vector3& f, const Vector3& normal)
  {
    TriangleFoot next(*this);
    double last = std::numeric_limits<double>::infinity();
    for (int iteration = 0; iteration < 10; ++iteration)
    {
      const Vector3 rest = f - next.R * u - next.S * v;
      const double dist2 = Norm2(rest);
      if (!(dist2 < last))
      {
        break;
      }
      *this = next;
      last = dist2;
      next.R += Dot(Cross(rest, v), normal);
      next.S += Dot(Cross(u, rest), normal);
    }
  }
};

/// The nearest of those edges that the foot lies outside of; of all three if it is uncertain.
inline TrianglePoint ClosestPointOnTriangleEdges(
  const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& x, const TriangleFoot& foot)
{
  TrianglePoint nearest{ a, 0.0, 0.0, Distance2(a, x) };
  if (foot.IsUncertain || foot.S < 0.0)
  {
    const SegmentPoint<3> ab = ClosestPointOnSegment(a, b, x);
    nearest = { ab.Point, ab.R, 0.0, ab.Dist2 };
  }
  if (foot.IsUncertain || foot.R < 0.0)
  {
    const SegmentPoint<3> ac = ClosestPointOnSegment(a, c, x);
    if (ac.Dist2 < nearest.Dist2)
    {
      nearest = { ac.Point, 0.0, ac.R, ac.Dist2 };
    }
  }
  if (foot.IsUncertain || foot.R + foot.S > 1.0)
  {
    const SegmentPoint<3> bc = ClosestPointOnSegment(b, c, x);
    if (bc.Dist2 < nearest.Dist2)
    {
      const double r = 1.0 - bc.R;
      nearest = { bc.Point, r, 1.0 - r, bc.Dist2 };
    }
  }
  return nearest;
}

inline TrianglePoint ClosestPointOnTriangle(
  const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& x)
{
  const Vector3 u = b - a;
  const Vector3 v = c - a;
  const Vector3 f = x - a;
  const TriangleFoot foot(u, v, f);
  const bool isInside = foot.IsInside();
  if (!isInside || foot.IsUncertain)
  {
    const TrianglePoint edge = ClosestPointOnTriangleEdges(a, b, c, x, foot);
    if (!isInside || edge.Dist2 <= Norm2(f - foot.R * u - foot.S * v))
    {
      return edge;
    }
  }
  const double s = foot.S < 1.0 - foot.R ? foot.S : 1.0 - foot.R; // no weight below 0
  return { a + foot.R * u + s * v, foot.R, s, Norm2(f - foot.R * u - s * v) };
}

}

#endif
