// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Adaptation_EdgeLaplacian_h
#define skd_Adaptation_EdgeLaplacian_h

#include "ConjugateResiduals.h"
#include "SurfaceMesh.h"

#include <cmath>

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

namespace detail
{

/// One over the diagonal; 0 of a cell without flows.
inline std::vector<double> InverseDiagonal(const EdgeLaplacian& matrix)
{
  std::vector<double> diagonal(matrix.NumberOfCells, 0.0);
  for (const EdgeLaplacian::Flow& flow : matrix.Flows)
  {
    diagonal[flow.Cells[0]] += flow.Weight;
    diagonal[flow.Cells[1]] += flow.Weight;
  }
  for (double& value : diagonal)
  {
    value = value > 0.0 ? 1.0 / value : 0.0;
  }
  return diagonal;
}

}

/// The y of which each cell gains `gains`, by conjugate gradients with the diagonal as
/// preconditioner (M. R. Hestenes, E. Stiefel, J. Res. Nat. Bur. Standards 49 (1952) 409-436). In
/// each connected part the gains must sum to 0; y is known but for a constant there. Begins with
/// the y given, ends when the residual is `tolerance` of the gains, or after 10 sqrt(N) + 100
/// steps, and returns how many steps were made. Does not depend on threads.
inline int SolveForGains(const EdgeLaplacian& matrix, const std::vector<double>& gains,
  double tolerance, std::vector<double>& y)
{
  const std::size_t n = matrix.NumberOfCells;
  const std::vector<double> inverse = detail::InverseDiagonal(matrix);
  std::vector<double> image, residual(n), scaled(n), direction(n, 0.0);
  matrix.Apply(y, image);
  for (std::size_t i = 0; i < n; ++i)
  {
    residual[i] = -gains[i] - image[i];
  }
  const double enough = tolerance * tolerance * detail::DotOf(gains, gains);
  const int most = 100 + static_cast<int>(10.0 * std::sqrt(static_cast<double>(n)));
  double before = 0.0;
  int step = 0;
  for (; step < most && detail::DotOf(residual, residual) > enough; ++step)
  {
    for (std::size_t i = 0; i < n; ++i)
    {
      scaled[i] = inverse[i] * residual[i];
    }
    const double now = detail::DotOf(residual, scaled);
    for (std::size_t i = 0; i < n; ++i)
    {
      direction[i] = scaled[i] + (step > 0 ? now / before : 0.0) * direction[i];
    }
    matrix.Apply(direction, image);
    const double curvature = detail::DotOf(direction, image);
    if (!(curvature > 0.0))
    {
      break;
    }
    for (std::size_t i = 0; i < n; ++i)
    {
      y[i] += now / curvature * direction[i];
      residual[i] -= now / curvature * image[i];
    }
    before = now;
  }
  return step;
}

}

#endif
