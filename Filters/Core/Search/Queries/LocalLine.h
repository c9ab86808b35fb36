// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Queries_LocalLine_h
#define skd_Queries_LocalLine_h

#include "../../Geometry/Segment.h"
#include "../Tree/AxisLanes.h"
#include "../Tree/Frame.h"
#include "../Tree/Tolerances.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace skd
{

/// A segment in a tree's frame. Which way it runs along an axis is anyone's guess, and there is
/// no branch on it.
template <int D>
struct LocalLine
{
  static constexpr float Slack = tolerances::SegmentParameter;
  /// "Insure width of L in each coordinate direction".
  static constexpr double Least = tolerances::LeastAlong;
  /// What is beyond so much is as good there.
  static constexpr double Most = 1.0 / Least;

  LocalLine(const Frame<D>& frame, const Segment<D>& segment)
  {
    const AxisLanes<D> scale(frame.Scale);
    const AxisLanes<D> a(segment.A);
    this->Along = (AxisLanes<D>(segment.B) - a) * scale;
    this->From = (a - AxisLanes<D>(frame.Centre)) * scale;
    this->Inverse = AxisLanes<D>(1.0) / Max(Abs(this->Along), AxisLanes<D>(Least));
  }

  /// Leaves of it what is near the tree, if an end is far; `margin` in world units. False: nothing.
  bool Clip(const Frame<D>& frame, double margin)
  {
    double rounding = RoundingNear;
    if (!this->IsNear())
    {
      rounding = this->Rounding();
      if (!std::isfinite(rounding) || !this->ClipTo(2.0 + margin * frame.Scale + 2.0 * rounding))
      {
        return false;
      }
    }
    this->Margin = std::min(margin * frame.Scale + rounding, Most);
    return margin >= 0.0;
  }

  /// How far coordinates are moved outward so that the floats nearest to their products with a
  /// number, and those of sides of boxes with the float nearest to it, are on the safe side by the
  /// margin. (Of the floats that parameters are sums of each may be off by 2^-24; coordinates of
  /// boxes are at most 1.) What no float is near, 0 is: boxes are rounded outward by as much.
  AxisLanes<D> Room() const
  {
    constexpr double roundings = 2.125 / (1 << 24);
    const AxisLanes<D> margin(this->Margin);
    return margin + AxisLanes<D>(roundings) * (Abs(this->From) + margin + AxisLanes<D>(1.0));
  }

  ///@{
  /// The limit of a search that wants nothing beyond a parameter; one that falls to that.
  static float LimitAt(float last) { return last + Slack; }
  static void Lower(float& limit, double last)
  {
    if (last < 1.0)
    {
      limit = LimitAt(Frame<D>::RoundUpInRange(std::max(last, 0.0)));
    }
  }
  ///@}

  AxisLanes<D> From;
  AxisLanes<D> Along;
  AxisLanes<D> Inverse;   ///< of the lengths along the axes, in the parameter of what is left
  double Begin = 0.0;     ///< of what is left
  double PerLength = 1.0; ///< 1 over the length that the clipping left, in the parameter
  double Margin = 0.0;    ///< in the frame, with the rounding of points

private:
  /// Whether no end is far from the tree: then nothing is clipped.
  bool IsNear() const
  {
    const AxisLanes<D> most = Max(Abs(this->From), Abs(this->From + this->Along));
    return AllLessEqual(most, AxisLanes<D>(Near));
  }

  ///@{
  /// The maximum rounding error of points of the segment. Infinite or NaN if an end is.
  double Rounding() const
  {
    const Vector<D> most = (Abs(this->From) + Abs(this->Along)).Values();
    double sum = 0.0;
    ForEachAxis<D>([&](int axis) { sum += most[axis]; });
    return RoundingOf(sum);
  }
  static constexpr double RoundingOf(double sum)
  {
    return 4.0 * std::numeric_limits<double>::epsilon() * sum;
  }
  static constexpr double Near = 4.0; ///< in any coordinate
  static constexpr double RoundingNear = RoundingOf(3.0 * D * Near);
  ///@}

  /// The interval on which no coordinate is beyond `room`: Min > Max if there is none.
  Interval Within(double room) const
  {
    const AxisLanes<D> side = TimesSign(AxisLanes<D>(room), this->Along);
    const AxisLanes<D> perStep = TimesSign(this->Inverse, this->Along);
    const Vector<D> enter = ((-side - this->From) * perStep).Values();
    const Vector<D> leave = ((side - this->From) * perStep).Values();
    Interval inside{ 0.0, 1.0 };
    ForEachAxis<D>(
      [&](int axis)
      {
        inside.Min = std::max(inside.Min, enter[axis]);
        inside.Max = std::min(inside.Max, leave[axis]);
      });
    return inside;
  }

  /// Leaves of it what no coordinate is beyond `room` of. False: nothing.
  bool ClipTo(double room)
  {
    const Interval inside = this->Within(room);
    if (!(inside.Min <= inside.Max))
    {
      return false;
    }
    this->Begin = inside.Min;
    this->PerLength = 1.0 / std::max(inside.Max - inside.Min, Least);
    this->From = this->From + AxisLanes<D>(this->Begin) * this->Along;
    this->Inverse = Min(this->Inverse * AxisLanes<D>(this->PerLength), AxisLanes<D>(Most));
    return true;
  }
};

}

#endif
