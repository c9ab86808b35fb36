// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_Cells_Wedge_h
#define skd_Geometry_Cells_Wedge_h

#include "../Vector.h"

#include <algorithm>

namespace skd
{

/// The linear wedge in VTK's order: a triangle in (r, s) at t = 0, and the one at t = 1.
struct Wedge
{
  static constexpr int Size = 6;
  static constexpr int NumberOfFaces = 5;
  /// Point ids around the faces in VTK's order; the fourth id of a triangle is -1.
  static constexpr int Faces[5][4] = { { 0, 1, 2, -1 }, { 3, 5, 4, -1 }, { 0, 3, 4, 1 },
    { 1, 4, 5, 2 }, { 2, 5, 3, 0 } };

  static constexpr double Corners[6][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
    { 1, 0, 1 }, { 0, 1, 1 } };

  static void Weights(const Vector3& p, double* w)
  {
    const double triangle[3] = { 1.0 - p[0] - p[1], p[0], p[1] };
    for (int i = 0; i < 3; ++i)
    {
      w[i] = triangle[i] * (1.0 - p[2]);
      w[i + 3] = triangle[i] * p[2];
    }
  }

  /// By r for all points, then by s, then by t, as VTK has them.
  static void Derivatives(const Vector3& p, double* d)
  {
    static constexpr double byR[3] = { -1, 1, 0 };
    static constexpr double byS[3] = { -1, 0, 1 };
    const double triangle[3] = { 1.0 - p[0] - p[1], p[0], p[1] };
    for (int i = 0; i < 3; ++i)
    {
      d[i] = byR[i] * (1.0 - p[2]);
      d[i + 3] = byR[i] * p[2];
      d[i + 6] = byS[i] * (1.0 - p[2]);
      d[i + 9] = byS[i] * p[2];
      d[i + 12] = -triangle[i];
      d[i + 15] = triangle[i];
    }
  }

  /// The corners of the cube that the wedge is half of, parametric coordinates read as bits.
  static void CubeCorners(const Vector3* points, Vector3* corners)
  {
    for (int t = 0; t < 2; ++t)
    {
      const Vector3* triangle = points + 3 * t;
      std::copy(triangle, triangle + 3, corners + 4 * t);
      corners[4 * t + 3] = triangle[1] + (triangle[2] - triangle[0]);
    }
  }

  /// The face that p, outside of the domain, is farthest beyond.
  static int FaceBeyond(const Vector3& p)
  {
    const double beyond[5] = { -p[2], p[2] - 1.0, -p[1], p[0] + p[1] - 1.0, -p[0] };
    return static_cast<int>(std::max_element(beyond, beyond + 5) - beyond);
  }

  /// One branch, not five that nobody can predict.
  static bool InDomain(const Vector3& p)
  {
    const bool isAbove = (p[0] >= 0.0) & (p[1] >= 0.0) & (p[2] >= 0.0);
    const bool isBelow = (p[0] + p[1] <= 1.0) & (p[2] <= 1.0);
    return isAbove & isBelow;
  }

  /// A point of the domain near to p, p itself if it is in there; NaN gives 0.
  static Vector3 ClampToDomain(Vector3 p)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      p[axis] = p[axis] > 0.0 ? std::min(p[axis], 1.0) : 0.0;
    }
    const double sum = p[0] + p[1];
    if (sum > 1.0)
    {
      p[0] /= sum;
      p[1] = 1.0 - p[0];
    }
    return p;
  }
};

}

#endif
