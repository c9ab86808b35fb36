// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdPointsOfBlocks_h
#define SkdPointsOfBlocks_h

#include "Core/Geometry/Vector.h"
#include "Pipeline/SkdBlocks.h"

#include <algorithm>
#include <vector>

namespace skdtree
{
/// The points of several meshes, one after the other.
class SkdPointsOfBlocks
{
public:
  explicit SkdPointsOfBlocks(const std::vector<SkdBlock>& meshes)
    : Meshes(meshes)
  {
    for (const SkdBlock& mesh : meshes)
    {
      this->Offsets.push_back(
        this->Offsets.back() + static_cast<std::size_t>(mesh.Mesh->GetNumberOfPoints()));
    }
  }

  std::size_t GetNumber() const { return this->Offsets.back(); }

  /// Calls visit(mesh, point) with the index of the mesh and the id in it of a point.
  template <class VisitPoint>
  void Visit(std::size_t i, const VisitPoint& visit) const
  {
    const auto next = std::upper_bound(this->Offsets.begin(), this->Offsets.end(), i);
    const auto mesh = static_cast<std::size_t>(next - this->Offsets.begin()) - 1;
    visit(mesh, static_cast<vtkIdType>(i - this->Offsets[mesh]));
  }

  skd::Vector3 Get(std::size_t i) const
  {
    skd::Vector3 x;
    this->Visit(
      i, [&](std::size_t mesh, vtkIdType point) { this->Meshes[mesh].Mesh->GetPoint(point, x.X); });
    return x;
  }

private:
  const std::vector<SkdBlock>& Meshes;
  std::vector<std::size_t> Offsets{ 0 };
};
}

#endif
