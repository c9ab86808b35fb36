// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file WindingReference.h
 * @brief the winding number of a surface, triangle by triangle
 */
#ifndef skdtest_WindingReference_h
#define skdtest_WindingReference_h

#include "Support/MeshBuilder.h"

#include <cmath>

namespace skdtest
{

/// The solid angle of all triangles of a surface that is oriented, over 4 pi: 1 inside, 0 outside
/// (A. van Oosterom, J. Strackee, "The Solid Angle of a Plane Triangle", IEEE Trans. Biomed. Eng.
/// 30 (1983) 125-126).
inline double WindingNumber(const Mesh& triangles, const Point& x)
{
  double sum = 0.0;
  for (const CellSpec& cell : triangles.Cells)
  {
    const Point a = triangles.Points[cell.Points[0]] - x;
    const Point b = triangles.Points[cell.Points[1]] - x;
    const Point c = triangles.Points[cell.Points[2]] - x;
    const double la = Length(a), lb = Length(b), lc = Length(c);
    sum += 2.0 *
      std::atan2(
        Dot(a, Cross(b, c)), la * lb * lc + Dot(a, b) * lc + Dot(b, c) * la + Dot(c, a) * lb);
  }
  return sum / (4.0 * 3.14159265358979323846);
}

}

#endif
