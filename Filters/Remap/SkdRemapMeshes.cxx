// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Remap/SkdRemapMeshes.h"

#include "Cells/Read/SkdCellReader.h"
#include "Pipeline/SkdLonLat.h"
#include "Pipeline/SkdPartialArrays.h"
#include "Remap/SkdOverlapSurface.h"
#include "Remap/SkdRemapTolerances.h"
#include "vtkAppendFilter.h"
#include "vtkCell.h"
#include "vtkGenericCell.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>

namespace
{
vtkSmartPointer<vtkUnstructuredGrid> Append(const std::vector<vtkDataSet*>& meshes)
{
  vtkNew<vtkAppendFilter> append;
  for (vtkDataSet* mesh : meshes)
  {
    append->AddInputData(mesh);
  }
  append->Update();
  return append->GetOutput();
}
}

vtkSmartPointer<vtkDataSet> SkdJoinBlocks(
  const std::vector<SkdBlock>& blocks, std::set<std::string>& partial)
{
  partial.clear();
  if (blocks.size() == 1)
  {
    return blocks.front().Mesh;
  }
  std::vector<vtkDataSet*> meshes;
  const std::vector<SkdBlock> completed = SkdCompleteArrays(blocks, partial);
  for (const SkdBlock& block : completed)
  {
    meshes.push_back(block.Mesh);
  }
  return meshes.empty() ? vtkSmartPointer<vtkUnstructuredGrid>::New() : Append(meshes);
}

vtkSmartPointer<vtkDataSet> SkdMovedToSphere(vtkDataSet* mesh, double radius)
{
  vtkSmartPointer<vtkUnstructuredGrid> moved = Append({ mesh });
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(moved->GetNumberOfPoints());
  for (vtkIdType i = 0; i < moved->GetNumberOfPoints(); ++i)
  {
    skd::Vector3 x;
    moved->GetPoint(i, x.X);
    points->SetPoint(i, (radius * SkdDirectionOfLonLat(x)).X);
  }
  moved->SetPoints(points);
  return moved;
}

int SkdDimensionOf(vtkDataSet* mesh)
{
  int dimension = -1;
  vtkNew<vtkGenericCell> cell;
  const SkdCellReader reader(mesh);
  int known = -1;
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells() && dimension < 3; ++i)
  {
    const int type = reader.TypeOf(i);
    if (type != known && type != VTK_EMPTY_CELL)
    {
      cell->SetCellType(type);
      dimension = std::max(dimension, cell->GetCellDimension());
      known = type;
    }
  }
  return dimension;
}

std::optional<double> SkdRadiusOf(vtkDataSet* mesh)
{
  double bounds[6];
  mesh->GetBounds(bounds);
  const bool isFlat = bounds[0] == bounds[1] || bounds[2] == bounds[3] || bounds[4] == bounds[5];
  double least = VTK_DOUBLE_MAX, greatest = 0.0, sum = 0.0;
  const vtkIdType n = mesh->GetNumberOfPoints();
  using remap_tolerances::RadiusSpread;
  for (vtkIdType i = 0; i < n && !isFlat && !(greatest - least > RadiusSpread * greatest); ++i)
  {
    double x[3];
    mesh->GetPoint(i, x);
    const double radius = vtkMath::Norm(x);
    least = std::min(least, radius);
    greatest = std::max(greatest, radius);
    sum += radius;
  }
  const bool isSphere = n > 2 && !isFlat && greatest - least <= RadiusSpread * greatest;
  return isSphere ? std::optional<double>(sum / n) : std::nullopt;
}

bool SkdMayBeLonLat(vtkDataSet* mesh)
{
  double bounds[6];
  mesh->GetBounds(bounds);
  constexpr double radian = 57.3, halfTurn = 180.0, turn = 360.0;
  const double width = bounds[1] - bounds[0];
  return mesh->GetNumberOfPoints() > 0 && bounds[4] == bounds[5] && bounds[2] >= -0.5 * halfTurn &&
    bounds[3] <= 0.5 * halfTurn && bounds[0] >= -turn && bounds[1] <= 1.5 * turn && width > radian;
}

bool SkdAreInOnePlane(vtkDataSet* donor, const std::vector<SkdBlock>& blocks)
{
  SkdOverlapSettings settings;
  settings.Space = SkdOverlapSpace::Plane;
  return std::all_of(blocks.begin(), blocks.end(),
    [&](const SkdBlock& block)
    {
      return block.Mesh->GetNumberOfCells() == 0 ||
        SkdOverlapSurface(donor, block.Mesh, settings).GetProblem().empty();
    });
}

SkdOverlapSpace SkdSpaceOf(vtkDataSet* mesh)
{
  switch (SkdDimensionOf(mesh))
  {
    case 0:
    case 1:
      return SkdOverlapSpace::Line;
    case 2:
      return SkdRadiusOf(mesh) ? SkdOverlapSpace::Sphere : SkdOverlapSpace::Plane;
    default:
      return SkdOverlapSpace::Volume;
  }
}

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
    if (cell->GetNumberOfPoints() > 0)
    {
      double pcoords[3];
      int subId = cell->GetParametricCenter(pcoords);
      weights.resize(static_cast<std::size_t>(cell->GetNumberOfPoints()) + 1);
      cell->EvaluateLocation(subId, pcoords, middles[i].X, weights.data());
    }
  }
  return middles;
}

vtkSmartPointer<vtkPolyData> SkdCloudOf(const std::vector<skd::Vector3>& places)
{
  auto cloud = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(places.size()));
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    points->SetPoint(static_cast<vtkIdType>(i), places[i].X);
  }
  cloud->SetPoints(points);
  return cloud;
}
