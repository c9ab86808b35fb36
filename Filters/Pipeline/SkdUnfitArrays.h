// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdUnfitArrays_h
#define SkdUnfitArrays_h

#include "vtkDataSet.h"
#include "vtkSmartPointer.h"

#include <string>

namespace skdtree
{
/// A mesh without arrays that have more or fewer tuples than it has points or cells: whoever reads
/// one value for each of these reads beyond the end of an array, or values of nothing.
struct SkdFittingMesh
{
  vtkSmartPointer<vtkDataSet> Mesh; ///< the given one if all arrays fit
  std::string Fault;                ///< "point array X has 3 tuples for 9 points."; empty if none
};

/// O(arrays).
SkdFittingMesh SkdLeaveOutUnfitArrays(vtkDataSet* mesh);
}

#endif
