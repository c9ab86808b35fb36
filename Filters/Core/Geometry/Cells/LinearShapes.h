// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The linear volume cells: their points and faces in VTK's order, and the maps from their
/// parametric coordinates.
#ifndef skd_Geometry_Cells_LinearShapes_h
#define skd_Geometry_Cells_LinearShapes_h

#include "../ForEachAxis.h"
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

/// Parametric coordinates in [0, 1], all three.
struct CubeDomain
{
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

/// The trilinear hexahedron in VTK's order: around the bottom (t = 0), then around the top.
struct Hexahedron : CubeDomain
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
  template <class Corner>
  static void CubeCorners(const Vector3* points, Corner* corners)
  {
    constexpr int order[8] = { 0, 1, 3, 2, 4, 5, 7, 6 };
    ForEachAxis<8>([&](int i) { corners[i] = points[order[i]]; });
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
};

/// The parallelepiped spanned by p1 - p0, p2 - p0 and p4 - p0, in VTK's voxel order: point i has
/// the bits of i as parametric coordinates.
struct Voxel : Hexahedron
{
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
};

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
  template <class Corner>
  static void CubeCorners(const Vector3* points, Corner* corners)
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

/// VTK's pyramid: a bilinear base in (r, s) at t = 0, shrinking to the apex, point 4, at t = 1.
/// At the apex r and s mean nothing: they are given as 0.
struct Pyramid : CubeDomain
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
};

}

#endif
