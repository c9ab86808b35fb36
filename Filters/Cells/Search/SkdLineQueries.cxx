// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/Search/SkdCellTree.h"

#include "Cells/Kernels/SkdGenericKernel.h"
#include "Cells/Kernels/SkdKernels.h"
#include "Cells/Kernels/SkdPolyKernels.h"
#include "Cells/Search/SkdCellTreeWalk.h"
#include "Cells/Search/SkdMotion.h"
#include "Core/Geometry/Intersection/CrossingDirection.h"
#include "Core/Geometry/Intersection/SegmentNearTriangle.h"
#include "Core/Geometry/Intersection/SegmentPolygon.h"
#include "Core/Search/LeafFilters/TriangleLeafFilters.h"
#include "Core/Search/Queries/AlongSegment.h"
#include "Core/Search/Queries/PacketHits.h"
#include "Core/Search/Queries/TriangleHits.h"

#include "vtkCell.h"
#include "vtkDataSet.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace skdtree
{
namespace
{
bool IsBefore(const SkdHitCell& a, const SkdHitCell& b)
{
  return std::tie(a.T, a.Id) < std::tie(b.T, b.Id);
}

SkdHitCell WithId(const SkdLineHit& hit, vtkIdType id)
{
  SkdHitCell found;
  static_cast<SkdLineHit&>(found) = hit;
  found.Id = id;
  return found;
}

/// The calling thread's list of hits. Found once a query: each access to such a variable is a call.
SKD_NOINLINE std::vector<SkdHitCell>& EmptyList()
{
  thread_local std::vector<SkdHitCell> hits;
  hits.clear();
  return hits;
}

/// A facet of a surface that a segment meets.
struct FacetHit
{
  double T;
  vtkIdType Id;
  bool OnEdge;
  bool Passes;
};

/// What ForEachFacet() passes on.
struct Facet
{
  double T;
  bool OnEdge;
  bool Passes;
};

/// As CrossingDirection(), of a polygon that is passed through.
int DirectionAcross(const skd::Segment<3>& segment, const SkdPolyCell& polygon)
{
  skd::Vector3 area{ { 0.0, 0.0, 0.0 } };
  for (int i = 1; i + 1 < polygon.Size; ++i)
  {
    const skd::Vector3& corner = polygon.Points[0];
    area = area + skd::Cross(polygon.Points[i] - corner, polygon.Points[i + 1] - corner);
  }
  return skd::Dot(area, segment.B - segment.A) < 0.0 ? -1 : 1;
}

/// Facets that share the point of an edge or vertex are one crossing: the parameter there is the
/// same number for all of them (SegmentTriangle.h).
void Merge(std::vector<FacetHit>& facets, SkdCrossings& crossings)
{
  std::sort(facets.begin(), facets.end(),
    [](const FacetHit& a, const FacetHit& b)
    { return std::tie(a.T, b.OnEdge, a.Id) < std::tie(b.T, a.OnEdge, b.Id); });
  for (const FacetHit& facet : facets)
  {
    const bool isSame =
      facet.OnEdge && !crossings.List.empty() && crossings.List.back().T == facet.T;
    if (!isSame)
    {
      const std::size_t first = crossings.Cells.size();
      crossings.List.push_back({ facet.T, first, first, false });
    }
    SkdCrossing& crossing = crossings.List.back();
    crossing.Passes ^= facet.Passes;
    const bool isNew =
      crossings.Cells.size() == crossing.First || crossings.Cells.back() != facet.Id;
    if (isNew)
    {
      crossings.Cells.push_back(facet.Id);
    }
    crossing.Last = crossings.Cells.size();
  }
}
}

//------------------------------------------------------------------------------
/// The triangles of a cell that is a surface, if its shape is one of ours.
template <class Visit>
void SkdCellTree::ForEachTriangle(std::uint32_t cell, Visit visit) const
{
  const std::uint32_t* ids = this->Store.PointIdsOf(cell);
  const std::uint32_t size = this->Store.SizeOf(cell);
  const auto point = [&](std::uint32_t i) { return this->Store.Point(ids[i]); };
  switch (this->Store.ShapeOf(cell))
  {
    case SkdShape::Quad:
    case SkdShape::Pixel:
    {
      const bool isPixel = this->Store.ShapeOf(cell) == SkdShape::Pixel;
      const skd::Vector3 quad[4] = { point(0), point(1), point(isPixel ? 3 : 2),
        point(isPixel ? 2 : 3) };
      for (const auto& triangle : SkdQuadSplit(quad).Triangles)
      {
        visit(quad[triangle[0]], quad[triangle[1]], quad[triangle[2]]);
      }
      return;
    }
    case SkdShape::Strip:
      for (std::uint32_t i = 0; i + 2 < size; ++i)
      {
        visit(point(i), point(i + 1), point(i + 2));
      }
      return;
    case SkdShape::Triangle:
      visit(point(0), point(1), point(2));
      return;
    default:
      return;
  }
}

//------------------------------------------------------------------------------
std::optional<SkdLineHit> SkdCellTree::Hit(std::uint32_t cell, const skd::SegmentView& view,
  double tolerance, const SkdCellSource& source) const
{
  std::optional<SkdLineHit> hit;
  const SkdShape shape = this->Store.ShapeOf(cell);
  const SkdHitTolerance maxDistance{ tolerance, this->TheRounding };
  const auto intersect = [&](auto kernel)
  {
    skd::Vector3 points[kernel.Size];
    this->Store.Gather(cell, points);
    hit = kernel.Intersect(points, view, maxDistance);
  };
  if (SkdVisitKernel(shape, intersect))
  {
    return hit;
  }
  if (shape != SkdShape::Generic)
  {
    return SkdPolyKernels::Intersect(this->Store.GatherPoly(cell), view, maxDistance);
  }
  return SkdGenericKernel::Intersect(
    source.Load(this->Store.IdOf(cell)), this->Store.ExtentOf(cell), view.GetSegment(), tolerance);
}

//------------------------------------------------------------------------------
template <bool InOrder, class Visitor>
void SkdCellTree::WalkAlong(const skd::Segment<3>& segment, double margin, Visitor& visitor) const
{
  const auto wide = [&](const SkdWideTree& tree)
  { SkdWideWalks::AlongSegment(tree, &segment, margin, InOrder, SkdWideVisitor::Of(visitor)); };
  // Walks that are inlined would take their stacks from all that calls them.
  const auto narrow = [&]() SKD_NOINLINE
  {
    using LeafFilter = skd::LineLeafFilter<false>;
    const skd::Shear shear(segment.B - segment.A);
    skd::AlongSegment<3, Visitor, LeafFilter, InOrder> query(
      this->GetFrame(), segment, margin, visitor, this->Packets, shear);
    this->Walk(query);
  };
  if (!this->WalkWide(wide))
  {
    narrow();
  }
}

//------------------------------------------------------------------------------
template <bool InOrder, class Visitor>
bool SkdCellTree::VisitTriangleHits(
  const skd::Segment<3>& segment, double tolerance, Visitor& visitor) const
{
  if (!this->Packets.HavePoints())
  {
    return false;
  }
  const auto wide = [&](const SkdWideTree& tree)
  {
    SkdWideWalks::VisitTriangleHits(
      tree, &segment, tolerance, InOrder, SkdWideHits::Of<skd::TriangleHit>(visitor));
  };
  const auto narrow = [&]() SKD_NOINLINE
  { skd::VisitTriangleHits<InOrder>(this->View, this->Packets, segment, tolerance, visitor); };
  if (!this->WalkWide(wide))
  {
    narrow();
  }
  return true;
}

//------------------------------------------------------------------------------
// A packet gains while its lines are about a leaf apart: rows of 8 lines of a picture took 0.73 of
// the time of single ones where they were 60 over the root of the number of cells apart, in the
// frame (bunny, 7 * 10^4), 0.83 at 100 and 1.07 at 200 (dragon, 9 * 10^5).
double SkdCellTree::MaxSpreadOfLines() const
{
  return 64.0 / (std::sqrt(this->Store.NumberOfCells()) * this->GetFrame().Scale);
}

bool SkdCellTree::AreAlike(const skd::Segment<3>* segments, int count) const
{
  const SkdCellTree& tree = this->WithoutEqual();
  return tree.Packets.HavePoints() &&
    skd::LinePacket::AreAlike(segments, count, tree.MaxSpreadOfLines());
}

template <bool InOrder, class Visitor>
bool SkdCellTree::VisitPacketHits(
  const skd::Segment<3>* segments, int count, double tolerance, Visitor& visitor) const
{
  if (count < 2 || !this->Packets.HavePoints())
  {
    return false;
  }
  static_assert(SkdLinesAtOnce <= skd::LinePacket::Width);
  const double maxDistance = std::max(tolerance, 0.0);
  const double maxSpread = this->MaxSpreadOfLines();
  bool areAlike = false;
  const auto wide = [&](const SkdWideTree& tree)
  {
    areAlike = SkdWideWalks::VisitPacketHits(tree, segments, count, maxSpread, maxDistance, InOrder,
      SkdWidePacketHits::Of<skd::TriangleHit>(visitor));
  };
  if (!this->WalkWide(wide))
  {
    areAlike = skd::VisitPacketHits<InOrder>(
      this->View, this->Packets, segments, count, maxSpread, maxDistance, visitor);
  }
  return areAlike;
}

bool SkdCellTree::FindFirstHits(
  const skd::Segment<3>* segments, int count, double tolerance, SkdHitCell* firsts) const
{
  if (this->Distinct)
  {
    return this->Distinct->FindFirstHits(segments, count, tolerance, firsts);
  }
  auto take = [&](int line, std::uint32_t cell, const skd::TriangleHit& hit)
  {
    const SkdHitCell found = WithId(SkdTriangleKernel::From(hit), this->Store.IdOf(cell));
    if (firsts[line].Id < 0 || IsBefore(found, firsts[line]))
    {
      firsts[line] = found;
    }
    return firsts[line].T;
  };
  return this->VisitPacketHits<true>(segments, count, tolerance, take);
}

//------------------------------------------------------------------------------
SkdHitCell SkdCellTree::FindFirstHit(
  const skd::Segment<3>& segment, double tolerance, const SkdCellSource& source) const
{
  const SkdCellTree& tree = this->WithoutEqual();
  SkdHitCell first;
  const double maxDistance = std::max(tolerance, 0.0);
  const auto take = [&](std::uint32_t cell, const SkdLineHit& hit)
  {
    const SkdHitCell found = WithId(hit, tree.Store.IdOf(cell));
    if (first.Id < 0 || IsBefore(found, first))
    {
      first = found;
    }
    return first.T;
  };
  auto takeTriangle = [&](std::uint32_t cell, const skd::TriangleHit& hit)
  { return take(cell, SkdTriangleKernel::From(hit)); };
  if (tree.VisitTriangleHits<true>(segment, maxDistance, takeTriangle))
  {
    return first;
  }
  const skd::SegmentView view(segment);
  if (!view.IsValid())
  {
    return first;
  }
  auto visitor = [&](std::uint32_t cell)
  {
    const auto hit = tree.Hit(cell, view, maxDistance, source);
    return hit ? take(cell, *hit) : (first.Id < 0 ? 1.0 : first.T);
  };
  tree.WalkAlong<true>(segment, maxDistance, visitor);
  return first;
}

//------------------------------------------------------------------------------
const std::vector<SkdHitCell>& SkdCellTree::FindHits(
  const skd::Segment<3>& segment, double tolerance, const SkdCellSource& source) const
{
  std::vector<SkdHitCell>& hits = EmptyList();
  const double maxDistance = std::max(tolerance, 0.0);
  auto takeTriangle = [&](std::uint32_t cell, const skd::TriangleHit& hit)
  {
    hits.push_back(WithId(SkdTriangleKernel::From(hit), this->Store.IdOf(cell)));
    return 1.0;
  };
  if (!this->VisitTriangleHits<false>(segment, maxDistance, takeTriangle))
  {
    const skd::SegmentView view(segment);
    auto visitor = [&](std::uint32_t cell)
    {
      if (const auto hit = this->Hit(cell, view, maxDistance, source))
      {
        hits.push_back(WithId(*hit, this->Store.IdOf(cell)));
      }
      return 1.0;
    };
    if (view.IsValid())
    {
      this->WalkAlong<false>(segment, maxDistance, visitor);
    }
  }
  std::sort(hits.begin(), hits.end(), IsBefore);
  return hits;
}

//------------------------------------------------------------------------------
const std::vector<SkdHitOfLine>* SkdCellTree::FindHitsOfLines(
  const skd::Segment<3>* segments, int count, double tolerance) const
{
  thread_local std::vector<SkdHitOfLine> list;
  std::vector<SkdHitOfLine>& hits = list; // found once, as that of EmptyList()
  hits.clear();
  auto take = [&](int line, std::uint32_t cell, const skd::TriangleHit& hit)
  {
    hits.push_back({ line, SkdTriangleKernel::From(hit).T, this->Store.IdOf(cell) });
    return 1.0;
  };
  if (!this->VisitPacketHits<false>(segments, count, tolerance, take))
  {
    return nullptr;
  }
  std::sort(hits.begin(), hits.end(),
    [](const SkdHitOfLine& a, const SkdHitOfLine& b)
    { return std::tie(a.Line, a.T, a.Id) < std::tie(b.Line, b.T, b.Id); });
  return &hits;
}

//------------------------------------------------------------------------------
const std::vector<SkdHitCell>& SkdCellTree::FindBoundsHits(
  const skd::Segment<3>& segment, double tolerance, const skd::RigidMotion* motion) const
{
  std::vector<SkdHitCell>& hits = EmptyList();
  const double maxDistance = std::max(tolerance, 0.0);
  const auto clip = [&](std::uint32_t cell)
  {
    const skd::Box3 bounds = this->WorldBoundsOf(cell, motion).Inflated(maxDistance);
    if (const auto inside = skd::Clip(segment, bounds))
    {
      hits.push_back(WithId({ inside->Min, { { 0.0, 0.0, 0.0 } } }, this->Store.IdOf(cell)));
    }
  };
  if (motion)
  {
    skd::Box3 around;
    around.Add(segment.A);
    around.Add(segment.B);
    this->ForEachNear(around.Inflated(maxDistance), *motion, clip);
  }
  else
  {
    auto visitor = [&](std::uint32_t cell)
    {
      clip(cell);
      return 1.0;
    };
    skd::AlongSegment<3, decltype(visitor), skd::NoLeafFilter, false> query(
      this->GetFrame(), segment, maxDistance, visitor);
    this->Walk(query);
  }
  std::sort(hits.begin(), hits.end(), IsBefore);
  return hits;
}

//------------------------------------------------------------------------------
/// Calls take(cell, hit, way) for each facet of a surface that the segment hits: way() returns the
/// direction through the facet, see CrossingDirection().
template <class Take>
void SkdCellTree::ForEachFacet(
  const skd::Segment<3>& segment, const SkdCellSource& source, const Take& take) const
{
  auto takeTriangle = [&](std::uint32_t cell, const skd::TriangleHit& hit)
  {
    const auto point = [&](int i) { return this->Store.Point(this->Store.PointIdsOf(cell)[i]); };
    take(cell, Facet{ hit.T, hit.OnEdge, hit.Passes },
      [&]
      { return skd::CrossingDirection(skd::SegmentView(segment), point(0), point(1), point(2)); });
    return 1.0;
  };
  if (this->VisitTriangleHits<false>(segment, 0.0, takeTriangle))
  {
    return;
  }
  const skd::SegmentView view(segment);
  auto visitor = [&](std::uint32_t cell)
  {
    if (this->Store.ShapeOf(cell) == SkdShape::Generic)
    {
      vtkCell* loaded = source.Load(this->Store.IdOf(cell));
      const bool isSurface = loaded->GetCellDimension() == 2;
      const auto hit = isSurface
        ? SkdGenericKernel::Intersect(loaded, this->Store.ExtentOf(cell), segment, 0.0)
        : std::nullopt;
      if (hit)
      {
        take(cell, Facet{ hit->T, false, true }, [] { return 0; });
      }
      return 1.0;
    }
    if (this->Store.ShapeOf(cell) == SkdShape::Polygon)
    {
      const SkdPolyCell polygon = this->Store.GatherPoly(cell);
      if (const auto hit = skd::Intersect(view, polygon.Points, polygon.Size))
      {
        take(cell, Facet{ hit->T, hit->OnEdge, hit->Passes },
          [&] { return hit->Passes ? DirectionAcross(segment, polygon) : 0; });
      }
      return 1.0;
    }
    this->ForEachTriangle(cell,
      [&](const skd::Vector3& a, const skd::Vector3& b, const skd::Vector3& c)
      {
        if (const auto hit = skd::Intersect(view, a, b, c))
        {
          take(cell, Facet{ hit->T, hit->OnEdge, hit->Passes },
            [&] { return skd::CrossingDirection(view, a, b, c); });
        }
      });
    return 1.0;
  };
  if (view.IsValid())
  {
    this->WalkAlong<false>(segment, 0.0, visitor);
  }
}

//------------------------------------------------------------------------------
const SkdCrossings& SkdCellTree::FindCrossings(
  const skd::Segment<3>& segment, const SkdCellSource& source) const
{
  thread_local SkdCrossings crossings;
  thread_local std::vector<FacetHit> kept;
  std::vector<FacetHit>& facets = kept; // found once, as that of EmptyList()
  crossings.List.clear();
  crossings.Cells.clear();
  facets.clear();
  this->ForEachFacet(segment, source,
    [&](std::uint32_t cell, const Facet& hit, const auto&) {
      facets.push_back({ hit.T, this->Store.IdOf(cell), hit.OnEdge, hit.Passes });
    });
  Merge(facets, crossings);
  return crossings;
}

//------------------------------------------------------------------------------
const std::vector<SkdPass>& SkdCellTree::FindPasses(
  const skd::Segment<3>& segment, const SkdCellSource& source) const
{
  thread_local std::vector<SkdPass> kept;
  std::vector<SkdPass>& passes = kept; // found once, as that of EmptyList()
  passes.clear();
  this->ForEachFacet(segment, source,
    [&](std::uint32_t cell, const Facet& hit, const auto& sideOfPass)
    {
      if (hit.Passes)
      {
        passes.push_back({ hit.T, this->Store.IdOf(cell), sideOfPass() });
      }
    });
  std::sort(passes.begin(), passes.end(),
    [](const SkdPass& a, const SkdPass& b) { return std::tie(a.T, a.Id) < std::tie(b.T, b.Id); });
  return passes;
}
}
