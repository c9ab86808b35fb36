// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdGridLattice_h
#define SkdGridLattice_h

#include "vtkDataSet.h"
#include "vtkType.h"

#include <algorithm>
#include <array>

namespace skdtree
{
/// Of an image, rectilinear or structured grid.
std::array<int, 6> SkdExtentOf(vtkDataSet* grid);

/// The smallest extent of both.
void SkdUniteExtents(std::array<int, 6>& all, const std::array<int, 6>& other);

/// An image's origin, spacing and directions; zeros of other grids.
std::array<double, 15> SkdLatticeOfImage(vtkDataSet* grid);

/// The lattice of a grid's points, or of its cells (vtkDataObject's type).
class SkdGridLattice
{
public:
  SkdGridLattice(const std::array<int, 6>& extent, int type)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const int span = extent[2 * axis + 1] - extent[2 * axis];
      const int steps = type == vtkDataObject::POINT ? span + 1 : std::max(span, 1);
      this->First[axis] = extent[2 * axis];
      this->Number[axis] = steps;
    }
  }

  vtkIdType GetSize() const
  {
    return static_cast<vtkIdType>(this->Number[0]) * this->Number[1] * this->Number[2];
  }

  vtkIdType IdOf(const int (&ijk)[3]) const
  {
    vtkIdType id = 0;
    for (int axis = 2; axis >= 0; --axis)
    {
      id = id * this->Number[axis] + (ijk[axis] - this->First[axis]);
    }
    return id;
  }

  bool Contains(const int (&ijk)[3]) const
  {
    bool isIn = true;
    for (int axis = 0; axis < 3; ++axis)
    {
      const int step = ijk[axis] - this->First[axis];
      isIn = isIn && 0 <= step && step < this->Number[axis];
    }
    return isIn;
  }

  /// Calls visit(ijk) in the order of ids.
  template <class Visit>
  void VisitAll(const Visit& visit) const
  {
    int ijk[3];
    for (ijk[2] = this->First[2]; ijk[2] < this->First[2] + this->Number[2]; ++ijk[2])
    {
      for (ijk[1] = this->First[1]; ijk[1] < this->First[1] + this->Number[1]; ++ijk[1])
      {
        for (ijk[0] = this->First[0]; ijk[0] < this->First[0] + this->Number[0]; ++ijk[0])
        {
          visit(ijk);
        }
      }
    }
  }

private:
  int First[3];
  int Number[3];
};
}

#endif
