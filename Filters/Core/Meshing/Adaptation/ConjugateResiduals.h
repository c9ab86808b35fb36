// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Adaptation_ConjugateResiduals_h
#define skd_Adaptation_ConjugateResiduals_h

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace skd
{

namespace detail
{

inline double DotOf(const std::vector<double>& a, const std::vector<double>& b)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    sum += a[i] * b[i];
  }
  return sum;
}

inline void AddTo(std::vector<double>& a, double factor, const std::vector<double>& b)
{
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    a[i] += factor * b[i];
  }
}

inline void Scale(std::vector<double>& a, double factor)
{
  for (double& value : a)
  {
    value *= factor;
  }
}

}

/// The x for which apply(x) is `wanted`, by generalised conjugate residuals (S. C. Eisenstat, H. C.
/// Elman, M. H. Schultz, SIAM J. Numer. Anal. 20 (1983) 345-357): of a matrix that need not be
/// symmetric, nor have an inverse. estimate(r) is about the x for which apply(x) is r. Ends after
/// at most `steps`, or when the residual, which never grows, is `tolerance` of what was wanted, or
/// hardly falls: what the matrix cannot make would only be sought with ever larger x.
template <class Apply, class Estimate>
std::vector<double> SolveByResiduals(const std::vector<double>& wanted, const Apply& apply,
  const Estimate& estimate, double tolerance, int steps)
{
  std::vector<double> x(wanted.size(), 0.0);
  std::vector<double> residual = wanted;
  std::vector<std::vector<double>> directions, images;
  constexpr double least = 0.02; // of the residual's square, taken by a step
  const double enough = tolerance * tolerance * detail::DotOf(wanted, wanted);
  for (int step = 0; step < steps && detail::DotOf(residual, residual) > enough; ++step)
  {
    std::vector<double> direction = estimate(residual);
    std::vector<double> image = apply(direction);
    for (std::size_t i = 0; i < images.size(); ++i)
    {
      const double part = detail::DotOf(image, images[i]);
      detail::AddTo(direction, -part, directions[i]);
      detail::AddTo(image, -part, images[i]);
    }
    const double length = std::sqrt(detail::DotOf(image, image));
    if (!(length > 0.0))
    {
      break;
    }
    detail::Scale(direction, 1.0 / length);
    detail::Scale(image, 1.0 / length);
    const double part = detail::DotOf(residual, image);
    if (!(part * part > least * detail::DotOf(residual, residual)))
    {
      break;
    }
    detail::AddTo(x, part, direction);
    detail::AddTo(residual, -part, image);
    directions.push_back(std::move(direction));
    images.push_back(std::move(image));
  }
  return x;
}

}

#endif
