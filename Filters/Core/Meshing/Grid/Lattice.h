// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Grid_Lattice_h
#define skd_Grid_Lattice_h

#include "../../Geometry/Box.h"

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace skd
{

/// Where a cell is among those of its level: cells before it along each axis.
using LatticePoint = std::array<std::int64_t, 3>;

/// The cells of a rectilinear base grid, and of all its refinements: a cell of level l is cut into
/// Branch[axis] equal ones of level l + 1 along each axis. An axis along which the grid is flat has
/// one cell of no length, and a branch of 1.
///
/// Neighbours agree to the last bit on where their common face is, be they of different levels.
class Lattice
{
public:
  Lattice() = default;

  /// Planes[axis]: the coordinates of the base cells' faces, ascending; one of a flat axis.
  Lattice(std::array<std::vector<double>, 3> planes, int branch)
    : Planes(std::move(planes))
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Branch[axis] = this->IsFlat(axis) ? 1 : branch;
    }
  }

  bool IsFlat(int axis) const { return this->Planes[axis].size() < 2; }
  int Dimension() const { return 3 - this->IsFlat(0) - this->IsFlat(1) - this->IsFlat(2); }
  const std::vector<double>& GetPlanes(int axis) const { return this->Planes[axis]; }
  const std::array<int, 3>& GetBranch() const { return this->Branch; }

  /// The base cells along an axis, at least 1.
  std::int64_t NumberOfBaseCells(int axis) const
  {
    return this->IsFlat(axis) ? 1 : static_cast<std::int64_t>(this->Planes[axis].size()) - 1;
  }

  std::int64_t NumberOfBaseCells() const
  {
    return this->NumberOfBaseCells(0) * this->NumberOfBaseCells(1) * this->NumberOfBaseCells(2);
  }

  Box3 BoxOf(int level, const LatticePoint& position) const
  {
    Box3 box;
    for (int axis = 0; axis < 3; ++axis)
    {
      const std::int64_t cells = this->CellsAcross(level, axis);
      box.Min[axis] = this->At(axis, position[axis], cells);
      box.Max[axis] =
        this->IsFlat(axis) ? box.Min[axis] : this->At(axis, position[axis] + 1, cells);
    }
    return box;
  }

  /// A corner of cells of a level, by the number of cells before it along each axis.
  Vector3 PointOf(int level, const LatticePoint& position) const
  {
    Vector3 point;
    for (int axis = 0; axis < 3; ++axis)
    {
      const std::int64_t cells = this->CellsAcross(level, axis);
      point[axis] = this->At(axis, this->IsFlat(axis) ? 0 : position[axis], cells);
    }
    return point;
  }

  /// The cells of a level along one base cell.
  std::int64_t CellsAcross(int level, int axis) const
  {
    std::int64_t cells = 1;
    for (int i = 0; i < level; ++i)
    {
      cells *= this->Branch[axis];
    }
    return cells;
  }

private:
  /// The quotient is rounded once, so that equal fractions are equal, whatever their level.
  double At(int axis, std::int64_t position, std::int64_t cells) const
  {
    const auto base = static_cast<std::size_t>(position / cells);
    const std::int64_t rest = position % cells;
    const double low = this->Planes[axis][base];
    if (rest == 0)
    {
      return low;
    }
    const double part = static_cast<double>(rest) / static_cast<double>(cells);
    return low + part * (this->Planes[axis][base + 1] - low);
  }

  std::array<std::vector<double>, 3> Planes{ { { 0.0 }, { 0.0 }, { 0.0 } } };
  std::array<int, 3> Branch{ { 1, 1, 1 } };
};

}

#endif
