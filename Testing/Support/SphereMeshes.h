// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SphereMeshes.h
 * @brief meshes of the unit sphere that climate models use, and averages over their cells
 */
#ifndef skdtest_SphereMeshes_h
#define skdtest_SphereMeshes_h

#include "Support/MeshBuilder.h"

namespace skdtest
{

/// Six faces of n x n quads each, between great circles at equal angles.
Mesh CubedSphere(int n);

/// The dual of an icosahedron whose faces are cut into n x n triangles: 12 pentagons, else
/// hexagons, 10 n^2 + 2 cells.
Mesh IcosahedralDual(int n);

/// The average of a function of the unit sphere over each cell, between great circles, by Gauss
/// quadrature of order 11 on a fan of triangles.
std::vector<double> CellAverages(
  const Mesh& mesh, const std::function<double(const Point&)>& function);

/// The square root of the area-weighted mean of (a - b)^2, by that of b^2.
double L2Error(
  const std::vector<double>& a, const std::vector<double>& b, const std::vector<double>& areas);

}

#endif
