// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_Resolution_h
#define skd_Geometry_Resolution_h

#include "Vector.h"

#include <cmath>
#include <limits>

namespace skd
{

/// Whether a length is more than a few units in the last place of a coordinate: what is not has
/// ends, or a middle, that rounding makes one.
inline bool IsResolved(double length, double coordinate)
{
  return length > 4.0 * std::numeric_limits<double>::epsilon() * std::abs(coordinate);
}

/// Of an edge. Coordinates that both ends have in common round nothing.
inline bool IsResolved(const Vector3& a, const Vector3& b)
{
  double length = 0.0;
  double largest = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    if (a[axis] != b[axis])
    {
      length = std::max(length, std::abs(b[axis] - a[axis]));
      largest = std::max({ largest, std::abs(a[axis]), std::abs(b[axis]) });
    }
  }
  return IsResolved(length, largest);
}

}

#endif
