// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_Cells_Brick_h
#define skd_Geometry_Cells_Brick_h

#include "LinearShapes.h"
#include "VolumePoint.h"

namespace skd
{

/// A voxel, in the hope that its edges are at right angles: then each parametric coordinate of the
/// nearest point is found, and clamped, by itself.
struct Brick
{
  Vector3 Origin;
  Vector3 Edges[3];

  explicit Brick(const Vector3* points)
    : Origin(points[0])
    , Edges{ points[1] - points[0], points[2] - points[0], points[4] - points[0] }
  {
  }

  /// Exactly so: true of cells whose edges are along the axes, also of flat ones.
  bool IsRectangular() const
  {
    const Vector3* e = this->Edges;
    return Dot(e[0], e[1]) == 0.0 && Dot(e[0], e[2]) == 0.0 && Dot(e[1], e[2]) == 0.0;
  }

  VolumePoint ClosestPoint(const Vector3& x) const
  {
    const Vector3* e = this->Edges;
    const Vector3 f = x - this->Origin;
    const Vector3 free{ { Dot(f, e[0]) / Norm2(e[0]), Dot(f, e[1]) / Norm2(e[1]),
      Dot(f, e[2]) / Norm2(e[2]) } };
    if (Voxel::InDomain(free))
    {
      return { x, free, 0.0 };
    }
    const Vector3 p = Voxel::ClampToDomain(free); // 0 along an edge without length
    const Vector3 position = p[0] * e[0] + p[1] * e[1] + p[2] * e[2];
    return { this->Origin + position, p, Norm2(f - position) };
  }
};

}

#endif
