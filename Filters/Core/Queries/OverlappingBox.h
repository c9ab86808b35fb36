// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Queries_OverlappingBox_h
#define skd_Queries_OverlappingBox_h

#include "../Tree/Node.h"

namespace skd
{

/// Elements whose own boxes overlap a box (Algorithm 5.3), most of them without a look at these.
///
/// A tree has safety boxes, wider than the elements' own by at most `excess` (world units) on each
/// side. What is inside the query box, whole subtrees, or overlaps it even without that excess, is
/// `sure(element)`; of the rest, in a thin layer about the query box's faces, `visitor(element)`
/// has to find out.
template <int D, class Visitor, class Sure>
class OverlappingBox
{
public:
  static constexpr bool Ordered = false;

  OverlappingBox(
    const Frame<D>& frame, const Box<D>& box, double excess, Visitor& visitor, Sure& sure)
    : Excess(Frame<D>::RoundUp(excess * frame.Scale + Rounding))
    , TheVisitor(visitor)
    , TheSure(sure)
  {
    for (int axis = 0; axis < D; ++axis)
    {
      this->Min[axis] = Spread(frame.Down(box.Min[axis], axis));
      this->Max[axis] = Spread(frame.Up(box.Max[axis], axis));
      this->InnerMin[axis] = Spread(frame.Up(box.Min[axis], axis));
      this->InnerMax[axis] = Spread(frame.Down(box.Max[axis], axis));
    }
  }

  template <int W>
  SKD_IN_ONE_PIECE unsigned TestBoxes(const BoxPacket<D, W>& boxes, float*) const
  {
    unsigned overlapping = ~0u;
    ForEachAxis<D>(
      [&](int axis)
      {
        overlapping &= LessEqual(boxes.Mins(axis), Lanes<W>(this->Max[axis])) &
          LessEqual(Lanes<W>(this->Min[axis]), boxes.Maxs(axis));
      });
    return overlapping;
  }

  /// Bit i: all that is below lane i is an answer.
  SKD_IN_ONE_PIECE unsigned SureOf(const Node<D>& node) const
  {
    return node.IsLeaf ? this->Inside(node.Boxes) | this->Overlapping(node.Boxes)
                       : this->Inside(node.Boxes);
  }

  float Limit() const { return 0.0f; }
  bool Visit(std::uint32_t element) { return this->TheVisitor(element); }
  bool VisitSure(std::uint32_t element) { return this->TheSure(element); }

private:
  /// More than rounding outward and a sum add to coordinates of at most 1.
  static constexpr double Rounding = 1e-6;

  template <int W>
  unsigned Inside(const BoxPacket<D, W>& boxes) const
  {
    unsigned inside = ~0u;
    ForEachAxis<D>(
      [&](int axis)
      {
        inside &= LessEqual(Lanes<W>(this->InnerMin[axis]), boxes.Mins(axis)) &
          LessEqual(boxes.Maxs(axis), Lanes<W>(this->InnerMax[axis]));
      });
    return inside;
  }

  template <int W>
  unsigned Overlapping(const BoxPacket<D, W>& boxes) const
  {
    const Lanes<W> excess(this->Excess);
    unsigned overlapping = ~0u;
    ForEachAxis<D>(
      [&](int axis)
      {
        overlapping &= LessEqual(boxes.Mins(axis) + excess, Lanes<W>(this->InnerMax[axis])) &
          LessEqual(Lanes<W>(this->InnerMin[axis]), boxes.Maxs(axis) - excess);
      });
    return overlapping;
  }

  Spread Min[D];
  Spread Max[D];
  Spread InnerMin[D];
  Spread InnerMax[D];
  float Excess;
  Visitor& TheVisitor;
  Sure& TheSure;
};

}

#endif
