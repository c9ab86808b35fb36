// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The nearest point of a volume cell: x itself inside, else one of its faces.
#ifndef skd_Geometry_ClosestPointInCell_h
#define skd_Geometry_ClosestPointInCell_h

#include "BilinearPatch.h"
#include "InvertMap.h"

namespace skd
{

/// Point is the cell's point at PCoords, or x itself when that is inside (Dist2 = 0).
struct VolumePoint
{
  Vector3 Point;
  Vector3 PCoords;
  double Dist2;
};

/// The nearest point of the faces.
template <class Shape>
VolumePoint ClosestPointOnFaces(const Vector3* points, const Vector3& x, double limit2)
{
  VolumePoint nearest{ x, { { 0.0, 0.0, 0.0 } }, std::numeric_limits<double>::infinity() };
  for (const auto& face : Shape::Faces)
  {
    const bool isTriangle = face[3] < 0;
    const Vector3 corners[4] = { points[face[0]], points[face[1]], points[face[2]],
      points[face[isTriangle ? 2 : 3]] };
    const PatchPoint found = ClosestPointOnPatch(corners, x, std::min(limit2, nearest.Dist2));
    if (found.Dist2 < nearest.Dist2)
    {
      nearest.Point = found.Point;
      nearest.Dist2 = found.Dist2;
    }
  }
  return nearest;
}

/// The nearest point of a Tetrahedron, Voxel, Hexahedron, Wedge or Pyramid, for any points: warped,
/// inverted or collapsed. When no point is within sqrt(limit2), Dist2 may be infinite instead (the
/// rest is then nothing). A NaN gives Dist2 = NaN or infinity.
template <class Shape>
VolumePoint ClosestPointInCell(const Vector3* points, const Vector3& x, double limit2)
{
  if (const std::optional<Vector3> pcoords = InvertMap<Shape>(points, x))
  {
    return { x, *pcoords, 0.0 };
  }
  return ClosestPointOnFaces<Shape>(points, x, limit2);
}

}

#endif
