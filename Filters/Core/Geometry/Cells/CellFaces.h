// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_Cells_CellFaces_h
#define skd_Geometry_Cells_CellFaces_h

#include "../Distance/BilinearPatch.h"
#include "LinearShapes.h"

namespace skd
{

/// The points of one face of a cell.
template <class Shape>
struct CellFace
{
  int Size;
  Vector3 Points[4];

  CellFace(const Vector3* points, int face)
    : Size(Shape::Faces[face][3] < 0 ? 3 : 4)
  {
    for (int i = 0; i < this->Size; ++i)
    {
      this->Points[i] = points[Shape::Faces[face][i]];
    }
  }

  PatchPoint ClosestPoint(const Vector3& x, double limit2) const
  {
    const Vector3* p = this->Points;
    if (this->Size == 4)
    {
      return ClosestPointOnPatch(p, x, limit2);
    }
    const TrianglePoint nearest = ClosestPointOnTriangle(p[0], p[1], p[2], x);
    return { nearest.Point, nearest.R, nearest.S, nearest.Dist2 };
  }
};

/// A direction across a face, of any length: 0 for a face without area.
template <class Shape>
Vector3 FaceNormal(const Vector3* points, int face)
{
  const int* ids = Shape::Faces[face];
  const int last = ids[3] < 0 ? ids[0] : ids[3];
  return Cross(points[ids[2]] - points[ids[0]], points[last] - points[ids[1]]);
}

/// The cell's parametric coordinates of a face's point, given that of the face: faces are flat in
/// the domain.
template <class Shape>
Vector3 PCoordsOnFace(int face, double r, double s)
{
  const int* ids = Shape::Faces[face];
  const double* first = Shape::Corners[ids[0]];
  const double* alongR = Shape::Corners[ids[1]];
  const double* alongS = Shape::Corners[ids[3] < 0 ? ids[2] : ids[3]];
  Vector3 pcoords;
  for (int axis = 0; axis < 3; ++axis)
  {
    pcoords[axis] =
      first[axis] + r * (alongR[axis] - first[axis]) + s * (alongS[axis] - first[axis]);
  }
  return pcoords;
}

/// The sides of a pyramid keep r and s on the way to the apex: a share of the edge, and t.
template <>
inline Vector3 PCoordsOnFace<Pyramid>(int face, double r, double s)
{
  const int* ids = Pyramid::Faces[face];
  const double* a = Pyramid::Corners[ids[0]];
  const double* b = Pyramid::Corners[ids[1]];
  if (ids[3] >= 0)
  {
    return { { s, r, 0.0 } }; // 0, 3, 2, 1
  }
  if (s >= 1.0)
  {
    return { { 0.0, 0.0, 1.0 } };
  }
  const double share = std::min(1.0, r / (1.0 - s));
  return { { a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1]), s } };
}

}

#endif
