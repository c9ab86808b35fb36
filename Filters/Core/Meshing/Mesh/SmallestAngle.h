// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Mesh_SmallestAngle_h
#define skd_Mesh_SmallestAngle_h

#include "RefinedMesh.h"

#include <cmath>
#include <limits>

namespace skd
{

/// The angle between two vectors, 0 to pi; accurate for small ones, too. NaN if one has no length.
inline double AngleBetween(const Vector3& a, const Vector3& b)
{
  return Norm2(a) > 0.0 && Norm2(b) > 0.0 ? std::atan2(Norm(Cross(a, b)), Dot(a, b))
                                          : std::numeric_limits<double>::quiet_NaN();
}

/// The smallest angle of a surface cell at a corner, or of a tetrahedron at an edge (between two
/// faces), in radians, where its points are now; infinity of other cells.
inline double SmallestAngleOf(const RefinedMesh& mesh, std::uint32_t cell)
{
  double smallest = std::numeric_limits<double>::infinity();
  const auto keep = [&smallest](double angle) { smallest = angle < smallest ? angle : smallest; };
  const RefinedMesh::Nodes nodes = mesh.NodesOf(cell);
  const auto at = [&](std::uint32_t i) { return mesh.Point(nodes[i % nodes.Size]); };
  if (mesh[cell].Kind == CellKind::Tetrahedron)
  {
    Vector3 normals[4];
    for (std::uint32_t i = 0; i < 4; ++i)
    {
      const double side = i % 2 == 0 ? 1.0 : -1.0;
      normals[i] = side * Cross(at(i + 1) - at(i), at(i + 2) - at(i));
      for (std::uint32_t k = 0; k < i; ++k)
      {
        keep(AngleBetween(-1.0 * normals[i], normals[k]));
      }
    }
  }
  else if (DimensionOf(mesh[cell].Kind) == 2)
  {
    for (std::uint32_t i = 0; i < nodes.Size; ++i)
    {
      keep(AngleBetween(at(i + 1) - at(i), at(i + nodes.Size - 1) - at(i)));
    }
  }
  return smallest;
}

}

#endif
