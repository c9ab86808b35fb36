// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Queries_AlongPlane_h
#define skd_Queries_AlongPlane_h

#include "../Geometry/Plane.h"
#include "../Tree/Node.h"

namespace skd
{

/// Elements whose boxes come within a distance of a plane. `leaf(element)` returns false to end
/// the search.
template <int D, class Leaf>
class AlongPlane
{
public:
  static constexpr bool Ordered = false;

  AlongPlane(const Frame<D>& frame, const Plane<D>& plane, double tolerance, Leaf& leaf)
    : TheLeaf(leaf)
  {
    const double offset = Dot(plane.Normal, plane.Origin - frame.Centre) * frame.Scale;
    const double width = tolerance * frame.Scale + Slack * (1.0 + std::abs(offset));
    this->Lowest = Frame<D>::RoundDown(offset - width);
    this->Highest = Frame<D>::RoundUp(offset + width);
    for (int axis = 0; axis < D; ++axis)
    {
      this->Normal[axis] = static_cast<float>(plane.Normal[axis]);
    }
  }

  template <int W>
  void Keys(const Bundle<D, W>& boxes, float* keys) const
  {
    for (int lane = 0; lane < W; ++lane)
    {
      float least = 0.0f;
      float greatest = 0.0f;
      for (int axis = 0; axis < D; ++axis)
      {
        const float a = this->Normal[axis] * boxes.Min[axis][lane];
        const float b = this->Normal[axis] * boxes.Max[axis][lane];
        least += a < b ? a : b;
        greatest += a > b ? a : b;
      }
      keys[lane] = least <= this->Highest && this->Lowest <= greatest ? 0.0f : 1.0f;
    }
  }

  float Limit() const { return 0.0f; }
  bool Visit(std::uint32_t element) { return this->TheLeaf(element); }

private:
  /// Above the rounding of a sum of a few products of numbers of at most 1 in single precision.
  static constexpr double Slack = 4e-6;

  float Normal[D];
  float Lowest;
  float Highest;
  Leaf& TheLeaf;
};

}

#endif
