// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The exact tests of the shapes that have a kernel of their own. A kernel is a struct without
/// state:
///   Size                                    points of the cell
///   Closest(points, x, limit2)              the cell's nearest point to x, nothing farther matters
///   Intersect(points, view, reach)          first hit of a segment; reach: by how far it may miss
///   Weights(pcoords, weights)               interpolation weights, VTK's order
/// Points and parametric coordinates are in VTK's order and convention.
#ifndef SkdKernels_h
#define SkdKernels_h

#include "Cells/Kernels/SkdCellAnswers.h"
#include "Cells/Kernels/SkdQuadSplit.h"
#include "Cells/Read/SkdShape.h"
#include "Core/Geometry/Cells/ClosestPointInCell.h"
#include "Core/Geometry/Cells/LinearShapes.h"
#include "Core/Geometry/Distance/ClosestSegments.h"
#include "Core/Geometry/Intersection/SegmentNearTriangle.h"

namespace skdtree
{
struct SkdVertexKernel
{
  static constexpr int Size = 1;

  static SkdCellPoint Closest(const skd::Vector3* p, const skd::Vector3& x, double)
  {
    return { p[0], { { 0.0, 0.0, 0.0 } }, skd::Distance2(p[0], x) };
  }

  static std::optional<SkdLineHit> Intersect(
    const skd::Vector3* p, const skd::SegmentView& view, const SkdHitTolerance& hitTolerance)
  {
    const skd::Segment<3>& segment = view.GetSegment();
    const auto nearest = skd::ClosestPointOnSegment(segment.A, segment.B, p[0]);
    if (!(nearest.Dist2 <= hitTolerance.OfLines() * hitTolerance.OfLines()))
    {
      return std::nullopt;
    }
    return SkdLineHit{ nearest.R, { { 0.0, 0.0, 0.0 } } };
  }

  static void Weights(const skd::Vector3&, double* weights) { weights[0] = 1.0; }
};

struct SkdLineKernel
{
  static constexpr int Size = 2;

  static SkdCellPoint Closest(const skd::Vector3* p, const skd::Vector3& x, double)
  {
    const auto nearest = skd::ClosestPointOnSegment(p[0], p[1], x);
    const bool isInner = nearest.R > 0.0 && nearest.R < 1.0;
    return { nearest.Point, { { nearest.R, 0.0, 0.0 } }, nearest.Dist2, 0, isInner };
  }

  static std::optional<SkdLineHit> Intersect(
    const skd::Vector3* p, const skd::SegmentView& view, const SkdHitTolerance& hitTolerance)
  {
    const skd::SegmentPair nearest = skd::ClosestPoints(view.GetSegment(), { p[0], p[1] });
    if (!(nearest.Dist2 <= hitTolerance.OfLines() * hitTolerance.OfLines()))
    {
      return std::nullopt;
    }
    return SkdLineHit{ nearest.T, { { nearest.R, 0.0, 0.0 } } };
  }

  static void Weights(const skd::Vector3& pcoords, double* weights)
  {
    weights[0] = 1.0 - pcoords[0];
    weights[1] = pcoords[0];
  }
};

struct SkdTriangleKernel
{
  static constexpr int Size = 3;

  static SkdCellPoint Closest(const skd::Vector3* p, const skd::Vector3& x, double)
  {
    const auto nearest = skd::ClosestPointOnTriangle(p[0], p[1], p[2], x);
    const bool isInner = nearest.R > 0.0 && nearest.S > 0.0 && nearest.R + nearest.S < 1.0;
    return { nearest.Point, { { nearest.R, nearest.S, 0.0 } }, nearest.Dist2, 0, isInner };
  }

  static std::optional<SkdLineHit> Intersect(
    const skd::Vector3* p, const skd::SegmentView& view, const SkdHitTolerance& hitTolerance)
  {
    const auto hit = skd::IntersectWithin(view, p[0], p[1], p[2], hitTolerance.Tolerance);
    return hit ? std::optional<SkdLineHit>(From(*hit)) : std::nullopt;
  }

