// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Adaptation_SurfaceShape_h
#define skd_Adaptation_SurfaceShape_h

#include "../../Geometry/Measures/SolidAngle.h"
#include "SurfaceMesh.h"

#include <functional>

namespace skd
{

/// What points of a mesh stay on.
struct SurfaceShape
{
  enum class Kind
  {
    Plane,
    Sphere,
    Other
  };

  Kind What = Kind::Other;
  Vector3 Centre{ { 0.0, 0.0, 0.0 } }; ///< of a sphere; a point of a plane
  Vector3 Normal{ { 0.0, 0.0, 1.0 } }; ///< of a plane, of length 1
  double Radius = 0.0;
  std::function<Vector3(const Vector3&)> FindClosest; ///< of another surface

  /// The point of the surface for one that is near it.
  Vector3 Put(const Vector3& x) const
  {
    if (this->What == Kind::Plane)
    {
      return x - Dot(this->Normal, x - this->Centre) * this->Normal;
    }
    if (this->What == Kind::Sphere)
    {
      const Vector3 r = x - this->Centre;
      return this->Centre + (this->Radius / Norm(r)) * r;
    }
    return this->FindClosest ? this->FindClosest(x) : x;
  }

  /// The direction off a plane or sphere at a point of it.
  Vector3 NormalOf(const Vector3& x) const
  {
    return this->What == Kind::Sphere ? (1.0 / Norm(x - this->Centre)) * (x - this->Centre)
                                      : this->Normal;
  }

  /// The path from one point of a plane or sphere to another one, of its length and with the
  /// direction that it begins with: on a sphere along a great circle.
  Vector3 Along(const Vector3& from, const Vector3& to) const
  {
    if (this->What != Kind::Sphere)
    {
      return to - from;
    }
    const Vector3 up = this->NormalOf(from);
    const Vector3 r = to - this->Centre;
    const Vector3 across = r - Dot(r, up) * up;
    const double length = Norm(across);
    const double angle = std::atan2(length, Dot(r, up));
    return length > 0.0 ? (this->Radius * angle / length) * across : across;
  }
};

/// Half the sum of the cross products of a cell's corners: its area times its normal.
inline Vector3 VectorArea(const SurfaceMesh& mesh, std::uint32_t cell)
{
  const IndexRows::Row corners = mesh.Cells[cell];
  const Vector3& p = mesh.Points[corners[0]];
  Vector3 sum{ { 0.0, 0.0, 0.0 } };
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
  {
    sum = sum + Cross(mesh.Points[corners[i]] - p, mesh.Points[corners[i + 1]] - p);
  }
  return 0.5 * sum;
}

inline Vector3 CornerMean(const SurfaceMesh& mesh, std::uint32_t cell)
{
  Vector3 sum{ { 0.0, 0.0, 0.0 } };
  for (const std::uint32_t corner : mesh.Cells[cell])
  {
    sum = sum + mesh.Points[corner];
  }
  return (1.0 / static_cast<double>(mesh.Cells[cell].size())) * sum;
}

/// The area of a cell, 0 or more: on a sphere between great-circle arcs, else that of triangles
/// around the mean of the corners.
inline double CellArea(const SurfaceMesh& mesh, const SurfaceShape& shape, std::uint32_t cell)
{
  const IndexRows::Row corners = mesh.Cells[cell];
  if (shape.What == SurfaceShape::Kind::Plane)
  {
    return std::abs(Dot(shape.Normal, VectorArea(mesh, cell)));
  }
  const bool isSphere = shape.What == SurfaceShape::Kind::Sphere;
  const Vector3 middle = CornerMean(mesh, cell);
  double sum = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    const Vector3& a = mesh.Points[corners[i]];
    const Vector3& b = mesh.Points[corners[i + 1 < corners.size() ? i + 1 : 0]];
    sum +=
      isSphere ? SolidAngle(middle, a, b, shape.Centre) : 0.5 * Norm(Cross(a - middle, b - middle));
  }
  return isSphere ? std::abs(sum) * shape.Radius * shape.Radius : sum;
}

/// The direction, of length 1, that is off the surface at a point; 0 where there is none.
inline Vector3 NormalAt(const SurfaceMesh& mesh, const SurfaceShape& shape, std::uint32_t point)
{
  Vector3 normal = shape.Normal;
  if (shape.What == SurfaceShape::Kind::Sphere)
  {
    normal = mesh.Points[point] - shape.Centre;
  }
  else if (shape.What == SurfaceShape::Kind::Other)
  {
    normal = { { 0.0, 0.0, 0.0 } };
    for (const std::uint32_t cell : mesh.CellsOfPoint[point])
    {
      normal = normal + VectorArea(mesh, cell);
    }
  }
  const double length = Norm(normal);
  return length > 0.0 ? (1.0 / length) * normal : Vector3{ { 0.0, 0.0, 0.0 } };
}

}

#endif
