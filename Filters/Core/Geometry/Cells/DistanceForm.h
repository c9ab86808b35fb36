// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_Cells_DistanceForm_h
#define skd_Geometry_Cells_DistanceForm_h

#include "BernsteinLayout.h"

#include <vector>

namespace skd
{

/// The squared distance of a map in Bernstein form from a point as a polynomial in Bernstein form,
/// of twice the degree. What it needs to know of a layout; constant.
class DistanceForm
{
public:
  DistanceForm() = default;
  explicit DistanceForm(const BernsteinLayout& layout)
    : Layout(layout)
    , Square(layout.Squared())
    , Factors(MakeFactors(layout))
    , Divisors(MakeFactors(Square))
  {
    layout.ForEachRow(0,
      [this](int offset, int degree, const int(&index)[3])
      {
        const int squared = index[1] * this->Square.Stride[1] + index[2] * this->Square.Stride[2];
        this->Rows.push_back({ offset, squared, degree + 1 });
      });
  }

  const BernsteinLayout& GetLayout() const { return this->Layout; }
  const BernsteinLayout& GetSquare() const { return this->Square; }

  /// Whether 2 p . direction >= least for all control points p, given as below. Then it is so on
  /// the whole map: they are a convex hull where all weights are positive.
  bool IsBeyond(double* const (&controls)[3], const double* weights, const Vector3& direction,
    double least) const
  {
    for (int i = 0; i < this->Layout.Size; ++i)
    {
      const double along = controls[0][i] * direction[0] + controls[1][i] * direction[1] +
        controls[2][i] * direction[2];
      const double weight = weights ? weights[i] : 1.0;
      const bool isEmpty = weight == 0.0 && along == 0.0;
      if (!(weight > 0.0 && 2.0 * along >= least * weight) && !isEmpty)
      {
        return false;
      }
    }
    return true;
  }

  /// Sets `values`, of the squared layout, to scale (|p + gap|^2 - |gap|^2) w^2 for the map p, of
  /// weight w (nullptr: 1). Given are the control points of p w, three arrays, and of w. The former
  /// are changed; `other` is memory of as many values.
  void Make(double* const (&controls)[3], const double* weights, const Vector3& gap, double scale,
    double* other, double* values) const
  {
    this->Weigh(controls, weights, gap, other);
    std::fill(values, values + this->Square.Size, 0.0);
    for (const Row& a : this->Rows)
    {
      for (const Row& b : this->Rows)
      {
        this->Multiply(a, b, controls, other, values + a.Squared + b.Squared);
      }
    }
    for (int i = 0; i < this->Square.Size; ++i)
    {
      values[i] *= scale / this->Divisors[static_cast<std::size_t>(i)];
    }
  }

private:
  struct Row
  {
    int Offset;
    int Squared;
    int Size;
  };

  /// The product of binomial (multinomial) coefficients that a Bernstein polynomial has.
  static std::vector<double> MakeFactors(const BernsteinLayout& layout)
  {
    std::vector<double> factors(static_cast<std::size_t>(layout.Size), 1.0);
    layout.ForEachRow(0,
      [&](int offset, int degree, const int(&start)[3])
      {
        int index[3] = { start[0], start[1], start[2] };
        for (int i = 0; i <= degree; ++i)
        {
          index[0] = i;
          factors[static_cast<std::size_t>(offset + i)] = FactorOf(layout, index);
        }
      });
    return factors;
  }

  static double FactorOf(const BernsteinLayout& layout, const int (&index)[3])
  {
    double factor = 1.0;
    int left = layout.Degree[0];
    for (int axis = 0; axis < layout.Dimension; ++axis)
    {
      const bool isIn = layout.IsInSimplex(axis);
      factor *= Binomial(isIn ? left : layout.Degree[axis], index[axis]);
      left -= index[axis];
    }
    return factor;
  }

  static double Binomial(int n, int k)
  {
    double binomial = 1.0;
    for (int i = 1; i <= k; ++i)
    {
      binomial *= (n - k + i) / double(i);
    }
    return binomial;
  }

  /// Makes `other` of p w + 2 gap w, in three parts of the layout's size.
  void Weigh(
    double* const (&controls)[3], const double* weights, const Vector3& gap, double* other) const
  {
    const int size = this->Layout.Size;
    for (int i = 0; i < size; ++i)
    {
      const double factor = this->Factors[static_cast<std::size_t>(i)];
      const double weight = factor * (weights ? weights[i] : 1.0);
      for (int axis = 0; axis < 3; ++axis)
      {
        controls[axis][i] *= factor;
        other[axis * size + i] = controls[axis][i] + 2.0 * weight * gap[axis];
      }
    }
  }

  void Multiply(const Row& a, const Row& b, double* const (&controls)[3], const double* other,
    double* values) const
  {
    const int size = this->Layout.Size;
    const double* x = other + b.Offset;
    const double* y = x + size;
    const double* z = y + size;
    for (int i = 0; i < a.Size; ++i)
    {
      const double p = controls[0][a.Offset + i];
      const double q = controls[1][a.Offset + i];
      const double r = controls[2][a.Offset + i];
      for (int j = 0; j < b.Size; ++j)
      {
        values[i + j] += p * x[j] + q * y[j] + r * z[j];
      }
    }
  }

  BernsteinLayout Layout;
  BernsteinLayout Square;
  std::vector<double> Factors;
  std::vector<double> Divisors;
  std::vector<Row> Rows;
};

}

#endif
