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

/// Positions in a plane, and the slope at its origin of the quadratic polynomial that fits values
/// there best (weighted least squares), as a sum of weights times values. Where the positions do
/// not determine the second derivatives these are as small as can be; where they are on a line the
/// slope has no part across. Weights fall smoothly to almost 0 at the farthest position, so that
/// origins close to each other have about the same slopes, be their positions other ones.
///
/// With t(x) = (1, x, y, xx, xy, yy) the coefficients c minimise the sum of w (c . t(x) - v)^2 over
/// the positions x with values v: M c = sum of w v t(x), where M = sum of w t(x) t(x)^T. The slope
/// along x is the second coefficient, e . c with the unit vector e; so a value v counts in it by
/// w (M^-1 e) . t(x). The same along y with the third.
class QuadraticFit
{
public:
  void Add(double x, double y) { this->Positions.push_back({ { x, y } }); }

  /// What each position's value adds to the slopes.
  std::vector<std::array<double, 2>> FindWeights() const;

private:
  using Position = std::array<double, 2>;
  static constexpr std::size_t NumberOfTerms = 6;
  using Terms = std::array<double, NumberOfTerms>; // of the polynomial: 1, x, y, xx, xy, yy
  using Matrix = std::array<Terms, NumberOfTerms>; // the lower half counts

  /// Directions in which positions vary most and least, and one over how much, 0 for hardly.
  struct Axes
  {
    double Cosine;
    double Sine;
    std::array<double, 2> Scale;
  };

  Axes FindAxes() const;
  std::vector<Position> Standardized(const Axes& axes) const;
  static std::vector<double> FitWeights(const std::vector<Position>& positions);
  static Matrix NormalMatrix(
    const std::vector<Position>& positions, const std::vector<double>& fitWeights);
  static Terms TermsOf(const Position& x)
  {
    return { { 1.0, x[0], x[1], x[0] * x[0], x[0] * x[1], x[1] * x[1] } };
  }
  static void Factorise(Matrix& matrix);
  static Terms Solve(const Matrix& factor, std::size_t unit);

  std::vector<Position> Positions;
};

// The axes of the covariance matrix (xx, xy; xy, yy): its eigenvalues, the squares of the standard
// deviations along them, are the mean of xx and yy plus and minus `spread`, and the first one's
// direction is at half the angle of the vector ((xx - yy) / 2, xy).
inline QuadraticFit::Axes QuadraticFit::FindAxes() const
{
  constexpr double thin = 1e-3; // of the longest standard deviation: positions are on a line
  double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;
  const double part = 1.0 / static_cast<double>(this->Positions.size());
  for (const Position& position : this->Positions)
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
  constexpr double positive = 1e-300; // a pivot that rounding has made 0 or less
  for (std::size_t i = 0; i < NumberOfTerms; ++i)
  {
    for (std::size_t j = 0; j <= i; ++j)
    {
      double value = matrix[i][j];
      for (std::size_t k = 0; k < j; ++k)
      {
        value -= matrix[i][k] * matrix[j][k];
      }
      matrix[i][j] = i == j ? std::sqrt(std::max(value, positive)) : value / matrix[j][j];
    }
  }
}

/// The solution for the right side that is 1 at `unit` and 0 elsewhere: forth by the factor, and
/// back by its transpose.
inline QuadraticFit::Terms QuadraticFit::Solve(const Matrix& factor, std::size_t unit)
{
  Terms x{};
  for (std::size_t i = unit; i < NumberOfTerms; ++i)
  {
    double value = i == unit ? 1.0 : 0.0;
    for (std::size_t k = unit; k < i; ++k)
    {
      value -= factor[i][k] * x[k];
    }
    x[i] = value / factor[i][i];
  }
  for (std::size_t i = NumberOfTerms; i-- > 0;)
  {
    for (std::size_t k = i + 1; k < NumberOfTerms; ++k)
    {
      x[i] -= factor[k][i] * x[k];
    }
    x[i] /= factor[i][i];
  }
  return x;
}

/// In the axes, in units of the standard deviations.
inline std::vector<QuadraticFit::Position> QuadraticFit::Standardized(const Axes& axes) const
{
  std::vector<Position> standardized;
  for (const Position& x : this->Positions)
  {
    standardized.push_back({ { axes.Scale[0] * (axes.Cosine * x[0] + axes.Sine * x[1]),
      axes.Scale[1] * (axes.Cosine * x[1] - axes.Sine * x[0]) } });
  }
  return standardized;
}

/// By the distance r from the origin, in units of a little more than the farthest: (1 - r)^4 (4 r +
/// 1), which is twice differentiable (H. Wendland, Adv. Comput. Math. 4 (1995) 389-396).
inline std::vector<double> QuadraticFit::FitWeights(const std::vector<Position>& positions)
{
  constexpr double beyond = 1.1; // times the farthest: so that it counts a little, too
  double radius = 0.0;
  for (const Position& x : positions)
  {
    radius = std::max(radius, beyond * std::hypot(x[0], x[1]));
  }
  std::vector<double> weights;
  for (const Position& x : positions)
  {
    const double r = radius > 0.0 ? std::hypot(x[0], x[1]) / radius : 0.0;
    const double part = (1.0 - r) * (1.0 - r);
    weights.push_back(part * part * (4.0 * r + 1.0));
  }
  return weights;
}

/// M, and what makes coefficients small that the positions do not determine (A. N. Tikhonov's
/// regularization): as if there were the value 0 of each of them, with a weight so small that it
/// does not matter to the others. Second derivatives give way to slopes.
inline QuadraticFit::Matrix QuadraticFit::NormalMatrix(
  const std::vector<Position>& positions, const std::vector<double>& fitWeights)
{
  constexpr double ofSlopes = 1e-9; // of the sum of weights
  constexpr double ofSecondDerivatives = 1e-6;
  Matrix matrix{};
  for (std::size_t position = 0; position < positions.size(); ++position)
  {
    const Terms terms = TermsOf(positions[position]);
    for (std::size_t i = 0; i < NumberOfTerms; ++i)
    {
      for (std::size_t k = 0; k <= i; ++k)
      {
        matrix[i][k] += fitWeights[position] * terms[i] * terms[k];
      }
    }
  }
  const double total = matrix[0][0];
  for (std::size_t i = 1; i < NumberOfTerms; ++i)
  {
    matrix[i][i] += (i < 3 ? ofSlopes : ofSecondDerivatives) * total;
  }
  return matrix;
}

inline std::vector<std::array<double, 2>> QuadraticFit::FindWeights() const
{
  const Axes axes = this->FindAxes();
  const std::vector<Position> positions = this->Standardized(axes);
  const std::vector<double> fitWeights = FitWeights(positions);
  Matrix matrix = NormalMatrix(positions, fitWeights);
  Factorise(matrix);
  const Terms slopes[2] = { Solve(matrix, 1), Solve(matrix, 2) };
  std::vector<std::array<double, 2>> weights;
  for (std::size_t i = 0; i < positions.size(); ++i)
  {
    const Terms terms = TermsOf(positions[i]);
    double along = 0.0, across = 0.0; // the slopes in the axes and their units
    for (std::size_t k = 0; k < NumberOfTerms; ++k)
    {
      along += axes.Scale[0] * fitWeights[i] * slopes[0][k] * terms[k];
      across += axes.Scale[1] * fitWeights[i] * slopes[1][k] * terms[k];
    }
    weights.push_back(
      { { axes.Cosine * along - axes.Sine * across, axes.Sine * along + axes.Cosine * across } });
  }
  return weights;
}

}

#endif
