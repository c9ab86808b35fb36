// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/SkdVolumeCells.h"

#include "Cells/Curved/SkdCurvedFaces.h"
#include "Cells/Read/SkdCellReader.h"
#include "Pipeline/SkdShownElements.h"
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

/// Given the directions of the axes: each product of one of them with its own of these is 1, and
/// with the others 0.
std::array<Vector3, 3> DualOf(const std::array<Vector3, 3>& directions)
{
  const Vector3 across = skd::Cross(directions[1], directions[2]);
  const double perVolume = 1.0 / skd::Dot(directions[0], across);
  return { perVolume * across, perVolume * skd::Cross(directions[2], directions[0]),
    perVolume * skd::Cross(directions[0], directions[1]) };
}

std::optional<SkdVoxelLattice> LatticeOf(vtkImageData* image)
{
  const double* spacing = image->GetSpacing();
  const Vector3 size{ { spacing[0], spacing[1], spacing[2] } };
  std::array<Vector3, 3> directions;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int i = 0; i < 3; ++i)
    {
      directions[static_cast<std::size_t>(axis)][i] =
        image->GetDirectionMatrix()->GetElement(i, axis);
    }
  }
  const std::array<Vector3, 3> axes = DualOf(directions);
  const bool isVolume = image->GetDataDimension() == 3 && size[0] > 0.0 && size[1] > 0.0 &&
    size[2] > 0.0 && IsFinite(axes[0]) && IsFinite(axes[1]) && IsFinite(axes[2]);
  return isVolume ? std::make_optional(SkdVoxelLattice{ axes, size, size }) : std::nullopt;
}

/// From the first corner of a voxel to its neighbours.
std::array<Vector3, 3> SidesOf(
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
  return { corners[1] - corners[0], corners[2] - corners[0], corners[4] - corners[0] };
}

Vector3 UnitOf(const Vector3& side)
{
  return (1.0 / skd::Norm(side)) * side;
}

/// The lattice that has the axes of another one, and one voxel; none if its sides have not these.
std::optional<SkdVoxelLattice> LatticeOf(
  const std::array<Vector3, 3>& sides, const SkdVoxelLattice& like)
{
  constexpr double rounding = 1e-6;
  SkdVoxelLattice lattice = like;
  for (int axis = 0; axis < 3; ++axis)
  {
    const Vector3& side = sides[static_cast<std::size_t>(axis)];
    const double size = like.GetCoordinate(side, axis);
    const double aside = std::abs(like.GetCoordinate(side, (axis + 1) % 3)) +
      std::abs(like.GetCoordinate(side, (axis + 2) % 3));
    if (!(size > 0.0) || !(aside <= rounding * size))
    {
      return std::nullopt;
    }
    lattice.Least[axis] = lattice.Most[axis] = size;
  }
  return lattice;
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
    if (type != VTK_VOXEL)
    {
      return std::nullopt;
    }
    const std::array<Vector3, 3> sides = SidesOf(grid, reader, cell, list);
    const SkdVoxelLattice like = all
      ? *all
      : SkdVoxelLattice{ DualOf({ UnitOf(sides[0]), UnitOf(sides[1]), UnitOf(sides[2]) }), {}, {} };
    const std::optional<SkdVoxelLattice> lattice = LatticeOf(sides, like);
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
  if (mesh->IsA("vtkPolyData"))
  {
    return false;
  }
  const SkdShown shown(mesh, vtkDataObject::CELL);
  bool hasVolume = false;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells() && !hasVolume; ++cell)
  {
    hasVolume = SkdDimensionOfCellType(mesh->GetCellType(cell)) == 3 && shown.Has(cell);
  }
  return hasVolume;
}

bool SkdHasVolumeCells(const std::vector<SkdBlock>& blocks)
{
  return std::any_of(blocks.begin(), blocks.end(),
    [](const SkdBlock& block) { return SkdHasVolumeCells(block.Mesh); });
}

bool SkdVoxelLattice::HasSameAxes(const SkdVoxelLattice& other) const
{
  constexpr double rounding = 1e-9;
  bool areSame = true;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    areSame = areSame && skd::Norm2(this->Axes[axis] - other.Axes[axis]) <= rounding * rounding;
  }
  return areSame;
}

SkdVoxelLattice SkdVoxelLattice::With(const SkdVoxelLattice& other) const
{
  return { this->Axes, skd::Least(this->Least, other.Least),
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
