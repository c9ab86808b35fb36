// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_Cells_BernsteinLayout_h
#define skd_Geometry_Cells_BernsteinLayout_h

#include "Core/Geometry/Vector.h"

namespace skd
{

/// The highest degree of a map along an axis, and that of its square.
constexpr int HighestMapDegree = 12;
constexpr int HighestSquareDegree = 2 * HighestMapDegree;

/// How the Bernstein coefficients of a polynomial on a curve, square, triangle, cube, tetrahedron
/// or prism are stored: by up to three indices, the first running fastest. The first `SimplexAxes`
/// axes belong to a triangle or a tetrahedron: their parameters sum up to at most 1, their indices
/// to at most their common degree. Each other axis has its own degree.
struct BernsteinLayout
{
  int Dimension = 0;
  int SimplexAxes = 0;
  int Degree[3] = { 0, 0, 0 };
  int Stride[3] = { 1, 1, 1 };
  int Size = 1; ///< with the room that simplices leave empty

  BernsteinLayout() = default;
  BernsteinLayout(int dimension, int simplexAxes, const int (&degree)[3])
    : Dimension(dimension)
    , SimplexAxes(simplexAxes < 2 ? 0 : simplexAxes)
  {
    for (int axis = 0; axis < dimension; ++axis)
    {
      this->Degree[axis] = degree[axis];
    }
    this->SetStrides();
  }

  bool IsInSimplex(int axis) const { return axis < this->SimplexAxes; }
  bool AreInSimplex(int a, int b) const { return this->IsInSimplex(a) && this->IsInSimplex(b); }

  /// The same of the square of such a polynomial.
  BernsteinLayout Squared() const
  {
    return { this->Dimension, this->SimplexAxes,
      { 2 * this->Degree[0], 2 * this->Degree[1], 2 * this->Degree[2] } };
  }

  /// The same without an axis.
  BernsteinLayout Without(int axis) const
  {
    int degree[3] = { 0, 0, 0 };
    for (int from = 0, to = 0; from < this->Dimension; ++from)
    {
      if (from != axis)
      {
        degree[to++] = this->Degree[from];
      }
    }
    return { this->Dimension - 1, this->SimplexAxes - (this->IsInSimplex(axis) ? 1 : 0), degree };
  }

  /// Calls visit(offset, degree, index) for each row of coefficients along an axis: where it
  /// begins, its last index, and the indices at its beginning.
  template <class Visit>
  void ForEachRow(int axis, const Visit& visit) const
  {
    const int outer = axis == 2 ? 1 : 2;
    const int inner = axis == 0 ? 1 : 0;
    int index[3] = { 0, 0, 0 };
    for (int j = 0; j <= this->Degree[outer]; ++j)
    {
      for (int i = 0; i <= this->Degree[inner]; ++i)
      {
        index[outer] = j;
        index[inner] = i;
        const int used = (this->IsInSimplex(outer) ? j : 0) + (this->IsInSimplex(inner) ? i : 0);
        const int last = this->Degree[axis] - (this->IsInSimplex(axis) ? used : 0);
        if (last < 0 || (this->SimplexAxes > 0 && used > this->Degree[0]))
        {
          break;
        }
        visit(j * this->Stride[outer] + i * this->Stride[inner], last, index);
      }
    }
  }

  /// Whether a condition of the offset holds for all coefficients.
  template <class Condition>
  bool AllOf(const Condition& condition) const
  {
    bool all = true;
    this->ForEachRow(0,
      [&](int offset, int degree, const int(&)[3])
      {
        for (int i = 0; i <= degree; ++i)
        {
          all = all && condition(offset + i);
        }
      });
    return all;
  }

private:
  void SetStrides()
  {
    this->Stride[1] = this->Degree[0] + 1;
    this->Stride[2] = this->Stride[1] * (this->Degree[1] + 1);
    this->Size = this->Stride[2] * (this->Degree[2] + 1);
  }
};

/// A point of a domain with the value and the gradient that a polynomial has there.
struct BernsteinPoint
{
  Vector3 Parameters;
  double Value;
  Vector3 Gradient;
};

/// The Bernstein polynomials of a layout at a point.
class BernsteinWeights
{
public:
  BernsteinWeights(const BernsteinLayout& layout, const Vector3& p)
    : Layout(layout)
    , At(p)
  {
    double sum = 0.0;
    for (int axis = 0; axis < layout.Dimension; ++axis)
    {
      sum += layout.IsInSimplex(axis) ? p[axis] : 0.0;
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      const double at = axis < layout.Dimension ? p[axis] : 0.0;
      const double rest = 1.0 - (layout.IsInSimplex(axis) ? sum : at);
      const bool isRow = axis == 0 || !layout.IsInSimplex(axis);
      this->Factor *= Fill(this->Powers[axis], at, layout.Degree[axis], isRow);
      Fill(this->Rests[axis], rest, layout.Degree[axis], false);
    }
  }

