// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdAxisLine_h
#define SkdAxisLine_h

#include "Core/Geometry/Vector.h"

#include <array>

namespace skdtree
{
/// A line along an axis, through a point.
struct SkdAxisLine
{
  int Axis;
  skd::Vector3 Point;
};

/// Where such a line crosses a triangle.
struct SkdPositionOnLine
{
  SkdAxisLine Line;
  std::array<skd::Vector3, 3> Corners; ///< of the triangle
};
}

#endif
