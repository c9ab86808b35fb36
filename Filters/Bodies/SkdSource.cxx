// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bodies/SkdSource.h"

namespace skdtree
{
void SkdSource::Update(
  vtkDataObject* source, bool wantsSide, double epsilon, double chordalDeviation)
{
  this->Blocks = SkdBlocksWithCells(SkdBlocksOf(source));
  this->TreesBuilt = this->UpdateTrees(wantsSide, epsilon, chordalDeviation);
}

// Trees of the other kind are released to save memory; switching back builds them again.
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
}
