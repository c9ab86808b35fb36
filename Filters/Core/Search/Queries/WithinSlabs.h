// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Queries_WithinSlabs_h
#define skd_Queries_WithinSlabs_h

#include "../../Geometry/Plane.h"
#include "../Tree/Node.h"
#include "../Tree/Tolerances.h"

#include <array>

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
    const double rounding =
      tolerances::PlaneOffset * Dot(Magnitudes(plane.Normal), Magnitudes(origin));
    this->Offset = Frame<D>::RoundDown(offset); // the slack covers it
    this->HalfWidth = Frame<D>::RoundUp(
      halfWidth * frame.Scale + tolerances::PlaneSum * (1.0 + std::abs(offset)) + rounding);
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

  /// Bit i is set where the box of lane i comes near enough.
  template <int W>
  unsigned Overlapping(const BoxPacket<D, W>& boxes) const
  {
    Lanes<W> distance(-this->Offset);
    Lanes<W> maxDistance(this->HalfWidth);
    for (int axis = 0; axis < D; ++axis)
    {
      const Lanes<W> min = boxes.Mins(axis);
      const Lanes<W> max = boxes.Maxs(axis);
      distance = distance + Lanes<W>(this->Normal[axis]) * (min + max);
      maxDistance = maxDistance + Lanes<W>(this->Weights[axis]) * (max - min);
    }
    return LessEqual(distance, maxDistance) & LessEqual(Lanes<W>(0.0f) - distance, maxDistance);
  }

private:
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

/// Elements whose boxes overlap each of N slabs: one for a plane, three for a turned box.
/// `visitor(element)` returns false to end the search.
template <int D, int N, class Visitor>
class WithinSlabs
{
public:
  static constexpr bool Ordered = false;

  WithinSlabs(const std::array<Slab<D>, N>& slabs, Visitor& visitor)
    : Slabs(slabs)
    , TheVisitor(visitor)
  {
  }

  template <int W>
  unsigned TestBoxes(const BoxPacket<D, W>& boxes, float*) const
  {
    unsigned overlapping = ~0u;
    for (const Slab<D>& slab : this->Slabs)
    {
      overlapping &= slab.Overlapping(boxes);
    }
    return overlapping;
  }

  float Limit() const { return 0.0f; }
  bool Visit(std::uint32_t element) { return this->TheVisitor(element); }

private:
  std::array<Slab<D>, N> Slabs;
  Visitor& TheVisitor;
};

/// Elements whose boxes come within a distance of a plane. `visitor(element)` returns false to end
/// the search.
template <int D, class Visitor>
class AlongPlane : public WithinSlabs<D, 1, Visitor>
{
public:
  AlongPlane(const Frame<D>& frame, const Plane<D>& plane, double tolerance, Visitor& visitor)
    : WithinSlabs<D, 1, Visitor>({ Slab<D>(frame, plane, tolerance) }, visitor)
  {
  }
};

}

#endif
