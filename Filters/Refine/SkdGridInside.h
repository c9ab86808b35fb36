// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdGridInside_h
#define SkdGridInside_h

#include "Refine/SkdGrid.h"

class SkdEnclosure;
class vtkAlgorithm;

/// Which cells have their centres inside of a boundary, a value a cell, level by level; that of a
/// refined cell is 1 if more than half of its children's are.
///
/// Leaves that no part meets and that share a face are on the same side of a closed boundary: one
/// of those that hang together is asked for all. Of an open boundary each leaf is asked.
std::vector<std::vector<unsigned char>> SkdFindInside(const SkdGrid& grid,
  const SkdEnclosure& enclosure, vtkAlgorithm* algorithm, double first, double last);

#endif
