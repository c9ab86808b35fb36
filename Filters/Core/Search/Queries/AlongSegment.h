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
  AlongSegment(const Frame<D>& frame, const Segment<D>& segment, double margin, Visitor& visitor,
    const PartsOfLeafFilter&... parts)
    : FilteredQuery<AlongSegment, LeafFilter>(-1.0f, parts...) // less than every key
    , TheVisitor(visitor)
  {
    Line line(frame, segment);
    double rounding = Line::RoundingNear;
    if (!line.IsNear())
    {
      rounding = line.Rounding();
      if (!std::isfinite(rounding) ||
        !this->Clip(line, 2.0 + margin * frame.Scale + 2.0 * rounding))
      {
        return;
      }
    }
    if (margin >= 0.0)
    {
      this->SetLocal(line, std::min(margin * frame.Scale + rounding, Most));
      this->EndAt(1.0f);
    }
  }

  template <int W>
  SKD_FLATTEN unsigned TestBoxes(const BoxPacket<D, W>& boxes, float* keys) const
  {
    Lanes<W> enter(0.0f);
    Lanes<W> leave(this->TheLimit);
    ForEachAxis<D>(
      [&](int axis)
      {
        const Lanes<W> back = Lanes<W>(this->Back[axis]).InRegisters();
        const Lanes<W> near = boxes.Side(this->Sides->Near[axis]);
        const Lanes<W> far = boxes.Side(this->Sides->Far[axis]);
        enter = Max(MinusProduct(Lanes<W>(this->Enter[axis]), near, back), enter);
        leave = Min(MinusProduct(Lanes<W>(this->Leave[axis]), far, back), leave);
      });
    enter.Store(keys);
    return LessEqual(enter, leave);
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
  void EndAt(float last) { this->TheLimit = last + Slack; }

  static constexpr float Slack = tolerances::SegmentParameter;

  /// "Insure width of L in each coordinate direction".
  static constexpr double Least = tolerances::LeastAlong;
  /// What is beyond so much is as good there.
  static constexpr double Most = 1.0 / Least;
  using Packet = BoxPacket<D, Node<D>::Width>;

  /// A segment in the tree's frame. Which way it runs along an axis is anyone's guess, and there is
  /// no branch on it.
  struct Line
  {
    Line(const Frame<D>& frame, const Segment<D>& segment)
    {
      const AxisLanes<D> scale(frame.Scale);
      const AxisLanes<D> a(segment.A);
      this->Along = (AxisLanes<D>(segment.B) - a) * scale;
      this->From = (a - AxisLanes<D>(frame.Centre)) * scale;
      this->Inverse = AxisLanes<D>(1.0) / Max(Abs(this->Along), AxisLanes<D>(Least));
    }

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

    AxisLanes<D> From;
    AxisLanes<D> Along;
    AxisLanes<D> Inverse; ///< of the lengths along the axes, in the parameter of what is left
  };

  /// Leaves of a line what no coordinate is beyond `room` of. False: nothing.
  bool Clip(Line& line, double room)
  {
    const Interval inside = line.Within(room);
    if (!(inside.Min <= inside.Max))
    {
      return false;
    }
    this->Begin = inside.Min;
    this->PerLength = 1.0 / std::max(inside.Max - inside.Min, Least);
    line.From = line.From + AxisLanes<D>(this->Begin) * line.Along;
    line.Inverse = Min(line.Inverse * AxisLanes<D>(this->PerLength), AxisLanes<D>(Most));
    return true;
  }

  void SetLocal(const Line& line, double margin2)
  {
    const AxisLanes<D> room = TimesSign(Room(line.From, margin2), line.Along);
    const AxisLanes<D> back = -TimesSign(line.Inverse, line.Along);
    SpreadOut((line.From + room) * back, this->Enter);
    SpreadOut((line.From - room) * back + AxisLanes<D>(Slack), this->Leave);
    SpreadOut(back, this->Back);
    this->Sides = &Packet::SidesOf(line.Along.Signs());
    this->TheLeafFilter.Aim(line.From.Values(), margin2);
  }

  static void SpreadOut(const AxisLanes<D>& from, Spread* to)
  {
    float values[AxisLanes<D>::Room];
    from.StorePadded(values);
    ForEachAxis<AxisLanes<D>::Room>([&](int i) { to[i] = Spread(values[i]); });
  }

  /// How far coordinates are moved outward so that the floats nearest to their products with a
  /// number, and those of sides of boxes with the float nearest to it, are on the safe side by the
  /// margin. (Of the floats that parameters are sums of each may be off by 2^-24; coordinates of
  /// boxes are at most 1.) What no float is near, 0 is: boxes are rounded outward by as much.
  static AxisLanes<D> Room(const AxisLanes<D>& coordinates, double margin2)
  {
    constexpr double roundings = 2.125 / (1 << 24);
    const AxisLanes<D> margin(margin2);
    return margin + AxisLanes<D>(roundings) * (Abs(coordinates) + margin + AxisLanes<D>(1.0));
  }

  double Begin = 0.0;
  double PerLength = 1.0; ///< 1 over the length that the clipping left, in the parameter
  const typename Packet::Sides* Sides = nullptr;
  ///@{
  /// The parameters at which the planes through the frame's centre are passed, and that for each
  /// step, negative: what a side of a box is away is subtracted.
  Spread Enter[AxisLanes<D>::Room];
  Spread Leave[AxisLanes<D>::Room];
  Spread Back[AxisLanes<D>::Room];
  ///@}
  Visitor& TheVisitor;
};

}

#endif
