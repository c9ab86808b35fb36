// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_Box_h
#define skd_Geometry_Box_h

#include "ForEachAxis.h"
#include "Vector.h"

#include <algorithm>
#include <limits>

namespace skd
{

/// An axis-aligned ("isothetic") box, bounds included. A new one is empty: (+max, lowest).
template <int D>
struct Box
{
  Vector<D> Min;
  Vector<D> Max;

  Box()
  {
    ForEachAxis<D>(
      [this](int axis)
      {
        this->Min[axis] = std::numeric_limits<double>::max();
        this->Max[axis] = std::numeric_limits<double>::lowest();
      });
  }
  Box(const Vector<D>& min, const Vector<D>& max)
    : Min(min)
    , Max(max)
  {
  }

  bool IsEmpty() const
  {
    bool isEmpty = false;
    ForEachAxis<D>([&](int axis) { isEmpty |= !(this->Min[axis] <= this->Max[axis]); });
    return isEmpty;
  }

  void Add(const Vector<D>& point)
  {
    this->Min = Least(this->Min, point);
    this->Max = Greatest(this->Max, point);
  }

  void Add(const Box& other)
  {
    this->Min = Least(this->Min, other.Min);
    this->Max = Greatest(this->Max, other.Max);
  }

  /// The box grown by `margin` on every side; an empty box stays empty.
  Box Inflated(double margin) const
  {
    if (this->IsEmpty())
    {
      return *this;
    }
    Box grown;
    ForEachAxis<D>(
      [&](int axis)
      {
        grown.Min[axis] = this->Min[axis] - margin;
        grown.Max[axis] = this->Max[axis] + margin;
      });
    return grown;
  }

  /// Halves are added, not the sum halved: no overflow near the largest double.
  Vector<D> Centroid() const
  {
    Vector<D> centre;
    for (int axis = 0; axis < D; ++axis)
    {
      centre[axis] = 0.5 * this->Min[axis] + 0.5 * this->Max[axis];
    }
    return centre;
  }

  double Length(int axis) const { return this->Max[axis] - this->Min[axis]; }

  /// The lowest of the axes along which the box is longest.
  int LongestAxis() const
  {
    int longest = 0;
    for (int axis = 1; axis < D; ++axis)
    {
      if (this->Length(axis) > this->Length(longest))
      {
        longest = axis;
      }
    }
    return longest;
  }

  double Diagonal() const { return this->IsEmpty() ? 0.0 : Norm(this->Max - this->Min); }

  bool Contains(const Vector<D>& point) const
  {
    for (int axis = 0; axis < D; ++axis)
    {
      if (!(this->Min[axis] <= point[axis] && point[axis] <= this->Max[axis]))
      {
        return false;
      }
    }
    return true;
  }

  bool Contains(const Box& other) const
  {
    return this->Contains(other.Min) && this->Contains(other.Max);
  }

  bool Overlaps(const Box& other) const
  {
    for (int axis = 0; axis < D; ++axis)
    {
      if (!(this->Min[axis] <= other.Max[axis] && other.Min[axis] <= this->Max[axis]))
      {
        return false;
      }
    }
    return true;
  }
};

using Box3 = Box<3>;

/// The largest coordinate of a point of the box, without its sign; 0 of an empty one.
template <int D>
double LargestCoordinate(const Box<D>& box)
{
  double largest = 0.0;
  for (int axis = 0; axis < D && !box.IsEmpty(); ++axis)
  {
    largest = std::max({ largest, std::abs(box.Min[axis]), std::abs(box.Max[axis]) });
  }
  return largest;
}

}

#endif
