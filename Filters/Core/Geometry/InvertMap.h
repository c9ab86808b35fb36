// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Which parametric coordinates of a volume cell give the point x.
#ifndef skd_Geometry_InvertMap_h
#define skd_Geometry_InvertMap_h

#include "Hexahedron.h"
#include "Pyramid.h"
#include "Tetrahedron.h"
#include "Voxel.h"
#include "Wedge.h"

#include <optional>

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

/// Parametric coordinates in the cell's domain that give x to within rounding, if there are any.
template <class Shape>
std::optional<Vector3> InvertMap(const Vector3* points, const Vector3& x)
{
  Vector3 p{ { 0.3, 0.3, 0.3 } };
  for (int iteration = 0; iteration < 30; ++iteration)
  {
    double derivatives[3 * Shape::Size];
    Shape::Derivatives(p, derivatives);
    Vector3 columns[3] = {};
    for (int i = 0; i < Shape::Size; ++i)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        columns[axis] = columns[axis] + derivatives[axis * Shape::Size + i] * (points[i] - x);
      }
    }
    const Vector3 f = Evaluate<Shape>(points, p, x);
    const Vector3 rows[3] = { Cross(columns[1], columns[2]), Cross(columns[2], columns[0]),
      Cross(columns[0], columns[1]) };
    const double volume = Dot(columns[0], rows[0]);
    p = p - (1.0 / volume) * Vector3{ { Dot(rows[0], f), Dot(rows[1], f), Dot(rows[2], f) } };
  }
  const Vector3 inside = Shape::ClampToDomain(p);
  if (Distance2(p, inside) < 1e-20)
  {
    return inside;
  }
  return std::nullopt;
}

}

#endif
