// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Refine/SkdEnclosure.h"

#include "Pipeline/SkdOrientation.h"

int SkdEnclosure::Update(
  const std::vector<SkdBlock>& blocks, double epsilon, double chordalDeviation)
{
  const int built = this->Boundary.Update(blocks, epsilon, chordalDeviation);
  if (this->IsClosed())
  {
    this->Winding.reset();
  }
  else if (built > 0 || !this->Winding)
  {
    vtkPolyData* surface = this->Boundary.GetSurface();
    const std::vector<bool> isReversed =
      SkdFindReversed(SkdPointsOf(surface), SkdTrianglesOf(surface),
        [this](const skd::Vector3& x) { return this->Boundary.IsInside(x.X); });
    this->Winding = std::make_unique<SkdWinding>(surface, isReversed);
  }
  return built;
}
