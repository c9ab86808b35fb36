// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdDuplicates_h
#define SkdDuplicates_h

#include "Surfaces/SkdTrianglePairs.h"

/// A triangle with the same corners as a lower one.
struct SkdDuplicate
{
  std::uint32_t Original; ///< the lowest with these corners
  std::uint32_t Triangle;
  int Sign; ///< 1 if both have the same orientation, else -1

  bool operator<(const SkdDuplicate& other) const
  {
    return this->Original != other.Original ? this->Original < other.Original
                                            : this->Triangle < other.Triangle;
  }
};

/// Takes duplicate triangles out of the pairs of a set with itself, so that no surface is split
/// along all its edges because it is there twice. What meets a duplicate meets its original.
/// Returns the duplicates, ascending. O(n).
std::vector<SkdDuplicate> SkdTakeDuplicates(
  const SkdPlacedTriangles& set, std::vector<SkdTrianglePair>& pairs);

#endif
