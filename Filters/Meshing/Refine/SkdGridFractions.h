// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdGridFractions_h
#define SkdGridFractions_h

#include "Meshing/Refine/SkdGrid.h"

class vtkAlgorithm;

namespace skdtree
{
class SkdEnclosure;

/// The fraction of each cell inside a boundary, from 0 to 1, level by level: for leaves that a part
/// intersects by exact clipping, or by 4 samples along each axis if the boundary is open; for other
/// leaves from `inside`; for refined cells the mean of their children.
std::vector<std::vector<double>> SkdFindFractions(const SkdGrid& grid,
  const SkdEnclosure& enclosure, const std::vector<std::vector<unsigned char>>& inside,
  double epsilon, vtkAlgorithm* algorithm, double first, double last);
}

#endif
