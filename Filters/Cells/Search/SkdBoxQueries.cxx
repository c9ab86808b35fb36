// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/Search/SkdCellTree.h"

#include "Cells/Search/SkdCellTreeWalk.h"
#include "Cells/Search/SkdMotion.h"
#include "Core/Geometry/Distance/Distance.h"
#include "Core/Search/Queries/AlongSegment.h"
#include "Core/Search/Queries/Nearest.h"
#include "Core/Search/Queries/OverlappingBox.h"
#include "Core/Search/Queries/WithinBox.h"
#include "Core/Search/Queries/WithinSlabs.h"

#include "vtkIdList.h"

#include <algorithm>

namespace skdtree
{
namespace
{
/// Of searches by distance: distances of boxes, which may be those of corners on a grid, say
/// nothing about what comes first.
void Sort(vtkIdList* ids)
{
  vtkIdType* const first = ids->GetPointer(0);
  std::sort(first, first + ids->GetNumberOfIds());
}

bool IsUsable(const skd::Plane<3>& plane)
{
  return skd::IsFinite(plane.Origin) && skd::IsFinite(plane.Normal);
}
}

//------------------------------------------------------------------------------
skd::Box3 SkdCellTree::WorldBoundsOf(std::uint32_t cell, const skd::RigidMotion* motion) const
{
  if (!motion)
  {
    return this->Store.BoundsOf(cell);
  }
  skd::Box3 bounds;
  const std::uint32_t* ids = this->Store.PointIdsOf(cell);
  const std::uint32_t size = this->Store.SizeOf(cell);
  for (std::uint32_t i = 0; i < size; ++i)
  {
    bounds.Add(motion->Forward(this->Store.Point(ids[i])));
  }
  return bounds;
}

//------------------------------------------------------------------------------
bool SkdCellTree::BoundsHold(
  const skd::Vector3& x, vtkIdType id, double tolerance, const skd::RigidMotion* motion) const
{
  const std::int64_t cell = this->Store.CellOfId(id);
  if (cell < 0)
  {
    return false;
  }
  const skd::Box3 bounds = this->WorldBoundsOf(static_cast<std::uint32_t>(cell), motion);
  return bounds.Inflated(std::max(tolerance, 0.0)).Contains(x);
}

//------------------------------------------------------------------------------
void SkdCellTree::FindWithinBounds(
  const skd::Box3& box, const skd::RigidMotion* motion, vtkIdList* ids) const
{
  ids->Reset();
  if (box.IsEmpty())
  {
    return;
  }
  auto visitor = [&](std::uint32_t cell)
  {
    if (this->WorldBoundsOf(cell, motion).Overlaps(box))
    {
      ids->InsertNextId(this->Store.IdOf(cell));
    }
    return true;
  };
  if (motion)
  {
    this->ForEachNear(box, *motion, visitor);
    return;
  }
  // Safety boxes of curved cells are larger than those of their points, so nothing can be concluded
  // from the latter.
  auto sure = [&](std::uint32_t cell)
  {
    if (this->Store.ShapeOf(cell) == SkdShape::Generic)
    {
      return visitor(cell);
    }
    ids->InsertNextId(this->Store.IdOf(cell));
    return true;
  };
  const double excess = this->BoxExcess();
  const auto wide = [&](const SkdWideTree& tree)
  {
    SkdWideWalks::OverlappingBox(
      tree, &box, excess, SkdWideVisitor::Of(visitor), SkdWideVisitor::Of(sure));
  };
  if (!this->WalkWide(wide))
  {
    skd::OverlappingBox<3, decltype(visitor), decltype(sure)> query(
      this->GetFrame(), box, excess, visitor, sure);
    this->Walk(query);
  }
}

//------------------------------------------------------------------------------
void SkdCellTree::FindAlongPlane(const skd::Plane<3>& plane, double tolerance,
  const skd::RigidMotion* motion, vtkIdList* ids) const
{
  ids->Reset();
  if (!IsUsable(plane))
  {
    return;
  }
  const double maxDistance = std::max(tolerance, 0.0);
  auto visitor = [&](std::uint32_t cell)
  {
    if (skd::Overlaps(plane, this->WorldBoundsOf(cell, motion), maxDistance))
    {
      ids->InsertNextId(this->Store.IdOf(cell));
    }
    return true;
  };
  const skd::Frame<3>& frame = this->GetFrame();
  const skd::Slab<3> slab = motion ? SkdSlabBeforeMotion(frame, plane, maxDistance, *motion)
                                   : skd::Slab<3>(frame, plane, maxDistance);
  skd::WithinSlabs<3, 1, decltype(visitor)> query({ slab }, visitor);
  this->Walk(query);
}

//------------------------------------------------------------------------------
// A reference point is trusted only as far as an element's box that holds it: the farthest point of
// that box bounds the nearest distance, wherever the reference point came from.
void SkdCellTree::FindNearestCandidates(
  const skd::Vector3& x, const skd::Vector3* reference, vtkIdList* ids) const
{
  ids->Reset();
  if (!SkdHasDistances(x))
  {
    return;
  }
  double known2 = std::numeric_limits<double>::max();
  if (reference && skd::IsFinite(*reference))
  {
    auto bound = [&](std::uint32_t cell)
    {
      known2 = std::min(known2, skd::MaxDistance2(x, this->SafetyBoxOf(cell)));
      return true;
    };
    skd::WithinBox<3, decltype(bound)> atReference(
      this->GetFrame(), skd::Box3(*reference, *reference), bound);
    this->Walk(atReference);
  }
  thread_local std::vector<std::uint32_t> found;
  found.clear();
  auto visitor = [&](std::uint32_t cell)
  {
    found.push_back(cell);
    known2 = std::min(known2, skd::MaxDistance2(x, this->SafetyBoxOf(cell)));
  };
  skd::NearestCandidates<3, decltype(visitor)> query(this->GetFrame(), x, known2, visitor);
  this->Walk(query);
  for (const std::uint32_t cell : found)
  {
    if (skd::MinDistance2(x, this->SafetyBoxOf(cell)) <= known2)
    {
      ids->InsertNextId(this->Store.IdOf(cell));
    }
  }
  Sort(ids);
}

//------------------------------------------------------------------------------
void SkdCellTree::FindSafetyBoxesAlong(const skd::Segment<3>& segment, vtkIdList* ids) const
{
  ids->Reset();
  auto visitor = [&](std::uint32_t cell)
  {
    if (skd::Clip(segment, this->SafetyBoxOf(cell)))
    {
      ids->InsertNextId(this->Store.IdOf(cell));
    }
    return 1.0;
  };
  skd::AlongSegment<3, decltype(visitor), skd::NoLeafFilter, false> query(
    this->GetFrame(), segment, 0.0, visitor);
  this->Walk(query);
}

//------------------------------------------------------------------------------
void SkdCellTree::FindSafetyBoxesWithin(const skd::Box3& box, vtkIdList* ids) const
{
  ids->Reset();
  if (box.IsEmpty())
  {
    return;
  }
  auto visitor = [&](std::uint32_t cell)
  {
    if (this->SafetyBoxOf(cell).Overlaps(box))
    {
      ids->InsertNextId(this->Store.IdOf(cell));
    }
    return true;
  };
  skd::WithinBox<3, decltype(visitor)> query(this->GetFrame(), box, visitor);
  this->Walk(query);
}

//------------------------------------------------------------------------------
void SkdCellTree::FindSafetyBoxesWithin(const skd::Vector3& x, double radius, vtkIdList* ids) const
{
  ids->Reset();
  if (!SkdHasDistances(x) || !(radius >= 0.0))
  {
    return;
  }
  const double radius2 = radius * radius;
  auto visitor = [&](std::uint32_t cell)
  {
    if (skd::MinDistance2(x, this->SafetyBoxOf(cell)) <= radius2)
    {
      ids->InsertNextId(this->Store.IdOf(cell));
    }
    return radius2;
  };
  skd::Nearest<3, decltype(visitor)> query(this->GetFrame(), x, radius2, visitor);
  this->Walk(query);
  Sort(ids);
}

//------------------------------------------------------------------------------
void SkdCellTree::FindSafetyBoxesAlong(
  const skd::Plane<3>& plane, double tolerance, vtkIdList* ids) const
{
  ids->Reset();
  if (!IsUsable(plane))
  {
    return;
  }
  auto visitor = [&](std::uint32_t cell)
  {
    if (skd::Overlaps(plane, this->SafetyBoxOf(cell), tolerance))
    {
      ids->InsertNextId(this->Store.IdOf(cell));
    }
    return true;
  };
  skd::AlongPlane<3, decltype(visitor)> query(this->GetFrame(), plane, tolerance, visitor);
  this->Walk(query);
}

//------------------------------------------------------------------------------
void SkdCellTree::FindMaybeWithin(const skd::Box3& box, std::vector<std::uint32_t>& cells) const
{
  if (box.IsEmpty())
  {
    return;
  }
  auto visitor = [&](std::uint32_t cell)
  {
    cells.push_back(cell);
    return true;
  };
  skd::WithinBox<3, decltype(visitor)> query(this->GetFrame(), box, visitor);
  this->Walk(query);
}

//------------------------------------------------------------------------------
void SkdCellTree::FindMaybeWithin(
  const skd::Vector3& x, double radius, std::vector<std::uint32_t>& cells) const
{
  if (!SkdHasDistances(x) || !(radius >= 0.0))
  {
    return;
  }
  const double radius2 = radius * radius;
  auto visitor = [&](std::uint32_t cell)
  {
    cells.push_back(cell);
    return radius2;
  };
  skd::Nearest<3, decltype(visitor)> query(this->GetFrame(), x, radius2, visitor);
  this->Walk(query);
}
}
