// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdTiedNearest_h
#define SkdTiedNearest_h

#include "Core/Geometry/Vector.h"
#include "Pipeline/SkdSourceTrees.h"

#include <array>
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <vector>

namespace skdtree
{
/// Nearest points of a surface to centres of spheres, where much of the surface may be equally far:
/// in the middle of a ball all of it is, and a query by a tree looks at all cells.
///
/// How many cells a query would look at is estimated from a sample of the surface's points. Where
/// these are many, and a quarter of all, the nearest point to a point of a lattice close by, at
/// most a thousandth of the radius away along each axis, stands for it: centres that are so close
/// together share one query. That point is farther than the nearest one by at most twice the
/// distance of centre and lattice point. Elsewhere queries are exact. Answers do not depend on the
/// order of queries, points or cells, or on threads.
class SkdTiedNearest
{
public:
  SkdTiedNearest(const SkdSourceTrees& trees, int blocks);

  /// Whether a query would look at many cells. Costs 128 distances. Thread-safe.
  bool AreMany(const skd::Vector3& centre, double radius) const;

  ///@{
  /// The nearest point within a radius of a centre: exact, or as described. Thread-safe.
  std::optional<SkdNearest> FindExact(const skd::Vector3& centre, double radius) const
  {
    return this->Trees.FindNearest(centre.X, radius);
  }
  std::optional<SkdNearest> Find(const skd::Vector3& centre, double radius) const;
  ///@}

  /// How many queries at points of a lattice there were.
  std::size_t GetNumberShared() const;

private:
  using LatticeKey = std::array<std::int64_t, 4>; // on a lattice, and the exponent of its spacing

  SkdNearest FindShared(const skd::Vector3& centre, double radius) const;

  const SkdSourceTrees& Trees;
  std::vector<skd::Vector3> Sample;
  double Share = 1.0;   // of the sample, from which on cells are many
  double BoxSize = 0.0; // about that of a leaf of the tree

  mutable std::mutex Mutex;
  mutable std::map<LatticeKey, SkdNearest> Known;
};
}

#endif
