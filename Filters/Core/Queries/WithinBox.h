// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Queries_WithinBox_h
#define skd_Queries_WithinBox_h

#include "../Tree/Node.h"

namespace skd
{

/// Elements whose boxes overlap a box (Algorithm 5.3). A point is a box, too.
/// `leaf(element)` returns false to end the search.
template <int D, class Leaf>
class WithinBox
{
public:
  static constexpr bool Ordered = false;

  WithinBox(const Frame<D>& frame, const Box<D>& box, Leaf& leaf)
    : Query(frame.Outward(box))
    , TheLeaf(leaf)
  {
  }

  template <int W>
  unsigned Reach(const Bundle<D, W>& boxes, float*) const
  {
    unsigned overlapping = ~0u;
    for (int axis = 0; axis < D; ++axis)
    {
      overlapping &= LessEqual(boxes.Mins(axis), Lanes<W>(this->Query.Max[axis]));
      overlapping &= LessEqual(Lanes<W>(this->Query.Min[axis]), boxes.Maxs(axis));
    }
    return overlapping;
  }

  float Limit() const { return 0.0f; }
  bool Visit(std::uint32_t element) { return this->TheLeaf(element); }

private:
  FloatBox<D> Query;
  Leaf& TheLeaf;
};

}

#endif
