// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdBooleanReport.h
 * @brief What a filter says about a Boolean operation: messages, and figures in the output.
 */

#ifndef SkdBooleanReport_h
#define SkdBooleanReport_h

#include "Solids/Boolean/SkdSolidArrangement.h"

class vtkAlgorithm;

namespace skdtree
{
class SkdReport;

/// Warnings about inputs: none has faces, faces too coarse for the deviation, tiny coordinates.
void SkdWarnAboutInputs(vtkAlgorithm* filter, const SkdSolidArrangement& solids,
  const SkdBooleanBlocks& blocks, double chordalDeviation);

/// The error that a solid is not closed: where, and what closes it.
void SkdTellUnclosed(vtkAlgorithm* filter, const SkdSolidArrangement& solids, std::uint32_t solid);

/// A warning that says by which rule surfaces that are not closed have an inside, if there are any.
void SkdTellRounded(vtkAlgorithm* filter, const SkdSolidArrangement& solids);

/// The error that regions could not be told apart, if there are no `faults`; else warnings about
/// these.
void SkdTellSheetFaults(vtkAlgorithm* filter, const std::optional<SkdSheetFaults>& faults);

/// What an output has: one boundary, or those of all parts.
struct SkdBooleanTotals
{
  SkdBoundaryMeasures Measures;
  std::vector<double> PartVolumes; ///< of a split
  vtkIdType NumberFolded = 0;
  SkdBadEdges Bad;
  std::string FirstBad; ///< where it is

  /// Adds a boundary as it is stored.
  void Add(const SkdSolidArrangement& solids, const SkdBooleanRule& rule,
    const SkdBooleanBoundary& boundary);
};

/// Volumes, areas and open edges of the inputs and of the output; a warning if that is not closed
/// although it should be.
void SkdReportBoolean(vtkAlgorithm* filter, const SkdSolidArrangement& solids,
  const SkdBooleanRule& rule, const SkdBooleanTotals& totals, bool closesCut, SkdReport& report);
}

#endif
