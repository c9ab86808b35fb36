// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Queries_AlongSegment_h
#define skd_Queries_AlongSegment_h

#include "../Tree/Walk.h"
#include "LocalLine.h"

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
    LocalLine<D> line(frame, segment);
    if (line.Clip(frame, margin))
    {
      this->Begin = line.Begin;
      this->PerLength = line.PerLength;
      this->SetLocal(line);
      this->TheLimit = LocalLine<D>::LimitAt(1.0f);
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
    LocalLine<D>::Lower(this->TheLimit, (parameter - this->Begin) * this->PerLength);
    return true;
  }

private:
  using Packet = BoxPacket<D, Node<D>::Width>;

  void SetLocal(const LocalLine<D>& line)
  {
    const AxisLanes<D> room = TimesSign(line.Room(), line.Along);
    const AxisLanes<D> back = -TimesSign(line.Inverse, line.Along);
    SpreadOut((line.From + room) * back, this->Enter);
    SpreadOut((line.From - room) * back + AxisLanes<D>(LocalLine<D>::Slack), this->Leave);
    SpreadOut(back, this->Back);
    this->Sides = &Packet::SidesOf(line.Along.Signs());
    this->TheLeafFilter.Aim(line.From.Values(), line.Margin);
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
