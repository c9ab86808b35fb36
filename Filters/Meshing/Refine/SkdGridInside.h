// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdGridInside_h
#define SkdGridInside_h

#include "Meshing/Refine/SkdGrid.h"

class vtkAlgorithm;

namespace skdtree
{
class SkdEnclosure;

/// Whether the centres of cells are inside a boundary, level by level; 1 for a refined cell if more
/// than half of its children are inside.
///
/// Adjacent leaves that no part intersects are on the same side of a closed boundary: one test for
/// each connected component. For an open boundary each leaf is tested.
std::vector<std::vector<unsigned char>> SkdFindInside(const SkdGrid& grid,
  const SkdEnclosure& enclosure, vtkAlgorithm* algorithm, double first, double last);
}

#endif
