// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Meshing/Refine/SkdGridOutput.h"

#include "Meshing/Refine/SkdGridPoints.h"
#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

namespace skdtree
{
std::vector<SkdGridCell> SkdMakeUnstructuredGrid(const SkdGrid& grid, vtkUnstructuredGrid* output)
{
  constexpr int types[4] = { VTK_VERTEX, VTK_LINE, VTK_PIXEL, VTK_VOXEL };
  std::vector<SkdGridCell> leaves = grid.Leaves();
  SkdGridPoints points(grid);
  const std::vector<unsigned> corners = points.Corners();
  vtkNew<vtkIdTypeArray> connectivity;
  connectivity->SetNumberOfTuples(static_cast<vtkIdType>(leaves.size() * corners.size()));
  vtkIdType* id = connectivity->GetPointer(0);
  for (const SkdGridCell& leaf : leaves)
  {
    const skd::LatticePoint position = grid.Forest.LatticePointOf(leaf.Level, leaf.Index);
    for (const unsigned corner : corners)
    {
      *id++ = points.IdOf(points.CornerOf(leaf.Level, position, corner));
    }
  }
  vtkNew<vtkCellArray> cells;
  cells->SetData(static_cast<vtkIdType>(corners.size()), connectivity);
  output->Initialize();
  output->SetPoints(points.MakePoints());
  output->SetCells(types[grid.Lattice.Dimension()], cells);
  output->GetPointData()->AddArray(points.MakeHanging());
  return leaves;
}
}
