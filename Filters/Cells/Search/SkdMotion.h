// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Queries for the bounds of cells after a rigid motion, on the tree before it. The bounds of a
/// rotated box extend beyond the box, so slabs with larger weights are used.
#ifndef SkdMotion_h
#define SkdMotion_h

#include "Cells/Search/SkdCellTreeWalk.h"
#include "Core/Search/Queries/WithinSlabs.h"

namespace skdtree
{
inline skd::Vector3 SkdAbsolutesOf(const skd::Vector3& row)
{
  return { { std::abs(row[0]), std::abs(row[1]), std::abs(row[2]) } };
}

/// The plane and the reach for boxes before the motion that correspond to bounds after it.
inline skd::Slab<3> SkdSlabBeforeMotion(const skd::Frame<3>& frame, const skd::Plane<3>& plane,
  double halfWidth, const skd::RigidMotion& motion)
{
  skd::Vector3 weights{ { 0.0, 0.0, 0.0 } };
  for (int i = 0; i < 3; ++i)
  {
    weights = weights + std::abs(plane.Normal[i]) * SkdAbsolutesOf(motion.Rows[i]);
  }
  const skd::Plane<3> before{ motion.Back(plane.Origin), motion.RotateBack(plane.Normal) };
  return skd::Slab<3>(frame, before, halfWidth, weights);
}

inline std::array<skd::Slab<3>, 3> SkdSlabsBeforeMotion(
  const skd::Frame<3>& frame, const skd::Box3& box, const skd::RigidMotion& motion)
{
  std::array<skd::Slab<3>, 3> slabs;
  for (int axis = 0; axis < 3; ++axis)
  {
    skd::Plane<3> middle{ box.Centroid(), { { 0.0, 0.0, 0.0 } } };
    middle.Normal[axis] = 1.0;
    slabs[static_cast<std::size_t>(axis)] =
      SkdSlabBeforeMotion(frame, middle, 0.5 * box.Length(axis), motion);
  }
  return slabs;
}

/// Calls visit(cell) for every cell whose bounds after the motion may overlap the box.
template <class Visit>
void SkdCellTree::ForEachNear(
  const skd::Box3& box, const skd::RigidMotion& motion, Visit visit) const
{
  auto visitor = [&visit](std::uint32_t cell)
  {
    visit(cell);
    return true;
  };
  skd::WithinSlabs<3, 3, decltype(visitor)> query(
    SkdSlabsBeforeMotion(this->GetFrame(), box, motion), visitor);
  this->Walk(query);
}
}

#endif
