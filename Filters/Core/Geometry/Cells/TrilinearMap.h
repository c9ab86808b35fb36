// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_Cells_TrilinearMap_h
#define skd_Geometry_Cells_TrilinearMap_h

#include "PaddedVector.h"

#include <algorithm>

namespace skd
{

inline Vector3 Abs(const Vector3& v)
{
  return { { std::abs(v[0]), std::abs(v[1]), std::abs(v[2]) } };
}

inline double MaxNorm(const Vector3& v)
{
  return std::max(std::max(std::abs(v[0]), std::abs(v[1])), std::abs(v[2]));
}

/// Three columns, and how to solve with them.
struct Matrix3
{
  PaddedVector Columns[3];

  /// The solution of (columns) y = right: infinite or NaN when there is none.
  Vector3 Solve(const PaddedVector& right) const
  {
    const PaddedVector* c = this->Columns;
    const PaddedVector cross12 = Cross(c[1], c[2]);
    const PaddedVector cross0 = Cross(c[0], right);
    const double scale = 1.0 / Dot(c[0], cross12);
    return { { scale * Dot(right, cross12), scale * Dot(c[2], cross0),
      scale * -Dot(c[1], cross0) } };
  }
};

/// A trilinear map from the cube [-1, 1]^3, times 8. Term[i] goes with the product of those
/// coordinates whose bits are set in i: Term[0] is the image of the middle, Term[1], [2], [4] the
/// half edges there.
struct TrilinearMap
{
  PaddedVector Term[8];

  TrilinearMap() = default;

  /// From the images of the corners: the bits of an index are set where a coordinate is 1. Sums and
  /// differences along the first coordinate, then along the second, then along the third.
  explicit TrilinearMap(const PaddedVector (&c)[8])
  {
    this->SetHalves(0, c[1] + c[0], c[3] + c[2], c[5] + c[4], c[7] + c[6]);
    this->SetHalves(1, c[1] - c[0], c[3] - c[2], c[5] - c[4], c[7] - c[6]);
  }

  PaddedVector At(const Vector3& u) const
  {
    const PaddedVector* c = this->Term;
    return c[0] + u[0] * c[1] + u[1] * (c[2] + u[0] * c[3]) +
      u[2] * (c[4] + u[0] * c[5] + u[1] * (c[6] + u[0] * c[7]));
  }

  Matrix3 Jacobian(const Vector3& u) const
  {
    const PaddedVector* c = this->Term;
    return { { c[1] + u[1] * c[3] + u[2] * (c[5] + u[1] * c[7]),
      c[2] + u[0] * c[3] + u[2] * (c[6] + u[0] * c[7]),
      c[4] + u[0] * c[5] + u[1] * (c[6] + u[0] * c[7]) } };
  }

  /// This map on the part of the cube with the given centre and half lengths.
  TrilinearMap Restricted(const Vector3& u, const Vector3& half) const
  {
    const PaddedVector* c = this->Term;
    const Matrix3 jacobian = this->Jacobian(u);
    TrilinearMap part;
    part.Term[0] = this->At(u);
    part.Term[1] = half[0] * jacobian.Columns[0];
    part.Term[2] = half[1] * jacobian.Columns[1];
    part.Term[4] = half[2] * jacobian.Columns[2];
    part.Term[3] = half[0] * half[1] * (c[3] + u[2] * c[7]);
    part.Term[5] = half[0] * half[2] * (c[5] + u[1] * c[7]);
    part.Term[6] = half[1] * half[2] * (c[6] + u[0] * c[7]);
    part.Term[7] = half[0] * half[1] * half[2] * c[7];
    return part;
  }

  /// Whether a coordinate of the image is nowhere in the cube zero to within rounding.
  bool IsApartFromZero(double rounding) const
  {
    const PaddedVector middle = Abs(this->Term[0]);
    const PaddedVector half = this->HalfExtent();
    return middle[0] > half[0] + rounding || middle[1] > half[1] + rounding ||
      middle[2] > half[2] + rounding;
  }

  /// No image of the cube has a greater coordinate.
  double Size() const { return MaxNorm(Abs(this->Term[0]) + this->HalfExtent()); }

private:
  void SetHalves(int index, const PaddedVector& c0, const PaddedVector& c1, const PaddedVector& c2,
    const PaddedVector& c3)
  {
    const PaddedVector bottom = c1 + c0;
    const PaddedVector top = c3 + c2;
    const PaddedVector bottomDifference = c1 - c0;
    const PaddedVector topDifference = c3 - c2;
    this->Term[index] = top + bottom;
    this->Term[index + 2] = topDifference + bottomDifference;
    this->Term[index + 4] = top - bottom;
    this->Term[index + 6] = topDifference - bottomDifference;
  }

  /// How far, by coordinate, images may be from that of the middle.
  PaddedVector HalfExtent() const
  {
    const PaddedVector* c = this->Term;
    return ((Abs(c[1]) + Abs(c[2])) + (Abs(c[4]) + Abs(c[3]))) +
      ((Abs(c[5]) + Abs(c[6])) + Abs(c[7]));
  }
};

}

#endif
