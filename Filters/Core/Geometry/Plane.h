// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_Plane_h
#define skd_Geometry_Plane_h

#include "Box.h"

namespace skd
{

/// The points x with Normal . (x - Origin) = 0; the normal has length 1.
template <int D>
struct Plane
{
  Vector<D> Origin;
  Vector<D> Normal;
};

/// Whether the box comes within `tolerance` of the plane.
template <int D>
bool Overlaps(const Plane<D>& plane, const Box<D>& box, double tolerance)
{
  double lowest = 0.0;
  double highest = 0.0;
  for (int axis = 0; axis < D; ++axis)
  {
    const double a = plane.Normal[axis] * (box.Min[axis] - plane.Origin[axis]);
    const double b = plane.Normal[axis] * (box.Max[axis] - plane.Origin[axis]);
    lowest += std::min(a, b);
    highest += std::max(a, b);
  }
  return lowest <= tolerance && -tolerance <= highest;
}

}

#endif
