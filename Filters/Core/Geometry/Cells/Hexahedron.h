// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_Cells_Hexahedron_h
#define skd_Geometry_Cells_Hexahedron_h

#include "../Vector.h"

#include <algorithm>

namespace skd
{

/// The trilinear hexahedron in VTK's order: around the bottom (t = 0), then around the top.
struct Hexahedron
{
  static constexpr int Size = 8;
  static constexpr int NumberOfFaces = 6;
  /// Point ids around the faces, in VTK's order.
  static constexpr int Faces[6][4] = { { 0, 4, 7, 3 }, { 1, 2, 6, 5 }, { 0, 1, 5, 4 },
    { 3, 7, 6, 2 }, { 0, 3, 2, 1 }, { 4, 5, 6, 7 } };

  static constexpr double Corners[8][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 },
    { 0, 0, 1 }, { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } };

  static void Weights(const Vector3& p, double* w)
  {
    const double a[3] = { 1.0 - p[0], 1.0 - p[1], 1.0 - p[2] };
    const double bottom[4] = { a[0] * a[1], p[0] * a[1], p[0] * p[1], a[0] * p[1] };
    for (int i = 0; i < 4; ++i)
    {
      w[i] = bottom[i] * a[2];
      w[i + 4] = bottom[i] * p[2];
    }
  }

  /// By r for all points, then by s, then by t, as VTK has them.
  static void Derivatives(const Vector3& p, double* d)
  {
    const double a[3] = { 1.0 - p[0], 1.0 - p[1], 1.0 - p[2] };
    const double byR[4] = { -a[1], a[1], p[1], -p[1] };
    const double byS[4] = { -a[0], -p[0], p[0], a[0] };
    const double bottom[4] = { a[0] * a[1], p[0] * a[1], p[0] * p[1], a[0] * p[1] };
    for (int i = 0; i < 4; ++i)
    {
      d[i] = byR[i] * a[2];
      d[i + 4] = byR[i] * p[2];
      d[i + 8] = byS[i] * a[2];
      d[i + 12] = byS[i] * p[2];
      d[i + 16] = -bottom[i];
      d[i + 20] = bottom[i];
    }
  }

  /// The points in the order of their parametric coordinates read as bits.
  static void CubeCorners(const Vector3* points, Vector3* corners)
  {
    static constexpr int order[8] = { 0, 1, 3, 2, 4, 5, 7, 6 };
    for (int i = 0; i < 8; ++i)
    {
      corners[i] = points[order[i]];
    }
  }

  /// The face that p, outside of the domain, is farthest beyond.
  static int FaceBeyond(const Vector3& p)
  {
    const double fromMiddle[3] = { std::abs(p[0] - 0.5), std::abs(p[1] - 0.5),
      std::abs(p[2] - 0.5) };
    int axis = fromMiddle[1] > fromMiddle[0] ? 1 : 0;
    axis = fromMiddle[2] > std::max(fromMiddle[0], fromMiddle[1]) ? 2 : axis;
    return 2 * axis + (p[axis] > 0.5 ? 1 : 0);
  }

  /// One branch, not six that nobody can predict.
  static bool InDomain(const Vector3& p)
  {
    const bool isAbove = (p[0] >= 0.0) & (p[1] >= 0.0) & (p[2] >= 0.0);
    const bool isBelow = (p[0] <= 1.0) & (p[1] <= 1.0) & (p[2] <= 1.0);
    return isAbove & isBelow;
  }

  /// The point of the domain nearest to p; NaN gives 0.
  static Vector3 ClampToDomain(Vector3 p)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      p[axis] = p[axis] > 0.0 ? std::min(p[axis], 1.0) : 0.0;
    }
    return p;
  }
};

}

#endif
