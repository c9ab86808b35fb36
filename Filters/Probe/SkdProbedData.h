// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdProbedData.h
 * @brief A Source's data at the places of points, as point arrays.
 */

#ifndef SkdProbedData_h
#define SkdProbedData_h

#include "Pipeline/SkdArrayGather.h"
#include "Probe/SkdGradient.h"

/// What is wanted of the Source's data, and what could not be had.
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
  /// active scalars become the Source's, or else its first array of numbers. Puts down names that
  /// are refused or missing.
  SkdProbedData(vtkDataSetAttributes* into, vtkIdType n, const std::vector<SkdBlock>& blocks,
    SkdProbedNames& names, double fill);

  /// Fills tuple i from where the finder is, having been asked for x. Thread-safe for distinct
  /// tuples, each thread with a finder and a `gradient` of its own.
  void Set(vtkIdType i, const double x[3], SkdCellFinder& finder, SkdGradient& gradient);

private:
  void Activate(vtkDataSetAttributes* into) const;

  const std::vector<SkdBlock>& Blocks;
  SkdArrayGather Quantities;
  SkdArrayGather Labels;
  SkdArrayGather OfCells;
  SkdGradientArrays Gradients;
};

#endif
