// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdNearest_h
#define SkdNearest_h

#include "vtkType.h"

/// The point of a Source nearest to a query point.
struct SkdNearest
{
  double Point[3];
  double Distance2; // squared
  int Block;        // index in the list of the Source's blocks
  vtkIdType CellId; // in that block
};

/// Statistics of a search structure, for reports.
struct SkdTreeCounts
{
  vtkIdType Cells = 0;        // in the trees
  vtkIdType CellsLeftOut = 0; // ghost, blanked, empty, not finite or of unknown type
  double Tolerance = 0.0;     // the largest absolute epsilon of a tree
};

#endif
