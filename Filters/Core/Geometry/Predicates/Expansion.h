// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Exact numbers as sums of doubles: J. R. Shewchuk, "Adaptive Precision Floating-Point Arithmetic
/// and Fast Robust Geometric Predicates", Discrete & Computational Geometry 18 (1997) 305-363. Must
/// be compiled without contraction of products and sums into fused operations (-ffp-contract=off).
/// Exact as long as nothing over- or underflows.
#ifndef skd_Predicates_Expansion_h
#define skd_Predicates_Expansion_h

#include "TripleProduct.h"

#include <cmath>

namespace skd
{

/// The exact sum of at most N doubles that do not overlap, by growing magnitude, none of them 0.
template <int N>
class Expansion
{
public:
  Expansion() {} // the parts stay as they are: most are never used

  /// The exact a - b.
  static Expansion Difference(double a, double b)
  {
    static_assert(N >= 2, "a difference needs two doubles");
    const DoubleDouble difference = ExactSum(a, -b);
    Expansion expansion;
    expansion.Append(difference.Low);
    expansion.Append(difference.High);
    return expansion;
  }

  int Size() const { return this->Count; }
  double operator[](int i) const { return this->Parts[i]; }

  /// Parts come by growing magnitude.
  void Append(double part)
  {
    if (part != 0.0)
    {
      this->Parts[this->Count++] = part;
    }
  }

  /// -1, 0 or 1: the greatest part outweighs all others.
  int Sign() const
  {
    const double greatest = this->Count > 0 ? this->Parts[this->Count - 1] : 0.0;
    return (greatest > 0.0) - (greatest < 0.0);
  }

  /// The number, rounded: to about one unit in the last place.
  double Value() const
  {
    double sum = 0.0;
    for (int i = 0; i < this->Count; ++i)
    {
      sum += this->Parts[i];
    }
    return sum;
  }

  Expansion operator-() const
  {
    Expansion negated = *this;
    for (int i = 0; i < this->Count; ++i)
    {
      negated.Parts[i] = -this->Parts[i];
    }
    return negated;
  }

private:
  double Parts[N];
  int Count = 0;
};

/// The exact sum: the parts of both, merged by magnitude and added up (Shewchuk, Figure 8).
template <int N, int M>
Expansion<N + M> operator+(const Expansion<N>& a, const Expansion<M>& b)
{
  Expansion<N + M> sum;
  int atA = 0;
  int atB = 0;
  double carry = 0.0;
  while (atA < a.Size() || atB < b.Size())
  {
    const bool takesA = atB == b.Size() || (atA < a.Size() && std::abs(a[atA]) < std::abs(b[atB]));
    const DoubleDouble grown = ExactSum(carry, takesA ? a[atA++] : b[atB++]);
    sum.Append(grown.Low);
    carry = grown.High;
  }
  sum.Append(carry);
  return sum;
}

template <int N, int M>
Expansion<N + M> operator-(const Expansion<N>& a, const Expansion<M>& b)
{
  return a + (-b);
}

/// The exact product with one double (Shewchuk, Figure 13).
template <int N>
Expansion<2 * N> operator*(double factor, const Expansion<N>& a)
{
  Expansion<2 * N> product;
  double carry = 0.0;
  for (int i = 0; i < a.Size(); ++i)
  {
    const DoubleDouble part = ExactProduct(factor, a[i]);
    const DoubleDouble low = ExactSum(carry, part.Low);
    const DoubleDouble high = ExactSum(part.High, low.High);
    product.Append(low.Low);
    product.Append(high.Low);
    carry = high.High;
  }
  product.Append(carry);
  return product;
}

/// The exact product with a difference of two doubles.
template <int N>
Expansion<4 * N> operator*(const Expansion<2>& a, const Expansion<N>& b)
{
  const Expansion<2 * N> none;
  return (a.Size() > 0 ? a[0] * b : none) + (a.Size() > 1 ? a[1] * b : none);
}

}

#endif
