// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdWeightsGrid_h
#define SkdWeightsGrid_h

#include "Remap/SkdOverlapTypes.h"

#include <cstddef>
#include <vector>

class vtkDataSet;

namespace skdtree
{
/// One of the two grids of a file of weights: what is told of each of its cells.
struct SkdWeightsGrid
{
  using Numbers = std::vector<double>;

  Numbers Centres[3];
  Numbers Corners[2]; ///< so many a cell
  std::size_t CornersPerCell = 0;
  Numbers Areas;
  Numbers Fractions;
  std::vector<int> Mask;
  std::vector<int> Sizes; ///< along each dimension, the first varies fastest

  std::size_t Size() const { return this->Areas.size(); }

  void Resize(std::size_t cells);

  /// A cell as numbers, and again: calls transfer(number) for each of them.
  template <class Transfer>
  void TransferCell(std::size_t cell, const Transfer& transfer)
  {
    for (Numbers& centres : this->Centres)
    {
      transfer(centres[cell]);
    }
    transfer(this->Areas[cell]);
    transfer(this->Fractions[cell]);
    transfer(this->Mask[cell]);
    for (Numbers& corners : this->Corners)
    {
      for (std::size_t i = 0; i < this->CornersPerCell; ++i)
      {
        transfer(corners[cell * this->CornersPerCell + i]);
      }
    }
  }

  /// Adds the cells of a mesh. On a sphere centres are longitudes and latitudes in degrees, and
  /// areas those of the unit sphere.
  void Add(const SkdOverlapCells& cells, bool isOnSphere, double radius);

  /// Of a mesh without dimensions all its cells are along one.
  void SetSizes(const std::vector<int>& sizes);

  /// The corners of the cells of a mesh that was added, mesh after mesh. Of cells with fewer
  /// corners than others the last repeats, of those with none the centre.
  void AddCorners(vtkDataSet* mesh);
};

/// How many corners a cell of a mesh has, at most.
int SkdCornersPerCell(vtkDataSet* mesh);
}

#endif
