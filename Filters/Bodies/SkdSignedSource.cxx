// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bodies/SkdSignedSource.h"

namespace skdtree
{
int SkdSignedSource::Update(
  const std::vector<SkdBlock>& blocks, double epsilon, double chordalDeviation)
{
  const double chordalLength = SkdChordalLength(blocks, chordalDeviation);
  const bool isSame = this->Body.HasBoundary() && this->ChordalLength == chordalLength &&
    this->Meshes.AreSameAs(blocks);
  if (!isSame)
  {
    this->ChordalLength = chordalLength;
    this->Body = SkdBody(this->Meshes.Keep(blocks), chordalLength);
    this->Body.GetBoundary().Surface->GetCellsBounds(this->Bounds);
  }
  return this->Body.Build(epsilon, true);
}

bool SkdSignedSource::IsInside(const double x[3]) const
{
  if (this->Body.GetOpenSolid())
  {
    return this->Body.GetOpenSolid()->IsInside(x);
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    if (!(x[axis] >= this->Bounds[2 * axis] && x[axis] <= this->Bounds[2 * axis + 1]))
    {
      return false;
    }
  }
  return this->Body.GetSolid()->Ask(x, SkdRayEndsAlongAxes(this->Bounds, x)[0]).IsInside;
}

SkdTreeCounts SkdSignedSource::GetCounts() const
{
  vtkSkdTreeCellLocator* faces = this->Body.GetFaces();
  return { faces->GetNumberOfCellsInTree(), faces->GetNumberOfCellsLeftOut(),
    faces->GetAbsoluteEpsilon() };
}
}
