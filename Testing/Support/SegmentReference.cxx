// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Support/SegmentReference.h"

namespace skdtest
{

double EntryIntoBox(const Point& p1, const Point& p2, const Bounds& box)
{
  long double enter = 0.0L;
  long double leave = 1.0L;
  for (int axis = 0; axis < 3; ++axis)
  {
    const long double from = p1[axis];
    const long double along = static_cast<long double>(p2[axis]) - from;
    if (along == 0.0L)
    {
      if (from < box[2 * axis] || from > box[2 * axis + 1])
      {
        return -1.0;
      }
      continue;
    }
    const long double a = (box[2 * axis] - from) / along;
    const long double b = (box[2 * axis + 1] - from) / along;
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter <= leave ? static_cast<double>(enter) : -1.0;
}

double SegmentsDistance(const Point& p1, const Point& p2, const Point& q1, const Point& q2)
{
  double best = std::min({ SegmentDistance(p1, q1, q2), SegmentDistance(p2, q1, q2),
    SegmentDistance(q1, p1, p2), SegmentDistance(q2, p1, p2) });
  const Point d = p2 - p1;
  const Point e = q2 - q1;
  const double a = Dot(d, d);
  const double b = Dot(d, e);
  const double c = Dot(e, e);
  const double determinant = a * c - b * b;
  if (determinant > 0)
  {
    const Point r = p1 - q1;
    const double s = (b * Dot(e, r) - c * Dot(d, r)) / determinant;
    const double t = (a * Dot(e, r) - b * Dot(d, r)) / determinant;
    if (s >= 0 && s <= 1 && t >= 0 && t <= 1)
    {
      best = std::min(best, Distance(Lerp(p1, p2, s), Lerp(q1, q2, t)));
    }
  }
  return best;
}

}
