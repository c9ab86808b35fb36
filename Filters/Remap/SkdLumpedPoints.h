// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdLumpedPoints_h
#define SkdLumpedPoints_h

#include <vector>

class vtkDataSet;

namespace skdtree
{
/// Values of cells, tuple by tuple, taken to the points by lumped masses: each cell gives an equal
/// share of its measure to each of its corners, and a point has the mean of its cells by these
/// shares. So the sum of mass times value is the integral over the cells, and values keep to the
/// bounds of those around. Cells whose value is NaN, or without a measure, give nothing; points
/// without such cells have NaN. The order of the cells decides the order of the sums.
std::vector<double> SkdLumpToPoints(vtkDataSet* mesh, const std::vector<double>& values,
  int components, const std::vector<double>& measures);
}

#endif
