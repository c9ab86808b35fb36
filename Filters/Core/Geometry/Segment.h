// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_Segment_h
#define skd_Geometry_Segment_h

#include "Box.h"

#include <optional>
#include <utility>

namespace skd
{

/// The points A + t (B - A), 0 <= t <= 1.
template <int D>
struct Segment
{
  Vector<D> A;
  Vector<D> B;

  Vector<D> At(double t) const { return Lerp(this->A, this->B, t); }
};

/// A interval of a segment's parameter.
struct Interval
{
  double Min;
  double Max;
};

/// The interval of [0, 1] on which the segment is inside the box (section 5.1: the box projected
/// along each axis onto the segment), or nothing. NaN and infinite ends mean nothing.
template <int D>
std::optional<Interval> Clip(const Segment<D>& segment, const Box<D>& box)
{
  Interval inside{ 0.0, 1.0 };
  for (int axis = 0; axis < D; ++axis)
  {
    const double origin = segment.A[axis];
    const double length = segment.B[axis] - origin;
    if (length == 0.0)
    {
      if (!(box.Min[axis] <= origin && origin <= box.Max[axis]))
      {
        return std::nullopt;
      }
      continue;
    }
    const double sides[2] = { box.Min[axis], box.Max[axis] }; // without a branch
    const bool isForward = length > 0.0;
    const double enter = (sides[!isForward] - origin) / length;
    const double leave = (sides[isForward] - origin) / length;
    if (!(enter <= leave && std::isfinite(length)))
    {
      return std::nullopt;
    }
    inside.Min = std::max(inside.Min, enter);
    inside.Max = std::min(inside.Max, leave);
    if (!(inside.Min <= inside.Max))
    {
      return std::nullopt;
    }
  }
  return inside;
}

}

#endif
