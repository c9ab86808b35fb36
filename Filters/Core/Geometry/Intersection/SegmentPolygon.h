// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Where a segment crosses a polygon, watertight along the polygon's edges: these are tested as
/// those of triangles are (SegmentTriangle.h), so that no segment slips between two cells.
#ifndef skd_Geometry_Intersection_SegmentPolygon_h
#define skd_Geometry_Intersection_SegmentPolygon_h

#include "../Polygons/PolygonPlane.h"
#include "SegmentTriangle.h"

namespace skd
{

/// A crossing of a segment and a polygon; as TriangleHit.
struct PolygonHit
{
  double T;
  bool OnEdge;
  bool Passes;
};

namespace detail
{

/// What a walk around the polygon, seen along the segment, finds.
struct PolygonWinding
{
  double EdgeParameter = std::numeric_limits<double>::infinity(); ///< finite if on an edge
  double Least = std::numeric_limits<double>::infinity();         ///< parameters of the points
  double Most = -std::numeric_limits<double>::infinity();
  bool Passes = false;
  bool IsEdgeOn = true; ///< all edges are seen end to end

  void Add(const Sheared& p, const Sheared& q)
  {
    this->Least = std::min(this->Least, q.Z);
    this->Most = std::max(this->Most, q.Z);
    if (p.X == q.X && p.Y == q.Y)
    {
      return;
    }
    const EdgeSide side = SideOf(p, q);
    this->IsEdgeOn &= side.Sign == 0;
    if ((p.Y > 0.0) != (q.Y > 0.0))
    {
      this->Passes ^= (side.MovedSign > 0) == (q.Y > p.Y);
    }
    if (side.Sign == 0 && Holds(p.X, q.X) && Holds(p.Y, q.Y))
    {
      this->EdgeParameter = std::min(this->EdgeParameter, ParameterAt(p, q));
    }
  }

private:
  static bool Holds(double a, double b) { return std::min(a, b) <= 0.0 && std::max(a, b) >= 0.0; }

  static double ParameterAt(const Sheared& p, const Sheared& q)
  {
    if (p.X == 0.0 && p.Y == 0.0)
    {
      return p.Z;
    }
    return q.X == 0.0 && q.Y == 0.0 ? q.Z : ParameterOnEdge(p, q);
  }
};

}

/// Within the polygon the hit is in its plane. One seen exactly edge-on, or of no area, is not hit.
template <class Points>
std::optional<PolygonHit> Intersect(const SegmentView& view, const Points& points, int size)
{
  detail::PolygonWinding winding;
  Sheared last = view.See(points[size - 1]);
  for (int i = 0; i < size; ++i)
  {
    const Sheared next = view.See(points[i]);
    winding.Add(last, next);
    last = next;
  }
  const bool isOnEdge = std::isfinite(winding.EdgeParameter);
  if (winding.IsEdgeOn || !(winding.Passes || isOnEdge))
  {
    return std::nullopt;
  }
  double parameter = winding.EdgeParameter;
  if (!isOnEdge)
  {
    const PolygonPlane plane(points, size);
    const Segment<3>& segment = view.GetSegment();
    parameter =
      Dot(plane.Normal, plane.Origin - segment.A) / Dot(plane.Normal, segment.B - segment.A);
    parameter = std::max(winding.Least, std::min(winding.Most, parameter)); // also of a warped one
  }
  const std::optional<double> accepted = view.Accept(parameter);
  return accepted ? std::optional<PolygonHit>({ *accepted, isOnEdge, winding.Passes })
                  : std::nullopt;
}

}

#endif
