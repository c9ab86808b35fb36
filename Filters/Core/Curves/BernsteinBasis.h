// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Curves_BernsteinBasis_h
#define skd_Curves_BernsteinBasis_h

#include "BezierPatch.h"

#include <array>
#include <utility>

namespace skd
{

/// From the values that a polynomial has at 0, 1/n, ..., 1 to its Bernstein coefficients. Exact to
/// rounding; at degree 10 that costs three digits.
class BernsteinBasis
{
public:
  explicit BernsteinBasis(int degree)
    : Degree(degree)
  {
    for (int i = 0; i <= degree; ++i)
    {
      for (int j = 0; j <= degree; ++j)
      {
        this->Matrix[i][j] = ValueOf(j, static_cast<long double>(i) / degree);
        this->Inverse[i][j] = i == j ? 1.0L : 0.0L;
      }
    }
    this->Invert();
  }

  /// In place, of values that lie `stride` apart. Those at both ends stay as they are.
  void Convert(Homogeneous* values, int stride = 1) const
  {
    Homogeneous converted[MaximumDegree + 1] = {};
    for (int i = 1; i < this->Degree; ++i)
    {
      for (int j = 0; j <= this->Degree; ++j)
      {
        converted[i] = converted[i] + static_cast<double>(this->Inverse[i][j]) * values[j * stride];
      }
    }
    for (int i = 1; i < this->Degree; ++i)
    {
      values[i * stride] = converted[i];
    }
  }

private:
  long double ValueOf(int j, long double t) const
  {
    long double value = 1.0L;
    for (int k = 0; k < this->Degree; ++k)
    {
      value *= k < j ? t * (this->Degree - k) / (j - k) : 1.0L - t;
    }
    return value;
  }

  /// Gauss and Jordan's elimination, with the largest pivot.
  void Invert()
  {
    for (int column = 0; column <= this->Degree; ++column)
    {
      int pivot = column;
      for (int row = column; row <= this->Degree; ++row)
      {
        pivot =
          std::abs(this->Matrix[row][column]) > std::abs(this->Matrix[pivot][column]) ? row : pivot;
      }
      std::swap(this->Matrix[pivot], this->Matrix[column]);
      std::swap(this->Inverse[pivot], this->Inverse[column]);
      for (int row = 0; row <= this->Degree; ++row)
      {
        const long double factor =
          (row == column ? this->Matrix[row][column] - 1.0L : this->Matrix[row][column]) /
          this->Matrix[column][column];
        this->Subtract(row, factor, column);
      }
    }
  }

  void Subtract(int row, long double factor, int from)
  {
    const Row matrix = this->Matrix[from];
    const Row inverse = this->Inverse[from];
    for (int i = 0; i <= this->Degree; ++i)
    {
      this->Matrix[row][i] -= factor * matrix[i];
      this->Inverse[row][i] -= factor * inverse[i];
    }
  }

  using Row = std::array<long double, MaximumDegree + 1>;

  int Degree;
  std::array<Row, MaximumDegree + 1> Matrix{};
  std::array<Row, MaximumDegree + 1> Inverse{};
};

/// The basis of a degree of 1 to MaximumDegree, made once. Thread-safe.
inline const BernsteinBasis& BernsteinBasisOf(int degree)
{
  static const std::array<BernsteinBasis, MaximumDegree> bases = { BernsteinBasis(1),
    BernsteinBasis(2), BernsteinBasis(3), BernsteinBasis(4), BernsteinBasis(5), BernsteinBasis(6),
    BernsteinBasis(7), BernsteinBasis(8), BernsteinBasis(9), BernsteinBasis(10) };
  return bases[static_cast<std::size_t>(degree - 1)];
}

/// Turns values at (i/p, j/q) into the patch that has them there.
inline void ConvertToBernstein(BezierPatch& patch)
{
  for (int j = 0; j <= patch.DegreeS; ++j)
  {
    BernsteinBasisOf(patch.DegreeR).Convert(&patch.Point(0, j));
  }
  for (int i = 0; i <= patch.DegreeR; ++i)
  {
    BernsteinBasisOf(patch.DegreeS).Convert(&patch.Point(i, 0), patch.DegreeR + 1);
  }
}

}

#endif
