// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdDuplicates_h
#define SkdDuplicates_h

#include "Solids/Surfaces/SkdCopies.h"
#include "Solids/Surfaces/SkdTrianglePairs.h"

namespace skdtree
{
/// Takes duplicate triangles out of the pairs of a set with itself, so that no surface is split
/// along all its edges because it is there twice. What meets a duplicate meets its original.
/// Returns the duplicates, ascending. O(n).
std::vector<SkdDuplicate> SkdTakeDuplicates(
  const SkdMovedTriangles& set, std::vector<SkdTrianglePair>& pairs);
}

#endif
