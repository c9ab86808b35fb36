// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdJoinedGrids_h
#define SkdJoinedGrids_h

#include "Exchange/SkdJoinedMesh.h"

namespace skdtree
{
/// Joins pieces that are parts of one image, rectilinear or structured grid by their extents.
/// Returns false, and does nothing, unless all are of one such type, have points and the same
/// origin, spacing and directions where they have such, and fill the box that encloses them.
/// Points and cells that several pieces have are taken from one where they are not marked as
/// duplicates, of these from the first. O(n).
bool SkdJoinGrids(const std::vector<vtkSmartPointer<vtkDataSet>>& pieces, SkdJoinedPieces& joined);
}

#endif
