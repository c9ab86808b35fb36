// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Queries_OverlappingBox_h
#define skd_Queries_OverlappingBox_h

#include "../Tree/Tolerances.h"
#include "QueryBox.h"

namespace skd
{

/// Elements whose own boxes overlap a box (Algorithm 5.3), mostly without testing these.
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
    : Excess(Frame<D>::RoundUp(excess * frame.Scale + tolerances::BoxExcess))
    , TheVisitor(visitor)
    , TheSure(sure)
  {
    SetAround(frame, box, this->Outer, this->Inner);
  }

  template <int W>
  SKD_FLATTEN unsigned TestBoxes(const BoxPacket<D, W>& boxes, float*) const
  {
    return this->Outer.Overlapping(boxes);
  }

  /// Bit i: all elements below lane i are answers.
  SKD_FLATTEN unsigned SureOf(const Node<D>& node) const
  {
    const unsigned inside = this->Inner.Holding(node.Boxes);
    return node.IsLeaf
      ? inside | this->Inner.Overlapping(node.Boxes, Lanes<Node<D>::Width>(this->Excess))
      : inside;
  }

  float Limit() const { return 0.0f; }
  bool Visit(std::uint32_t element) { return this->TheVisitor(element); }
  bool VisitSure(std::uint32_t element) { return this->TheSure(element); }

private:
  QueryBox<D> Outer;
  QueryBox<D> Inner;
  float Excess; ///< of the tree's boxes: what overlaps with so much less does so without it
  Visitor& TheVisitor;
  Sure& TheSure;
};

}

#endif
