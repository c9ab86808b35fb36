// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/SkdSource.h"

#include <algorithm>

void SkdSource::Update(
  vtkDataObject* source, bool wantsSide, double epsilon, double chordalDeviation)
{
  this->Blocks = SkdBlocksOf(source);
  this->Blocks.erase(std::remove_if(this->Blocks.begin(), this->Blocks.end(),
                       [](const SkdBlock& block) { return block.Mesh->GetNumberOfCells() == 0; }),
    this->Blocks.end());
  this->TreesBuilt = this->UpdateTrees(wantsSide, epsilon, chordalDeviation);
}

// Trees of the other kind are let go: whoever switches back pays for it, not everyone's memory.
int SkdSource::UpdateTrees(bool wantsSide, double epsilon, double chordalDeviation)
{
  int built = 0;
  this->Sided = false;
  if (wantsSide)
  {
    built = this->Boundary.Update(this->Blocks, epsilon, chordalDeviation);
    this->Sided = this->Boundary.GetNumberOfFaces() > 0;
  }
  if (this->Sided)
  {
    this->Trees.Clear();
    return built;
  }
  this->Boundary.Clear();
  return this->Trees.Update(this->Blocks, epsilon);
}

vtkDataSet* SkdSource::GetMesh(int block) const
{
  return this->Sided ? this->Boundary.GetMesh(block) : this->Trees.GetMesh(block);
}

std::optional<SkdNearest> SkdSource::FindNearest(const double x[3], double maximumDistance) const
{
  return this->Sided ? this->Boundary.FindNearest(x, maximumDistance)
                     : this->Trees.FindNearest(x, maximumDistance);
}

SkdTreeCounts SkdSource::GetCounts() const
{
  return this->Sided ? this->Boundary.GetCounts() : this->Trees.GetCounts();
}

vtkIdType SkdSource::GetNumberOfOpenEdges() const
{
  return this->Sided ? this->Boundary.GetNumberOfOpenEdges() : 0;
}
