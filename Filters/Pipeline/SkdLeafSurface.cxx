// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/SkdLeafSurface.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkDoubleArray.h"
#include "vtkExplicitStructuredGrid.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

namespace
{
// VTK's surface of an explicit structured grid has an original cell id that was never set.
vtkSmartPointer<vtkUnstructuredGrid> AsUnstructured(vtkExplicitStructuredGrid* explicitGrid)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(explicitGrid->GetPoints());
  grid->SetCells(VTK_HEXAHEDRON, explicitGrid->GetCells());
  grid->GetCellData()->AddArray(explicitGrid->GetCellGhostArray());
  return grid;
}

vtkSmartPointer<vtkPolyData> SurfaceOf(vtkDataSet* mesh)
{
  if (auto surface = vtkPolyData::SafeDownCast(mesh))
  {
    return surface;
  }
  auto explicitGrid = vtkExplicitStructuredGrid::SafeDownCast(mesh);
  vtkNew<vtkDataSetSurfaceFilter> filter;
  filter->SetInputData(mesh);
  if (explicitGrid)
  {
    filter->SetInputData(AsUnstructured(explicitGrid));
  }
  filter->PassThroughCellIdsOn();
  filter->PassThroughPointIdsOn();
  filter->Update();
  return filter->GetOutput();
}

}

SkdLeafSurface::SkdLeafSurface(vtkDataSet* mesh)
  : Mesh(mesh)
  , Surface(SurfaceOf(mesh))
{
  if (mesh != this->Surface.Get())
  {
    this->CellIds =
      vtkIdTypeArray::SafeDownCast(this->Surface->GetCellData()->GetArray("vtkOriginalCellIds"));
    this->PointIds =
      vtkIdTypeArray::SafeDownCast(this->Surface->GetPointData()->GetArray("vtkOriginalPointIds"));
  }
  else if (this->Surface->GetPoints())
  {
    vtkDataArray* points = this->Surface->GetPoints()->GetData();
    auto doubles = vtkDoubleArray::SafeDownCast(points);
    auto floats = vtkFloatArray::SafeDownCast(points);
    this->Doubles = doubles ? doubles->GetPointer(0) : nullptr;
    this->Floats = floats ? floats->GetPointer(0) : nullptr;
  }
}

bool SkdLeafSurface::IsOfVolume(vtkIdType cell)
{
  if (!this->CellIds)
  {
    return false;
  }
  if (!this->Cell)
  {
    this->Cell = vtkSmartPointer<vtkGenericCell>::New();
  }
  this->Mesh->GetCell(this->CellIds->GetValue(cell), this->Cell);
  return this->Cell->GetCellDimension() == 3;
}

// VTK's surface of a structured grid has its points rounded to float: look at the original's.
void SkdLeafSurface::FindPoint(vtkIdType point, double x[3]) const
{
  const vtkIdType original = this->PointIds ? this->PointIds->GetValue(point) : -1;
  vtkDataSet* from = original >= 0 ? this->Mesh : this->Surface.Get();
  from->GetPoint(original >= 0 ? original : point, x);
}
