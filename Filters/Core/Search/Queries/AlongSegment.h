// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Queries_AlongSegment_h
#define skd_Queries_AlongSegment_h

#include "../../Geometry/Segment.h"
#include "../Tree/AxisLanes.h"
#include "../Tree/Tolerances.h"
#include "../Tree/Walk.h"

namespace skd
{

/// Elements along a segment (Algorithm 5.2), by the parameter at which it enters their boxes.
///
/// `visitor(element)` intersects an element and returns the new limit of the search, a parameter
/// 0..1 along the segment: the first hit so far, or 1 for all hits.
///
/// A segment with an end far from the tree is first clipped in double precision, so that the end
/// costs no accuracy, to the cube of the tree's frame and as much room again: no new end comes near
/// a box. `margin` (world units) widens every box, for searches with a tolerance. Of a short query
/// much is what is done once a segment, one step waiting for the other: clipping would take as long
/// as five nodes.
/// `InOrder`: whether the nearest comes first. Where all is wanted, any order will do.
template <int D, class Visitor, class LeafFilter = NoLeafFilter, bool InOrder = true>
class AlongSegment : public FilteredQuery<AlongSegment<D, Visitor, LeafFilter, InOrder>, LeafFilter>
{
public:
  static constexpr bool Ordered = InOrder;

  template <class... PartsOfLeafFilter>
  SKD_NOINLINE AlongSegment(const Frame<D>& frame, const Segment<D>& segment, double margin,
    Visitor& visitor, const PartsOfLeafFilter&... parts)
    : FilteredQuery<AlongSegment, LeafFilter>(-1.0f, parts...) // less than every key
    , TheVisitor(visitor)
  {
    const Line line(frame, segment);
    const bool isNear = line.IsNear();
    const double rounding = isNear ? Line::RoundingNear : line.Rounding();
    const double margin2 = margin * frame.Scale + rounding;
    if (!isNear)
    {
      const Interval inside = line.Within(2.0 + margin2 + rounding);
      if (!(inside.Min <= inside.Max && std::isfinite(rounding)))
      {
        return;
      }
      this->Begin = inside.Min;
      this->PerLength = 1.0 / std::max(inside.Max - inside.Min, Least);
    }
    if (margin >= 0.0)
    {
      this->SetLocal(line, std::min(margin2, Most));
      this->EndAt(1.0f);
    }
  }

  template <int W>
  SKD_FLATTEN unsigned TestBoxes(const BoxPacket<D, W>& boxes, float* keys) const
  {
    Lanes<W> enter(0.0f);
    Lanes<W> leave(this->Last);
    ForEachAxis<D>(
      [&](int axis)
      {
        const Lanes<W> back(this->Back[axis]);
        const Lanes<W> near = boxes.Side(this->NearSide[axis]);
        const Lanes<W> far = boxes.Side(this->FarSide[axis]);
        enter = Max((Lanes<W>(this->NearOrigin[axis]) - near) * back, enter);
        leave = Min((Lanes<W>(this->FarOrigin[axis]) - far) * back, leave);
      });
    enter.Store(keys);
    return LessEqual(enter, leave + Lanes<W>(Slack));
  }

  bool Visit(std::uint32_t element)
  {
    const double parameter = this->TheVisitor(element);
    const double local = (parameter - this->Begin) * this->PerLength;
    if (local < 1.0)
    {
      this->EndAt(Frame<D>::RoundUpInRange(std::max(local, 0.0)));
    }
    return true;
  }

private:
  /// Nothing beyond this parameter is wanted any more.
  void EndAt(float last)
  {
    this->Last = last;
    this->TheLimit = last + Slack;
  }

  static constexpr float Slack = tolerances::SegmentParameter;

  /// "Insure width of L in each coordinate direction".
  static constexpr double Least = tolerances::LeastAlong;
  /// What is beyond so much is as good there.
  static constexpr double Most = 1.0 / Least;
  using Packet = BoxPacket<D, Node<D>::Width>;

