// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_Overlap_SegmentOverlap_h
#define skd_Geometry_Overlap_SegmentOverlap_h

#include "../Segment.h"
#include "Moments.h"

#include <limits>
#include <optional>

namespace skd
{

/// The interval that two segments of one line have in common, in the direction of the shorter one;
/// nothing where they only touch, or are not on one line. On one line means: the ends of the
/// shorter are off the longer's line by at most 1e-9 of its length, or 8 units in the last place of
/// the coordinates. Exact but for rounding: ends of the shorter within the longer are kept.
inline std::optional<Segment<3>> CommonInterval(const Segment<3>& one, const Segment<3>& other)
{
  const bool isOneShorter = Distance2(one.A, one.B) <= Distance2(other.A, other.B);
  const Segment<3>& within = isOneShorter ? one : other;
  const Segment<3>& around = isOneShorter ? other : one;
  const Vector3 along = around.B - around.A;
  const double length2 = Norm2(along);
  if (!(length2 > 0.0))
  {
    return std::nullopt;
  }
  const auto parameterOf = [&](const Vector3& x) { return Dot(x - around.A, along) / length2; };
  const double tolerance = std::max(1e-9 * std::sqrt(length2),
    8.0 * std::numeric_limits<double>::epsilon() * std::sqrt(Norm2(around.A) + Norm2(around.B)));
  const auto isOnLine = [&](const Vector3& x)
  { return Norm(x - around.A - parameterOf(x) * along) <= tolerance; };
  if (!isOnLine(within.A) || !isOnLine(within.B))
  {
    return std::nullopt;
  }
  const auto inside = [&](const Vector3& x)
  {
    const double t = parameterOf(x);
    return t <= 0.0 ? around.A : (t >= 1.0 ? around.B : x);
  };
  const Segment<3> common{ inside(within.A), inside(within.B) };
  const double least = 4.0 * std::numeric_limits<double>::epsilon() * std::sqrt(length2);
  return Distance2(common.A, common.B) > least * least ? std::make_optional(common) : std::nullopt;
}

/// About `reference`.
inline Moments MomentsOf(const Segment<3>& segment, const Vector3& reference)
{
  const double length = Norm(segment.B - segment.A);
  return { length, (0.5 * length) * ((segment.A - reference) + (segment.B - reference)) };
}

}

#endif
