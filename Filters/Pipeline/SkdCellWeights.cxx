// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/SkdCellWeights.h"

#include "vtkDataSet.h"
#include "vtkMath.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

void SkdCellWeights::Evaluate(vtkDataSet* mesh, vtkIdType cellId, const double x[3])
{
  mesh->GetCell(cellId, this->Cell);
  this->Weights.assign(this->Cell->GetNumberOfPoints(), 0.0);
  double nearest[3];
  double pcoords[3];
  int subId;
  double dist2;
  const int status =
    this->Cell->EvaluatePosition(x, nearest, subId, pcoords, dist2, this->Weights.data());
  const double sum = std::accumulate(this->Weights.begin(), this->Weights.end(), 0.0);
  if (status == -1 || !(std::abs(sum - 1.0) < 0.5))
  {
    if (!this->UseEdge(x))
    {
      this->UsePoint(x);
    }
  }
}

bool SkdCellWeights::UseEdge(const double x[3])
{
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < this->Cell->GetNumberOfEdges(); ++i)
  {
    vtkCell* edge = this->Cell->GetEdge(i);
    double nearest[3];
    double pcoords[3];
    int subId;
    double dist2;
    std::vector<double> weights(edge->GetNumberOfPoints(), 0.0);
    const int status = edge->EvaluatePosition(x, nearest, subId, pcoords, dist2, weights.data());
    if (status == -1 || !(dist2 < least))
    {
      continue;
    }
    least = dist2;
    std::fill(this->Weights.begin(), this->Weights.end(), 0.0);
    for (std::size_t k = 0; k < weights.size(); ++k)
    {
      const vtkIdType corner = this->Cell->GetPointIds()->IsId(edge->GetPointId(k));
      this->Weights[corner] = weights[k];
    }
  }
  return std::isfinite(least);
}

void SkdCellWeights::UsePoint(const double x[3])
{
  double least = std::numeric_limits<double>::infinity();
  std::fill(this->Weights.begin(), this->Weights.end(), 0.0);
  std::size_t nearest = 0;
  for (std::size_t i = 0; i < this->Weights.size(); ++i)
  {
    double corner[3];
    this->Cell->GetPoints()->GetPoint(i, corner);
    const double dist2 = vtkMath::Distance2BetweenPoints(x, corner);
    if (dist2 < least)
    {
      least = dist2;
      nearest = i;
    }
  }
  this->Weights[nearest] = 1.0;
}
