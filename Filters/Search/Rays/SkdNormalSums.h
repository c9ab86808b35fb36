// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdNormalSums_h
#define SkdNormalSums_h

#include "Core/Geometry/Vector.h"
#include "vtkType.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace skdtree
{
/// Sums of unit normals times angles at points, which are the same in whatever order they are
/// added: the order of cells depends on how a mesh is divided among processes, and rays along
/// normals that differ by rounding may hit different cells. Each summand is split into two parts,
/// multiples of powers of two that depend on the point's largest angle, so that sums of either are
/// not rounded: J. Demmel, H. D. Nguyen, "Parallel reproducible summation", IEEE Transactions on
/// Computers 64 (2015) 2060-2070. Of up to 2^27 summands a point.
class SkdNormalSums
{
public:
  explicit SkdNormalSums(vtkIdType points)
    : Sums(static_cast<std::size_t>(points))
  {
  }

  /// To be called for all angles before the first normal is added.
  void Expect(vtkIdType point, double angle)
  {
    if (angle > 0.0 && std::isfinite(angle))
    {
      int& exponent = this->Sums[static_cast<std::size_t>(point)].Exponent;
      exponent = std::max(exponent, std::ilogb(angle) + 2); // one more than that: for rounding
    }
  }

  void Add(vtkIdType point, double angle, const skd::Vector3& normal)
  {
    Sum& sum = this->Sums[static_cast<std::size_t>(point)];
    for (int axis = 0; axis < 3 && sum.Exponent > None; ++axis)
    {
      const double value = angle * normal[axis];
      const double high = Rounded(value, sum.Exponent - Bits);
      sum.High[axis] += high;
      sum.Low[axis] += Rounded(value - high, sum.Exponent - 2 * Bits);
    }
  }

  skd::Vector3 Get(vtkIdType point) const
  {
    const Sum& sum = this->Sums[static_cast<std::size_t>(point)];
    return sum.High + sum.Low;
  }

private:
  static constexpr int Bits = 26;
  static constexpr int None = std::numeric_limits<int>::min();

  struct Sum
  {
    int Exponent = None; // of a power of two larger than all summands
    skd::Vector3 High{ { 0.0, 0.0, 0.0 } };
    skd::Vector3 Low{ { 0.0, 0.0, 0.0 } };
  };

  /// The nearest multiple of a power of two: the last place of a number that is large enough.
  static double Rounded(double value, int exponent)
  {
    const double large = std::ldexp(1.5, exponent + std::numeric_limits<double>::digits - 1);
    return (value + large) - large;
  }

  std::vector<Sum> Sums;
};
}

#endif
