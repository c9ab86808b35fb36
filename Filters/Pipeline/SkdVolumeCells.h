// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdVolumeCells_h
#define SkdVolumeCells_h

#include "Core/Geometry/Vector.h"
#include "Pipeline/SkdBlocks.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

class vtkDataSet;

namespace skdtree
{
///@{
/// Whether volume cells are shown, whose outer faces bound a body. O(cells).
bool SkdHasVolumeCells(vtkDataSet* mesh);
bool SkdHasVolumeCells(const std::vector<SkdBlock>& blocks);
///@}

/// How voxels of one orientation lie, and the least and largest of their sizes.
struct SkdVoxelLattice
{
  /// Products with these are the coordinates along the axes of the voxels.
  std::array<skd::Vector3, 3> Axes;
  skd::Vector3 Least;
  skd::Vector3 Most;

  double GetCoordinate(const skd::Vector3& x, int axis) const
  {
    return skd::Dot(this->Axes[static_cast<std::size_t>(axis)], x);
  }

  /// But for rounding.
  bool HasSameAxes(const SkdVoxelLattice& other) const;

  /// With the sizes of others, too, that have the same axes.
  SkdVoxelLattice With(const SkdVoxelLattice& other) const;

  /// Whether sizes differ by more than rounding: then several voxels may cover a face of another.
  bool HasSeveralSizes() const;
};

/// Of an image, or of a grid whose volume cells are voxels of one orientation. O(cells).
std::optional<SkdVoxelLattice> SkdVoxelLatticeOf(vtkDataSet* mesh);
}

#endif
