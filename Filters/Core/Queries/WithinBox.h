// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Queries_WithinBox_h
#define skd_Queries_WithinBox_h

#include "NoLeafFilter.h"

namespace skd
{

/// Elements whose boxes overlap a box (Algorithm 5.3). A point is a box, too.
/// `visitor(element)` returns false to end the search.
template <int D, class Visitor, class LeafFilter = NoLeafFilter>
class WithinBox
{
public:
  static constexpr bool Ordered = false;
  static constexpr bool SkipsLeaves = LeafFilter::SkipsLeaves;

  WithinBox(const Frame<D>& frame, const Box<D>& box, Visitor& visitor,
    const LeafFilter& leafFilter = LeafFilter())
    : TheVisitor(visitor)
    , TheLeafFilter(leafFilter)
  {
    for (int axis = 0; axis < D; ++axis)
    {
      this->Min[axis] = Spread(frame.Down(box.Min[axis], axis));
      this->Max[axis] = Spread(frame.Up(box.Max[axis], axis));
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

  unsigned TestElements(const Node<D>& leaf, float* keys) const
  {
    return this->TheLeafFilter.Knows(leaf) ? this->TheLeafFilter.Pass(leaf, keys)
                                           : this->TestBoxes(leaf.Boxes, keys);
  }

  bool Knows(const Node<D>& inner) const { return this->TheLeafFilter.Knows(inner); }
  unsigned TestKnown(std::uint32_t leaf, std::uint32_t count, float* keys) const
  {
    return this->TheLeafFilter.Pass(leaf, count, keys);
  }
  void FetchKnown(std::uint32_t leaf) const { this->TheLeafFilter.Fetch(leaf); }

  float Limit() const { return 0.0f; }
  bool Visit(std::uint32_t element) { return this->TheVisitor(element); }

private:
  Spread Min[D];
  Spread Max[D];
  Visitor& TheVisitor;
  LeafFilter TheLeafFilter;
};

}

#endif
