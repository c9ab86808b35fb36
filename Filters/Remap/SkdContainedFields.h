// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdContainedFields_h
#define SkdContainedFields_h

#include "Remap/SkdContainedMean.h"
#include "Remap/SkdDonorFields.h"

namespace skdtree
{
/// What of a donor's fields of one kind, of points or of cells, becomes of a target's cells.
struct SkdContainedResult
{
  std::vector<std::vector<double>> Values; ///< of each field, tuple by tuple; NaN where none
  std::vector<vtkIdType> Counts;           ///< donor points that each cell holds
};

/// The statistic of each component of each field over the points that a cell holds, and that count.
/// Cells that hold none of these take what `empty` says; a sum is not taken from elsewhere: there
/// is nothing in them, 0. In parallel; the same to the last bit whatever the number of threads.
SkdContainedResult SkdMapContained(const SkdContainedMean& samples,
  const std::vector<SkdDonorField>& fields, const SkdTargetCells& cells, SkdStatistic statistic,
  SkdEmptyCells empty, SkdLoop& loop);
}

#endif
