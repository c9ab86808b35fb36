// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Least and greatest distances of a box to points, spheres and boxes (sections 4.1 to 4.3).
/// Names ending in 2 are squared. An empty box gives distances without meaning.
#ifndef skd_Geometry_Distance_Distance_h
#define skd_Geometry_Distance_Distance_h

#include "../Box.h"
#include "../Sphere.h"

namespace skd
{

/// Section 4.3: between the nearest points of two boxes, 0 when they overlap.
template <int D>
double MinDistance2(const Box<D>& a, const Box<D>& b)
{
  double sum = 0.0;
  for (int axis = 0; axis < D; ++axis)
  {
    const double gap = std::max({ 0.0, a.Min[axis] - b.Max[axis], b.Min[axis] - a.Max[axis] });
    sum += gap * gap;
  }
  return sum;
}

/// Section 4.3: between the farthest points of two boxes.
template <int D>
double MaxDistance2(const Box<D>& a, const Box<D>& b)
{
  double sum = 0.0;
  for (int axis = 0; axis < D; ++axis)
  {
    const double extent = std::max(b.Max[axis] - a.Min[axis], a.Max[axis] - b.Min[axis]);
    sum += extent * extent;
  }
  return sum;
}

/// Section 4.1: the distance from q to the nearest point of the box, 0 inside.
template <int D>
double MinDistance2(const Vector<D>& q, const Box<D>& box)
{
  return MinDistance2(Box<D>(q, q), box);
}

/// Section 4.1: the distance from q to the farthest point of the box.
template <int D>
double MaxDistance2(const Vector<D>& q, const Box<D>& box)
{
  return MaxDistance2(Box<D>(q, q), box);
}

/// Section 4.2: between the nearest points of a sphere and a box, 0 when they overlap.
template <int D>
double MinDistance(const Sphere<D>& sphere, const Box<D>& box)
{
  return std::max(0.0, std::sqrt(MinDistance2(sphere.Centre, box)) - sphere.Radius);
}

/// Section 4.2: between the farthest points of a sphere and a box.
template <int D>
double MaxDistance(const Sphere<D>& sphere, const Box<D>& box)
{
  return std::sqrt(MaxDistance2(sphere.Centre, box)) + sphere.Radius;
}

}

#endif
