// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Curves_Preconditioner_h
#define skd_Curves_Preconditioner_h

#include "BezierPatch.h"
#include "Tolerances.h"

namespace skd
{

/// How far a function of N parameters in [0, 1] is from x + constant on a whole box, from the hulls
/// of its derivatives: Spread[i] is the sum over j of max |dF_i/dx_j - delta_ij|.
///
/// Where all are below 1 the function takes no value twice. A root then lies within Spread / 2 of
/// the one that a simplified step of Newton's gives from the middle: R. Krawczyk's test.
template <int N>
struct Contraction
{
  double Step[N];   ///< from the middle of the box
  double Spread[N]; ///< infinite where there is no inverse
  double Slack[N];  ///< what the distance that is 0 to within rounding makes of a step

  double Worst() const { return *std::max_element(this->Spread, this->Spread + N); }

  /// Certainly no root in the box.
  bool Excludes() const
  {
    for (int i = 0; i < N; ++i)
    {
      if (this->Worst() < 1.0 &&
        std::abs(this->Step[i]) >
          0.5 * (1.0 + this->Spread[i]) + tolerances::Preconditioned + this->Slack[i])
      {
        return true;
      }
    }
    return false;
  }
};

/// Rows that take a difference in space to one of parameters: the inverse of the matrix of three
/// columns, or of the first two and what is across both.
struct InverseRows
{
  Vector3 Rows[3];
  bool IsRegular;

  InverseRows(const Vector3& a, const Vector3& b, const Vector3& c)
  {
    const double determinant = Dot(a, Cross(b, c));
    const double size = Norm(a) * Norm(b) * Norm(c);
    this->IsRegular = std::abs(determinant) > tolerances::Regular * size;
    const double scale = this->IsRegular ? 1.0 / determinant : 0.0;
    this->Rows[0] = scale * Cross(b, c);
    this->Rows[1] = scale * Cross(c, a);
    this->Rows[2] = scale * Cross(a, b);
  }
};

/// The interval of the products of points with a direction.
struct Extent
{
  double Min = std::numeric_limits<double>::infinity();
  double Max = -std::numeric_limits<double>::infinity();

  void Add(double value)
  {
    this->Min = std::min(this->Min, value);
    this->Max = std::max(this->Max, value);
  }
  void Add(const Vector3* points, int size, const Vector3& direction)
  {
    for (int i = 0; i < size; ++i)
    {
      this->Add(Dot(points[i], direction));
    }
  }
  bool IsApart(const Extent& other, double tolerance) const
  {
    return this->Min > other.Max + tolerance || other.Min > this->Max + tolerance;
  }
  /// Of the interval that holds both.
  double LengthWith(const Extent& other) const
  {
    return std::max(this->Max, other.Max) - std::min(this->Min, other.Min);
  }
};

}

#endif
