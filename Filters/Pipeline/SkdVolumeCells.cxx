// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/SkdVolumeCells.h"

#include "Cells/Curved/SkdCurvedFaces.h"
#include "vtkDataSet.h"

#include <algorithm>

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

bool SkdHasVolumeCells(const std::vector<SkdBlock>& blocks)
{
  return std::any_of(blocks.begin(), blocks.end(),
    [](const SkdBlock& block) { return SkdHasVolumeCells(block.Mesh); });
}
}
