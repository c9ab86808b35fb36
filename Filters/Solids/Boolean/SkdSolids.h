// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdSolids_h
#define SkdSolids_h

#include "Core/Geometry/RigidMotion.h"
#include "Solids/Surfaces/SkdTriangleSet.h"

#include <optional>

namespace skdtree
{
/// The data sets of the surfaces.
struct SkdBooleanBlocks
{
  std::vector<SkdBlock> All;
  int FirstOfSource; ///< those before it are of the Input
  bool IsComposite;
  std::optional<skd::RigidMotion> Motion = std::nullopt; ///< of the Source
  bool AlignsFaces = false;                              ///< see SkdAlignFaces
};

/// `source` may be nullptr.
SkdBooleanBlocks SkdMakeBooleanBlocks(vtkDataObject* input, vtkDataObject* source);

/// The solids that the triangles of a set bound.
struct SkdSolids
{
  std::vector<std::uint32_t> Of; ///< of each triangle
  std::uint32_t Count = 0;
};

/// The first triangle of a block, or of those after it; the number of triangles if there is none.
/// O(log n).
std::uint32_t SkdFirstTriangleOf(const SkdTriangleSet& set, int block);

/// Two: the blocks before `firstOfSource`, and the others.
SkdSolids SkdSolidsByInput(const SkdTriangleSet& set, int firstOfSource);

/// A solid for each block; empty without triangles.
SkdSolids SkdSolidsByBlock(const SkdTriangleSet& set, std::size_t numberOfBlocks);

/// A solid for each piece that edges connect, in the order of first triangles. O(n).
SkdSolids SkdSolidsByPiece(const SkdTriangleSet& set);
}

#endif
