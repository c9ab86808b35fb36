// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdSplitTriangles.h
 * @brief The triangles of a set, split along segments.
 */

#ifndef SkdSplitTriangles_h
#define SkdSplitTriangles_h

#include "Solids/Surfaces/SkdSplitRegions.h"
#include "Solids/Surfaces/SkdSplitSegments.h"

#include <optional>

namespace skdtree
{
class SkdLoop;

/// A new point: its position (with the placement's scale), and its weights for three of the set's
/// points.
struct SkdSplitPoint
{
  skd::Vector3 Position;
  SkdTriangleSet::Corners Corners;
  std::array<double, 3> Weights;
  std::uint32_t Parent; ///< the lowest triangle that it lies in
};

/// Pieces of triangles. Corners below the number of the set's points are these, further ones new.
struct SkdSplitResult
{
  std::vector<SkdTriangleSet::Corners> Triangles;
  std::vector<std::uint32_t> Parents; ///< of each, ascending
  std::vector<SkdSplitPoint> Points;  ///< the new ones
  std::vector<std::uint32_t> Ids;     ///< of each new one, in SkdSplitPoints
  std::vector<SkdSplitEdge> Curves;   ///< edges along curves and the borders of overlaps
  vtkIdType NumberSplit = 0;          ///< triangles of the set that are in pieces
};

/// Splits a set along all segments: each triangle with segments, or with points on an edge, is
/// replaced by their constrained triangulation, with its orientation; adjacent triangles have the
/// same points on the common edge. Other triangles, including degenerate ones, are not changed.
/// Empty after an abort.
std::optional<SkdSplitResult> SkdSplitTriangles(
  const SkdSplitSegments& segments, int side, SkdLoop& loop);
}

#endif
