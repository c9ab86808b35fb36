// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Remap/SkdWeightsGrid.h"

#include "Cells/Read/SkdCellReader.h"
#include "Pipeline/SkdLonLat.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkNew.h"

#include <algorithm>

namespace skdtree
{
namespace
{
using skd::Vector3;

/// The corners of a polygon, anticlockwise seen from outside the sphere; none of other cells.
void GetCorners(vtkDataSet* mesh, vtkIdType cell, int type, std::vector<Vector3>& corners)
{
  corners.clear();
  if (type != VTK_TRIANGLE && type != VTK_QUAD && type != VTK_POLYGON && type != VTK_PIXEL)
  {
    return;
  }
  vtkNew<vtkIdList> ids;
  mesh->GetCellPoints(cell, ids);
  for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
  {
    corners.emplace_back();
    mesh->GetPoint(ids->GetId(i), corners.back().X);
  }
  if (type == VTK_PIXEL)
  {
    std::swap(corners[2], corners[3]);
  }
  Vector3 middle{ { 0.0, 0.0, 0.0 } };
  Vector3 normal{ { 0.0, 0.0, 0.0 } };
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    middle = middle + corners[i];
    normal = normal + Cross(corners[i], corners[(i + 1) % corners.size()]);
  }
  if (Dot(middle, normal) < 0.0)
  {
    std::reverse(corners.begin(), corners.end());
  }
}
}

void SkdWeightsGrid::Resize(std::size_t cells)
{
  for (Numbers* numbers :
    { &this->Centres[0], &this->Centres[1], &this->Centres[2], &this->Areas, &this->Fractions })
  {
    numbers->resize(cells);
  }
  this->Mask.resize(cells);
  for (Numbers& corners : this->Corners)
  {
    corners.resize(cells * this->CornersPerCell);
  }
}

void SkdWeightsGrid::Add(const SkdOverlapCells& cells, bool isOnSphere, double radius)
{
  const double scale = isOnSphere ? 1.0 / (radius * radius) : 1.0;
  for (std::size_t i = 0; i < cells.Measures.size(); ++i)
  {
    const double whole = cells.Measures[i];
    const Vector3& centre = cells.Centroids[i];
    const Vector3 position = isOnSphere ? SkdLonLatOf(centre) : centre;
    for (int k = 0; k < 3; ++k)
    {
      this->Centres[k].push_back(position[k]);
    }
    this->Areas.push_back(scale * whole);
    this->Fractions.push_back(whole > 0.0 ? cells.Covered[i] / whole : 0.0);
    this->Mask.push_back(whole > 0.0 ? 1 : 0);
  }
}

void SkdWeightsGrid::SetSizes(const std::vector<int>& sizes)
{
  this->Sizes = sizes.empty() ? std::vector<int>{ static_cast<int>(this->Size()) } : sizes;
}

void SkdWeightsGrid::AddCorners(vtkDataSet* mesh)
{
  const SkdCellReader reader(mesh);
  std::vector<Vector3> corners;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    const std::size_t at = this->Corners[0].size() / this->CornersPerCell;
    GetCorners(mesh, cell, reader.TypeOf(cell), corners);
    for (std::size_t i = 0; i < this->CornersPerCell; ++i)
    {
      const Vector3 x = corners.empty()
        ? Vector3{ { this->Centres[0][at], this->Centres[1][at], 0.0 } }
        : SkdLonLatOf(corners[std::min(i, corners.size() - 1)]);
      this->Corners[0].push_back(x[0]);
      this->Corners[1].push_back(x[1]);
    }
  }
}

int SkdCornersPerCell(vtkDataSet* mesh)
{
  return std::max(mesh->GetMaxCellSize(), 1);
}
}
