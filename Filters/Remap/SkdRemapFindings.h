// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdRemapFindings_h
#define SkdRemapFindings_h

#include "Remap/SkdRemapTables.h"

#include <string>
#include <vector>

/// What a run came upon.
struct SkdRemapFindings
{
  SkdFieldProblems Fields;
  SkdRemapTally Tally;
  std::string Problem; ///< why there are no results, if so
  vtkIdType Cells = 0, EmptyCells = 0, PartlyCovered = 0, CoveredTwice = 0;
  vtkIdType SourceLeftOut = 0, InputLeftOut = 0, SourceCoveredTwice = 0;
  vtkIdType Unfit = 0; ///< cells of a type that contains nothing
  vtkIdType Overlaps = 0;
  int WeightsFound = 0; ///< for how many blocks they were not kept

  /// What to warn of besides fields, with what to do.
  std::vector<std::string> GetWarnings() const;
};

#endif
