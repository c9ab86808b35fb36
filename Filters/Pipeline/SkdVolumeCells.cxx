// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/SkdVolumeCells.h"

#include "Cells/Curved/SkdCurvedFaces.h"
#include "Cells/Read/SkdCellReader.h"
#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace skdtree
{
namespace
{
using skd::Vector3;

std::optional<SkdVoxelLattice> LatticeOf(vtkImageData* image)
{
  const double* spacing = image->GetSpacing();
  const Vector3 size{ { spacing[0], spacing[1], spacing[2] } };
  SkdVoxelLattice lattice{ {}, size, size };
  image->GetPoint(0, lattice.Origin.X);
  const bool isAlongAxes = image->GetDirectionMatrix()->IsIdentity();
  return image->GetDataDimension() == 3 && isAlongAxes && size[0] > 0.0 && size[1] > 0.0 &&
      size[2] > 0.0
    ? std::make_optional(lattice)
    : std::nullopt;
}

/// Of one voxel, if its sides are along the axes but for rounding.
std::optional<SkdVoxelLattice> LatticeOf(const std::array<Vector3, 8>& corners)
{
  constexpr double rounding = 1e-6;
  Vector3 size;
  for (int axis = 0; axis < 3; ++axis)
  {
    const Vector3 side = corners[std::size_t(1) << axis] - corners[0];
    const double aside = std::abs(side[(axis + 1) % 3]) + std::abs(side[(axis + 2) % 3]);
    size[axis] = side[axis];
    if (!(size[axis] > 0.0) || !(aside <= rounding * size[axis]))
    {
      return std::nullopt;
    }
  }
  return SkdVoxelLattice{ corners[0], size, size };
}

std::array<Vector3, 8> CornersOf(
  vtkUnstructuredGrid* grid, const SkdCellReader& reader, vtkIdType voxel, vtkIdList* list)
{
  std::array<Vector3, 8> corners{};
  reader.VisitPoints(voxel, list,
    [&](const auto* ids, std::size_t size)
    {
      for (std::size_t i = 0; i < std::min(size, corners.size()); ++i)
      {
        grid->GetPoint(static_cast<vtkIdType>(ids[i]), corners[i].X);
      }
    });
  return corners;
}

/// Images that cannot be one become voxels where the pieces of processes are joined.
std::optional<SkdVoxelLattice> LatticeOf(vtkUnstructuredGrid* grid)
{
  std::optional<SkdVoxelLattice> all;
  const SkdCellReader reader(grid);
  vtkNew<vtkIdList> list;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    const int type = reader.TypeOf(cell);
    if (SkdDimensionOfCellType(type) != 3)
    {
      continue;
    }
    const std::optional<SkdVoxelLattice> lattice =
      type == VTK_VOXEL ? LatticeOf(CornersOf(grid, reader, cell, list)) : std::nullopt;
    if (!lattice)
    {
      return std::nullopt;
    }
    all = all ? all->With(*lattice) : lattice;
  }
  return all;
}
}

bool SkdHasVolumeCells(vtkDataSet* mesh)
{
  bool hasVolume = false;
  const vtkIdType cells = mesh->IsA("vtkPolyData") ? 0 : mesh->GetNumberOfCells();
  for (vtkIdType cell = 0; cell < cells && !hasVolume; ++cell)
  {
    hasVolume = SkdDimensionOfCellType(mesh->GetCellType(cell)) == 3;
  }
  return hasVolume;
}

bool SkdHasVolumeCells(const std::vector<SkdBlock>& blocks)
{
  return std::any_of(blocks.begin(), blocks.end(),
    [](const SkdBlock& block) { return SkdHasVolumeCells(block.Mesh); });
}

SkdVoxelLattice SkdVoxelLattice::With(const SkdVoxelLattice& other) const
{
  return { this->Origin, skd::Least(this->Least, other.Least),
    skd::Greatest(this->Most, other.Most) };
}

bool SkdVoxelLattice::HasSeveralSizes() const
{
  constexpr double more = 1.5;
  return this->Most[0] > more * this->Least[0] || this->Most[1] > more * this->Least[1] ||
    this->Most[2] > more * this->Least[2];
}

std::optional<SkdVoxelLattice> SkdVoxelLatticeOf(vtkDataSet* mesh)
{
  auto* image = vtkImageData::SafeDownCast(mesh);
  auto* grid = vtkUnstructuredGrid::SafeDownCast(mesh);
  return image ? LatticeOf(image) : grid ? LatticeOf(grid) : std::nullopt;
}
}
