// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_Cells_Voxel_h
#define skd_Geometry_Cells_Voxel_h

#include "Hexahedron.h"

namespace skd
{

/// The parallelepiped spanned by p1 - p0, p2 - p0 and p4 - p0, in VTK's voxel order: point i has
/// the bits of i as parametric coordinates.
struct Voxel
{
  static constexpr int Size = 8;
  static constexpr int NumberOfFaces = 6;
  /// Point ids around the faces: VTK's faces, but in the order of a quad.
  static constexpr int Faces[6][4] = { { 2, 0, 4, 6 }, { 1, 3, 7, 5 }, { 0, 1, 5, 4 },
    { 3, 2, 6, 7 }, { 1, 0, 2, 3 }, { 4, 5, 7, 6 } };

  static constexpr double Corners[8][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 },
    { 0, 0, 1 }, { 1, 0, 1 }, { 0, 1, 1 }, { 1, 1, 1 } };

  static void Weights(const Vector3& p, double* w)
  {
    Hexahedron::Weights(p, w);
    std::swap(w[2], w[3]);
    std::swap(w[6], w[7]);
  }

  /// By r for all points, then by s, then by t, as VTK has them.
  static void Derivatives(const Vector3& p, double* d)
  {
    Hexahedron::Derivatives(p, d);
    for (int axis = 0; axis < 3; ++axis)
    {
      std::swap(d[8 * axis + 2], d[8 * axis + 3]);
      std::swap(d[8 * axis + 6], d[8 * axis + 7]);
    }
  }

  /// The face that p, outside of the domain, is farthest beyond.
  static int FaceBeyond(const Vector3& p) { return Hexahedron::FaceBeyond(p); }

  static bool InDomain(const Vector3& p) { return Hexahedron::InDomain(p); }
  static Vector3 ClampToDomain(const Vector3& p) { return Hexahedron::ClampToDomain(p); }
};

}

#endif