  static SkdLineHit From(const skd::TriangleHit& hit)
  {
    return { hit.T, { { hit.R, hit.S, 0.0 } } };
  }

  static void Weights(const skd::Vector3& pcoords, double* weights)
  {
    weights[0] = 1.0 - pcoords[0] - pcoords[1];
    weights[1] = pcoords[0];
    weights[2] = pcoords[1];
  }
};

/// The nearest hit of a segment with a face of 3 or 4 points whose parametric coordinates are
/// given.
inline void SkdHitFace(const skd::Vector3* p, const skd::Vector3* pcoords, int size,
  const skd::SegmentView& view, const SkdHitTolerance& hitTolerance,
  std::optional<SkdLineHit>& first)
{
  const auto tryTriangle = [&](int a, int b, int c)
  {
    const skd::Vector3 corners[3] = { p[a], p[b], p[c] };
    const auto hit = SkdTriangleKernel::Intersect(corners, view, hitTolerance);
    if (hit && (!first || hit->T < first->T))
    {
      const double r = hit->PCoords[0];
      const double s = hit->PCoords[1];
      first = { hit->T, (1.0 - r - s) * pcoords[a] + r * pcoords[b] + s * pcoords[c] };
    }
  };
  if (size == 3)
  {
    tryTriangle(0, 1, 2);
    return;
  }
  for (const auto& triangle : SkdQuadSplit(p).Triangles)
  {
    tryTriangle(triangle[0], triangle[1], triangle[2]);
  }
}

/// Bilinear for distances, two triangles for segments.
struct SkdQuadKernel
{
  static constexpr int Size = 4;

  static SkdCellPoint Closest(const skd::Vector3* p, const skd::Vector3& x, double limit2)
  {
    const skd::PatchPoint nearest = skd::ClosestPointOnPatch(p, x, limit2);
    const bool isInner = nearest.R > 0.0 && nearest.R < 1.0 && nearest.S > 0.0 && nearest.S < 1.0;
    return { nearest.Point, { { nearest.R, nearest.S, 0.0 } }, nearest.Dist2, 0, isInner };
  }

  static std::optional<SkdLineHit> Intersect(
    const skd::Vector3* p, const skd::SegmentView& view, const SkdHitTolerance& hitTolerance)
  {
    static constexpr skd::Vector3 corners[4] = { { { 0.0, 0.0, 0.0 } }, { { 1.0, 0.0, 0.0 } },
      { { 1.0, 1.0, 0.0 } }, { { 0.0, 1.0, 0.0 } } };
    std::optional<SkdLineHit> first;
    SkdHitFace(p, corners, 4, view, hitTolerance, first);
    return first;
  }

  static void Weights(const skd::Vector3& pcoords, double* weights)
  {
    const double r = pcoords[0];
    const double s = pcoords[1];
    weights[0] = (1.0 - r) * (1.0 - s);
    weights[1] = r * (1.0 - s);
    weights[2] = r * s;
    weights[3] = (1.0 - r) * s;
  }
};

/// A quad whose last two points are swapped.
struct SkdPixelKernel
{
  static constexpr int Size = 4;

  static SkdCellPoint Closest(const skd::Vector3* p, const skd::Vector3& x, double limit2)
  {
    const skd::Vector3 quad[4] = { p[0], p[1], p[3], p[2] };
    return SkdQuadKernel::Closest(quad, x, limit2);
  }

  static std::optional<SkdLineHit> Intersect(
    const skd::Vector3* p, const skd::SegmentView& view, const SkdHitTolerance& hitTolerance)
  {
    const skd::Vector3 quad[4] = { p[0], p[1], p[3], p[2] };
    return SkdQuadKernel::Intersect(quad, view, hitTolerance);
  }

  static void Weights(const skd::Vector3& pcoords, double* weights)
  {
    SkdQuadKernel::Weights(pcoords, weights);
    std::swap(weights[2], weights[3]);
  }
};

/// A volume cell given by the shape's map and faces; a segment hits its faces.
template <class Shape>
struct SkdVolumeKernel
{
  static constexpr int Size = Shape::Size;