  /// The weight of a coefficient.
  double Value(const int (&index)[3]) const
  {
    double product = this->Factor;
    int left = this->Layout.Degree[0];
    for (int axis = 0; axis < 3; ++axis)
    {
      const int k = index[axis];
      left -= this->Layout.IsInSimplex(axis) || axis == 0 ? k : 0;
      product *= this->Power(axis, k) *
        (axis > 0 && !this->Layout.IsInSimplex(axis)
            ? this->Rest(axis, this->Layout.Degree[axis] - k)
            : 1.0);
    }
    return product * this->Rest(0, left);
  }

  /// The polynomial that has these coefficients.
  BernsteinPoint Sum(const double* values) const
  {
    BernsteinPoint point{ this->At, 0.0, {} };
    this->Layout.ForEachRow(0,
      [&](int offset, int degree, const int(&index)[3])
      { this->AddRow(values + offset, degree, index, point); });
    return point;
  }

private:
  /// x^k / k!. Returns the factorial of the degree if that is wanted, or 1.
  static double Fill(double* powers, double x, int degree, bool isWanted)
  {
    double factorial = 1.0;
    powers[0] = 0.0;
    powers[1] = 1.0;
    for (int k = 1; k <= degree; ++k)
    {
      powers[k + 1] = powers[k] * x / k;
      factorial *= k;
    }
    return isWanted ? factorial : 1.0;
  }

  // 0 for k = -1
  double Power(int axis, int k) const { return this->Powers[axis][k + 1]; }
  double Rest(int axis, int k) const { return this->Rests[axis][k + 1]; }

  void AddRow(const double* row, int degree, const int (&index)[3], BernsteinPoint& point) const
  {
    double sum = 0.0;
    double slope = 0.0;     // derived by the coordinate itself
    double restSlope = 0.0; // by what it leaves of 1
    for (int i = 0; i <= degree; ++i)
    {
      const double power = row[i] * this->Power(0, i);
      sum += power * this->Rest(0, degree - i);
      slope += row[i] * this->Power(0, i - 1) * this->Rest(0, degree - i);
      restSlope += power * this->Rest(0, degree - i - 1);
    }
    double outer[3] = { this->Factor, 1.0, 1.0 };
    double outerSlope[3] = { 0.0, 0.0, 0.0 };
    for (int axis = 1; axis < this->Layout.Dimension; ++axis)
    {
      const int k = index[axis];
      const int left = this->Layout.Degree[axis] - k;
      const bool isIn = this->Layout.IsInSimplex(axis);
      outer[axis] = this->Power(axis, k) * (isIn ? 1.0 : this->Rest(axis, left));
      outerSlope[axis] = isIn ? this->Power(axis, k - 1)
                              : this->Power(axis, k - 1) * this->Rest(axis, left) -
          this->Power(axis, k) * this->Rest(axis, left - 1);
    }
    const double whole = outer[0] * outer[1] * outer[2];
    point.Value += whole * sum;
    point.Gradient[0] += whole * (slope - restSlope);
    for (int axis = 1; axis < this->Layout.Dimension; ++axis)
    {
      point.Gradient[axis] += outer[0] * outer[3 - axis] * outerSlope[axis] * sum -
        (this->Layout.IsInSimplex(axis) ? whole * restSlope : 0.0);
    }
  }

  const BernsteinLayout& Layout;
  Vector3 At;
  double Factor = 1.0;
  double Powers[3][HighestSquareDegree + 2];
  double Rests[3][HighestSquareDegree + 2];
};

}

#endif
