// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Queries_PointKeys_h
#define skd_Queries_PointKeys_h

#include "../Tree/Node.h"
#include "../Tree/Tolerances.h"

namespace skd
{

/// A point as the boxes of a tree see it: its distances to a packet of boxes (section 4.1), in the
/// frame, squared. In single precision the point itself is a small box: that keeps least distances
/// on the low side and greatest ones on the high side. The few roundings of the sum are covered by
/// the slack of Frame::UpperBound2.
template <int D>
class PointKeys
{
public:
  PointKeys(const Frame<D>& frame, const Vector<D>& point)
  {
    for (int axis = 0; axis < D; ++axis)
    {
      this->Low[axis] = Spread(frame.Down(point[axis], axis));
      this->High[axis] = Spread(frame.Up(point[axis], axis));
    }
  }

  template <int W>
  Lanes<W> MinDistances2(const BoxPacket<D, W>& boxes) const
  {
    Lanes<W> sum(0.0f);
    ForEachAxis<D>(
      [&](int axis)
      {
        const Lanes<W> below = boxes.Mins(axis) - Lanes<W>(this->High[axis]);
        const Lanes<W> above = Lanes<W>(this->Low[axis]) - boxes.Maxs(axis);
        const Lanes<W> gap = Max(Max(below, above), Lanes<W>(0.0f));
        sum = sum + gap * gap;
      });
    return sum;
  }

  template <int W>
  Lanes<W> MaxDistances2(const BoxPacket<D, W>& boxes) const
  {
    Lanes<W> sum(0.0f);
    ForEachAxis<D>(
      [&](int axis)
      {
        const Lanes<W> fromMin = Lanes<W>(this->High[axis]) - boxes.Mins(axis);
        const Lanes<W> fromMax = boxes.Maxs(axis) - Lanes<W>(this->Low[axis]);
        const Lanes<W> reach = Max(fromMin, fromMax);
        sum = sum + reach * reach;
      });
    constexpr float slack = 1.0f + 1.0f / (1 << 19);
    constexpr auto denormals = static_cast<float>(tolerances::Denormal2);
    return sum * Lanes<W>(slack) + Lanes<W>(denormals);
  }

private:
  Spread Low[D];
  Spread High[D];
};

}

#endif
