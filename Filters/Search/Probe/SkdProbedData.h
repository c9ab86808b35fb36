// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdProbedData.h
 * @brief A Source's data at the locations of points, as point arrays.
 */

#ifndef SkdProbedData_h
#define SkdProbedData_h

#include "Pipeline/SkdArrayGather.h"
#include "Search/Probe/SkdGradient.h"

namespace skdtree
{
/// The requested data of the Source, and the names that are not available.
struct SkdProbedNames
{
  std::set<std::string> Categorical; // point arrays to be taken, not interpolated
  std::set<std::string> Gradients;   // point arrays whose gradients are wanted
  std::set<std::string> Refused;     // arrays left out: their names are in use
  std::set<std::string> Missing;     // names above that the Source does not have
};

class SkdProbedData
{
public:
  /// Adds the arrays to `into`, of n tuples, at first `fill` (see SkdArrayGather::Allocate). The
  /// active scalars become the Source's, or else its first numeric array. Records names that are
  /// refused or missing.
  SkdProbedData(vtkDataSetAttributes* into, vtkIdType n, const std::vector<SkdBlock>& blocks,
    SkdProbedNames& names, double fill);

  /// Sets tuple i from the finder's location for x. Thread-safe for distinct tuples, if each thread
  /// has its own finder and `gradient`.
  void Set(vtkIdType i, const double x[3], SkdCellFinder& finder, SkdGradient& gradient);

private:
  void Activate(vtkDataSetAttributes* into) const;

  const std::vector<SkdBlock>& Blocks;
  SkdArrayGather Quantities;
  SkdArrayGather Labels;
  SkdArrayGather OfCells;
  SkdGradientArrays Gradients;
};
}

#endif
