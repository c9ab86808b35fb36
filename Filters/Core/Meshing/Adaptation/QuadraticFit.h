// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Adaptation_QuadraticFit_h
#define skd_Adaptation_QuadraticFit_h

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace skd
{

/// Places in a plane, and the slope at its origin of the quadratic polynomial that fits values
/// there best (weighted least squares), as a sum of weights times values. Where places do not tell
/// the second derivatives these are as small as can be; where they are on a line the slope has no
/// part across. Weights fall smoothly to almost 0 at the farthest place, so that origins close to
/// each other have about the same slopes, be their places other ones.
class QuadraticFit
{
public:
  void Add(double x, double y) { this->Positions.push_back({ { x, y } }); }

  /// What each place's value adds to the slopes.
  std::vector<std::array<double, 2>> FindWeights() const;

private:
  using Terms = std::array<double, 6>; // of the polynomial: 1, x, y, xx, xy, yy
  using Matrix = std::array<Terms, 6>;

  /// Directions in which places spread most and least, and one over how far, 0 for hardly.
  struct Axes
  {
    double Cosine;
    double Sine;
    std::array<double, 2> Scale;
  };

  Axes FindAxes() const;
  static Terms TermsOf(const std::array<double, 2>& x)
  {
    return { { 1.0, x[0], x[1], x[0] * x[0], x[0] * x[1], x[1] * x[1] } };
  }
  static void Factorise(Matrix& matrix);
  static Terms Solve(const Matrix& factor, std::size_t unit);

  std::vector<std::array<double, 2>> Positions;
};

inline QuadraticFit::Axes QuadraticFit::FindAxes() const
{
  constexpr double thin = 1e-3;
  double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;
  const double part = 1.0 / static_cast<double>(this->Positions.size());
  for (const std::array<double, 2>& position : this->Positions)
  {
    x += part * position[0];
    y += part * position[1];
    xx += part * position[0] * position[0];
    xy += part * position[0] * position[1];
    yy += part * position[1] * position[1];
  }
  xx -= x * x;
  xy -= x * y;
  yy -= y * y;
  const double spread = std::hypot(0.5 * (xx - yy), xy);
  const double angle = 0.5 * std::atan2(xy, 0.5 * (xx - yy));
  const double longest = std::sqrt(std::max(0.5 * (xx + yy) + spread, 0.0));
  const double shortest = std::sqrt(std::max(0.5 * (xx + yy) - spread, 0.0));
  return { std::cos(angle), std::sin(angle),
    { { longest > 0.0 ? 1.0 / longest : 0.0, shortest > thin * longest ? 1.0 / shortest : 0.0 } } };
}

/// Cholesky's lower factor.
inline void QuadraticFit::Factorise(Matrix& matrix)
{
  for (std::size_t i = 0; i < 6; ++i)
  {
    for (std::size_t j = 0; j <= i; ++j)
    {
      double value = matrix[i][j];
      for (std::size_t k = 0; k < j; ++k)
      {
        value -= matrix[i][k] * matrix[j][k];
      }
      matrix[i][j] = i == j ? std::sqrt(std::max(value, 1e-300)) : value / matrix[j][j];
    }
  }
}

inline QuadraticFit::Terms QuadraticFit::Solve(const Matrix& factor, std::size_t unit)
{
  Terms x{};
  for (std::size_t i = unit; i < 6; ++i)
  {
    double value = i == unit ? 1.0 : 0.0;
    for (std::size_t k = unit; k < i; ++k)
    {
      value -= factor[i][k] * x[k];
    }
    x[i] = value / factor[i][i];
  }
  for (std::size_t i = 6; i-- > 0;)
  {
    for (std::size_t k = i + 1; k < 6; ++k)
    {
      x[i] -= factor[k][i] * x[k];
    }
    x[i] /= factor[i][i];
  }
  return x;
}

inline std::vector<std::array<double, 2>> QuadraticFit::FindWeights() const
{
  const Axes axes = this->FindAxes();
  std::vector<std::array<double, 2>> rotated;
  double radius = 0.0;
  for (const std::array<double, 2>& x : this->Positions)
  {
    rotated.push_back({ { axes.Scale[0] * (axes.Cosine * x[0] + axes.Sine * x[1]),
      axes.Scale[1] * (axes.Cosine * x[1] - axes.Sine * x[0]) } });
    radius = std::max(radius, 1.1 * std::hypot(rotated.back()[0], rotated.back()[1]));
  }
  Matrix matrix{};
  std::vector<double> counts;
  for (const std::array<double, 2>& x : rotated)
  {
    const double away = radius > 0.0 ? std::hypot(x[0], x[1]) / radius : 0.0;
    const double part = (1.0 - away) * (1.0 - away);
    counts.push_back(part * part * (4.0 * away + 1.0)); // H. Wendland's, twice differentiable
    const Terms terms = TermsOf(x);
    for (std::size_t i = 0; i < 6; ++i)
    {
      for (std::size_t k = 0; k <= i; ++k)
      {
        matrix[i][k] += counts.back() * terms[i] * terms[k];
      }
    }
  }
  const double total = matrix[0][0];
  for (std::size_t i = 1; i < 6; ++i) // what places do not tell is to be small
  {
    matrix[i][i] += (i < 3 ? 1e-9 : 1e-6) * total;
  }
  Factorise(matrix);
  const Terms slopes[2] = { Solve(matrix, 1), Solve(matrix, 2) };
  std::vector<std::array<double, 2>> weights;
  for (std::size_t i = 0; i < rotated.size(); ++i)
  {
    const Terms terms = TermsOf(rotated[i]);
    double along = 0.0, across = 0.0;
    for (std::size_t k = 0; k < 6; ++k)
    {
      along += axes.Scale[0] * counts[i] * slopes[0][k] * terms[k];
      across += axes.Scale[1] * counts[i] * slopes[1][k] * terms[k];
    }
    weights.push_back(
      { { axes.Cosine * along - axes.Sine * across, axes.Sine * along + axes.Cosine * across } });
  }
  return weights;
}

}

#endif
