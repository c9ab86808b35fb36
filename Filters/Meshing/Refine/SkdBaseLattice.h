// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdBaseLattice_h
#define SkdBaseLattice_h

#include "Core/Meshing/Grid/Lattice.h"

#include <optional>
#include <string>

class vtkDataObject;

namespace skdtree
{
/// Settings of a base grid that is not given as a data set.
struct SkdBaseSettings
{
  skd::Box3 Bounds;                ///< empty: those of the parts, with a margin
  double Margin = 0.1;             ///< on each side, relative to the longest of the bounds
  std::array<int, 3> Dimensions{}; ///< cells along each axis; 0: as many as are about cubes
  double CellSize = 0.0;           ///< of cubes, or 0; then the bounds grow to whole cells
};

/// The base cells, or the reason why they cannot be made.
struct SkdBaseLattice
{
  std::optional<skd::Lattice> Lattice;
  std::string Complaint;
};

/// Along axes without length the grid is flat. `parts` are the bounds of all parts.
SkdBaseLattice SkdMakeBaseLattice(
  const SkdBaseSettings& settings, const skd::Box3& parts, int branch);

/// The cells of a vtkImageData without a direction matrix, or of a vtkRectilinearGrid.
SkdBaseLattice SkdTakeBaseLattice(vtkDataObject* grid, int branch);
}

#endif
