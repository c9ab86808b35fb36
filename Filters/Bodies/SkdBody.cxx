// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bodies/SkdBody.h"

namespace skdtree
{
SkdBody::SkdBody(const std::vector<SkdBlock>& blocks, double chordalLength)
  : Boundary(SkdBoundaryOf(blocks, chordalLength))
  , Faces(SkdMakeLocator(this->Boundary.Faces))
  , Surface(this->Boundary.Surface == this->Boundary.Faces ? this->Faces
                                                           : SkdMakeLocator(this->Boundary.Surface))
{
  if (this->Boundary.OpenEdges == 0)
  {
    this->Solid = std::make_unique<SkdSolid>(this->Boundary, this->Surface);
  }
}

//------------------------------------------------------------------------------
int SkdBody::Build(double epsilon, bool wantsOpenSolid)
{
  const bool isNew = !this->IsBuilt;
  this->IsBuilt = true;
  int built = SkdBuildLocator(this->Faces, epsilon, isNew);
  if (this->Surface != this->Faces)
  {
    built += SkdBuildLocator(this->Surface, epsilon, isNew);
  }
  if (!this->Solid && wantsOpenSolid && built > 0)
  {
    this->OpenSolid = std::make_unique<SkdOpenSolid>(this->Boundary, this->Surface, epsilon);
  }
  return built;
}

//------------------------------------------------------------------------------
std::optional<SkdNearest> SkdFindNearestFace(vtkSkdTreeCellLocator* faces,
  const std::vector<SkdBoundary::Origin>& origins, const double x[3], double maximumDistance)
{
  double query[3] = { x[0], x[1], x[2] };
  SkdNearest nearest;
  vtkIdType face;
  int subId;
  if (!faces->FindClosestPointWithinRadius(
        query, maximumDistance, nearest.Point, nullptr, face, subId, nearest.Distance2))
  {
    return std::nullopt;
  }
  nearest.Block = origins[static_cast<std::size_t>(face)].Block;
  nearest.CellId = origins[static_cast<std::size_t>(face)].CellId;
  return nearest;
}
}
