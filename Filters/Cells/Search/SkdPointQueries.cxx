// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/Search/SkdCellTree.h"

#include "Cells/Kernels/SkdGenericKernel.h"
#include "Cells/Kernels/SkdKernels.h"
#include "Cells/Kernels/SkdPolyKernels.h"
#include "Cells/Search/SkdCellTreeWalk.h"
#include "Core/Search/LeafFilters/PlaneLeafFilter.h"
#include "Core/Search/LeafFilters/TriangleLeafFilters.h"
#include "Core/Search/Queries/Nearest.h"
#include "Core/Search/Queries/WithinBox.h"

#include <algorithm>

namespace skdtree
{
namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();

/// Whether SkdWideWalks::ClosestPointInCell has the kernel's shape.
template <class Kernel>
constexpr bool IsWide = false;
template <>
constexpr bool IsWide<SkdVolumeKernel<skd::Pyramid>> = true;
template <>
constexpr bool IsWide<SkdVolumeKernel<skd::Wedge>> = true;
template <>
constexpr bool IsWide<SkdVolumeKernel<skd::Hexahedron>> = true;

/// Takes a candidate over if it is nearer, or as near with a lower id.
class BestCell
{
public:
  explicit BestCell(double limit2)
    : Limit2(limit2)
  {
  }

  bool CouldTake(vtkIdType id) const
  {
    return this->Limit2 > 0.0 || this->Found.Id < 0 || id < this->Found.Id;
  }

  void Offer(vtkIdType id, const SkdCellPoint& point)
  {
    const bool isTie = point.Dist2 == this->Limit2 && (this->Found.Id < 0 || id < this->Found.Id);
    if (point.Dist2 < this->Limit2 || isTie)
    {
      static_cast<SkdCellPoint&>(this->Found) = point;
      this->Found.Id = id;
      this->Limit2 = point.Dist2;
    }
  }

  double Limit2;
  SkdFoundCell Found;
};
}

//------------------------------------------------------------------------------
SkdCellPoint SkdCellTree::Measure(
  std::uint32_t cell, const skd::Vector3& x, double limit2, const SkdCellSource& source) const
{
  SkdCellPoint found;
  const auto measure = [&](auto kernel)
  {
    skd::Vector3 points[kernel.Size];
    if constexpr (IsWide<decltype(kernel)>)
    {
      if (SkdWideWalks::AreOn())
      {
        skd::VolumePoint nearest;
        SkdWideWalks::ClosestPointInCell(kernel.Size, &this->Store.AllPoints(),
          this->Store.PointIdsOf(cell), x.X, limit2, points, &nearest);
        found = kernel.From(points, x, nearest);
        return;
      }
    }
    this->Store.Gather(cell, points);
    found = kernel.Closest(points, x, limit2);
  };
  const SkdShape shape = this->Store.ShapeOf(cell);
  if (SkdVisitKernel(shape, measure))
  {
    return found;
  }
  if (this->Runs.Has(cell))
  {
    return this->Runs.Closest(this->Store, cell, x, limit2);
  }
  return shape == SkdShape::Generic
    ? SkdGenericKernel::Closest(source.Load(this->Store.IdOf(cell)), x, limit2)
    : SkdPolyKernels::Closest(this->Store.GatherPoly(cell), x, limit2);
}

//------------------------------------------------------------------------------
template <bool OnlyNearest, class Visitor>
void SkdCellTree::WalkNearest(const skd::Vector3& x, double limit2, Visitor& visitor) const
{
  const auto wide = [&](const SkdWideTree& tree)
  { SkdWideWalks::Nearest(tree, x.X, limit2, OnlyNearest, SkdWideVisitor::Of(visitor)); };
  if (!this->WalkWide(wide))
  {
    using LeafFilter = skd::DistanceLeafFilter<OnlyNearest>;
    skd::Nearest<3, Visitor, LeafFilter> query(
      this->GetFrame(), x, limit2, visitor, LeafFilter(this->Packets, this->GetFrame().Local(x)));
    this->Walk(query);
  }
}

//------------------------------------------------------------------------------
SkdFoundCell SkdCellTree::FindNearest(
  const skd::Vector3& x, double limit2, const SkdCellSource& source) const
{
  if (this->Distinct)
  {
    return this->Distinct->FindNearest(x, limit2, source);
  }
  BestCell best(limit2);
  if (!SkdHasDistances(x) || !(limit2 >= 0.0))
  {
    return best.Found;
  }
  auto visitor = [&](std::uint32_t cell)
  {
    const vtkIdType id = this->Store.IdOf(cell);
    if (best.CouldTake(id))
    {
      best.Offer(id, this->Measure(cell, x, best.Limit2, source));
    }
    return best.Limit2;
  };
  this->WalkNearest<true>(x, limit2, visitor);
  return best.Found;
}

