// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Remap/SkdMeshPoints.h"

#include "Cells/Read/SkdCellReader.h"
#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkGenericCell.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

namespace skdtree
{
std::vector<skd::Vector3> SkdPointsOf(vtkDataSet* mesh)
{
  std::vector<skd::Vector3> points(static_cast<std::size_t>(mesh->GetNumberOfPoints()));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    mesh->GetPoint(static_cast<vtkIdType>(i), points[i].X);
  }
  return points;
}

std::vector<skd::Vector3> SkdMiddlesOf(vtkDataSet* mesh)
{
  const double nan = vtkMath::Nan();
  std::vector<skd::Vector3> middles(
    static_cast<std::size_t>(mesh->GetNumberOfCells()), skd::Vector3{ { nan, nan, nan } });
  vtkNew<vtkGenericCell> cell;
  std::vector<double> weights;
  for (std::size_t i = 0; i < middles.size(); ++i)
  {
    SkdLoadCell(mesh, static_cast<vtkIdType>(i), cell);
    if (cell->GetCellType() != VTK_EMPTY_CELL && cell->GetNumberOfPoints() > 0)
    {
      double pcoords[3];
      int subId = cell->GetParametricCenter(pcoords);
      weights.resize(static_cast<std::size_t>(cell->GetNumberOfPoints()) + 1);
      cell->EvaluateLocation(subId, pcoords, middles[i].X, weights.data());
    }
  }
  return middles;
}

void SkdLeaveOut(const std::vector<unsigned char>& counts, std::vector<skd::Vector3>& points)
{
  const double nan = vtkMath::Nan();
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    points[i] = counts[i] != 0 ? points[i] : skd::Vector3{ { nan, nan, nan } };
  }
}

vtkSmartPointer<vtkPolyData> SkdCloudOf(const std::vector<skd::Vector3>& positions)
{
  auto cloud = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(positions.size()));
  for (std::size_t i = 0; i < positions.size(); ++i)
  {
    points->SetPoint(static_cast<vtkIdType>(i), positions[i].X);
  }
  cloud->SetPoints(points);
  return cloud;
}
}
