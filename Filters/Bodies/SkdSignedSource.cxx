// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bodies/SkdSignedSource.h"

int SkdSignedSource::Update(
  const std::vector<SkdBlock>& blocks, double epsilon, double chordalDeviation)
{
  const double chordalLength = SkdChordalLength(blocks, chordalDeviation);
  const bool isSame =
    this->Faces && this->ChordalLength == chordalLength && this->Meshes.AreSameAs(blocks);
  if (!isSame)
  {
    this->ChordalLength = chordalLength;
    this->MakeBoundary(blocks);
  }
  int built = SkdBuildLocator(this->Faces, epsilon, !isSame);
  if (this->Surface != this->Faces)
  {
    built += SkdBuildLocator(this->Surface, epsilon, !isSame);
  }
  if (!this->Solid && built > 0)
  {
    this->OpenSolid = std::make_unique<SkdOpenSolid>(this->Boundary, this->Surface, epsilon);
  }
  return built;
}

void SkdSignedSource::MakeBoundary(const std::vector<SkdBlock>& blocks)
{
  this->Boundary = SkdBoundaryOf(this->Meshes.Keep(blocks), this->ChordalLength);
  this->Boundary.Surface->GetCellsBounds(this->Bounds);
  this->Faces = SkdMakeLocator(this->Boundary.Faces);
  const bool isOne = this->Boundary.Surface == this->Boundary.Faces;
  this->Surface = isOne ? this->Faces : SkdMakeLocator(this->Boundary.Surface);
  this->Solid = this->Boundary.OpenEdges == 0
    ? std::make_unique<SkdSolid>(this->Boundary, this->Surface)
    : nullptr;
  this->OpenSolid.reset();
}

std::optional<SkdNearest> SkdSignedSource::FindNearest(
  const double x[3], double maximumDistance) const
{
  double asked[3] = { x[0], x[1], x[2] };
  SkdNearest nearest;
  vtkIdType face;
  int subId;
  if (!this->Faces->FindClosestPointWithinRadius(
        asked, maximumDistance, nearest.Point, nullptr, face, subId, nearest.Distance2))
  {
    return std::nullopt;
  }
  nearest.Block = this->Boundary.Origins[face].Block;
  nearest.CellId = this->Boundary.Origins[face].CellId;
  return nearest;
}

bool SkdSignedSource::IsInside(const double x[3]) const
{
  if (this->OpenSolid)
  {
    return this->OpenSolid->IsInside(x);
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    if (!(x[axis] >= this->Bounds[2 * axis] && x[axis] <= this->Bounds[2 * axis + 1]))
    {
      return false;
    }
  }
  return this->Solid->Ask(x, SkdRayEndsAlongAxes(this->Bounds, x)[0]).IsInside;
}

SkdTreeCounts SkdSignedSource::GetCounts() const
{
  return { this->Faces->GetNumberOfCellsInTree(), this->Faces->GetNumberOfCellsLeftOut(),
    this->Faces->GetAbsoluteEpsilon() };
}