  static SkdCellPoint Closest(const skd::Vector3* p, const skd::Vector3& x, double limit2)
  {
    return From(p, x, skd::ClosestPointInCell<Shape>(p, x, limit2));
  }

  static SkdCellPoint From(
    const skd::Vector3* p, const skd::Vector3& x, const skd::VolumePoint& nearest)
  {
    if (nearest.Dist2 > 0.0 && std::isfinite(nearest.Dist2))
    {
      if (const double* corner = CornerAt(p, x))
      {
        return { x, { { corner[0], corner[1], corner[2] } }, 0.0, 0, true };
      }
    }
    return { nearest.Point, nearest.PCoords, nearest.Dist2, 0, nearest.Dist2 == 0.0 };
  }

  /// Cells that share a corner must tie there despite rounding errors of their maps.
  static const double* CornerAt(const skd::Vector3* p, const skd::Vector3& x)
  {
    for (int i = 0; i < Size; ++i)
    {
      if (p[i] == x)
      {
        return Shape::Corners[i];
      }
    }
    return nullptr;
  }

  static std::optional<SkdLineHit> Intersect(
    const skd::Vector3* p, const skd::SegmentView& view, const SkdHitTolerance& hitTolerance)
  {
    std::optional<SkdLineHit> first;
    for (const auto& face : Shape::Faces)
    {
      const int size = face[3] < 0 ? 3 : 4;
      skd::Vector3 points[4];
      skd::Vector3 pcoords[4];
      for (int i = 0; i < size; ++i)
      {
        const double* corner = Shape::Corners[face[i]];
        points[i] = p[face[i]];
        pcoords[i] = { { corner[0], corner[1], corner[2] } };
      }
      SkdHitFace(points, pcoords, size, view, hitTolerance, first);
    }
    return first;
  }

  static void Weights(const skd::Vector3& pcoords, double* weights)
  {
    Shape::Weights(pcoords, weights);
  }
};

/// As in VTK, a segment hits a voxel where it enters the box, or at its start if that is inside.
struct SkdVoxelKernel : SkdVolumeKernel<skd::Voxel>
{
  static std::optional<SkdLineHit> Intersect(
    const skd::Vector3* p, const skd::SegmentView& view, const SkdHitTolerance& hitTolerance)
  {
    const skd::Segment<3>& segment = view.GetSegment();
    const skd::VolumePoint start = skd::ClosestPointInCell<skd::Voxel>(p, segment.A, 0.0);
    if (start.Dist2 == 0.0)
    {
      return SkdLineHit{ 0.0, start.PCoords };
    }
    return SkdVolumeKernel<skd::Voxel>::Intersect(p, view, hitTolerance);
  }
};

/// Calls visit(kernel) with the kernel of a shape that has one. False for the others.
template <class Visit>
bool SkdVisitKernel(SkdShape shape, Visit&& visit)
{
  switch (shape)
  {
    case SkdShape::Vertex:
      visit(SkdVertexKernel());
      return true;
    case SkdShape::Line:
      visit(SkdLineKernel());
      return true;
    case SkdShape::Triangle:
      visit(SkdTriangleKernel());
      return true;
    case SkdShape::Pixel:
      visit(SkdPixelKernel());
      return true;
    case SkdShape::Quad:
      visit(SkdQuadKernel());
      return true;
    case SkdShape::Tetrahedron:
      visit(SkdVolumeKernel<skd::Tetrahedron>());
      return true;
    case SkdShape::Voxel:
      visit(SkdVoxelKernel());
      return true;
    case SkdShape::Hexahedron:
      visit(SkdVolumeKernel<skd::Hexahedron>());
      return true;
    case SkdShape::Wedge:
      visit(SkdVolumeKernel<skd::Wedge>());
      return true;
    case SkdShape::Pyramid:
      visit(SkdVolumeKernel<skd::Pyramid>());
      return true;
    default:
      return false;
  }
}
}

#endif
