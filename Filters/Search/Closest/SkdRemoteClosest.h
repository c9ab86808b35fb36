// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdRemoteClosest_h
#define SkdRemoteClosest_h

#include "Bodies/SkdSource.h"
#include "Exchange/SkdSpreadSource.h"
#include "Pipeline/SkdLoop.h"
#include "Search/Closest/SkdClosestArrays.h"

#include <vector>

/// Finds the nearest of a Source that stays in its pieces: each process searches its own, `own`,
/// and asks others where they may have something nearer. All processes must call it together.
/// Blocks and ids are those of the whole Source. Returns how often a point was sent to another
/// process.
std::uint64_t SkdFindRemoteClosest(const std::vector<SkdBlock>& meshes, const SkdSource& own,
  const SkdSpreadSource& spread, double maximumDistance, std::vector<SkdClosestArrays>& answers,
  SkdLoop& loop);

#endif
