// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Queries_AlongSegment_h
#define skd_Queries_AlongSegment_h

#include "../../Geometry/Segment.h"
#include "../Tree/Tolerances.h"
#include "../Tree/Walk.h"

namespace skd
{

/// Elements along a segment (Algorithm 5.2), by the parameter at which it enters their boxes.
///
/// `visitor(element)` intersects an element and returns the new limit of the search, a parameter
/// 0..1 along the segment: the first hit so far, or 1 for all hits.
///
/// The segment is first clipped in double precision, so that a far end costs no accuracy, to the
/// cube of the tree's frame and as much room again: no new end comes near a box. `margin` (world
/// units) widens every box, for searches with a tolerance. Of a short query much is what is done
/// once a segment: there is a division for each axis, and one for what the clipping leaves.
/// `InOrder`: whether the nearest comes first. Where all is wanted, any order will do.
template <int D, class Visitor, class LeafFilter = NoLeafFilter, bool InOrder = true>
class AlongSegment : public FilteredQuery<AlongSegment<D, Visitor, LeafFilter, InOrder>, LeafFilter>
{
public:
  static constexpr bool Ordered = InOrder;

  SKD_NOINLINE AlongSegment(const Frame<D>& frame, const Segment<D>& segment, double margin,
    Visitor& visitor, const LeafFilter& leafFilter = LeafFilter())
    : FilteredQuery<AlongSegment, LeafFilter>(leafFilter, -1.0f) // less than every key
    , TheVisitor(visitor)
  {
    const Line line(frame.Local(segment.A), frame.Scale * (segment.B - segment.A));
    const double rounding = line.Rounding();
    const double reach = margin * frame.Scale + rounding;
    const Interval inside = line.Within(2.0 + reach + rounding);
    this->Begin = inside.Min;
    this->PerLength = 1.0 / std::max(inside.Max - inside.Min, Least);
    this->SetLocal(line, std::min(reach, Most));
    this->TheLeafFilter.Aim(line.At(this->Begin), reach);
    if (inside.Min <= inside.Max && margin >= 0.0 && std::isfinite(rounding)) // may meet the tree
    {
      this->TheLimit = 1.0f + Slack;
    }
  }

  template <int W>
  SKD_FLATTEN unsigned TestBoxes(const BoxPacket<D, W>& boxes, float* keys) const
  {
    Lanes<W> enter(0.0f);
    Lanes<W> leave(1.0f);
    ForEachAxis<D>(
      [&](int axis)
      {
        const Lanes<W> inverse(this->Inverse[axis]);
        const Lanes<W> near = boxes.Side(this->NearSide[axis]);
        const Lanes<W> far = boxes.Side(this->FarSide[axis]);
        enter = Max((near - Lanes<W>(this->NearOrigin[axis])) * inverse, enter);
        leave = Min((far - Lanes<W>(this->FarOrigin[axis])) * inverse, leave);
      });
    enter.Store(keys);
    return LessEqual(enter, Min(leave + Lanes<W>(Slack), Lanes<W>(this->TheLimit)));
  }

  bool Visit(std::uint32_t element)
  {
    const double parameter = this->TheVisitor(element);
    const double local = (parameter - this->Begin) * this->PerLength;
    if (local < 1.0)
    {
      this->TheLimit = Frame<D>::RoundUpInRange(std::max(local, 0.0)) + Slack;
    }
    return true;
  }

private:
  static constexpr float Slack = tolerances::SegmentParameter;

  /// "Insure width of L in each coordinate direction".
  static constexpr double Least = tolerances::LeastAlong;
  /// What is beyond so much is as good there.
  static constexpr double Most = 1.0 / Least;

  /// A segment in the tree's frame, mirrored so that it runs forward along every axis: which way
  /// it does is anyone's guess, and there is no branch on it.
  struct Line
  {
    Line(const Vector<D>& from, const Vector<D>& along)
    {
      ForEachAxis<D>(
        [&](int axis)
        {
          this->Sign[axis] = std::copysign(1.0, along[axis]);
          this->From[axis] = this->Sign[axis] * from[axis];
          this->Along[axis] = std::abs(along[axis]);
          this->Inverse[axis] = 1.0 / std::max(this->Along[axis], Least);
        });
    }

    /// The maximum rounding error of points of the segment. Infinite if an end is infinite or NaN.
    double Rounding() const
    {
      double most = 0.0;
      ForEachAxis<D>([&](int axis) { most += std::abs(this->From[axis]) + this->Along[axis]; });
      return 4.0 * std::numeric_limits<double>::epsilon() * most;
    }

    /// The interval on which no coordinate is beyond `room`: Min > Max if there is none.
    Interval Within(double room) const
    {
      Interval inside{ 0.0, 1.0 };
      ForEachAxis<D>(
        [&](int axis)
        {
          const double enter = (-room - this->From[axis]) * this->Inverse[axis];
          const double leave = (room - this->From[axis]) * this->Inverse[axis];
          inside.Min = std::max(inside.Min, enter);
          inside.Max = std::min(inside.Max, leave);
        });
      return inside;
    }

    /// As it is, not mirrored.
    Vector<D> At(double parameter) const
    {
      Vector<D> x;
      ForEachAxis<D>([&](int axis)
        { x[axis] = this->Sign[axis] * (this->From[axis] + parameter * this->Along[axis]); });
      return x;
    }

    Vector<D> Sign; ///< -1 of an axis that is mirrored
    Vector<D> From;
    Vector<D> Along;
    Vector<D> Inverse; ///< of Along
  };

  void SetLocal(const Line& line, double reach)
  {
    ForEachAxis<D>(
      [&](int axis)
      {
        const double sign = line.Sign[axis];
        const double place = line.From[axis] + this->Begin * line.Along[axis];
        const double from = std::max(-Most, std::min(place, Most));
        this->NearOrigin[axis] = Spread(static_cast<float>(sign * RoundedUp(from + reach)));
        this->FarOrigin[axis] = Spread(static_cast<float>(-sign * RoundedUp(reach - from)));
        const double inverse = std::min(line.Inverse[axis] * this->PerLength, Most);
        this->Inverse[axis] = Spread(static_cast<float>(sign * inverse));
        const bool isForward = sign > 0.0;
        this->NearSide[axis] = BoxPacket<D, Node<D>::Width>::SideAt(axis, !isForward);
        this->FarSide[axis] = BoxPacket<D, Node<D>::Width>::SideAt(axis, isForward);
      });
  }

  /// So that the nearest float is not below. What no float is near, 0 is: boxes are rounded outward
  /// by as much.
  static double RoundedUp(double place)
  {
    constexpr double half = 1.0 / (1 << 23);
    return place + half * std::abs(place);
  }

  double Begin = 0.0;
  double PerLength = 0.0; ///< 1 over the length that the clipping left, in the parameter
  std::size_t NearSide[D];
  std::size_t FarSide[D];
  Spread NearOrigin[D];
  Spread FarOrigin[D];
  Spread Inverse[D];
  Visitor& TheVisitor;
};

}

#endif
