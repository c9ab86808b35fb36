// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StructuredMeshes.h
 * @brief data sets whose cells are not listed: images and the grids of i, j, k
 */
#ifndef skdtest_StructuredMeshes_h
#define skdtest_StructuredMeshes_h

#include "Support/VolumeMeshes.h"

#include "vtkDoubleArray.h"
#include "vtkExplicitStructuredGrid.h"
#include "vtkImageData.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredGrid.h"
#include "vtkUniformGrid.h"

namespace skdtest
{

/// n^3 voxels, neither at the origin nor cubes.
vtkSmartPointer<vtkImageData> MakeImage(int n);

/// The same, its extent starting off zero and its axes turned by a direction matrix.
vtkSmartPointer<vtkImageData> MakeRotatedImage(int n);

/// n x n pixels in a plane across the given axis.
vtkSmartPointer<vtkImageData> MakeFlatImage(int n, int across);

/// n^3 voxels, their sides growing along each axis.
vtkSmartPointer<vtkRectilinearGrid> MakeRectilinear(int n);

/// n^3 bent hexahedra.
vtkSmartPointer<vtkStructuredGrid> MakeStructured(int n);

bool IsBlanked(vtkIdType cell);

/// Every third cell blanked (IsBlanked), of a structured or uniform grid.
template <typename GridType>
vtkSmartPointer<GridType> Blanked(vtkSmartPointer<GridType> grid)
{
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    if (IsBlanked(cell))
    {
      grid->BlankCell(cell);
    }
  }
  return grid;
}

vtkSmartPointer<vtkUniformGrid> MakeUniformGrid(int n);

/// n^3 bent hexahedra with a fault: the halves do not share points.
vtkSmartPointer<vtkExplicitStructuredGrid> MakeExplicitStructured(int n);

}

#endif
