// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What two segments in space have in common, decided by exact signs (Orient3D.h): nothing, a
/// point, or a interval of the line that both lie on.
#ifndef skd_Geometry_Intersection_SegmentContact_h
#define skd_Geometry_Intersection_SegmentContact_h

#include "../Predicates/ExactOrientation.h"
#include "../Segment.h"
#include "../Tolerances.h"

#include <algorithm>

namespace skd
{

/// Exact as to what it is and as to which ends are part of it: these have parameters of 0 or 1. All
/// other parameters are right to a few units in the last place.
struct SegmentContact
{
  enum Kinds
  {
    None,
    Point,   ///< Begin and End are the same
    Interval ///< ascending along the first
  };

  /// On both segments.
  struct Position
  {
    double T = 0.0;
    double S = 0.0;
  };

  Kinds Kind = None;
  Position Begin;
  Position End;
};

namespace detail
{

inline int LongestAxis(const Vector3& v)
{
  const double sizes[3] = { std::abs(v[0]), std::abs(v[1]), std::abs(v[2]) };
  return static_cast<int>(std::max_element(sizes, sizes + 3) - sizes);
}

/// Where a point of a segment's line is: the same number for all callers.
inline double ParameterOnSegment(const Segment<3>& segment, const Vector3& x)
{
  const int axis = LongestAxis(segment.B - segment.A);
  return (x[axis] - segment.A[axis]) / (segment.B[axis] - segment.A[axis]) + 0.0; // never -0
}

/// Whether the boxes around both are apart: most are.
inline bool AreBoxesApart(const Segment<3>& first, const Segment<3>& second)
{
  bool areApart = false;
  for (int axis = 0; axis < 3; ++axis)
  {
    areApart |= std::max(first.A[axis], first.B[axis]) < std::min(second.A[axis], second.B[axis]) ||
      std::max(second.A[axis], second.B[axis]) < std::min(first.A[axis], first.B[axis]);
  }
  return areApart;
}

/// Two segments of one line.
inline SegmentContact MeetInLine(const Segment<3>& first, const Segment<3>& second)
{
  const int axis = LongestAxis(first.B - first.A);
  const bool rises = first.A[axis] < first.B[axis];
  const auto isBefore = [&](const Vector3& p, const Vector3& q)
  { return rises ? p[axis] < q[axis] : p[axis] > q[axis]; };
  const bool isAlong = isBefore(second.A, second.B);
  const Vector3& low = isAlong ? second.A : second.B;
  const Vector3& high = isAlong ? second.B : second.A;
  const Vector3& begin = isBefore(first.A, low) ? low : first.A;
  const Vector3& end = isBefore(high, first.B) ? high : first.B;
  SegmentContact contact;
  if (isBefore(end, begin))
  {
    return contact;
  }
  contact.Kind = isBefore(begin, end) ? SegmentContact::Interval : SegmentContact::Point;
  contact.Begin = { ParameterOnSegment(first, begin), ParameterOnSegment(second, begin) };
  contact.End = { ParameterOnSegment(first, end), ParameterOnSegment(second, end) };
  return contact;
}

/// Where a segment crosses a line that its ends are on different sides of, or on: 0 and 1 only for
/// the ends themselves, unless it is rounded so.
inline double CrossingParameter(double sideOfA, double sideOfB)
{
  return sideOfA == 0.0 ? 0.0 : (sideOfB == 0.0 ? 1.0 : sideOfA / (sideOfA - sideOfB));
}

/// Two segments of one plane that are not parallel as seen along the axis.
inline SegmentContact MeetInPlane(const Segment<3>& first, const Segment<3>& second, int axis)
{
  SegmentContact contact;
  const int ends[4] = { Orient2D(second.A, second.B, first.A, axis),
    Orient2D(second.A, second.B, first.B, axis), Orient2D(first.A, first.B, second.A, axis),
    Orient2D(first.A, first.B, second.B, axis) };
  if (ends[0] * ends[1] > 0 || ends[2] * ends[3] > 0)
  {
    return contact;
  }
  contact.Kind = SegmentContact::Point;
  const auto area = [&](const Segment<3>& line, const Vector3& x, int sign)
  { return sign == 0 ? 0.0 : AreaOf(line.A, line.B, x, axis); };
  double t = CrossingParameter(area(second, first.A, ends[0]), area(second, first.B, ends[1]));
  double s = CrossingParameter(area(first, second.A, ends[2]), area(first, second.B, ends[3]));
  // The parameter of an end on the other is the same, whichever piece of a polyline has that end.
  if (ends[0] * ends[1] == 0 && ends[2] * ends[3] != 0)
  {
    s = ParameterOnSegment(second, ends[0] == 0 ? first.A : first.B);
  }
  else if (ends[2] * ends[3] == 0 && ends[0] * ends[1] != 0)
  {
    t = ParameterOnSegment(first, ends[2] == 0 ? second.A : second.B);
  }
  contact.Begin = contact.End = { t, s };
  return contact;
}

/// Within the range of coordinates that signs are exact in.
inline SegmentContact MeetInRange(const Segment<3>& first, const Segment<3>& second)
{
  if (Orient3D(first.A, first.B, second.A, second.B) != 0)
  {
    return {};
  }
  const int axis = LongestAxis(Cross(first.B - first.A, second.B - second.A));
  for (const int along : { axis, (axis + 1) % 3, (axis + 2) % 3 })
  {
    if (SignOfCross(first.A, first.B, second.A, second.B, along) != 0)
    {
      return MeetInPlane(first, second, along);
    }
  }
  for (int along = 0; along < 3; ++along)
  {
    if (Orient2D(first.A, first.B, second.A, along) != 0)
    {
      return {}; // parallel, side by side
    }
  }
  return MeetInLine(first, second);
}

}

/// Of segments that have a length and finite coordinates.
inline SegmentContact Meet(const Segment<3>& first, const Segment<3>& second)
{
  if (detail::AreBoxesApart(first, second))
  {
    return {};
  }
  double largest = 0.0;
  for (const Vector3* point : { &first.A, &first.B, &second.A, &second.B })
  {
    largest =
      std::max({ largest, std::abs((*point)[0]), std::abs((*point)[1]), std::abs((*point)[2]) });
  }
  if (largest > tolerances::LeastCoordinate && largest < tolerances::LargestCoordinate)
  {
    return detail::MeetInRange(first, second);
  }
  const double scale = std::ldexp(1.0, -std::ilogb(largest)); // by which nothing is rounded
  return detail::MeetInRange(
    { scale * first.A, scale * first.B }, { scale * second.A, scale * second.B });
}

}

#endif
