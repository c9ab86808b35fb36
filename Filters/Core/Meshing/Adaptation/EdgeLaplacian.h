// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Adaptation_EdgeLaplacian_h
#define skd_Adaptation_EdgeLaplacian_h

#include "ConjugateResiduals.h"
#include "SurfaceMesh.h"

namespace skd
{

/// The matrix of flows between cells across edges: a cell gains weight (y of the other - y of the
/// cell) across each. Symmetric, and no flow is lost.
struct EdgeLaplacian
{
  struct Flow
  {
    std::uint32_t Cells[2];
    double Weight; ///< greater than 0
  };

  std::size_t NumberOfCells = 0;
  std::vector<Flow> Flows;

  /// Minus the gains: a matrix with no negative eigenvalue.
  void Apply(const std::vector<double>& y, std::vector<double>& losses) const
  {
    losses.assign(this->NumberOfCells, 0.0);
    for (const Flow& flow : this->Flows)
    {
      const double loss = flow.Weight * (y[flow.Cells[0]] - y[flow.Cells[1]]);
      losses[flow.Cells[0]] += loss;
      losses[flow.Cells[1]] -= loss;
    }
  }
};

}

#endif
