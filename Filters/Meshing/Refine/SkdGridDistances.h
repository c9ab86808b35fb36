// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdGridDistances_h
#define SkdGridDistances_h

#include "Bodies/SkdParts.h"
#include "Meshing/Refine/SkdGrid.h"

class vtkAlgorithm;

namespace skdtree
{
/// The distances of the centres of all cells from the nearest part, level by level; infinity
/// without parts, NaN after an abort.
std::vector<std::vector<double>> SkdFindDistances(
  const SkdGrid& grid, const SkdParts& parts, vtkAlgorithm* algorithm, double first, double last);

/// Makes the distances of cells that are inside negative.
void SkdSignDistances(std::vector<std::vector<double>>& distances,
  const std::vector<std::vector<unsigned char>>& inside);
}

#endif
