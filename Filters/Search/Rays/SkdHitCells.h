// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdHitCells_h
#define SkdHitCells_h

#include "Exchange/SkdFoundCells.h"
#include "Search/Rays/SkdRayOutputs.h"

#include <cstdint>
#include <vector>

namespace skdtree
{
/// Which cells of a Source that stays in its pieces rays may hit.
struct SkdHitCells
{
  std::vector<SkdFoundPieceCell> Cells;
  std::uint64_t RaysSent = 0; // how often a ray was sent to another process
  bool IsWhole = false;       // false after an abort on any process: rays would hit others
};

/// Of the first hits: the first of each ray in the own piece, and in those of processes that have
/// boxes before it. With `all`, all cells that rays hit. `trees` are those of the own piece. Rays
/// that are cast at these cells alone, with those that meet the bounds of the Source, hit what
/// they hit in the whole. All processes must call it together.
SkdHitCells SkdFindHitCells(vtkAlgorithm* algorithm, const std::vector<SkdCastRays>& rays,
  const SkdSourceTrees& trees, const SkdSpreadSource& spread, const SkdRayLimits& limits, bool all,
  SkdLoop& loop);

/// The same of the first hits of rays that are given by their starts and directions.
SkdHitCells SkdFindHitCells(const SkdRayCaster::Vectors& starts,
  const SkdRayCaster::Vectors& directions, const SkdSourceTrees& trees,
  const SkdSpreadSource& spread, const SkdRayLimits& limits, SkdLoop& loop);
}

#endif
