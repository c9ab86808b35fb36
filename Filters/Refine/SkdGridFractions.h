// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdGridFractions_h
#define SkdGridFractions_h

#include "Refine/SkdGrid.h"

class SkdEnclosure;
class vtkAlgorithm;

/// How much of each cell is inside of a boundary, from 0 to 1, level by level: of leaves that a
/// part meets by exact clipping, or if the boundary is open by 4 samples along each axis; of others
/// by `inside`; of refined cells the mean of their children.
std::vector<std::vector<double>> SkdFindFractions(const SkdGrid& grid,
  const SkdEnclosure& enclosure, const std::vector<std::vector<unsigned char>>& inside,
  double epsilon, vtkAlgorithm* algorithm, double first, double last);

#endif
