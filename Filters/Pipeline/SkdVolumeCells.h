// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdVolumeCells_h
#define SkdVolumeCells_h

#include "Core/Geometry/Vector.h"
#include "Pipeline/SkdBlocks.h"

#include <optional>
#include <vector>

class vtkDataSet;

namespace skdtree
{
///@{
/// Whether there are volume cells, whose outer faces bound a body. O(cells).
bool SkdHasVolumeCells(vtkDataSet* mesh);
bool SkdHasVolumeCells(const std::vector<SkdBlock>& blocks);
///@}

/// A corner of voxels along the axes, and the least and largest of their sizes.
struct SkdVoxelLattice
{
  skd::Vector3 Origin;
  skd::Vector3 Least;
  skd::Vector3 Most;

  /// That of others, too.
  SkdVoxelLattice With(const SkdVoxelLattice& other) const;

  /// Whether sizes differ by more than rounding: then several voxels may cover a face of another.
  bool HasSeveralSizes() const;
};

/// Of an image, or of a grid whose volume cells are voxels, both along the axes. O(cells).
std::optional<SkdVoxelLattice> SkdVoxelLatticeOf(vtkDataSet* mesh);
}

#endif
