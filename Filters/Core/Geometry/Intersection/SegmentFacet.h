// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Where a segment of a polyline crosses a triangle of a mesh, such that a closed polyline passes
/// through a closed mesh an even number of times, whatever vertices and edges of either it meets.
///
/// All decisions are signs of exact determinants (ExactOrientation.h). Where one is 0, the whole
/// polyline counts as moved by (e, e^2, e^3) with e > 0 below any number: then it meets no vertex
/// and no edge, lies in no plane, and each of its points is on one side of each triangle, the same
/// for both of its segments.
#ifndef skd_Geometry_Intersection_SegmentFacet_h
#define skd_Geometry_Intersection_SegmentFacet_h

#include "../Predicates/ExactOrientation.h"
#include "../Segment.h"

namespace skd
{

/// A point that a segment and a triangle have in common.
struct FacetHit
{
  double T; ///< along the segment, [0, 1]
  double R; ///< x = (1 - R - S) p0 + R p1 + S p2
  double S;
  bool OnBoundary; ///< of the triangle or the segment: neighbours report it, too, with an equal T
  /// Whether the moved segment passes through the triangle: 1 in the sense of its normal
  /// (p1 - p0) x (p2 - p0), -1 against it, 0 not at all.
  int Passes;
  int Direction; ///< the sense in which the segment itself goes through the triangle's plane
};

/// How the line of a segment, after the move, passes the edge from p to q: -1 where it goes along
/// the normal of what is on the left of the edge, 1 where against it; 0 only for parallel ones.
inline int MovedSideOf(const Segment<3>& segment, const Vector3& p, const Vector3& q)
{
  const int side = Orientation(segment.A, segment.B, p, q);
  return side ? side : SignOfCrossAlongMove(segment.A, segment.B, q, p);
}

namespace detail
{

/// The parameter of the point of the line that is nearest to a vertex.
inline double ParameterOf(const Segment<3>& segment, const Vector3& vertex)
{
  const Vector3 along = segment.B - segment.A;
  return Dot(vertex - segment.A, along) / Norm2(along);
}

/// Where the line is nearest to that of an edge: the same number from both of its triangles.
inline double ParameterAtEdge(const Segment<3>& segment, const Vector3& p, const Vector3& q)
{
  const Vector3& low = p < q ? p : q;
  const Vector3 along = segment.B - segment.A;
  const Vector3 edge = (p < q ? q : p) - low;
  const Vector3 across = Cross(along, edge);
  return Dot(Cross(low - segment.A, edge), across) / Norm2(across);
}

struct FacetSigns
{
  int Ends[2];  ///< on which side of the triangle are A and B
  int Edges[3]; ///< how does the line pass the edges opposite to p0, p1, p2

