// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdGridPoints_h
#define SkdGridPoints_h

#include "Cells/Read/SkdForEach.h"
#include "Meshing/Refine/SkdGrid.h"
#include "Meshing/Refine/SkdGridArrays.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"

#include <unordered_map>

namespace skdtree
{
/// Corners of leaves by their integer coordinates on the finest level: exact, and the same for all
/// leaves.
class SkdGridPoints
{
public:
  explicit SkdGridPoints(const SkdGrid& grid)
    : Grid(grid)
    , Finest(grid.Forest.NumberOfLevels() - 1)
  {
    this->Ids.reserve(grid.Forest.NumberOfLeaves() * 5 / 4);
  }

  vtkIdType IdOf(const skd::LatticePoint& position)
  {
    const auto [entry, isNew] =
      this->Ids.emplace(position, static_cast<vtkIdType>(this->Positions.size()));
    if (isNew)
    {
      this->Positions.push_back(position);
    }
    return entry->second;
  }

  /// -1 if no requested leaf has a corner there.
  vtkIdType FindId(const skd::LatticePoint& position) const
  {
    const auto entry = this->Ids.find(position);
    return entry == this->Ids.end() ? -1 : entry->second;
  }

  /// The corners of a leaf in VTK's order of voxels, pixels and lines: along axes that are not
  /// flat.
  std::vector<unsigned> Corners() const
  {
    const skd::Lattice& lattice = this->Grid.Lattice;
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

  /// A corner of a cell: bit i of `corner` is the side along axis i.
  skd::LatticePoint CornerOf(int level, const skd::LatticePoint& cell, unsigned corner) const
  {
    skd::LatticePoint position;
    for (int axis = 0; axis < 3; ++axis)
    {
      const auto& lattice = this->Grid.Lattice;
      const std::int64_t across = lattice.CellsAcross(this->Finest - level, axis);
      position[axis] = (cell[axis] + (corner >> axis & 1u)) * across;
    }
    return position;
  }

  vtkSmartPointer<vtkPoints> MakePoints() const
  {
    auto points = vtkSmartPointer<vtkPoints>::New();
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(static_cast<vtkIdType>(this->Positions.size()));
    this->ForEach([&](vtkIdType i, const skd::LatticePoint& position)
      { points->SetPoint(i, this->Grid.Lattice.PointOf(this->Finest, position).X); });
    return points;
  }

  vtkSmartPointer<vtkUnsignedCharArray> MakeHanging() const
  {
    auto hanging = vtkSmartPointer<vtkUnsignedCharArray>::New();
    hanging->SetName(SkdGridArrays::HangingName);
    hanging->SetNumberOfTuples(static_cast<vtkIdType>(this->Positions.size()));
    this->ForEach([&](vtkIdType i, const skd::LatticePoint& position)
      { hanging->SetValue(i, this->IsHanging(position)); });
    return hanging;
  }

private:
  struct Hash
  {
    std::size_t operator()(const skd::LatticePoint& position) const
    {
      std::size_t hash = 0;
      for (const std::int64_t along : position)
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
    SkdForEach(static_cast<vtkIdType>(this->Positions.size()),
      [&](vtkIdType i) { body(i, this->Positions[static_cast<std::size_t>(i)]); });
  }

  /// Whether the point is hanging: some leaf around it does not have it as a corner.
  bool IsHanging(const skd::LatticePoint& point) const
  {
    for (unsigned around = 0; around < 8; ++around)
    {
      const skd::LatticePoint position{ point[0] - (around & 1u), point[1] - (around >> 1 & 1u),
        point[2] - (around >> 2 & 1u) };
      const skd::Forest::Node leaf = this->Grid.Forest.Find(this->Finest, position);
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
  std::unordered_map<skd::LatticePoint, vtkIdType, Hash> Ids;
  std::vector<skd::LatticePoint> Positions;
};
}

#endif
