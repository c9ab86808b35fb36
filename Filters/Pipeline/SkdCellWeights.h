// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdCellWeights_h
#define SkdCellWeights_h

#include "vtkGenericCell.h"
#include "vtkNew.h"

#include <vector>

class vtkDataSet;

/// The weights by which a cell interpolates at one of its points. One a thread.
class SkdCellWeights
{
public:
  /// Sets the weights at x, a point of the cell. A cell that has no weights of its own there (a
  /// triangle without area, say) interpolates along its nearest edge, else takes its nearest point.
  void Evaluate(vtkDataSet* mesh, vtkIdType cellId, const double x[3]);

  vtkIdList* GetPointIds() { return this->Cell->GetPointIds(); }
  double* GetWeights() { return this->Weights.data(); }

private:
  bool UseEdge(const double x[3]);
  void UsePoint(const double x[3]);

  vtkNew<vtkGenericCell> Cell;
  std::vector<double> Weights;
};

#endif
