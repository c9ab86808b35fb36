// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_Polygons_DelaunayEdge_h
#define skd_Geometry_Polygons_DelaunayEdge_h

#include "../Vector.h"

#include <cmath>
#include <utility>

namespace skd
{

/// Whether the edge from c to d is that of the Delaunay triangulation, not the one from a to b: the
/// angles at c and d opposite to that exceed 180 degrees together. To within rounding, so that
/// squares keep either edge.
inline bool IsOtherEdgeDelaunay(
  const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d)
{
  const auto see = [&](const Vector3& from)
  {
    const Vector3 toA = a - from;
    const Vector3 toB = b - from;
    const double size = std::sqrt(Norm2(toA) * Norm2(toB));
    return std::pair(Dot(toA, toB) / size, Norm(Cross(toA, toB)) / size);
  };
  constexpr double rounding = 1e-12; // else squares would be flipped without end
  const auto [cosC, sinC] = see(c);
  const auto [cosD, sinD] = see(d);
  return sinC * cosD + cosC * sinD < -rounding;
}

}

#endif
