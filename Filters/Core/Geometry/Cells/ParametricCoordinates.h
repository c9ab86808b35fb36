// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Which parametric coordinates of a volume cell give the point x.
#ifndef skd_Geometry_Cells_ParametricCoordinates_h
#define skd_Geometry_Cells_ParametricCoordinates_h

#include "InverseMap.h"
#include "LinearShapes.h"
#include "PyramidInverse.h"
#include "TetrahedronInverse.h"
#include "VoxelInverse.h"

namespace skd
{

/// The point of the cell with the parametric coordinates p, relative to origin.
template <class Shape>
Vector3 Evaluate(const Vector3* points, const Vector3& p, const Vector3& origin)
{
  double weights[Shape::Size];
  Shape::Weights(p, weights);
  Vector3 sum{ { 0.0, 0.0, 0.0 } };
  for (int i = 0; i < Shape::Size; ++i)
  {
    sum = sum + weights[i] * (points[i] - origin);
  }
  return sum;
}

/// Parametric coordinates in the domain of a Tetrahedron, Voxel, Hexahedron, Wedge or Pyramid that
/// give x to within rounding. None if there are none: x is then not in the cell, or the cell has no
/// volume. Of several (inverted parts, folds) any one.
template <class Shape>
std::optional<Vector3> ParametricCoordinates(const Vector3* points, const Vector3& x)
{
  if (!IsFinite(x))
  {
    return std::nullopt;
  }
  const InverseMap<Shape> inverse(points, x);
  const std::optional<Vector3> found = inverse.Find(inverse.Guess());
  return found ? Shape::ClampToDomain(*found) : found;
}

}

#endif
