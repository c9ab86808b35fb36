// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdSplitRegions_h
#define SkdSplitRegions_h

#include "Solids/Surfaces/SkdTriangleSet.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace skdtree
{
/// An edge by its ends, the lower first.
using SkdSplitEdge = std::pair<std::uint32_t, std::uint32_t>;

inline SkdSplitEdge SkdMakeSplitEdge(std::uint32_t a, std::uint32_t b)
{
  return a < b ? SkdSplitEdge{ a, b } : SkdSplitEdge{ b, a };
}

/// The region of each triangle: triangles that share an edge belong to one region, unless the edge
/// is among `borders`. Regions are numbered 0, 1, ... by their first triangle. O(n log n).
std::vector<std::uint32_t> SkdFindSplitRegions(
  const std::vector<SkdTriangleSet::Corners>& triangles, std::vector<SkdSplitEdge> borders);
}

#endif
