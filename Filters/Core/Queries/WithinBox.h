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
  void Keys(const Bundle<D, W>& boxes, float* keys) const
  {
    for (int lane = 0; lane < W; ++lane)
    {
      bool overlaps = true;
      for (int axis = 0; axis < D; ++axis)
      {
        overlaps &= boxes.Min[axis][lane] <= this->Query.Max[axis];
        overlaps &= this->Query.Min[axis] <= boxes.Max[axis][lane];
      }
      keys[lane] = overlaps ? 0.0f : 1.0f;
    }
  }

  float Limit() const { return 0.0f; }
  bool Visit(std::uint32_t element) { return this->TheLeaf(element); }

private:
  FloatBox<D> Query;
  Leaf& TheLeaf;
};

}

#endif
