// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdPointWeights.h
 * @brief The weights that take a mesh's points to the cells of another: integrals of linear fields.
 */

#ifndef SkdPointWeights_h
#define SkdPointWeights_h

#include "Remap/SkdOverlapWeights.h"

/// Rows of target cells, columns of donor points, ascending (CSR): the integral over the target
/// cell of the function that is 1 at the point, 0 at all others, and linear on the simplices that
/// the donor's cells are cut into. Triangles, tetrahedra and lines are their own; others are cut
/// between their points. A row sums up to what of the cell is covered. On a sphere linear means: as
/// on the flat triangle of the three points, constant along its normal.
struct SkdOverlapPointTable
{
  std::vector<std::size_t> Rows; ///< one more than there are target cells
  std::vector<vtkIdType> Columns;
  std::vector<double> Weights;
};

/// Fills the table. Curved cells of the donor have no weights; its edges on a sphere are arcs of
/// great circles. Results do not depend on the number of threads. False if the algorithm was
/// aborted, or if the weights of these meshes would have a problem.
bool SkdFindPointWeights(vtkDataSet* donor, vtkDataSet* target, const SkdOverlapSettings& settings,
  SkdOverlapPointTable& table, vtkAlgorithm* algorithm, double first = 0.0, double last = 1.0);

#endif
