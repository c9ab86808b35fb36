// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Tree_Frame_h
#define skd_Tree_Frame_h

#include "../../Geometry/Box.h"
#include "Tolerances.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

namespace skd
{

/// The box of an element or a node in a tree's frame.
template <int D>
struct FloatBox
{
  float Min[D];
  float Max[D];
};

/// A box that Enclose() makes into any other.
template <int D>
FloatBox<D> NoBox()
{
  FloatBox<D> box;
  ForEachAxis<D>(
    [&](int axis)
    {
      box.Min[axis] = std::numeric_limits<float>::max();
      box.Max[axis] = std::numeric_limits<float>::lowest();
    });
  return box;
}

/// Makes `box` hold the other, too.
template <int D>
void Enclose(FloatBox<D>& box, const FloatBox<D>& other)
{
  ForEachAxis<D>(
    [&](int axis)
    {
      box.Min[axis] = std::min(box.Min[axis], other.Min[axis]);
      box.Max[axis] = std::max(box.Max[axis], other.Max[axis]);
    });
}

/// Half the surface of a box, in any dimension: 1 of an interval, and half the way round a
/// rectangle.
template <int D>
double HalfArea(const FloatBox<D>& box)
{
  double sum = 0.0;
  for (int side = 0; side < D; ++side)
  {
    double area = 1.0;
    for (int axis = 0; axis < D; ++axis)
    {
      area *= axis == side ? 1.0 : double(box.Max[axis]) - box.Min[axis];
    }
    sum += area;
  }
  return sum;
}

/// The coordinate frame of a tree's single-precision boxes: world coordinates relative to the
/// centre of the set, scaled by a power of two so that the set lies in [-1, 1]. So a tree does not
/// lose precision on data that are tiny, huge or far from the origin.
///
/// Rounding is outward and monotone: a <= b in the world gives Down(a) <= Up(b) in the frame. Boxes
/// that overlap in the world overlap in the frame.
template <int D>
struct Frame
{
  Vector<D> Centre;
  double Scale;

  static Frame Of(const Box<D>& bounds)
  {
    Frame frame;
    frame.Centre = bounds.Centroid();
    double halfLength = 0.0;
    for (int axis = 0; axis < D; ++axis)
    {
      halfLength = std::max(halfLength, 0.5 * bounds.Max[axis] - 0.5 * bounds.Min[axis]);
    }
    int exponent = 0;
    std::frexp(halfLength, &exponent);
    frame.Scale = halfLength > 0.0 ? std::ldexp(1.0, -std::clamp(exponent, -1023, 1024)) : 1.0;
    return frame;
  }

  Vector<D> Local(const Vector<D>& world) const
  {
    Vector<D> local;
    ForEachAxis<D>([&](int axis) { local[axis] = this->Local(world[axis], axis); });
    return local;
  }

  float Down(double world, int axis) const { return RoundDown(this->Local(world, axis)); }
  float Up(double world, int axis) const { return RoundUp(this->Local(world, axis)); }

  FloatBox<D> Outward(const Box<D>& box) const
  {
    return Rounded([&](int axis) { return this->Down(box.Min[axis], axis); },
      [&](int axis) { return this->Up(box.Max[axis], axis); });
  }

  /// As Outward(), of the finite box grown by `margin`, which lies within the bounds that the frame
  /// is of.
  FloatBox<D> OutwardWithin(const Box<D>& box, double margin) const
  {
    return Rounded([&](int axis)
      { return -RoundUpInRange(-this->Local(box.Min[axis] - margin, axis)); },
      [&](int axis) { return RoundUpInRange(this->Local(box.Max[axis] + margin, axis)); });
  }

  /// A squared world distance as a bound on squared frame distances that single precision
  /// arithmetic on at most a dozen axes cannot miss: each adds a rounding, relative or, near 0, of
  /// half a denormal.
  float UpperBound2(double distance2) const
  {
    constexpr double slack = 1.0 + 1.0 / (1 << 20);
    return RoundUp(distance2 * this->Scale * this->Scale * slack + tolerances::Denormal2);
  }

  /// Always a step outward from the nearest float: no comparison that a compiler could fold away.
  /// (GCC 12 drops the rounding of double(float(x)) where it vectorises two of them.)
  static float RoundDown(double value) { return -Next(-ToFloat(value)); }
  static float RoundUp(double value) { return Next(ToFloat(value)); }
  /// The same of what is surely in the range of float.
  static float RoundUpInRange(double value) { return NextOfLess(static_cast<float>(value)); }

private:
  template <class Min, class Max>
  static FloatBox<D> Rounded(const Min& min, const Max& max)
  {
    FloatBox<D> rounded;
    ForEachAxis<D>(
      [&](int axis)
      {
        rounded.Min[axis] = min(axis);
        rounded.Max[axis] = max(axis);
      });
    return rounded;
  }

  static constexpr float Infinity = std::numeric_limits<float>::infinity();

  double Local(double world, int axis) const { return (world - this->Centre[axis]) * this->Scale; }

  /// The next float above, of infinity and NaN themselves: nextafterf without the call.
  static float Next(float value) { return value < Infinity ? NextOfLess(value) : value; }
  static float NextOfLess(float value)
  {
    std::int32_t bits;
    value += 0.0f; // -0 becomes 0
    std::memcpy(&bits, &value, sizeof(bits));
    bits += (bits >> 31) | 1; // of negative numbers the bits count down
    std::memcpy(&value, &bits, sizeof(bits));
    return value;
  }

  // A double beyond the range of float has no conversion in C++: infinity is the rounding we want.
  static float ToFloat(double value)
  {
    constexpr double largest = std::numeric_limits<float>::max();
    if (value > largest)
    {
      return Infinity;
    }
    return value < -largest ? -Infinity : static_cast<float>(value);
  }
};

}

#endif
