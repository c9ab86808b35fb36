// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/Kernels/SkdPolyKernels.h"

#include "Cells/Kernels/SkdKernels.h"
#include "Core/Geometry/Cells/ClosestPointOnPolyhedron.h"
#include "Core/Geometry/Cells/MeanValue.h"
#include "Core/Geometry/Intersection/SegmentPolygon.h"

namespace skdtree
{
namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr skd::Vector3 Zero{ { 0.0, 0.0, 0.0 } };

SkdCellPoint Nowhere(const skd::Vector3& x)
{
  return { x, Zero, Infinity };
}

/// Strips, polylines and polyvertices are lists of simple cells: `Kernel` of points i, i + 1, ...
int NumberOfPieces(const SkdPolyCell& cell, int sizeOfPiece)
{
  return cell.Size - sizeOfPiece + 1;
}

template <class Kernel>
SkdCellPoint ClosestPiece(const SkdPolyCell& cell, const skd::Vector3& x, double limit2)
{
  SkdCellPoint nearest = Nowhere(x);
  for (int i = 0; i < NumberOfPieces(cell, Kernel::Size); ++i)
  {
    SkdCellPoint piece = Kernel::Closest(cell.Points + i, x, limit2);
    if (piece.Dist2 < nearest.Dist2)
    {
      piece.SubId = i;
      nearest = piece;
    }
  }
  return nearest;
}

template <class Kernel>
std::optional<SkdLineHit> FirstPieceHit(
  const SkdPolyCell& cell, const skd::SegmentView& view, const SkdHitTolerance& hitTolerance)
{
  std::optional<SkdLineHit> first;
  for (int i = 0; i < NumberOfPieces(cell, Kernel::Size); ++i)
  {
    const auto hit = Kernel::Intersect(cell.Points + i, view, hitTolerance);
    if (hit && (!first || hit->T < first->T))
    {
      first = hit;
      first->SubId = i;
    }
  }
  return first;
}

template <class Kernel>
void WeighPiece(const SkdPolyCell& cell, const SkdCellPoint& found, double* weights)
{
  std::fill(weights, weights + cell.Size, 0.0);
  Kernel::Weights(found.PCoords, weights + found.SubId);
}

/// Calls visit(kernel) with the kernel of the pieces. Too few points are lines, or a vertex.
/// False for polygons and polyhedra.
template <class Visit>
bool VisitPieces(const SkdPolyCell& cell, Visit visit)
{
  if (cell.Shape == SkdShape::Polygon || cell.Shape == SkdShape::Polyhedron)
  {
    return false;
  }
  if (cell.Shape == SkdShape::Strip && cell.Size > 2)
  {
    visit(SkdTriangleKernel());
  }
  else if (cell.Shape != SkdShape::PolyVertex && cell.Size > 1)
  {
    visit(SkdLineKernel());
  }
  else
  {
    visit(SkdVertexKernel());
  }
  return true;
}

/// VTK counts the first two points of every other triangle of a strip the other way around.
skd::Vector3 StripPCoords(const SkdPolyCell& cell, int subId, const skd::Vector3& pcoords)
{
  const bool isReversed = cell.Shape == SkdShape::Strip && cell.Size > 2 && subId % 2 == 1;
  return isReversed ? skd::Vector3{ { 1.0 - pcoords[0] - pcoords[1], pcoords[1], 0.0 } } : pcoords;
}

//------------------------------------------------------------------------------
/// The parametric coordinates of polygons: a rectangle around the points, along the first edge.
skd::Vector3 PolygonPCoords(const SkdPolyCell& cell, const skd::Vector3& x)
{
  const skd::Vector3 origin = cell.Points[0];
  const skd::Vector3 normal = skd::PolygonPlane(cell.Points, cell.Size).Normal;
  const skd::Vector3 along = cell.Points[cell.Size > 1 ? 1 : 0] - origin;
  const skd::Vector3 axes[2] = { along, skd::Cross(normal, along) };
  skd::Vector3 pcoords = Zero;
  for (int axis = 0; axis < 2; ++axis)
  {
    double least = 0.0;
    double most = 0.0;
    for (int i = 1; i < cell.Size; ++i)
    {
      const double at = skd::Dot(axes[axis], cell.Points[i] - origin);
      least = std::min(least, at);
      most = std::max(most, at);
    }
    const double at = skd::Dot(axes[axis], x - origin);
    pcoords[axis] = most > least ? (at - least) / (most - least) : 0.0;
  }
  return pcoords;
}

/// What rounding makes of distances among points as large as these, squared.
double Rounding2(const SkdPolyCell& cell)
{
  double largest = 0.0;
  for (int i = 0; i < cell.Size; ++i)
  {
    const skd::Vector3& p = cell.Points[i];
    largest = std::max({ largest, std::abs(p[0]), std::abs(p[1]), std::abs(p[2]) });
  }
  const double rounding = 8.0 * std::numeric_limits<double>::epsilon() * largest;
  return rounding * rounding;
}

//------------------------------------------------------------------------------
SkdCellPoint ClosestOnPolygon(const SkdPolyCell& cell, const skd::Vector3& x)
{
  const skd::PolygonPoint nearest = skd::ClosestPointOnPolygon(cell.Points, cell.Size, x);
  return { nearest.Point, Zero, nearest.Dist2, 0, nearest.IsInner };
}

std::optional<SkdLineHit> HitPolygon(
  const SkdPolyCell& cell, const skd::SegmentView& view, const SkdHitTolerance& hitTolerance)
{
  const skd::Segment<3>& segment = view.GetSegment();
  if (const auto hit = skd::Intersect(view, cell.Points, cell.Size))
  {
    return SkdLineHit{ hit->T, PolygonPCoords(cell, segment.At(hit->T)) };
  }
  if (!(hitTolerance.Tolerance > 0.0))
  {
    return std::nullopt;
  }
  const skd::PolygonPlane plane(cell.Points, cell.Size);
  const std::optional<double> accepted =
    view.Accept(skd::Dot(plane.Normal, plane.Origin - segment.A) /
      skd::Dot(plane.Normal, segment.B - segment.A));
  if (!accepted)
  {
    return std::nullopt;
  }
  const skd::PolygonPoint nearest =
    skd::ClosestPointOnPolygon(cell.Points, cell.Size, segment.At(*accepted));
  if (!(nearest.Dist2 <= hitTolerance.Tolerance * hitTolerance.Tolerance))
  {
    return std::nullopt;
  }
  return SkdLineHit{ *accepted, PolygonPCoords(cell, nearest.Point) };
}

void WeighPolygon(const SkdPolyCell& cell, const skd::Vector3& x, double* weights)
{
  const skd::PolygonPoint edge = skd::ClosestPointOnPolygonEdges(cell.Points, cell.Size, x);
  const bool isOnEdge = !(edge.Dist2 > Rounding2(cell));
  if (isOnEdge || !skd::MeanValueWeights(cell.Points, cell.Size, x, weights))
  {
    std::fill(weights, weights + cell.Size, 0.0);
    weights[edge.Edge] += 1.0 - edge.R;
    weights[(edge.Edge + 1) % cell.Size] += edge.R;
  }
}

//------------------------------------------------------------------------------
SkdCellPoint ClosestOnPolyhedron(const SkdPolyCell& cell, const skd::Vector3& x, double limit2)
{
  const skd::PolyhedronView polyhedron = cell.AsPolyhedron();
  const skd::Box3 bounds = polyhedron.Bounds();
  if (skd::MinDistance2(x, bounds) > limit2)
  {
    return Nowhere(x);
  }
  if (skd::Contains(polyhedron, bounds, x))
  {
    return { x, Zero, 0.0, 0, true };
  }
  const skd::PolygonPoint nearest = skd::ClosestPointOnFaces(polyhedron, x, limit2);
  return { nearest.Point, Zero, nearest.Dist2 };
}

std::optional<SkdLineHit> HitPolyhedron(
  const SkdPolyCell& cell, const skd::SegmentView& view, const SkdHitTolerance& hitTolerance)
{
  const skd::PolyhedronView polyhedron = cell.AsPolyhedron();
  std::optional<SkdLineHit> first;
  polyhedron.ForEachFace(
    [&](const skd::PolyhedronFace& face)
    {
      if (!(hitTolerance.Tolerance > 0.0) && !skd::MayCross(view, face))
      {
        return;
      }
      skd::ForEachTriangle(face,
        [&](const skd::FaceTriangle& triangle)
        {
          const auto hit =
            SkdTriangleKernel::Intersect(skd::Ordered(triangle).Points, view, hitTolerance);
          first = hit && (!first || hit->T < first->T) ? hit : first;
        });
    });
  if (first)
  {
    const skd::Vector3 point = view.GetSegment().At(first->T);
    first->PCoords = SkdPolyKernels::PCoordsInBounds(polyhedron.Bounds(), point);
  }
  return first;
}

void WeighPolyhedron(const SkdPolyCell& cell, const skd::Vector3& x, double* weights)
{
  const skd::PolyhedronView polyhedron = cell.AsPolyhedron();
  const skd::NearestTriangle nearest = skd::FindNearestTriangle(polyhedron, x, Rounding2(cell));
  if (nearest.Nearest.Dist2 <= Rounding2(cell))
  {
    skd::FaceWeights(polyhedron, nearest, weights);
  }
  else if (!skd::MeanValueWeights(polyhedron, x, weights))
  {
    skd::FaceWeights(polyhedron, skd::FindNearestTriangle(polyhedron, x, Infinity), weights);
  }
}
}

