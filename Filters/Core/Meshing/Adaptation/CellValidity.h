// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Adaptation_CellValidity_h
#define skd_Adaptation_CellValidity_h

#include "../../Geometry/Predicates/Orient3D.h"
#include "SurfaceShape.h"

namespace skd
{

/// Whether a cell is oriented as it should be and does not cross itself, seen along its normal or
/// from the middle of its sphere: by exact signs.
class CellValidity
{
public:
  /// The cell as `mesh` has it now is what later ones are compared with.
  CellValidity(const SurfaceMesh& mesh, const SurfaceShape& shape, std::uint32_t cell)
  {
    const Vector3& corner = mesh.Points[mesh.Cells[cell][0]];
    const Vector3 area = VectorArea(mesh, cell);
    const double size = std::sqrt(Norm(area));
    if (shape.What == SurfaceShape::Kind::Sphere)
    {
      this->Apex = shape.Centre;
      this->Orientation = Dot(area, corner - shape.Centre) > 0.0 ? -1 : 1;
    }
    else if (shape.What == SurfaceShape::Kind::Plane)
    {
      this->Apex = corner + (size > 0.0 ? size : 1.0) * shape.Normal;
      this->Orientation = Dot(area, shape.Normal) > 0.0 ? 1 : -1;
    }
    else
    {
      this->Apex = corner + (size > 0.0 ? 1.0 / size : 1.0) * area;
      this->Orientation = 1;
    }
    this->Convex = true;
    this->Convex = this->IsValid(mesh, cell);
  }

  /// Convex cells stay so: each corner turns the same way, and the cell goes around once. Concave
  /// ones keep their sense and cross nothing.
  bool IsValid(const SurfaceMesh& mesh, std::uint32_t cell) const
  {
    return this->Convex ? this->IsConvex(mesh, cell) : this->IsSimple(mesh, cell);
  }

  /// The least over its corners of the sine there, relative to that of a regular polygon of as
  /// many: 1 of a regular one (and never more), 0 or less where a corner is flat or turns the wrong
  /// way.
  double QualityOf(const SurfaceMesh& mesh, std::uint32_t cell) const;

private:
  int SignOf(const SurfaceMesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) const
  {
    return this->Orientation * Orient3D(mesh.Points[a], mesh.Points[b], mesh.Points[c], this->Apex);
  }

  bool IsConvex(const SurfaceMesh& mesh, std::uint32_t cell) const;
  bool IsSimple(const SurfaceMesh& mesh, std::uint32_t cell) const;
  bool DoCross(const SurfaceMesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c,
    std::uint32_t d) const;

  Vector3 Apex;
  int Orientation;
  bool Convex;
};

// With up to four corners it is enough that each turns the right way; more could go around twice,
// but not if every edge has all other corners on the same side.
inline bool CellValidity::IsConvex(const SurfaceMesh& mesh, std::uint32_t cell) const
{
  const IndexRows::Row corners = mesh.Cells[cell];
  const std::size_t n = corners.size();
  const std::size_t others = n > 4 ? n - 2 : 1;
  for (std::size_t i = 0; i < n; ++i)
  {
    for (std::size_t k = 0; k < others; ++k)
    {
      if (this->SignOf(mesh, corners[i], corners[(i + 1) % n], corners[(i + 2 + k) % n]) <= 0)
      {
        return false;
      }
    }
  }
  return true;
}

inline bool CellValidity::DoCross(
  const SurfaceMesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const
{
  return this->SignOf(mesh, a, b, c) * this->SignOf(mesh, a, b, d) <= 0 &&
    this->SignOf(mesh, c, d, a) * this->SignOf(mesh, c, d, b) <= 0;
}

inline bool CellValidity::IsSimple(const SurfaceMesh& mesh, std::uint32_t cell) const
{
  const IndexRows::Row corners = mesh.Cells[cell];
  const std::size_t n = corners.size();
  double area = 0.0;
  for (std::size_t i = 0; i < n; ++i)
  {
    const std::uint32_t a = corners[i];
    const std::uint32_t b = corners[(i + 1) % n];
    area += SolidAngle(mesh.Points[corners[0]], mesh.Points[a], mesh.Points[b], this->Apex);
    for (std::size_t k = i + 2; k < n && (k + 1) % n != i; ++k)
    {
      if (this->DoCross(mesh, a, b, corners[k], corners[(k + 1) % n]))
      {
        return false;
      }
    }
    const Vector3 in = mesh.Points[b] - mesh.Points[a];
    const Vector3 out = mesh.Points[corners[(i + 2) % n]] - mesh.Points[b];
    if (this->SignOf(mesh, a, b, corners[(i + 2) % n]) == 0 && !(Dot(in, out) > 0.0))
    {
      return false;
    }
  }
  return this->Orientation * area < 0.0; // angles count the other way
}

inline double CellValidity::QualityOf(const SurfaceMesh& mesh, std::uint32_t cell) const
{
  const IndexRows::Row corners = mesh.Cells[cell];
  const std::size_t n = corners.size();
  const double regular = std::sin(6.283185307179586 / static_cast<double>(n));
  double least = 1.0;
  for (std::size_t i = 0; i < n; ++i)
  {
    const Vector3& x = mesh.Points[corners[i]];
    const Vector3 out = mesh.Points[corners[(i + 1) % n]] - x;
    const Vector3 in = mesh.Points[corners[(i + n - 1) % n]] - x;
    const Vector3 up = this->Apex - x;
    const Vector3 normal = Cross(out, in);
    const double product = Norm(out) * Norm(in);
    const double sign = this->Orientation * Dot(normal, up) > 0.0 ? 1.0 : -1.0;
    least = std::min(least, product > 0.0 ? sign * Norm(normal) / (product * regular) : 0.0);
  }
  return least;
}

}

#endif
