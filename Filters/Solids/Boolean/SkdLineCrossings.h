// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdLineCrossings_h
#define SkdLineCrossings_h

#include "Core/Search/Tree/PackedRTree.h"
#include "Solids/Boolean/SkdAxisLine.h"
#include "Solids/Surfaces/SkdPlacement.h"

#include <functional>
#include <optional>
#include <vector>

namespace skdtree
{
/// Where a line along an axis crosses a triangle: its normal points along the axis (1) or against
/// it (-1).
struct SkdLineCrossing
{
  std::uint32_t Triangle;
  int Sign;
};

/// Whether a line crosses a triangle, by exact signs; `isSure` becomes false if it passes through
/// an edge or corner.
std::optional<SkdLineCrossing> SkdCrossTriangle(
  const SkdMovedTriangles& set, std::uint32_t triangle, const SkdAxisLine& line, bool& isSure);

/// The exact order along a line of the planes of two triangles that it crosses: negative if it
/// crosses the first one earlier, 0 if both at one point.
int SkdCompareCrossings(
  const SkdMovedTriangles& set, std::uint32_t first, std::uint32_t second, const SkdAxisLine& line);

/// The same of triangles given by their corners.
int SkdCompareCrossings(const std::array<skd::Vector3, 3>& first,
  const std::array<skd::Vector3, 3>& second, const SkdAxisLine& line);

/// Some triangles, to be crossed by about so many lines.
class SkdLineCrossings
{
public:
  SkdLineCrossings(const SkdMovedTriangles& set, const std::vector<std::uint32_t>& triangles,
    std::size_t numberOfLines);

  /// The triangles that a line crosses, ascending; none if it passes through an edge or corner.
  /// O(n) or, of many lines, O(log n). Thread-safe.
  std::optional<std::vector<SkdLineCrossing>> Find(const SkdAxisLine& line) const;

private:
  const SkdMovedTriangles& Set;
  const std::vector<std::uint32_t>& Triangles;
  std::optional<skd::PackedRTree> Boxes; // none: few lines
  skd::Box3 Bounds;
};
}

#endif
