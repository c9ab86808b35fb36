// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/Read/SkdMeshTime.h"

#include "Cells/Read/SkdCellReader.h"

#include "vtkCellData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace skdtree
{
namespace
{
/// Of the object itself: of attributes, when an array was added or removed.
vtkMTimeType OwnTime(vtkObject* object)
{
  return object->vtkObject::GetMTime();
}

template <class Mesh>
vtkMTimeType OfStructure(vtkDataSet* data)
{
  auto* mesh = static_cast<Mesh*>(data);
  return std::max(std::max(OwnTime(mesh), mesh->GetMeshMTime()),
    std::max(OwnTime(mesh->GetCellData()), OwnTime(mesh->GetPointData())));
}

/// Whether arrays say which cells there are, or what shape they have.
bool HasShaping(vtkDataSetAttributes* attributes)
{
  return attributes->GetAbstractArray(vtkDataSetAttributes::GhostArrayName()) ||
    attributes->GetRationalWeights() || attributes->GetHigherOrderDegrees();
}
}

//------------------------------------------------------------------------------
void SkdMeshTime::Watch(vtkDataSet* mesh)
{
  if (!mesh || !SkdHasPlainCells(mesh) || HasShaping(mesh->GetCellData()) ||
    HasShaping(mesh->GetPointData()))
  {
    this->Ask = OfAll;
    return;
  }
  const bool isGrid = mesh->GetDataObjectType() == VTK_UNSTRUCTURED_GRID;
  this->Ask = isGrid ? OfStructure<vtkUnstructuredGrid> : OfStructure<vtkPolyData>;
}
}
