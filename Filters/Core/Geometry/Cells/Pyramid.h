// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_Cells_Pyramid_h
#define skd_Geometry_Cells_Pyramid_h

#include "Hexahedron.h"

namespace skd
{

/// VTK's pyramid: a bilinear base in (r, s) at t = 0, shrinking to the apex, point 4, at t = 1.
/// At the apex r and s mean nothing: they are given as 0.
struct Pyramid
{
  static constexpr int Size = 5;
  static constexpr int NumberOfFaces = 5;
  /// Point ids around the faces in VTK's order; the fourth id of a triangle is -1.
  static constexpr int Faces[5][4] = { { 0, 3, 2, 1 }, { 0, 1, 4, -1 }, { 1, 2, 4, -1 },
    { 2, 3, 4, -1 }, { 3, 0, 4, -1 } };

  static constexpr double Corners[5][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 },
    { 0, 0, 1 } };

  static void Weights(const Vector3& p, double* w)
  {
    const double a[3] = { 1.0 - p[0], 1.0 - p[1], 1.0 - p[2] };
    w[0] = a[0] * a[1] * a[2];
    w[1] = p[0] * a[1] * a[2];
    w[2] = p[0] * p[1] * a[2];
    w[3] = a[0] * p[1] * a[2];
    w[4] = p[2];
  }

  /// By r for all points, then by s, then by t, as VTK has them.
  static void Derivatives(const Vector3& p, double* d)
  {
    const double a[3] = { 1.0 - p[0], 1.0 - p[1], 1.0 - p[2] };
    const double values[15] = { -a[1] * a[2], a[1] * a[2], p[1] * a[2], -p[1] * a[2], 0.0,
      -a[0] * a[2], -p[0] * a[2], p[0] * a[2], a[0] * a[2], 0.0, -a[0] * a[1], -p[0] * a[1],
      -p[0] * p[1], -a[0] * p[1], 1.0 };
    std::copy(values, values + 15, d);
  }

  /// The face that p, outside of the domain, is farthest beyond.
  static int FaceBeyond(const Vector3& p)
  {
    const double beyond[5] = { -p[2], -p[1], p[0] - 1.0, p[1] - 1.0, -p[0] };
    return static_cast<int>(std::max_element(beyond, beyond + 5) - beyond);
  }

  static bool InDomain(const Vector3& p) { return Hexahedron::InDomain(p); }
  static Vector3 ClampToDomain(const Vector3& p) { return Hexahedron::ClampToDomain(p); }
};

}

#endif
