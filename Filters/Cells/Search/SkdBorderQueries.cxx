// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// Where a segment may pass from one cell to another, and what one cell says of a point.
#include "Cells/Search/SkdCellTree.h"

#include "Cells/Kernels/SkdGenericKernel.h"
#include "Cells/Kernels/SkdKernels.h"
#include "Cells/Kernels/SkdPolyKernels.h"
#include "Cells/Search/SkdCellTreeWalk.h"
#include "Core/Geometry/Cells/LinearShapes.h"
#include "Core/Geometry/Cells/Polyhedron.h"
#include "Core/Geometry/Intersection/SegmentNearTriangle.h"
#include "Core/Geometry/Intersection/SegmentPatch.h"
#include "Core/Search/Queries/AlongSegment.h"

#include <algorithm>

namespace skdtree
{
namespace
{
/// Parameters at which a segment crosses the boundary of a cell: the faces of a volume, and the
/// edges of a surface or ends of a curve near the segment.
class Borders
{
public:
  Borders(const skd::SegmentView& view, double maxDistance, std::vector<double>& parameters)
    : View(view)
    , MaxDistance2(maxDistance * maxDistance)
    , Parameters(parameters)
  {
  }

  void AddEnd(const skd::Vector3& p)
  {
    const skd::Segment<3>& segment = this->View.GetSegment();
    const auto nearest = skd::ClosestPointOnSegment(segment.A, segment.B, p);
    if (nearest.Dist2 <= this->MaxDistance2)
    {
      this->Parameters.push_back(nearest.R);
    }
  }

  void AddEdge(const skd::Vector3& p, const skd::Vector3& q)
  {
    const skd::SegmentPair nearest = skd::ClosestPoints(this->View.GetSegment(), { p, q });
    if (nearest.Dist2 <= this->MaxDistance2)
    {
      this->Parameters.push_back(nearest.T);
    }
    this->AddEnd(p); // of edges along the segment both ends count
    this->AddEnd(q);
  }

  void AddLoop(const skd::Vector3* p, int size)
  {
    for (int i = 0; i < size; ++i)
    {
      this->AddEdge(p[i], p[(i + 1) % size]);
    }
  }

  void AddTriangle(const skd::Vector3& a, const skd::Vector3& b, const skd::Vector3& c)
  {
    if (const auto hit = skd::Intersect(this->View, a, b, c))
    {
      this->Parameters.push_back(hit->T);
    }
  }

  void AddPatch(const skd::Vector3* points)
  {
    const skd::PatchHits hits = skd::IntersectPatch(this->View, points);
    this->Parameters.insert(this->Parameters.end(), hits.T, hits.T + hits.Count);
  }

  template <class Shape>
  void AddFaces(const skd::Vector3* points)
  {
    for (int i = 0; i < Shape::NumberOfFaces; ++i)
    {
      const skd::CellFace<Shape> face(points, i);
      if (face.Size == 4)
      {
        this->AddPatch(face.Points);
      }
      else
      {
        this->AddTriangle(face.Points[0], face.Points[1], face.Points[2]);
      }
    }
  }

  ///@{
  /// What bounds the cells of each kernel.
  void Add(SkdVertexKernel, const skd::Vector3*) {}
  void Add(SkdLineKernel, const skd::Vector3* p)
  {
    this->AddEnd(p[0]);
    this->AddEnd(p[1]);
  }
  void Add(SkdTriangleKernel, const skd::Vector3* p) { this->AddLoop(p, 3); }
  void Add(SkdQuadKernel, const skd::Vector3* p) { this->AddLoop(p, 4); }
  void Add(SkdPixelKernel, const skd::Vector3* p)
  {
    const skd::Vector3 quad[4] = { p[0], p[1], p[3], p[2] };
    this->AddLoop(quad, 4);
  }
  template <class Shape>
  void Add(SkdVolumeKernel<Shape>, const skd::Vector3* p)
  {
    this->AddFaces<Shape>(p);
  }
  ///@}

  void AddPoly(const SkdPolyCell& cell)
  {
    switch (cell.Shape)
    {
      case SkdShape::Polygon:
        this->AddLoop(cell.Points, cell.Size);
        break;
      case SkdShape::Strip:
        for (int i = 0; i + 2 < cell.Size; ++i)
        {
          this->AddLoop(cell.Points + i, 3);
        }
        break;
      case SkdShape::PolyLine:
        std::for_each(
          cell.Points, cell.Points + cell.Size, [&](const skd::Vector3& p) { this->AddEnd(p); });
        break;
      case SkdShape::Polyhedron:
        this->AddPolyhedron(cell.AsPolyhedron());
        break;
      default:
        break;
    }
  }

private:
  void AddPolyhedron(const skd::PolyhedronView& polyhedron)
  {
    polyhedron.ForEachFace(
      [&](const skd::PolyhedronFace& face)
      {
        if (skd::MayCross(this->View, face))
        {
          skd::ForEachTriangle(face,
            [&](const skd::FaceTriangle& triangle)
            {
              const skd::FaceTriangle t = skd::Ordered(triangle);
              this->AddTriangle(t.Points[0], t.Points[1], t.Points[2]);
            });
        }
      });
  }