  /// A segment in the tree's frame, mirrored so that it runs forward along every axis: which way
  /// it does is anyone's guess, and there is no branch on it.
  struct Line
  {
    Line(const Frame<D>& frame, const Segment<D>& segment)
    {
      const AxisLanes<D> scale(frame.Scale);
      const AxisLanes<D> a(segment.A);
      const AxisLanes<D> along = (AxisLanes<D>(segment.B) - a) * scale;
      this->Sign = IfLess(along, AxisLanes<D>(0.0), AxisLanes<D>(-1.0), AxisLanes<D>(1.0));
      this->From = this->Sign * ((a - AxisLanes<D>(frame.Centre)) * scale);
      this->Along = this->Sign * along;
      this->Inverse = AxisLanes<D>(1.0) / Max(this->Along, AxisLanes<D>(Least));
    }

    /// Whether no end is far from the tree: then nothing is clipped.
    bool IsNear() const
    {
      const AxisLanes<D> most = Max(-this->From, this->From + this->Along);
      return AllLessEqual(most, AxisLanes<D>(Near));
    }

    ///@{
    /// The maximum rounding error of points of the segment. Infinite or NaN if an end is.
    double Rounding() const
    {
      const Vector<D> most = (Max(this->From, -this->From) + this->Along).Values();
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
      const Vector<D> enter = ((AxisLanes<D>(-room) - this->From) * this->Inverse).Values();
      const Vector<D> leave = ((AxisLanes<D>(room) - this->From) * this->Inverse).Values();
      Interval inside{ 0.0, 1.0 };
      ForEachAxis<D>(
        [&](int axis)
        {
          inside.Min = std::max(inside.Min, enter[axis]);
          inside.Max = std::min(inside.Max, leave[axis]);
        });
      return inside;
    }

    AxisLanes<D> Sign; ///< -1 of an axis that is mirrored
    AxisLanes<D> From;
    AxisLanes<D> Along;
    AxisLanes<D> Inverse; ///< of Along
  };

  void SetLocal(const Line& line, double margin2)
  {
    const AxisLanes<D> begin = line.From + AxisLanes<D>(this->Begin) * line.Along;
    const AxisLanes<D> near = line.Sign * RoundedUp(begin + AxisLanes<D>(margin2));
    const AxisLanes<D> far = line.Sign * RoundedUp(AxisLanes<D>(margin2) - begin);
    const AxisLanes<D> perStep =
      Min(line.Inverse * AxisLanes<D>(this->PerLength), AxisLanes<D>(Most));
    SpreadOut(near, this->NearOrigin);
    SpreadOut(-far, this->FarOrigin);
    SpreadOut(-(line.Sign * perStep), this->Back);
    // The two sides are at the same distance from the middle of them.
    const AxisLanes<D> toFar = line.Sign * AxisLanes<D>(Packet::HalfExtentOffset);
    (AxisLanes<D>(Packet::MiddlesOfSides()) - toFar).Store(this->NearSide);
    (AxisLanes<D>(Packet::MiddlesOfSides()) + toFar).Store(this->FarSide);
    this->TheLeafFilter.Aim((line.Sign * begin).Values(), margin2);
  }

  static void SpreadOut(const AxisLanes<D>& from, Spread* to)
  {
    float values[D];
    from.Store(values);
    ForEachAxis<D>([&](int axis) { to[axis] = Spread(values[axis]); });
  }

  /// So that the nearest float is not below. What no float is near, 0 is: boxes are rounded outward
  /// by as much.
  static AxisLanes<D> RoundedUp(const AxisLanes<D>& coordinates)
  {
    constexpr double half = 1.0 / (1 << 23);
    return coordinates + AxisLanes<D>(half) * Max(coordinates, -coordinates);
  }

  float Last = -1.0f;
  double Begin = 0.0;
  double PerLength = 1.0; ///< 1 over the length that the clipping left, in the parameter
  std::int32_t NearSide[D];
  std::int32_t FarSide[D];
  Spread NearOrigin[D];
  Spread FarOrigin[D];
  Spread
    Back[D]; ///< the parameter for each step, negative: boxes are subtracted from what is fixed
  Visitor& TheVisitor;
};

}

#endif
