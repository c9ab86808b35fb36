// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Queries_Slab_h
#define skd_Queries_Slab_h

#include "../Geometry/Plane.h"
#include "../Tree/Node.h"

namespace skd
{

/// The space within a distance of a plane, as the boxes of a tree see it.
///
/// A box reaches Weights . (half lengths) to either side of its centre along the normal. With the
/// magnitudes of the normal as weights that is the box itself; larger weights stand for the bounds
/// that the box has after a turn.
template <int D>
class Slab
{
public:
  Slab() = default;

  Slab(const Frame<D>& frame, const Plane<D>& plane, double halfWidth, const Vector<D>& weights)
  {
    const Vector<D> origin = frame.Local(plane.Origin);
    const double offset = Dot(plane.Normal, origin);
    const double rounding = 1e-15 * Dot(Magnitudes(plane.Normal), Magnitudes(origin));
    this->Offset = static_cast<float>(offset);
    this->HalfWidth = Frame<D>::RoundUp(
      halfWidth * frame.Scale + Slack * (1.0 + std::abs(offset)) + rounding);
    for (int axis = 0; axis < D; ++axis)
    {
      this->Normal[axis] = static_cast<float>(0.5 * plane.Normal[axis]);
      this->Weights[axis] = static_cast<float>(0.5 * weights[axis]);
    }
  }

  Slab(const Frame<D>& frame, const Plane<D>& plane, double halfWidth)
    : Slab(frame, plane, halfWidth, Magnitudes(plane.Normal))
  {
  }

  template <int W>
  bool Overlaps(const Bundle<D, W>& boxes, int lane) const
  {
    float centre = 0.0f;
    float reach = 0.0f;
    for (int axis = 0; axis < D; ++axis)
    {
      centre += this->Normal[axis] * (boxes.Min[axis][lane] + boxes.Max[axis][lane]);
      reach += this->Weights[axis] * (boxes.Max[axis][lane] - boxes.Min[axis][lane]);
    }
    const float distance = centre - this->Offset;
    return (distance < 0.0f ? -distance : distance) <= reach + this->HalfWidth;
  }

private:
  /// Above the rounding of a sum of a few products of numbers of at most 2 in single precision.
  static constexpr double Slack = 1e-5;

  static Vector<D> Magnitudes(Vector<D> normal)
  {
    for (int axis = 0; axis < D; ++axis)
    {
      normal[axis] = std::abs(normal[axis]);
    }
    return normal;
  }

  float Normal[D];
  float Weights[D];
  float Offset;
  float HalfWidth;
};

}

#endif
