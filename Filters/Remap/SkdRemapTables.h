// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdRemapTables.h
 * @brief What a remapping tells: integrals as field data, weights as rows.
 */

#ifndef SkdRemapTables_h
#define SkdRemapTables_h

#include "Core/Parallel/Processes.h"
#include "Remap/SkdConservativeRemap.h"

#include <map>
#include <string>
#include <utility>

class vtkDataObject;
class vtkDataSet;
class vtkTable;

namespace skdtree
{
/// Integrals of each component of each field, summed over the target's blocks.
class SkdRemapTally
{
public:
  /// A field that other processes may add, if this one has no cells.
  void Expect(const SkdDonorField& field);

  void Add(const SkdDonorField& field, const std::vector<SkdRemapIntegrals>& integrals);

  /// Adds what the other processes have, of the same fields. The sums are the same on all of them.
  /// `isSpread`: each has summed up its own cells of the donor, not all.
  void AddOthers(const skd::Processes& processes, bool isSpread);

  /// Field data, a value a component of a field: SkdReportArray (its name, with the component's
  /// number where there are several, and "(points)" where an array of cells has it, too),
  /// ...SourceIntegral, ...OverlapIntegral, ...TargetIntegral, ...ConservationError, ...Coverage.
  /// None without fields.
  void AddTo(vtkDataObject* output) const;

private:
  using Row = SkdRemapIntegrals;

  Row& RowOf(const SkdDonorField& field, std::size_t component);

  std::map<std::pair<std::string, bool>, Row> Rows; // by name and whether it is of points
};

/// Appends a row for each overlap of a target block: Row, Column (ids of the target's and the
/// donor's cell, in the whole donor), Weight (by which the donor's average counts in the target's),
/// Measure (of the overlap), Moment (see SkdOverlapTable), and RowBlockIndex if the target is
/// composite.
void SkdAppendWeights(const SkdOverlapWeights& weights, vtkDataSet* donor,
  SkdNormalization normalization, int blockIndex, bool isComposite, vtkTable* table);
}

#endif
