// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/Read/SkdMeshChecksum.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArrayRange.h"
#include "vtkExplicitStructuredGrid.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRectilinearGrid.h"
#include "vtkSkdTreeVersion.h"
#include "vtkUnstructuredGrid.h"

#include <functional>
#include <string_view>

namespace skdtree
{
namespace
{
class Checksum
{
public:
  void Add(vtkDataArray* values)
  {
    if (!values)
    {
      this->Combine(0);
    }
    else if (values->HasStandardMemoryLayout())
    {
      const auto bytes = static_cast<std::size_t>(values->GetNumberOfValues()) *
        static_cast<std::size_t>(values->GetDataTypeSize());
      this->AddBytes(values->GetVoidPointer(0), bytes);
    }
    else
    {
      for (const double value : vtk::DataArrayValueRange(values))
      {
        this->AddBytes(&value, sizeof(value));
      }
    }
  }
  void Add(vtkPoints* points) { this->Add(points ? points->GetData() : nullptr); }
  void Add(vtkCellArray* cells)
  {
    if (cells)
    {
      this->Add(cells->GetOffsetsArray());
      this->Add(cells->GetConnectivityArray());
    }
  }
  void AddShaping(vtkDataSetAttributes* attributes)
  {
    this->Add(attributes->GetArray(vtkDataSetAttributes::GhostArrayName()));
    this->Add(attributes->GetRationalWeights());
    this->Add(attributes->GetHigherOrderDegrees());
  }
  std::size_t Get() const { return this->Value; }

private:
  void AddBytes(const void* bytes, std::size_t count)
  {
    this->Combine(
      std::hash<std::string_view>()(std::string_view(static_cast<const char*>(bytes), count)));
  }
  void Combine(std::size_t hash)
  {
    constexpr std::size_t odd = 0x9e3779b97f4a7c15u; // 2^64 over the golden ratio
    this->Value = (this->Value ^ hash) * odd;
  }

  std::size_t Value = 1;
};

void AddCells(vtkDataSet* data, Checksum& sum)
{
  if (auto mesh = vtkPolyData::SafeDownCast(data))
  {
    for (vtkCellArray* cells :
      { mesh->GetVerts(), mesh->GetLines(), mesh->GetPolys(), mesh->GetStrips() })
    {
      sum.Add(cells);
    }
  }
  else if (auto grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    sum.Add(grid->GetCells());
    sum.Add(grid->VTK_SKD_GET_CELL_TYPES());
  }
  else if (auto explicitGrid = vtkExplicitStructuredGrid::SafeDownCast(data))
  {
    sum.Add(explicitGrid->GetCells());
  }
}
}

std::size_t SkdMeshChecksum(vtkDataSet* data)
{
  Checksum sum;
  if (auto mesh = vtkPointSet::SafeDownCast(data))
  {
    sum.Add(mesh->GetPoints());
  }
  else if (auto grid = vtkRectilinearGrid::SafeDownCast(data))
  {
    for (vtkDataArray* axis :
      { grid->GetXCoordinates(), grid->GetYCoordinates(), grid->GetZCoordinates() })
    {
      sum.Add(axis);
    }
  }
  AddCells(data, sum);
  sum.AddShaping(data->GetCellData());
  sum.AddShaping(data->GetPointData());
  return sum.Get();
}
}
