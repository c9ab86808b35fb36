// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_Cells_Tetrahedron_h
#define skd_Geometry_Cells_Tetrahedron_h

#include "../Vector.h"

#include <algorithm>

namespace skd
{

/// The linear tetrahedron in VTK's order: (0,0,0), (1,0,0), (0,1,0), (0,0,1).
struct Tetrahedron
{
  static constexpr int Size = 4;
  static constexpr int NumberOfFaces = 4;
  /// Point ids of the faces in VTK's order; the fourth id of a triangle is -1.
  static constexpr int Faces[4][4] = { { 0, 1, 3, -1 }, { 1, 2, 3, -1 }, { 2, 0, 3, -1 },
    { 0, 2, 1, -1 } };

  /// Parametric coordinates of the points.
  static constexpr double Corners[4][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };

  static void Weights(const Vector3& p, double* w)
  {
    w[0] = 1.0 - p[0] - p[1] - p[2];
    w[1] = p[0];
    w[2] = p[1];
    w[3] = p[2];
  }

  /// By r for all points, then by s, then by t, as VTK has them.
  static void Derivatives(const Vector3&, double* d)
  {
    static constexpr double values[12] = { -1, 1, 0, 0, -1, 0, 1, 0, -1, 0, 0, 1 };
    std::copy(values, values + 12, d);
  }

  /// The face that p, outside of the domain, is farthest beyond.
  static int FaceBeyond(const Vector3& p)
  {
    const double beyond[4] = { -p[1], p[0] + p[1] + p[2] - 1.0, -p[0], -p[2] };
    return static_cast<int>(std::max_element(beyond, beyond + 4) - beyond);
  }

  /// One branch, not four that nobody can predict.
  static bool InDomain(const Vector3& p)
  {
    const bool isAbove = (p[0] >= 0.0) & (p[1] >= 0.0) & (p[2] >= 0.0);
    return isAbove & (p[0] + p[1] + p[2] <= 1.0);
  }

  /// A point of the domain near to p, p itself if it is in there; NaN gives 0.
  static Vector3 ClampToDomain(Vector3 p)
  {
    double sum = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      p[axis] = p[axis] > 0.0 ? std::min(p[axis], 1.0) : 0.0;
      sum += p[axis];
    }
    return sum > 1.0 ? (1.0 / sum) * p : p;
  }
};

}

#endif
