// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Refine/SkdGridOutput.h"

#include "Refine/SkdGridArrays.h"
#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <unordered_map>

namespace
{
/// Corners of leaves by their places in the finest level there is: exact, and the same for all.
class GridPoints
{
public:
  explicit GridPoints(const SkdGrid& grid)
    : Grid(grid)
    , Finest(grid.Forest.NumberOfLevels() - 1)
  {
    this->Ids.reserve(grid.Forest.NumberOfLeaves() * 5 / 4);
  }

  vtkIdType IdOf(const skd::Place& place)
  {
    const auto [entry, isNew] =
      this->Ids.emplace(place, static_cast<vtkIdType>(this->Places.size()));
    if (isNew)
    {
      this->Places.push_back(place);
    }
    return entry->second;
  }

  /// A corner of a cell: bit i of `corner` tells the side along axis i.
  skd::Place CornerOf(int level, const skd::Place& cell, unsigned corner) const
  {
    skd::Place place;
    for (int axis = 0; axis < 3; ++axis)
    {
      const auto& lattice = this->Grid.Lattice;
      const std::int64_t across = lattice.CellsAcross(this->Finest - level, axis);
      place[axis] = (cell[axis] + (corner >> axis & 1u)) * across;
    }
    return place;
  }

  vtkSmartPointer<vtkPoints> MakePoints() const
  {
    auto points = vtkSmartPointer<vtkPoints>::New();
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(static_cast<vtkIdType>(this->Places.size()));
    this->ForEach([&](vtkIdType i, const skd::Place& place)
      { points->SetPoint(i, this->Grid.Lattice.PointOf(this->Finest, place).X); });
    return points;
  }

  vtkSmartPointer<vtkUnsignedCharArray> MakeHanging() const
  {
    auto hanging = vtkSmartPointer<vtkUnsignedCharArray>::New();
    hanging->SetName(SkdGridArrays::HangingName);
    hanging->SetNumberOfTuples(static_cast<vtkIdType>(this->Places.size()));
    this->ForEach(
      [&](vtkIdType i, const skd::Place& place) { hanging->SetValue(i, this->IsHanging(place)); });
    return hanging;
  }

private:
  struct Hash
  {
    std::size_t operator()(const skd::Place& place) const
    {
      std::size_t hash = 0;
      for (const std::int64_t along : place)
      {
        hash = (hash ^ static_cast<std::size_t>(along)) * 0x9e3779b97f4a7c15u;
        hash ^= hash >> 32;
      }
      return hash;
    }
  };

  template <class Body>
  void ForEach(const Body& body) const
  {
    vtkSMPTools::For(0, static_cast<vtkIdType>(this->Places.size()),
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          body(i, this->Places[static_cast<std::size_t>(i)]);
        }
      });
  }

  /// Whether a leaf around the point does not have it as a corner.
  bool IsHanging(const skd::Place& point) const
  {
    for (unsigned around = 0; around < 8; ++around)
    {
      const skd::Place place{ point[0] - (around & 1u), point[1] - (around >> 1 & 1u),
        point[2] - (around >> 2 & 1u) };
      const skd::Forest::Node leaf = this->Grid.Forest.Find(this->Finest, place);
      for (int axis = 0; leaf.Level >= 0 && axis < 3; ++axis)
      {
        const std::int64_t across = this->Grid.Lattice.CellsAcross(this->Finest - leaf.Level, axis);
        if (point[axis] % across != 0)
        {
          return true;
        }
      }
    }
    return false;
  }

  const SkdGrid& Grid;
  const int Finest;
  std::unordered_map<skd::Place, vtkIdType, Hash> Ids;
  std::vector<skd::Place> Places;
};

std::vector<SkdGridCell> LeavesOf(const SkdGrid& grid)
{
  std::vector<SkdGridCell> leaves;
  leaves.reserve(grid.Forest.NumberOfLeaves());
  for (int level = 0; level < grid.Forest.NumberOfLevels(); ++level)
  {
    for (std::uint32_t cell = 0; cell < grid.Forest.NumberOfCells(level); ++cell)
    {
      if (grid.Forest.IsLeaf(level, cell))
      {
        leaves.push_back({ level, cell });
      }
    }
  }
  return leaves;
}

/// The corners of a leaf in VTK's order of voxels, pixels and lines: along axes that are not flat.
std::vector<unsigned> CornersOf(const skd::Lattice& lattice)
{
  std::vector<unsigned> corners;
  for (unsigned corner = 0; corner < 8; ++corner)
  {
    const bool isThere = !((corner & 1u && lattice.IsFlat(0)) ||
      (corner & 2u && lattice.IsFlat(1)) || (corner & 4u && lattice.IsFlat(2)));
    if (isThere)
    {
      corners.push_back(corner);
    }
  }
  return corners;
}
}

std::vector<SkdGridCell> SkdMakeUnstructuredGrid(const SkdGrid& grid, vtkUnstructuredGrid* output)
{
  constexpr int types[4] = { VTK_VERTEX, VTK_LINE, VTK_PIXEL, VTK_VOXEL };
  const std::vector<SkdGridCell> leaves = LeavesOf(grid);
  const std::vector<unsigned> corners = CornersOf(grid.Lattice);
  GridPoints points(grid);
  vtkNew<vtkIdTypeArray> connectivity;
  connectivity->SetNumberOfTuples(static_cast<vtkIdType>(leaves.size() * corners.size()));
  vtkIdType* id = connectivity->GetPointer(0);
  for (const SkdGridCell& leaf : leaves)
  {
    const skd::Place place = grid.Forest.PlaceOf(leaf.Level, leaf.Index);
    for (const unsigned corner : corners)
    {
      *id++ = points.IdOf(points.CornerOf(leaf.Level, place, corner));
    }
  }
  vtkNew<vtkCellArray> cells;
  cells->SetData(static_cast<vtkIdType>(corners.size()), connectivity);
  output->Initialize();
  output->SetPoints(points.MakePoints());
  output->SetCells(types[grid.Lattice.Dimension()], cells);
  output->GetPointData()->AddArray(points.MakeHanging());
  return leaves;
}