//------------------------------------------------------------------------------
SkdFoundCell SkdCellTree::FindContaining(
  const skd::Vector3& x, double tolerance2, vtkIdType hint, const SkdCellSource& source) const
{
  const double rounding2 = this->TheRounding * this->TheRounding;
  BestCell best(tolerance2 > rounding2 ? tolerance2 : rounding2);
  if (!SkdHasDistances(x))
  {
    return best.Found;
  }
  const auto offer = [&](std::uint32_t cell, vtkIdType id)
  {
    SkdCellPoint point = this->Measure(cell, x, best.Limit2, source);
    point.Dist2 = point.Dist2 <= rounding2 ? 0.0 : point.Dist2;
    best.Offer(id, point);
  };
  const std::int64_t hinted = hint < 0 ? -1 : this->Store.CellOfId(hint);
  if (hinted >= 0 && this->SafetyBoxOf(static_cast<std::uint32_t>(hinted)).Contains(x))
  {
    offer(static_cast<std::uint32_t>(hinted), hint);
    if (best.Limit2 == 0.0)
    {
      return best.Found;
    }
  }
  if (this->Distinct)
  {
    return this->Distinct->FindContaining(x, tolerance2, -1, source);
  }
  auto tryCell = [&](std::uint32_t cell)
  {
    const vtkIdType id = this->Store.IdOf(cell);
    if (best.CouldTake(id))
    {
      offer(cell, id);
    }
    return best.Limit2;
  };
  if (best.Limit2 <= rounding2)
  {
    // Only boxes that hold x matter, in any order; safety boxes are wider than rounding.
    const skd::PlanePackets& planes = this->LeafFilters.GetPlanes();
    const auto wide = [&](const SkdWideTree& tree)
    { SkdWideWalks::AboutPoint(tree, &planes, x.X, SkdWideVisitor::Of(tryCell)); };
    if (!this->WalkWide(wide))
    {
      using LeafFilter = skd::PlaneLeafFilter;
      auto visitor = [&](std::uint32_t cell) { return tryCell(cell) >= 0.0; };
      const skd::Vector3 local = this->GetFrame().Local(x);
      skd::WithinBox<3, decltype(visitor), LeafFilter> query(
        local, visitor, LeafFilter(planes, local));
      this->Walk(query);
    }
    return best.Found;
  }
  // No bounds from above: cells within rounding are as near as the nearest.
  this->WalkNearest<false>(x, best.Limit2, tryCell);
  return best.Found;
}

//------------------------------------------------------------------------------
std::vector<std::pair<double, vtkIdType>>& SkdCellTree::FindNearestCells(
  const skd::Vector3& x, std::size_t number, double limit2, const SkdCellSource& source) const
{
  thread_local std::vector<std::pair<double, vtkIdType>> kept;
  auto& heap = kept; // the farthest on top; found once: each access to `kept` is a call
  heap.clear();
  if (!SkdHasDistances(x) || !(limit2 >= 0.0) || number == 0)
  {
    return heap;
  }
  const auto limit = [&]() { return heap.size() < number ? limit2 : heap.front().first; };
  const auto offer = [&](double dist2, std::uint32_t cell)
  {
    const std::pair<double, vtkIdType> candidate(dist2, this->Store.IdOf(cell));
    if (!(dist2 <= limit()) || (heap.size() == number && !(candidate < heap.front())))
    {
      return false;
    }
    if (heap.size() == number)
    {
      std::pop_heap(heap.begin(), heap.end());
      heap.pop_back();
    }
    heap.push_back(candidate);
    std::push_heap(heap.begin(), heap.end());
    return true;
  };
  const SkdCellTree& tree = this->WithoutEqual();
  auto visitor = [&](std::uint32_t cell)
  {
    const double dist2 = tree.Measure(cell, x, limit(), source).Dist2;
    if (this->Equal)
    {
      this->Equal->VisitGroup(cell, [&](std::uint32_t one) { return offer(dist2, one); });
    }
    else
    {
      offer(dist2, cell);
    }
    return limit();
  };
  tree.WalkNearest<false>(x, limit2, visitor);
  std::sort_heap(heap.begin(), heap.end());
  return heap;
}

//------------------------------------------------------------------------------
void SkdCellTree::Interpolate(
  SkdFoundCell& found, double* weights, const SkdCellSource& source) const
{
  const std::int64_t cell = this->Store.CellOfId(found.Id);
  if (cell < 0)
  {
    return;
  }
  const auto weigh = [&](auto kernel)
  {
    if (weights)
    {
      kernel.Weights(found.PCoords, weights);
    }
  };
  const SkdShape shape = this->Store.ShapeOf(static_cast<std::uint32_t>(cell));
  if (SkdVisitKernel(shape, weigh))
  {
    return;
  }
  if (shape != SkdShape::Generic)
  {
    SkdPolyKernels::Locate(
      this->Store.GatherPoly(static_cast<std::uint32_t>(cell)), found, weights);
  }
  else
  {
    SkdGenericKernel::Locate(
      source.Load(found.Id), found.Point, found.SubId, found.PCoords, weights);
  }
}

//------------------------------------------------------------------------------
skd::Vector3 SkdCellTree::PCoordsAfter(const skd::RigidMotion& motion, vtkIdType id,
  const skd::Vector3& x, const skd::Vector3& pcoords) const
{
  const std::int64_t found = this->Store.CellOfId(id);
  if (found < 0)
  {
    return pcoords;
  }
  const auto cell = static_cast<std::uint32_t>(found);
  return this->Store.ShapeOf(cell) == SkdShape::Polyhedron
    ? SkdPolyKernels::PCoordsInBounds(this->WorldBoundsOf(cell, &motion), x)
    : pcoords;
}
}
