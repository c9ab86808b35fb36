// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/Search/SkdCellTree.h"

#include "Cells/Kernels/SkdFaceTriangles.h"
#include "Cells/Kernels/SkdKernels.h"
#include "Cells/Search/SkdVisitCandidates.h"
#include "Core/Geometry/Cells/Polyhedron.h"
#include "Core/Geometry/Intersection/BoxOverlap.h"

namespace skdtree
{
namespace
{
/// A quad is two triangles here, as it is for segments.
bool OverlapsQuad(const skd::Box3& box, const skd::Vector3* p)
{
  const SkdQuadSplit split(p);
  const auto meets = [&](const int* i) { return skd::Overlaps(box, p[i[0]], p[i[1]], p[i[2]]); };
  return meets(split.Triangles[0]) || meets(split.Triangles[1]);
}

bool OverlapsSurface(const skd::Box3& box, const skd::Vector3* p, SkdVertexKernel)
{
  return box.Contains(p[0]);
}

bool OverlapsSurface(const skd::Box3& box, const skd::Vector3* p, SkdLineKernel)
{
  return skd::Overlaps(box, skd::Segment<3>{ p[0], p[1] });
}

bool OverlapsSurface(const skd::Box3& box, const skd::Vector3* p, SkdTriangleKernel)
{
  return skd::Overlaps(box, p[0], p[1], p[2]);
}

bool OverlapsSurface(const skd::Box3& box, const skd::Vector3* p, SkdQuadKernel)
{
  return OverlapsQuad(box, p);
}

bool OverlapsSurface(const skd::Box3& box, const skd::Vector3* p, SkdPixelKernel)
{
  const skd::Vector3 quad[4] = { p[0], p[1], p[3], p[2] };
  return OverlapsQuad(box, quad);
}

template <class Shape>
bool OverlapsSurface(const skd::Box3& box, const skd::Vector3* p, SkdVolumeKernel<Shape>)
{
  bool isMet = false;
  SkdForEachFaceTriangle<Shape>(p,
    [&](const skd::Vector3& a, const skd::Vector3& b, const skd::Vector3& c)
    { isMet = isMet || skd::Overlaps(box, a, b, c); });
  return isMet;
}

/// Whether a box that does not intersect the faces is inside them: by the parity of exact crossings
/// from one of its corners to the outside of the cell's bounds.
template <class Shape>
bool IsInsideOfFaces(const skd::Box3& bounds, const skd::Box3& box, const skd::Vector3* p)
{
  if (!bounds.Contains(box))
  {
    return false;
  }
  const skd::SegmentView view(skd::detail::SegmentOutOf(bounds, box.Min));
  bool isInside = false;
  SkdForEachFaceTriangle<Shape>(p,
    [&](const skd::Vector3& a, const skd::Vector3& b, const skd::Vector3& c)
    {
      const auto hit = view.IsValid() ? skd::Intersect(view, a, b, c) : std::nullopt;
      isInside ^= hit && hit->Passes;
    });
  return isInside;
}

template <class Kernel>
bool OverlapsCell(
  const skd::Box3& box, const skd::Box3&, const skd::Vector3* p, const Kernel& kernel)
{
  return OverlapsSurface(box, p, kernel);
}

template <class Shape>
bool OverlapsCell(const skd::Box3& box, const skd::Box3& bounds, const skd::Vector3* p,
  const SkdVolumeKernel<Shape>& kernel)
{
  return OverlapsSurface(box, p, kernel) || IsInsideOfFaces<Shape>(bounds, box, p);
}

bool OverlapsCell(
  const skd::Box3& box, const skd::Box3& bounds, const skd::Vector3* p, const SkdVoxelKernel&)
{
  return OverlapsCell(box, bounds, p, SkdVolumeKernel<skd::Voxel>());
}

bool OverlapsFaces(const skd::Box3& box, const SkdPolyCell& cell)
{
  bool isMet = false;
  cell.AsPolyhedron().ForEachFace(
    [&](const skd::PolyhedronFace& face)
    {
      skd::ForEachTriangle(face,
        [&](const skd::FaceTriangle& t)
        { isMet = isMet || skd::Overlaps(box, t.Points[0], t.Points[1], t.Points[2]); });
    });
  return isMet;
}

/// Strips, polylines and polyvertices: any of their pieces of `size` points.
bool OverlapsPiece(const skd::Box3& box, const SkdPolyCell& cell, int size)
{
  const skd::Vector3* p = cell.Points;
  const int last = std::min(size, cell.Size) - 1; // a strip of two points is a line
  for (int i = 0; i + last < cell.Size; ++i)
  {
    if (skd::Overlaps(box, p[i], p[i + std::min(last, 1)], p[i + last]))
    {
      return true;
    }
  }
  return false;
}

bool OverlapsSurface(const skd::Box3& box, const SkdPolyCell& cell)
{
  switch (cell.Shape)
  {
    case SkdShape::Polyhedron:
      return OverlapsFaces(box, cell) ||
        skd::Contains(cell.AsPolyhedron(), cell.AsPolyhedron().Bounds(), box.Min);
    case SkdShape::Polygon:
      return skd::OverlapsPolygon(box, cell.Points, cell.Size);
    case SkdShape::Strip:
      return OverlapsPiece(box, cell, 3);
    case SkdShape::PolyLine:
      return OverlapsPiece(box, cell, 2);
    default:
      return OverlapsPiece(box, cell, 1);
  }
}
}

//------------------------------------------------------------------------------
bool SkdCellTree::Overlaps(std::uint32_t cell, const skd::Box3& box) const
{
  const SkdShape shape = this->Store.ShapeOf(cell);
  const skd::Box3 bounds = this->Store.ExtentOf(cell);
  if (!bounds.Overlaps(box) || shape == SkdShape::Generic)
  {
    return bounds.Overlaps(box);
  }
  bool isMet = false;
  const auto test = [&](auto kernel)
  {
    skd::Vector3 points[kernel.Size];
    this->Store.Gather(cell, points);
    isMet = OverlapsCell(box, bounds, points, kernel);
  };
  return SkdVisitKernel(shape, test) ? isMet : OverlapsSurface(box, this->Store.GatherPoly(cell));
}

//------------------------------------------------------------------------------
bool SkdCellTree::IsMet(std::uint32_t cell, const skd::Box3& box, SkdOverlapTest test) const
{
  return test == SkdOverlapTest::Exact ? this->Overlaps(cell, box)
                                       : this->SafetyBoxOf(cell).Overlaps(box);
}

//------------------------------------------------------------------------------
bool SkdCellTree::NarrowCandidates(const SkdCandidateRange& above, const skd::Box3& box,
  SkdOverlapTest test, std::vector<skd::CandidateLanes>& below) const
{
  const auto isMet = [&](std::uint32_t cell) { return this->IsMet(cell, box, test); };
  return this->Lazy ? skd::NarrowCandidates(*this->Lazy, above.First, above.Last, box, isMet, below)
                    : skd::NarrowCandidates(this->View, above.First, above.Last, box, isMet, below);
}

//------------------------------------------------------------------------------
std::uint32_t SkdCellTree::CountListed(
  const SkdCandidateRange& above, const skd::Box3& box, SkdOverlapTest test) const
{
  std::uint32_t count = 0;
  this->VisitCandidates(
    above, box, [&](std::uint32_t cell) { count += this->IsMet(cell, box, test); });
  return count;
}
}
