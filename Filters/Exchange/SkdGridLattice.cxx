// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Exchange/SkdGridLattice.h"

#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredGrid.h"

namespace skdtree
{
std::array<int, 6> SkdExtentOf(vtkDataSet* grid)
{
  std::array<int, 6> extent;
  const int* own = nullptr;
  if (auto* image = vtkImageData::SafeDownCast(grid))
  {
    own = image->GetExtent();
  }
  else if (auto* rectilinear = vtkRectilinearGrid::SafeDownCast(grid))
  {
    own = rectilinear->GetExtent();
  }
  else
  {
    own = vtkStructuredGrid::SafeDownCast(grid)->GetExtent();
  }
  std::copy_n(own, 6, extent.begin());
  return extent;
}

void SkdUniteExtents(std::array<int, 6>& all, const std::array<int, 6>& other)
{
  for (std::size_t axis = 0; axis < 6; axis += 2)
  {
    all[axis] = std::min(all[axis], other[axis]);
    all[axis + 1] = std::max(all[axis + 1], other[axis + 1]);
  }
}

std::array<double, 15> SkdLatticeOfImage(vtkDataSet* grid)
{
  std::array<double, 15> lattice{};
  if (auto* image = vtkImageData::SafeDownCast(grid))
  {
    std::copy_n(image->GetOrigin(), 3, lattice.begin());
    std::copy_n(image->GetSpacing(), 3, lattice.begin() + 3);
    std::copy_n(image->GetDirectionMatrix()->GetData(), 9, lattice.begin() + 6);
  }
  return lattice;
}
}
