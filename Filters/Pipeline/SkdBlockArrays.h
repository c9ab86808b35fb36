// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdBlockArrays_h
#define SkdBlockArrays_h

#include "Pipeline/SkdArrayGather.h"
#include "Pipeline/SkdBlocks.h"

#include <functional>
#include <set>
#include <string>

class vtkAlgorithm;

/// The arrays (of points or cells, vtkDataObject's type) that all blocks have, made for `n` tuples
/// of "none" and added to `target`: all but ghost marks, and points' ids and rational weights.
/// Names that are already in use are not added but inserted into `refused`.
SkdArrayGather SkdGatherInto(vtkDataSetAttributes* target, vtkIdType n,
  const std::vector<SkdBlock>& blocks, int type, std::set<std::string>& refused);

/// The same for arrays for whose name `isWanted` returns true; "none" is `fill`, see
/// SkdArrayGather.
SkdArrayGather SkdGatherInto(vtkDataSetAttributes* target, vtkIdType n,
  const std::vector<SkdBlock>& blocks, int type, std::set<std::string>& refused, double fill,
  const std::function<bool(const std::string&)>& isWanted);

/// Warns about arrays that were not added.
void SkdWarnAboutRefused(vtkAlgorithm* self, const std::set<std::string>& refused);

#endif
