// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdJoinSegments_h
#define SkdJoinSegments_h

#include <cstddef>
#include <cstdint>
#include <functional>
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

/// What is known of the points of segments, which are numbered.
struct SkdSegmentPoints
{
  std::uint32_t Number;

  /// An order of different points that does not depend on their numbers.
  std::function<bool(std::uint32_t a, std::uint32_t b)> IsBefore;

  /// Where lines end, although two segments meet there: others do elsewhere. Empty: nowhere.
  std::vector<bool> IsEnd;
};

/// Joins segments into maximal polylines that end where one segment or more than two meet. A closed
/// one starts from the first of its points, an open one from the first of its ends, and where ends
/// do not decide it goes to the first of the points beside them: lines do not depend on the numbers
/// of points nor on the order of segments. The open ones come first. O(n log n).
std::vector<SkdPolyline> SkdJoinSegments(
  const std::vector<SkdEndPair>& segments, const SkdSegmentPoints& points);
}

#endif
