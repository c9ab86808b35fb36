// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdSampleTree.h
 * @brief Points of a donor in a tree, built once: which are in a box, and which is nearest.
 */

#ifndef SkdSampleTree_h
#define SkdSampleTree_h

#include "Core/Search/Tree/Tree.h"

#include <cstdint>
#include <vector>

namespace skdtree
{
class SkdSampleTree
{
public:
  /// On a sphere about the origin points are known by their directions: boxes and distances are
  /// those of the unit sphere. Points that are not finite, and there the origin, are never found.
  /// O(N log N), in parallel.
  SkdSampleTree(std::vector<skd::Vector3> points, bool isOnSphere);

  std::size_t GetNumberOfPoints() const { return this->Points.size(); }
  const skd::Vector3& GetPoint(std::uint32_t i) const { return this->Points[i]; }
  bool IsOnSphere() const { return this->OnSphere; }

  /// Of the points that can be found, where they count as.
  const skd::Box3& GetBounds() const { return this->Tree.GetBounds(); }

  /// Where a point counts as: on the unit sphere, if that is where points are.
  skd::Vector3 CoordinatesOf(const skd::Vector3& x) const
  {
    return this->OnSphere ? (1.0 / skd::Norm(x)) * x : x;
  }

  /// All points in the box, and some that are near, in any order. Thread-safe.
  void FindWithin(const skd::Box3& box, std::vector<std::uint32_t>& points) const;

  /// A point that was found, and its squared distance.
  struct Near
  {
    double Distance2;
    std::uint32_t Id;

    bool operator<(const Near& other) const
    {
      return this->Distance2 < other.Distance2 ||
        (this->Distance2 == other.Distance2 && this->Id < other.Id);
    }
  };

  /// SkdNearestSamples.h: the points nearest to x for which isWanted(i), at most so many; the
  /// nearest first, ties to the lowest. Thread-safe.
  template <class Wanted>
  void FindNearest(
    const skd::Vector3& x, int most, const Wanted& isWanted, std::vector<Near>& nearest) const;

  /// Likewise: the point nearest to x for which isWanted(i), ties to the lowest; -1 if none.
  /// Thread-safe.
  template <class Wanted>
  std::int64_t FindNearest(const skd::Vector3& x, const Wanted& isWanted) const;

private:
  std::vector<skd::Vector3> Points;
  bool OnSphere;
  skd::Tree<3> Tree;
};
}

#endif
