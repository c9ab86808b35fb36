// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Search/Rays/SkdSurfaceBlocks.h"

#include "Cells/Curved/SkdCurvedFaces.h"

namespace skdtree
{
bool SkdHasVolumeCells(vtkDataSet* mesh)
{
  bool hasVolume = false;
  const vtkIdType cells = mesh->IsA("vtkPolyData") ? 0 : mesh->GetNumberOfCells();
  for (vtkIdType cell = 0; cell < cells && !hasVolume; ++cell)
  {
    hasVolume = SkdDimensionOfCellType(mesh->GetCellType(cell)) == 3;
  }
  return hasVolume;
}

std::vector<SkdBlock> SkdSurfaceBlocks::Update(const std::vector<SkdBlock>& blocks)
{
  if (!this->Kept.AreSameAs(blocks) || this->Surfaces.size() != blocks.size())
  {
    const double chordalLength = SkdChordalLength(blocks, SkdDefaultChordalDeviation);
    this->Surfaces.clear();
    this->ChordalLength = 0.0;
    for (const SkdBlock& kept : this->Kept.Keep(blocks))
    {
      auto& surface = this->Surfaces.emplace_back();
      if (SkdHasVolumeCells(kept.Mesh))
      {
        surface.emplace(kept.Mesh, chordalLength);
        this->ChordalLength = chordalLength;
      }
    }
  }
  std::vector<SkdBlock> surfaces = blocks;
  for (std::size_t i = 0; i < blocks.size(); ++i)
  {
    if (this->Surfaces[i])
    {
      surfaces[i].Mesh = this->Surfaces[i]->Get();
    }
  }
  return surfaces;
}
}
