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
#include "vtkFieldData.h"
#include "vtkGenericCell.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>

namespace skdtree
{
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
  moved->GetFieldData()->PassData(mesh->GetFieldData());
  if (auto whole = SkdJoinedShape::Of(mesh))
  {
    whole->MoveToSphere(radius);
    whole->KeepIn(moved);
  }
  return moved;
}

bool SkdMayBeLonLat(vtkDataSet* mesh)
{
  double bounds[6];
  vtkIdType points = mesh->GetNumberOfPoints();
  mesh->GetBounds(bounds);
  if (const auto whole = SkdJoinedShape::Of(mesh))
  {
    const skd::Box3& box = whole->Bounds;
    points = whole->Points;
    std::copy_n(std::array<double, 6>{ { box.Min[0], box.Max[0], box.Min[1], box.Max[1], box.Min[2],
                                         box.Max[2] } }
                  .begin(),
      6, bounds);
  }
  constexpr double radian = 57.3, halfCircle = 180.0, fullCircle = 360.0;
  const double width = bounds[1] - bounds[0];
  return points > 0 && bounds[4] == bounds[5] && bounds[2] >= -0.5 * halfCircle &&
    bounds[3] <= 0.5 * halfCircle && bounds[0] >= -fullCircle && bounds[1] <= 1.5 * fullCircle &&
    width > radian;
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