  bool IsHit() const
  {
    const auto& [u, v, w] = this->Edges;
    const bool isInside = (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
    const bool isApart = this->Ends[0] * this->Ends[1] > 0;
    const bool isCoplanar = this->Ends[0] == 0 && this->Ends[1] == 0;
    return isInside && !isApart && !isCoplanar;
  }

  bool AreAllOnOneSide() const
  {
    const auto& [u, v, w] = this->Edges;
    return u != 0 && u == v && v == w;
  }
};

inline FacetSigns SignsOf(const Segment<3>& segment, const Vector3 (&p)[3])
{
  FacetSigns signs;
  signs.Ends[0] = Orientation(p[0], p[1], p[2], segment.A);
  signs.Ends[1] = Orientation(p[0], p[1], p[2], segment.B);
  if (signs.Ends[0] * signs.Ends[1] > 0)
  {
    return signs;
  }
  for (int i = 0; i < 3; ++i)
  {
    signs.Edges[i] = Orientation(segment.A, segment.B, p[(i + 1) % 3], p[(i + 2) % 3]);
  }
  return signs;
}

/// The signs after the move: none is 0 for a triangle with an area that is not seen edge-on.
inline FacetSigns Moved(FacetSigns signs, const Segment<3>& segment, const Vector3 (&p)[3])
{
  for (int& end : signs.Ends)
  {
    end = end ? end : -SignOfCrossAlongMove(p[0], p[1], p[0], p[2]);
  }
  for (int i = 0; i < 3; ++i)
  {
    int& edge = signs.Edges[i];
    edge = edge ? edge : MovedSideOf(segment, p[(i + 1) % 3], p[(i + 2) % 3]);
  }
  return signs;
}

/// From which of the triangle's vertices, edges or its plane, or the segment's ends, T follows.
inline double FacetParameter(
  const FacetSigns& signs, const Segment<3>& segment, const Vector3 (&p)[3], double weight)
{
  if (signs.Ends[0] == 0 || signs.Ends[1] == 0)
  {
    return signs.Ends[0] == 0 ? 0.0 : 1.0;
  }
  const int zeros = (signs.Edges[0] == 0) + (signs.Edges[1] == 0) + (signs.Edges[2] == 0);
  for (int i = 0; i < 3 && zeros > 0; ++i)
  {
    const int next = (i + 1) % 3;
    const int last = (i + 2) % 3;
    if (zeros == 2 && signs.Edges[i] != 0)
    {
      return ParameterOf(segment, p[i]);
    }
    if (zeros == 1 && signs.Edges[i] == 0)
    {
      return ParameterAtEdge(segment, p[next], p[last]);
    }
  }
  return weight;
}

}

/// What the segment and the triangle p have in common, boundaries included. A triangle seen exactly
/// edge-on, or of no area, and a segment of no length, are not hit.
inline std::optional<FacetHit> MeetFacet(const Segment<3>& segment, const Vector3 (&p)[3])
{
  const detail::FacetSigns signs = detail::SignsOf(segment, p);
  if (!signs.IsHit())
  {
    return std::nullopt;
  }
  // Six times the volumes of the tetrahedra of the triangle with A and with B are the heights of A
  // and B over the plane, times the same area: the plane is at their ratio along the segment.
  const double heightA = AccurateTripleProduct(p[0] - segment.A, p[1] - p[0], p[2] - p[0]);
  const double heightB = AccurateTripleProduct(p[0] - segment.B, p[1] - p[0], p[2] - p[0]);
  const double weight = heightA / (heightA - heightB);
  if (!std::isfinite(weight))
  {
    return std::nullopt; // not a number among the coordinates
  }
  FacetHit hit;
  hit.T = std::clamp(detail::FacetParameter(signs, segment, p, weight), 0.0, 1.0);
  const Vector3 x = segment.At(hit.T);
  // Barycentric coordinates: the areas of the triangles of x with two vertices, over the whole one.
  const Vector3 normal = Cross(p[1] - p[0], p[2] - p[0]);
  hit.R = Dot(Cross(x - p[0], p[2] - p[0]), normal) / Norm2(normal);
  hit.S = Dot(Cross(p[1] - p[0], x - p[0]), normal) / Norm2(normal);
  hit.OnBoundary =
    signs.Ends[0] * signs.Ends[1] == 0 || signs.Edges[0] * signs.Edges[1] * signs.Edges[2] == 0;
  // Contact on a boundary is not enough to pass through: the moved segment decides (see above).
  const detail::FacetSigns moved = detail::Moved(signs, segment, p);
  const bool passes = moved.Ends[0] * moved.Ends[1] < 0 && moved.AreAllOnOneSide();
  hit.Passes = passes ? moved.Ends[0] : 0;
  hit.Direction = signs.Ends[0] != 0 ? signs.Ends[0] : -signs.Ends[1];
  return hit;
}

/// The interval of a segment that runs within a triangle's plane and is on the triangle: exact as
/// to whether it does, its ends to within rounding.
inline std::optional<Interval> WithinFacet(const Segment<3>& segment, const Vector3 (&p)[3])
{
  const Vector3 normal = Cross(p[1] - p[0], p[2] - p[0]);
  const Vector3 along = segment.B - segment.A;
  const bool isWithin = Norm2(normal) > 0.0 && Norm2(along) > 0.0 &&
    Orientation(p[0], p[1], p[2], segment.A) == 0 && Orientation(p[0], p[1], p[2], segment.B) == 0;
  if (!isWithin)
  {
    return std::nullopt;
  }
  Interval inside{ 0.0, 1.0 };
  for (int i = 0; i < 3; ++i)
  {
    const Vector3 inward = Cross(normal, p[(i + 1) % 3] - p[i]);
    const double depth = Dot(inward, segment.A - p[i]);
    const double slope = Dot(inward, along);
    if (slope == 0.0 && depth < 0.0)
    {
      return std::nullopt;
    }
    inside.Min = slope > 0.0 ? std::max(inside.Min, -depth / slope) : inside.Min;
    inside.Max = slope < 0.0 ? std::min(inside.Max, -depth / slope) : inside.Max;
  }
  return inside.Min < inside.Max ? std::optional<Interval>(inside) : std::nullopt;
}

}

#endif
