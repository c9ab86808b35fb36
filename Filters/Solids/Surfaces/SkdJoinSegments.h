// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdJoinSegments_h
#define SkdJoinSegments_h

#include <cstddef>
#include <cstdint>
#include <vector>

namespace skdtree
{
/// A segment: its ends and the pair it belongs to.
struct SkdEndPair
{
  std::uint32_t A;
  std::uint32_t B;
  std::size_t Origin;
};

/// Segments one after the other. Segment i goes from point i to the next, of the last of a closed
/// one back to the first.
struct SkdPolyline
{
  std::vector<std::uint32_t> Points;
  std::vector<std::size_t> Segments; // indices
  bool IsClosed = false;
};

/// Joins segments into maximal polylines that end where one segment or more than two meet. Points
/// are numbered below `numberOfPoints`. The open ones come first, by the point that they start
/// from. O(n log n).
std::vector<SkdPolyline> SkdJoinSegments(
  const std::vector<SkdEndPair>& segments, std::uint32_t numberOfPoints);
}

#endif
