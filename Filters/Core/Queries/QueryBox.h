// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Queries_QueryBox_h
#define skd_Queries_QueryBox_h

#include "../Tree/Node.h"

namespace skd
{

/// A box that is asked about, in a tree's frame: each of its sides for all lanes of a packet.
template <int D>
class QueryBox
{
public:
  /// Each side moved inward by `inset`.
  explicit QueryBox(const FloatBox<D>& box, float inset = 0.0f)
  {
    for (int axis = 0; axis < D; ++axis)
    {
      this->Min[axis] = Spread(box.Min[axis] + inset);
      this->Max[axis] = Spread(box.Max[axis] - inset);
    }
  }

  /// Bit i is set where the box of lane i overlaps.
  template <int W>
  unsigned Overlapping(const BoxPacket<D, W>& boxes) const
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

  /// Bit i is set where the box of lane i is within this one.
  template <int W>
  unsigned Holding(const BoxPacket<D, W>& boxes) const
  {
    unsigned held = ~0u;
    ForEachAxis<D>(
      [&](int axis)
      {
        held &= LessEqual(Lanes<W>(this->Min[axis]), boxes.Mins(axis)) &
          LessEqual(boxes.Maxs(axis), Lanes<W>(this->Max[axis]));
      });
    return held;
  }

private:
  Spread Min[D];
  Spread Max[D];
};

}

#endif