//------------------------------------------------------------------------------
skd::Vector3 SkdPolyKernels::PCoordsInBounds(const skd::Box3& bounds, const skd::Vector3& x)
{
  skd::Vector3 pcoords = Zero;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double length = bounds.Length(axis);
    pcoords[axis] = length > 0.0 ? (x[axis] - bounds.Min[axis]) / length : 0.0;
  }
  return pcoords;
}

//------------------------------------------------------------------------------
SkdCellPoint SkdPolyKernels::Closest(const SkdPolyCell& cell, const skd::Vector3& x, double limit2)
{
  SkdCellPoint nearest;
  const auto measure = [&](auto kernel)
  {
    nearest = ClosestPiece<decltype(kernel)>(cell, x, limit2);
    nearest.PCoords = StripPCoords(cell, nearest.SubId, nearest.PCoords);
  };
  if (VisitPieces(cell, measure))
  {
    return nearest;
  }
  return cell.Shape == SkdShape::Polygon ? ClosestOnPolygon(cell, x)
                                         : ClosestOnPolyhedron(cell, x, limit2);
}

//------------------------------------------------------------------------------
std::optional<SkdLineHit> SkdPolyKernels::Intersect(
  const SkdPolyCell& cell, const skd::SegmentView& view, const SkdHitTolerance& hitTolerance)
{
  std::optional<SkdLineHit> first;
  const auto intersect = [&](auto kernel)
  {
    first = FirstPieceHit<decltype(kernel)>(cell, view, hitTolerance);
    if (first)
    {
      first->PCoords = StripPCoords(cell, first->SubId, first->PCoords);
    }
  };
  if (VisitPieces(cell, intersect))
  {
    return first;
  }
  return cell.Shape == SkdShape::Polygon ? HitPolygon(cell, view, hitTolerance)
                                         : HitPolyhedron(cell, view, hitTolerance);
}

//------------------------------------------------------------------------------
void SkdPolyKernels::Locate(const SkdPolyCell& cell, SkdCellPoint& found, double* weights)
{
  const auto weigh = [&](auto kernel)
  {
    SkdCellPoint piece = found;
    piece.PCoords = StripPCoords(cell, found.SubId, found.PCoords); // reversed twice is as it was
    if (weights)
    {
      WeighPiece<decltype(kernel)>(cell, piece, weights);
    }
  };
  if (VisitPieces(cell, weigh))
  {
    return;
  }
  const bool isPolygon = cell.Shape == SkdShape::Polygon;
  found.PCoords = isPolygon ? PolygonPCoords(cell, found.Point)
                            : PCoordsInBounds(cell.AsPolyhedron().Bounds(), found.Point);
  if (weights)
  {
    if (isPolygon)
    {
      WeighPolygon(cell, found.Point, weights);
    }
    else
    {
      WeighPolyhedron(cell, found.Point, weights);
    }
  }
}
}
