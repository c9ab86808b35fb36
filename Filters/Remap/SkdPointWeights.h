// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdPointWeights.h
 * @brief The weights that take a mesh's points to the cells of another: integrals of linear fields.
 */

#ifndef SkdPointWeights_h
#define SkdPointWeights_h

#include "Remap/SkdOverlapWeights.h"

namespace skdtree
{
/// Fills the table. Edges of the donor on a sphere are arcs of great circles. Results do not depend
/// on the number of threads. False if the algorithm was aborted, or if the weights of these meshes
/// would have a problem. `shares` are what overlaps of each donor cell are multiplied by, if any.
bool SkdFindPointWeights(vtkDataSet* donor, vtkDataSet* target, const SkdOverlapSettings& settings,
  SkdOverlapPointTable& table, vtkAlgorithm* algorithm, double first = 0.0, double last = 1.0,
  const std::vector<double>& shares = {});
}

#endif
