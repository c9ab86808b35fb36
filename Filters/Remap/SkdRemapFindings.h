// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdRemapFindings_h
#define SkdRemapFindings_h

#include "Remap/SkdMatchedSurfaces.h"
#include "Remap/SkdRemapTables.h"

#include <optional>
#include <string>
#include <vector>

namespace skdtree
{
/// Cells that have a fault.
struct SkdFaultyCells
{
  vtkIdType Count = 0;
  vtkIdType First = 0;

  void Add(const std::vector<vtkIdType>& ids)
  {
    this->First = this->Count == 0 && !ids.empty() ? ids.front() : this->First;
    this->Count += static_cast<vtkIdType>(ids.size());
  }
};

/// What a run came upon.
struct SkdRemapFindings
{
  SkdFieldProblems Fields;
  SkdRemapTally Tally;
  std::string Problem; ///< why there are no results, if so
  vtkIdType Cells = 0, EmptyCells = 0, PartlyCovered = 0, CoveredTwice = 0;
  vtkIdType SourceLeftOut = 0, InputLeftOut = 0, SourceCoveredTwice = 0;
  vtkIdType WithoutPartner =
    0;                 ///< cells of a curved surface that are not, or far from all, covered
  vtkIdType Unfit = 0; ///< cells of a type that contains nothing
  SkdFaultyCells SourceTooLarge, InputTooLarge, SourceCrossing, InputCrossing;
  vtkIdType Overlaps = 0;
  vtkIdType OverlapsElsewhere = 0;            ///< of other processes
  std::optional<SkdSurfaceFindings> Surfaces; ///< of curved ones
  int WeightsFound = 0;                       ///< for how many blocks they were not kept
  int WeightsUsed = 0;                        ///< for how many blocks there are some, new or kept

  /// What to warn of besides fields, with what to do; `hint` is said of meshes that do not meet.
  std::vector<std::string> GetWarnings(const std::string& hint = {}) const;
};
}

#endif
