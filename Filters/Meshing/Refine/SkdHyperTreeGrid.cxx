// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Meshing/Refine/SkdGridOutput.h"

#include "vtkDoubleArray.h"
#include "vtkHyperTree.h"
#include "vtkHyperTreeGrid.h"

#include <algorithm>

namespace skdtree
{
namespace
{
vtkSmartPointer<vtkDoubleArray> MakeCoordinates(const std::vector<double>& planes)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetNumberOfTuples(static_cast<vtkIdType>(planes.size()));
  std::copy(planes.begin(), planes.end(), array->GetPointer(0));
  return array;
}

/// Refines a tree as the grid's base cell is; nodes of the tree are numbered as they are made,
/// level by level. Appends its cells.
void FillTree(
  const SkdGrid& grid, std::uint32_t baseCell, vtkHyperTree* tree, std::vector<SkdGridCell>& cells)
{
  const std::size_t start = cells.size();
  tree->SetGlobalIndexStart(static_cast<vtkIdType>(start));
  cells.push_back({ 0, baseCell });
  for (std::size_t i = start; i < cells.size(); ++i)
  {
    const SkdGridCell at = cells[i];
    if (!grid.Forest.IsLeaf(at.Level, at.Index))
    {
      tree->SubdivideLeaf(static_cast<vtkIdType>(i - start), static_cast<unsigned int>(at.Level));
      const std::uint32_t child = grid.Forest.FirstChild(at.Level, at.Index);
      for (std::uint32_t k = 0; k < grid.Forest.FamilySize(); ++k)
      {
        cells.push_back({ at.Level + 1, child + k });
      }
    }
  }
}
}

std::vector<SkdGridCell> SkdMakeHyperTreeGrid(const SkdGrid& grid, vtkHyperTreeGrid* output)
{
  const skd::Lattice& lattice = grid.Lattice;
  const auto& branch = lattice.GetBranch();
  output->Initialize();
  int dimensions[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    dimensions[axis] = static_cast<int>(lattice.GetPlanes(axis).size());
  }
  output->SetDimensions(dimensions);
  output->SetBranchFactor(
    static_cast<unsigned int>(*std::max_element(branch.begin(), branch.end())));
  output->SetXCoordinates(MakeCoordinates(lattice.GetPlanes(0)));
  output->SetYCoordinates(MakeCoordinates(lattice.GetPlanes(1)));
  output->SetZCoordinates(MakeCoordinates(lattice.GetPlanes(2)));
  std::vector<SkdGridCell> cells;
  cells.reserve(grid.Forest.NumberOfCells());
  for (std::uint32_t baseCell = grid.FirstOwn; baseCell < grid.LastOwn; ++baseCell)
  {
    FillTree(grid, baseCell, output->GetTree(baseCell, true), cells);
  }
  return cells;
}
}
