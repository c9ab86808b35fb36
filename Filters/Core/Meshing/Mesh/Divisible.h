// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Mesh_Divisible_h
#define skd_Mesh_Divisible_h

#include "../../Geometry/Resolution.h"
#include "RefinedMesh.h"

namespace skd
{

/// Whether there is room for points in the middles of a cell's edges. Of cells that are about as
/// small as the resolution of their coordinates (far from the origin, say) middles are rounded to
/// ends, and what they are cut into is no smaller than they are.
inline bool IsDivisible(const RefinedMesh& mesh, std::uint32_t cell)
{
  const RefinedMesh::Nodes nodes = mesh.NodesOf(cell);
  bool isDivisible = true;
  ForEachEdge(mesh[cell].Kind, nodes.First, nodes.Size,
    [&](std::uint32_t a, std::uint32_t b)
    { isDivisible = isDivisible && IsResolved(mesh.FlatPoint(a), mesh.FlatPoint(b)); });
  return isDivisible;
}

}

#endif
