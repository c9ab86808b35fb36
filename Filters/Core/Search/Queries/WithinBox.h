// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Queries_WithinBox_h
#define skd_Queries_WithinBox_h

#include "../Tree/Walk.h"
#include "QueryBox.h"

namespace skd
{

/// Elements whose boxes overlap a box (Algorithm 5.3). A point is a box, too.
/// `visitor(element)` returns false to end the search.
template <int D, class Visitor, class LeafFilter = NoLeafFilter>
class WithinBox : public FilteredQuery<WithinBox<D, Visitor, LeafFilter>, LeafFilter>
{
public:
  static constexpr bool Ordered = false;

  WithinBox(const Frame<D>& frame, const Box<D>& box, Visitor& visitor,
    const LeafFilter& leafFilter = LeafFilter())
    : FilteredQuery<WithinBox, LeafFilter>(0.0f, leafFilter)
    , TheBox(OuterBox(frame, box))
    , TheVisitor(visitor)
  {
  }

  /// The same about a point, given in the frame.
  WithinBox(const Vector<D>& local, Visitor& visitor, const LeafFilter& leafFilter)
    : FilteredQuery<WithinBox, LeafFilter>(0.0f, leafFilter)
    , TheBox(AboutPoint(local))
    , TheVisitor(visitor)
  {
  }

  template <int W>
  SKD_FLATTEN unsigned TestBoxes(const BoxPacket<D, W>& boxes, float*) const
  {
    return this->TheBox.Overlapping(boxes);
  }

  bool Visit(std::uint32_t element) { return this->TheVisitor(element); }

private:
  QueryBox<D> TheBox;
  Visitor& TheVisitor;
};

}

#endif
