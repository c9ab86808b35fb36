// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/SkdBlockSurface.h"

#include "Cells/SkdCurvedFaces.h"
#include "Pipeline/SkdOuterSurface.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

namespace
{
vtkSmartPointer<vtkPolyData> SurfaceOf(vtkDataSet* mesh, double chordalLength)
{
  auto* surface = vtkPolyData::SafeDownCast(mesh);
  return surface ? vtkSmartPointer<vtkPolyData>(surface) : SkdOuterSurfaceOf(mesh, chordalLength);
}
}

SkdBlockSurface::SkdBlockSurface(vtkDataSet* mesh, double chordalLength)
  : Mesh(mesh)
  , Surface(SurfaceOf(mesh, chordalLength))
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

bool SkdBlockSurface::IsOfVolume(vtkIdType cell) const
{
  return this->CellIds &&
    SkdDimensionOfCellType(this->Mesh->GetCellType(this->CellIds->GetValue(cell))) == 3;
}

// VTK's surface of a structured grid has its points rounded to float: look at the original's.
void SkdBlockSurface::FindPoint(vtkIdType point, double x[3]) const
{
  const vtkIdType original = this->PointIds ? this->PointIds->GetValue(point) : -1;
  vtkDataSet* from = original >= 0 ? this->Mesh : this->Surface.Get();
  from->GetPoint(original >= 0 ? original : point, x);
}
