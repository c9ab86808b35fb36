// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Meshing/Refine/SkdNodePlacement.h"

#include "Bodies/SkdSource.h"

#include <limits>

namespace skdtree
{
skd::RefinedMesh::Placement SkdPutOnSphere(const skd::Vector3& centre)
{
  return
    [centre](const skd::Vector3& mean, const skd::RefinedMesh& mesh, skd::RefinedMesh::Nodes makers)
  {
    double radius = 0.0;
    for (const std::uint32_t maker : makers)
    {
      radius += skd::Norm(mesh.Point(maker) - centre) / makers.Size;
    }
    const double length = skd::Norm(mean - centre);
    // Opposite ends of a diameter leave no direction.
    return length > 0.0 ? centre + (radius / length) * (mean - centre) : mean;
  };
}

skd::RefinedMesh::Placement SkdPutOnSurface(const SkdSource& surface)
{
  return [&surface](const skd::Vector3& mean, const skd::RefinedMesh&,
           skd::RefinedMesh::Nodes) -> skd::Vector3
  {
    const auto nearest = surface.FindNearest(mean.X, std::numeric_limits<double>::max());
    return nearest ? skd::Vector3{ { nearest->Point[0], nearest->Point[1], nearest->Point[2] } }
                   : mean;
  };
}
}
