// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Curves_Preconditioner_h
#define skd_Curves_Preconditioner_h

#include "BezierPatch.h"
#include "Core/Geometry/Cells/Contraction.h"
#include "Tolerances.h"

namespace skd
{

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
