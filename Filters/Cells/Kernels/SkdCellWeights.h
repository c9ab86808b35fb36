// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdCellWeights_h
#define SkdCellWeights_h

#include "Core/Geometry/Vector.h"
#include "vtkGenericCell.h"
#include "vtkNew.h"

#include <vector>

class vtkDataSet;

namespace skdtree
{
/// Interpolation weights of a cell at one of its points, exact for linear fields. One object a
/// thread.
class SkdCellWeights
{
public:
  /// Sets the weights at x, a point of the cell: improved weights of VTK's cell. A degenerate cell
  /// without such weights (for example a triangle of zero area) interpolates along its nearest edge
  /// or, failing that, uses its nearest corner.
  void Evaluate(vtkDataSet* mesh, vtkIdType cellId, const double x[3]);

  ///@{
  /// The same at points of one cell that has parametric coordinates (VTK's), which are about known:
  /// by one step of Newton's method, and then the least change that makes them give the point.
  void Load(vtkDataSet* mesh, vtkIdType cellId);
  void EvaluateFrom(const double pcoords[3], const double x[3]);
  ///@}

  vtkIdList* GetPointIds() { return this->Cell->GetPointIds(); }
  double* GetWeights() { return this->Weights.data(); }

private:
  using Vector = skd::Vector3;

  void EvaluateByCell(const Vector& x);
  void EvaluateInHull(const Vector& x);
  void Improve(const Vector& x, int steps);
  Vector GetResidual(const Vector& x, const std::vector<double>& weights) const;
  bool MakeStep(const Vector& residual);
  void Shift(const Vector& residual);
  bool UseEdge(const Vector& x);
  void UseCorner(const Vector& x);

  vtkNew<vtkGenericCell> Cell;
  std::vector<Vector> Corners;
  std::vector<double> Weights;
  double PCoords[3];
  std::vector<double> Next;
  std::vector<double> Derivatives;
};
}

#endif
