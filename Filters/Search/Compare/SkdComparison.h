// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdComparison.h
 * @brief One of two sets as it is measured against the other: arrays of its points, and its row of
 * the table.
 */

#ifndef SkdComparison_h
#define SkdComparison_h

#include "Pipeline/SkdBlocks.h"
#include "Pipeline/SkdLoop.h"
#include "Search/Compare/SkdComparedSet.h"
#include "Search/Compare/SkdDistanceSamples.h"
#include "Search/Compare/SkdHausdorff.h"

#include <array>
#include <vector>

class vtkTable;

namespace skdtree
{
/// An input: its set and its blocks.
struct SkdComparedInput
{
  SkdComparedSet Set;
  std::vector<SkdBlock> Blocks;
  bool IsComposite = false;
};

/// What is found in one direction.
struct SkdComparison
{
  const SkdComparedInput* From;
  const SkdComparedInput* To;
  SkdHausdorff Hausdorff;
  SkdDistanceSamples Samples;
};

/// Adds the arrays of distances to the blocks of an output. Where processes tell sides together,
/// all must call it together. Returns whether sides are known of all points.
bool SkdAddDistances(
  const std::vector<SkdBlock>& outputs, const SkdComparedInput& to, SkdLoop& loop);

/// Fills the table on the first process: the two directions, and both together. All processes must
/// call it together.
void SkdFillComparison(
  const std::array<SkdComparison, 2>& comparisons, const SkdReduction& all, vtkTable* table);
}

#endif
