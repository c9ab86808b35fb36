// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TriangleMesh_h
#define TriangleMesh_h

#include "Core/Geometry/Intersection/TriangleContact.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace skdtest
{
/// A surface of triangles, by numbers of points.
struct TriangleMesh
{
  using Corners = std::array<std::uint32_t, 3>;

  std::vector<skd::Vector3> Points;
  std::vector<Corners> Triangles;

  std::array<skd::Vector3, 3> At(std::size_t i) const
  {
    const Corners& corners = this->Triangles[i];
    return { this->Points[corners[0]], this->Points[corners[1]], this->Points[corners[2]] };
  }

  void Add(const TriangleMesh& other)
  {
    const auto first = static_cast<std::uint32_t>(this->Points.size());
    this->Points.insert(this->Points.end(), other.Points.begin(), other.Points.end());
    for (const Corners& corners : other.Triangles)
    {
      this->Triangles.push_back({ corners[0] + first, corners[1] + first, corners[2] + first });
    }
  }
};

/// Whether two triangles have more in common than the corners that they share, exactly.
inline bool HaveMoreInCommon(const TriangleMesh& mesh, std::size_t i, std::size_t k)
{
  int numberShared = 0;
  for (const std::uint32_t corner : mesh.Triangles[i])
  {
    numberShared +=
      static_cast<int>(std::count(mesh.Triangles[k].begin(), mesh.Triangles[k].end(), corner));
  }
  const int count = skd::FindContact(mesh.At(i), mesh.At(k)).Count;
  return count > numberShared || (count == 3 && numberShared == 3);
}
}

#endif
