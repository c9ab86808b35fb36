// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdIntersectionGroups_h
#define SkdIntersectionGroups_h

#include "Curves/SkdSurfaceHit.h"
#include "Curves/SkdSurfaceSet.h"

#include <vector>

namespace skdtree
{
/// Merges hits of one intersection: on edges or vertices of the same part, or at the joints of a
/// curve, whose parameters differ by no more than their error.
class SkdIntersectionGroups
{
public:
  explicit SkdIntersectionGroups(const std::vector<SkdSurfaceElement>& elements)
    : Elements(elements)
  {
  }

  /// Hits must be sorted by (curve, U).
  void Add(const SkdSurfaceHit& hit);

  /// In the order in which they came.
  std::vector<SkdSurfaceIntersection> GetIntersections() const;

  /// The parts that are crossed an odd number of times, sorted by the last crossing.
  std::vector<int> GetPartsLeft() const;

private:
  struct Group
  {
    SkdSurfaceHit First;
    SkdSurfaceHit Lowest;
    int ExactPasses = 0;
    int ExactSum = 0;
    bool IsExact = true;
    bool GoesAlong = false; ///< with the normal
    bool GoesAgainst = false;
    unsigned SidesBefore = 0; ///< a bit for each side
    unsigned SidesAfter = 0;
    int OverlapsBegun = 0;
    int OverlapsEnded = 0;

    void Add(const SkdSurfaceHit& hit, const std::vector<SkdSurfaceElement>& elements);
    int Sense() const;
    int Before() const;
    int After() const;
    bool IsWithinOverlap() const;
    skd::IntersectionKind Kind() const;
  };

  bool BelongsTo(const Group& group, const SkdSurfaceHit& hit) const;

  const std::vector<SkdSurfaceElement>& Elements;
  std::vector<Group> Groups;
};
}

#endif