  const skd::SegmentView& View;
  double MaxDistance2;
  std::vector<double>& Parameters;
};

/// The parameter in (in, out) where isIn(t) changes, by bisection down to adjacent numbers.
template <class IsIn>
double FindTransition(double in, double out, const IsIn& isIn)
{
  for (int step = 0; step < 60; ++step)
  {
    const double middle = 0.5 * (in + out);
    (isIn(middle) ? in : out) = middle;
  }
  return 0.5 * (in + out);
}
}

//------------------------------------------------------------------------------
// Curved cells have no faces in closed form: they are evaluated at points along the segment, and
// where it first hits them from either end.
void SkdCellTree::AddTransitions(std::uint32_t cell, const skd::Segment<3>& segment,
  double maxDistance, const SkdCellSource& source, std::vector<double>& parameters) const
{
  constexpr int Samples = 32;
  const skd::Box3 extent = this->Store.ExtentOf(cell);
  const auto inside = skd::Clip(segment, extent.Inflated(maxDistance));
  if (!inside)
  {
    return;
  }
  const double maxDistance2 = maxDistance * maxDistance;
  const auto isIn = [&](double t)
  { return this->Measure(cell, segment.At(t), maxDistance2, source).Dist2 <= maxDistance2; };
  double last = inside->Min;
  bool wasIn = isIn(last);
  for (int i = 1; i <= Samples; ++i)
  {
    const double next = inside->Min + (inside->Max - inside->Min) * i / Samples;
    const bool isNextIn = isIn(next);
    if (isNextIn != wasIn)
    {
      parameters.push_back(
        wasIn ? FindTransition(last, next, isIn) : FindTransition(next, last, isIn));
    }
    last = next;
    wasIn = isNextIn;
  }
  vtkCell* loaded = source.Load(this->Store.IdOf(cell));
  const auto hit = SkdGenericKernel::Intersect(loaded, extent, segment, 0.0);
  const auto back = SkdGenericKernel::Intersect(loaded, extent, { segment.B, segment.A }, 0.0);
  parameters.insert(parameters.end(), { inside->Min, inside->Max });
  parameters.push_back(hit ? hit->T : inside->Min);
  parameters.push_back(back ? 1.0 - back->T : inside->Max);
}

//------------------------------------------------------------------------------
void SkdCellTree::FindBorders(const skd::Segment<3>& segment, double tolerance,
  const SkdCellSource& source, std::vector<double>& parameters) const
{
  const skd::SegmentView view(segment);
  if (!view.IsValid())
  {
    return;
  }
  parameters.insert(parameters.end(), { 0.0, 1.0 });
  const double maxDistance = tolerance > this->TheRounding ? tolerance : this->TheRounding;
  Borders borders(view, maxDistance, parameters);
  auto visitor = [&](std::uint32_t cell)
  {
    const SkdShape shape = this->Store.ShapeOf(cell);
    const auto add = [&](auto kernel)
    {
      skd::Vector3 points[kernel.Size];
      this->Store.Gather(cell, points);
      borders.Add(kernel, points);
    };
    if (!SkdVisitKernel(shape, add))
    {
      if (shape == SkdShape::Generic)
      {
        this->AddTransitions(cell, segment, maxDistance, source, parameters);
      }
      else
      {
        borders.AddPoly(this->Store.GatherPoly(cell));
      }
    }
    return 1.0;
  };
  skd::AlongSegment<3, decltype(visitor)> query(this->GetFrame(), segment, maxDistance, visitor);
  this->Walk(query);
}

//------------------------------------------------------------------------------
SkdFoundCell SkdCellTree::Evaluate(
  vtkIdType id, const skd::Vector3& x, const SkdCellSource& source) const
{
  SkdFoundCell found;
  const std::int64_t cell = this->Store.CellOfId(id);
  if (cell >= 0 && SkdHasDistances(x))
  {
    constexpr double all = std::numeric_limits<double>::infinity();
    static_cast<SkdCellPoint&>(found) =
      this->Measure(static_cast<std::uint32_t>(cell), x, all, source);
    found.Id = std::isfinite(found.Dist2) ? id : -1;
  }
  return found;
}
}
