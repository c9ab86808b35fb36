// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Boolean/SkdDuplicates.h"

#include <algorithm>

namespace skdtree
{
namespace
{
using Corners = SkdTriangleSet::Corners;

Corners Sorted(Corners corners)
{
  std::sort(corners.begin(), corners.end());
  return corners;
}
}

// Pairs are ascending, so the first pair that has a triangle as its second is with its original.
std::vector<SkdDuplicate> SkdTakeDuplicates(
  const SkdMovedTriangles& set, std::vector<SkdTrianglePair>& pairs)
{
  std::vector<bool> isDuplicate(set.GetSet().GetTriangles().size(), false);
  std::vector<SkdDuplicate> duplicates;
  for (const SkdTrianglePair& pair : pairs)
  {
    const Corners& first = set.GetCorners(pair.First);
    const Corners& second = set.GetCorners(pair.Second);
    if (pair.Contact.Count == 3 && !isDuplicate[pair.Second] && Sorted(first) == Sorted(second))
    {
      isDuplicate[pair.Second] = true;
      duplicates.push_back({ pair.First, pair.Second, SkdSignOfCopy(first, second) });
    }
  }
  const auto isOfDuplicate = [&](const SkdTrianglePair& pair)
  { return isDuplicate[pair.First] || isDuplicate[pair.Second]; };
  if (!duplicates.empty())
  {
    pairs.erase(std::remove_if(pairs.begin(), pairs.end(), isOfDuplicate), pairs.end());
  }
  std::sort(duplicates.begin(), duplicates.end());
  return duplicates;
}
}
