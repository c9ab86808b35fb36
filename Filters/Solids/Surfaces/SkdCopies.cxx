// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Surfaces/SkdCopies.h"

#include <algorithm>
#include <utility>

namespace skdtree
{
namespace
{
using Corners = std::array<std::uint32_t, 3>;
using Named = std::pair<Corners, std::uint32_t>; // ascending corners of a triangle

/// The triangles whose lowest corner is that of many.
std::vector<Named> ListSuspects(
  const skd::RawVector<Corners>& triangles, std::size_t numberOfPoints)
{
  std::vector<std::uint32_t> counts(numberOfPoints, 0);
  for (const Corners& corners : triangles)
  {
    ++counts[std::min({ corners[0], corners[1], corners[2] })];
  }
  std::vector<Named> suspects;
  if (std::none_of(
        counts.begin(), counts.end(), [](std::uint32_t count) { return count > SkdManyCopies; }))
  {
    return suspects;
  }
  for (std::uint32_t triangle = 0; triangle < triangles.size(); ++triangle)
  {
    Corners corners = triangles[triangle];
    if (counts[std::min({ corners[0], corners[1], corners[2] })] > SkdManyCopies)
    {
      std::sort(corners.begin(), corners.end());
      suspects.emplace_back(corners, triangle);
    }
  }
  std::sort(suspects.begin(), suspects.end());
  return suspects;
}
}

int SkdSignOfCopy(const Corners& a, const Corners& b)
{
  const auto first = std::find(b.begin(), b.end(), a[0]) - b.begin();
  return b[static_cast<std::size_t>((first + 1) % 3)] == a[1] ? 1 : -1;
}

std::vector<SkdDuplicate> SkdFindCopies(
  const skd::RawVector<Corners>& triangles, std::size_t numberOfPoints, std::size_t mostCopies)
{
  const std::vector<Named> suspects = ListSuspects(triangles, numberOfPoints);
  std::vector<SkdDuplicate> copies;
  for (std::size_t first = 0, last = 0; first < suspects.size(); first = last)
  {
    while (last < suspects.size() && suspects[last].first == suspects[first].first)
    {
      ++last;
    }
    const std::uint32_t original = suspects[first].second;
    for (std::size_t i = first + mostCopies; last - first > SkdManyCopies && i < last; ++i)
    {
      const std::uint32_t copy = suspects[i].second;
      copies.push_back({ original, copy, SkdSignOfCopy(triangles[original], triangles[copy]) });
    }
  }
  std::sort(copies.begin(), copies.end());
  return copies;
}
}
