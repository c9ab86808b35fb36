// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdGenericKernel_h
#define SkdGenericKernel_h

#include "Cells/SkdKernels.h"

#include "vtkType.h"

class vtkCell;
class vtkDataSet;
class vtkGenericCell;

/// What a query needs to look at a cell through VTK: the data set, and a cell to load it into that
/// no other thread uses.
struct SkdCellSource
{
  vtkDataSet* Data;
  vtkGenericCell* Scratch;

  vtkCell* Load(vtkIdType id) const;
};

/// The exact tests of cells without a kernel of their own, by the cell itself.
namespace SkdGenericKernel
{
/// Outside a volume cell the nearest point is sought on its faces: what EvaluatePosition gives
/// there comes from clamped parametric coordinates and need not be nearest.
SkdCellPoint Closest(vtkCell* cell, const skd::Vector3& x);

std::optional<SkdLineHit> Intersect(
  vtkCell* cell, const skd::Segment<3>& segment, double tolerance);

/// The sub-id, parametric coordinates and, unless nullptr, weights at a point of the cell that
/// Closest gave: hand its sub-id and parametric coordinates in.
void Locate(
  vtkCell* cell, const skd::Vector3& point, int& subId, skd::Vector3& pcoords, double* weights);
}

#endif
