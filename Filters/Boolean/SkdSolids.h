// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdSolids_h
#define SkdSolids_h

#include "Surfaces/SkdTriangleSet.h"

/// The solids that the triangles of a set bound.
struct SkdSolids
{
  std::vector<std::uint32_t> Of; ///< of each triangle
  std::uint32_t Count = 0;
};

/// Two: the blocks before `firstOfSource`, and the others.
SkdSolids SkdSolidsByInput(const SkdTriangleSet& set, int firstOfSource);

/// A solid for each block that has triangles.
SkdSolids SkdSolidsByBlock(const SkdTriangleSet& set);

/// A solid for each piece that edges connect, in the order of first triangles. O(n).
SkdSolids SkdSolidsByPiece(const SkdTriangleSet& set);

#endif
