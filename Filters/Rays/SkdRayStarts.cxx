// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rays/SkdRayStarts.h"

#include "Cells/SkdForEach.h"
#include "Rays/SkdSurfaceNormals.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <algorithm>

namespace
{
using skd::Vector3;

vtkDataSetAttributes* DataOf(vtkDataSet* mesh, SkdQueryPoints::At at)
{
  return at == SkdQueryPoints::At::Points ? static_cast<vtkDataSetAttributes*>(mesh->GetPointData())
                                          : mesh->GetCellData();
}

bool AreVectors(vtkDataArray* array)
{
  return array && array->GetNumberOfComponents() == 3;
}
}

SkdRayStarts::SkdRayStarts(vtkDataSet* mesh, SkdQueryPoints::At at, const SkdRayAim& aim)
{
  this->ReadPoints(mesh, at);
  switch (aim.Mode)
  {
    case SkdRayAim::Along::Normals:
      this->UseNormals(mesh, at);
      break;
    case SkdRayAim::Along::Array:
      this->UseArray(mesh, at, aim.Array);
      break;
    case SkdRayAim::Along::Direction:
      this->Directions.assign(this->Points.size(), SkdUnit(aim.Vector));
      break;
    case SkdRayAim::Along::ToPoint:
      for (const Vector3& point : this->Points)
      {
        this->Directions.push_back(SkdUnit(aim.Vector - point));
      }
      break;
  }
  if (aim.IsReversed)
  {
    for (Vector3& direction : this->Directions)
    {
      direction = -1.0 * direction;
    }
  }
}

vtkIdType SkdRayStarts::CountWithoutRay() const
{
  vtkIdType count = 0;
  for (std::size_t i = 0; i < this->Points.size(); ++i)
  {
    const bool hasRay = skd::IsFinite(this->Points[i]) && skd::Norm2(this->Directions[i]) > 0.0;
    count += hasRay ? 0 : 1;
  }
  return count;
}

void SkdRayStarts::ReadPoints(vtkDataSet* mesh, SkdQueryPoints::At at)
{
  const SkdQueryPoints starts(mesh, at);
  this->Points.resize(static_cast<std::size_t>(starts.GetNumber()));
  SkdForEach(this->Points.size(),
    [&](std::size_t i) { starts.GetPoint(static_cast<vtkIdType>(i), this->Points[i].X); });
}

void SkdRayStarts::UseNormals(vtkDataSet* mesh, SkdQueryPoints::At at)
{
  vtkDataArray* given = DataOf(mesh, at)->GetNormals();
  if (AreVectors(given))
  {
    this->Read(given);
    return;
  }
  this->Directions =
    at == SkdQueryPoints::At::Points ? SkdNormalsOfPoints(mesh) : SkdNormalsOfCells(mesh);
}

void SkdRayStarts::UseArray(vtkDataSet* mesh, SkdQueryPoints::At at, const std::string& name)
{
  vtkDataSetAttributes* data = DataOf(mesh, at);
  vtkDataArray* array = name.empty() ? data->GetVectors() : data->GetArray(name.c_str());
  if (AreVectors(array))
  {
    this->Read(array);
    return;
  }
  const std::string kind = at == SkdQueryPoints::At::Points ? "point" : "cell";
  this->Directions.assign(this->Points.size(), Vector3{ { 0.0, 0.0, 0.0 } });
  this->Fault = name.empty()
    ? "Input has no active vectors in its " + kind + " data; set DirectionArray."
    : "Input has no " + kind + " array \"" + name + "\" of three components; set DirectionArray.";
}

void SkdRayStarts::Read(vtkDataArray* vectors)
{
  this->Directions.resize(this->Points.size());
  SkdForEach(this->Directions.size(),
    [&](std::size_t i)
    {
      Vector3 vector;
      vectors->GetTuple(static_cast<vtkIdType>(i), vector.X);
      this->Directions[i] = SkdUnit(vector);
    });
}
