// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Support/StructuredMeshes.h"

namespace skdtest
{

vtkSmartPointer<vtkImageData> MakeImage(int n)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(n + 1, n + 1, n + 1);
  image->SetOrigin(-1, 0.5, 2);
  image->SetSpacing(1, 0.5, 0.25);
  return image;
}

vtkSmartPointer<vtkImageData> MakeRotatedImage(int n)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(3, n + 3, -2, n - 2, 1, n + 1);
  image->SetSpacing(1, 0.5, 0.25);
  image->SetDirectionMatrix(
    2.0 / 3, 2.0 / 3, -1.0 / 3, -1.0 / 3, 2.0 / 3, 2.0 / 3, 2.0 / 3, -1.0 / 3, 2.0 / 3);
  return image;
}

vtkSmartPointer<vtkImageData> MakeFlatImage(int n, int across)
{
  int dimensions[3] = { n + 1, n + 1, n + 1 };
  dimensions[across] = 1;
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(dimensions);
  image->SetOrigin(0.25, 0.5, 0.75);
  return image;
}

vtkSmartPointer<vtkRectilinearGrid> MakeRectilinear(int n)
{
  auto grid = vtkSmartPointer<vtkRectilinearGrid>::New();
  grid->SetDimensions(n + 1, n + 1, n + 1);
  vtkNew<vtkDoubleArray> coordinates[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int i = 0; i <= n; ++i)
    {
      coordinates[axis]->InsertNextValue(0.1 * (axis + 1) * i * i + 0.2 * i);
    }
  }
  grid->SetXCoordinates(coordinates[0]);
  grid->SetYCoordinates(coordinates[1]);
  grid->SetZCoordinates(coordinates[2]);
  return grid;
}

vtkSmartPointer<vtkStructuredGrid> MakeStructured(int n)
{
  Mesh mesh = Hexahedra(n);
  auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
  grid->SetDimensions(n + 1, n + 1, n + 1);
  grid->SetPoints(MakePoints(mesh.Map(Bent).Points));
  return grid;
}

bool IsBlanked(vtkIdType cell)
{
  return cell % 3 == 1;
}

vtkSmartPointer<vtkUniformGrid> MakeUniformGrid(int n)
{
  auto grid = vtkSmartPointer<vtkUniformGrid>::New();
  grid->ShallowCopy(MakeImage(n));
  return grid;
}

vtkSmartPointer<vtkExplicitStructuredGrid> MakeExplicitStructured(int n)
{
  const Mesh mesh = Soup(Hexahedra(n).Map(Bent));
  vtkNew<vtkCellArray> cells;
  for (const CellSpec& cell : mesh.Cells)
  {
    cells->InsertNextCell(8, cell.Points.data());
  }
  auto grid = vtkSmartPointer<vtkExplicitStructuredGrid>::New();
  grid->SetDimensions(n + 1, n + 1, n + 1);
  grid->SetPoints(MakePoints(mesh.Points));
  grid->SetCells(cells);
  return grid;
}

}
