// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdRemoteClosest_h
#define SkdRemoteClosest_h

#include "Bodies/SkdSource.h"
#include "Exchange/Bodies/SkdSpreadBody.h"
#include "Exchange/SkdFoundCells.h"
#include "Pipeline/SkdLoop.h"
#include "Search/Closest/SkdClosestArrays.h"

#include <optional>
#include <vector>

namespace skdtree
{
/// The nearest of a Source that stays in its pieces.
struct SkdRemoteClosest
{
  std::vector<SkdClosestArrays> Answers; // by mesh; blocks and ids are those of the whole Source
  std::vector<SkdFoundPieceCell> Cells;  // that have the nearest points
  std::uint64_t PointsSent = 0;          // how often a point was sent to another process
};

/// Each process searches its own piece, `own`, and asks others where they may have something
/// nearer. All processes must call it together.
SkdRemoteClosest SkdFindRemoteClosest(const std::vector<SkdBlock>& meshes, const SkdSource& own,
  const SkdSpreadSource& spread, double maximumDistance, SkdLoop& loop);

/// The same on the boundary of the source, with signs. Nothing unless it was decided of each point
/// whether it is inside.
std::optional<SkdRemoteClosest> SkdFindRemoteSigned(const std::vector<SkdBlock>& meshes,
  SkdSpreadBody& body, const SkdSpreadSource& spread, double maximumDistance, SkdLoop& loop);
}

#endif
