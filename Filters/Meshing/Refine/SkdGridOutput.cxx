// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Meshing/Refine/SkdGridOutput.h"

#include "Meshing/Refine/SkdGridArrays.h"
#include "vtkDataSetAttributes.h"
#include "vtkHyperTreeGrid.h"
#include "vtkOverlappingAMR.h"
#include "vtkUnstructuredGrid.h"

namespace skdtree
{
namespace
{
void AddArrays(const SkdGrid& grid, const SkdGridExtras& extras,
  const std::vector<int>& blockIndices, const std::vector<SkdGridCell>& cells,
  vtkDataObject* output)
{
  vtkDataSetAttributes* data = output->GetAttributes(vtkDataObject::CELL);
  for (const auto& array : SkdGridArrays::Make(grid, extras, blockIndices, cells))
  {
    data->AddArray(array);
  }
  data->SetActiveScalars(SkdGridArrays::LevelName);
}
}

//------------------------------------------------------------------------------
void SkdFillGridOutput(const SkdGrid& grid, const SkdGridExtras& extras,
  const std::vector<int>& blockIndices, bool isConforming, vtkDataObject* output)
{
  if (auto trees = vtkHyperTreeGrid::SafeDownCast(output))
  {
    AddArrays(grid, extras, blockIndices, SkdMakeHyperTreeGrid(grid, trees), trees);
  }
  else if (auto leaves = vtkUnstructuredGrid::SafeDownCast(output))
  {
    const bool conforms = isConforming && grid.Lattice.Dimension() == 2;
    AddArrays(grid, extras, blockIndices,
      conforms ? SkdMakeConformingGrid(grid, leaves) : SkdMakeUnstructuredGrid(grid, leaves),
      leaves);
  }
  else if (auto blocks = vtkOverlappingAMR::SafeDownCast(output))
  {
    for (const SkdGridBlock& block : SkdMakeOverlappingAMR(grid, blocks))
    {
      AddArrays(grid, extras, blockIndices, block.Cells, block.Grid);
    }
  }
}
}
