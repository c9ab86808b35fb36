// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Queries_PointKeys_h
#define skd_Queries_PointKeys_h

#include "../Tree/Node.h"

namespace skd
{

/// A point as the boxes of a tree see it: its distances to a bundle of boxes (section 4.1), in the
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
      this->Low[axis] = frame.Down(point[axis], axis);
      this->High[axis] = frame.Up(point[axis], axis);
    }
  }

  template <int W>
  void MinDistances2(const Bundle<D, W>& boxes, float* keys) const
  {
    for (int lane = 0; lane < W; ++lane)
    {
      float sum = 0.0f;
      for (int axis = 0; axis < D; ++axis)
      {
        const float below = boxes.Min[axis][lane] - this->High[axis];
        const float above = this->Low[axis] - boxes.Max[axis][lane];
        float gap = below > above ? below : above;
        gap = gap > 0.0f ? gap : 0.0f;
        sum += gap * gap;
      }
      keys[lane] = sum;
    }
  }

  template <int W>
  void MaxDistances2(const Bundle<D, W>& boxes, float* farthest) const
  {
    constexpr float slack = 1.0f + 1.0f / (1 << 19);
    constexpr float denormals = 1e-44f;
    for (int lane = 0; lane < W; ++lane)
    {
      float sum = 0.0f;
      for (int axis = 0; axis < D; ++axis)
      {
        const float fromMin = this->High[axis] - boxes.Min[axis][lane];
        const float fromMax = boxes.Max[axis][lane] - this->Low[axis];
        const float reach = fromMin > fromMax ? fromMin : fromMax;
        sum += reach * reach;
      }
      farthest[lane] = sum * slack + denormals;
    }
  }

private:
  float Low[D];
  float High[D];
};

}

#endif
