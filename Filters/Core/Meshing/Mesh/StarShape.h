// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// How polygons and volume cells can be cut into simplices: from their middle, if all of their
/// edges or faces are seen from there from inside; polygons else by Geometry/Ears.h.
#ifndef skd_Mesh_StarShape_h
#define skd_Mesh_StarShape_h

#include "../../Geometry/Polygons/Ears.h"
#include "RefinedMesh.h"

#include <vector>

namespace skd
{

namespace detail
{

inline Vector3 MeanOf(const std::vector<Vector3>& points)
{
  Vector3 sum{ { 0.0, 0.0, 0.0 } };
  for (const Vector3& point : points)
  {
    sum = sum + (1.0 / static_cast<double>(points.size())) * point;
  }
  return sum;
}

inline double SixfoldVolume(
  const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& apex)
{
  return Dot(Cross(b - a, c - a), apex - a);
}

}

inline std::vector<Vector3> FlatPointsOf(const RefinedMesh& mesh, std::uint32_t cell)
{
  std::vector<Vector3> points;
  for (const std::uint32_t node : mesh.NodesOf(cell))
  {
    points.push_back(mesh.FlatPoint(node));
  }
  return points;
}

/// Whether all triangles of a polygon's edges with its middle lie the same way.
inline bool IsStarShaped(const std::vector<Vector3>& polygon)
{
  const Vector3 middle = detail::MeanOf(polygon);
  const Vector3 normal = DirectionAcross(polygon.data(), polygon.size());
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Vector3& next = polygon[i + 1 == polygon.size() ? 0 : i + 1];
    if (!(Dot(Cross(polygon[i] - middle, next - middle), normal) > 0.0))
    {
      return false;
    }
  }
  return true;
}

/// Whether the middle of a volume cell sees all triangles of its faces, of those of four nodes
/// along both diagonals, from the same side. `side`: 1 where faces turn away from it, -1 where
/// towards it.
inline bool IsStarShaped(const RefinedMesh& mesh, std::uint32_t cell, int& side)
{
  const Vector3 middle = detail::MeanOf(FlatPointsOf(mesh, cell));
  int away = 0;
  int triangles = 0;
  const auto look = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c)
  {
    const double volume =
      detail::SixfoldVolume(mesh.FlatPoint(a), mesh.FlatPoint(b), mesh.FlatPoint(c), middle);
    away += volume < 0.0 ? 1 : (volume > 0.0 ? -1 : 0);
    ++triangles;
  };
  ForEachFace(mesh[cell].Kind, mesh.NodesOf(cell).First,
    [&](const FaceNodes& face)
    {
      look(face[0], face[1], face[2]);
      if (face[3] != RefinedMesh::None)
      {
        look(face[0], face[2], face[3]);
        look(face[1], face[2], face[3]);
        look(face[0], face[1], face[3]);
      }
    });
  side = away > 0 ? 1 : -1;
  return std::abs(away) == triangles;
}

}

#endif
