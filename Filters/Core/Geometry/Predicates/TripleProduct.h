// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Predicates_TripleProduct_h
#define skd_Predicates_TripleProduct_h

#include "../Vector.h"

namespace skd
{

/// An unevaluated sum of two doubles, with about 106 bits. Must be compiled without contraction of
/// products and sums into fused operations (-ffp-contract=off).
struct DoubleDouble
{
  double High;
  double Low;
};

/// The exact sum of two doubles.
inline DoubleDouble ExactSum(double a, double b)
{
  const double sum = a + b;
  const double partOfB = sum - a;
  return { sum, (a - (sum - partOfB)) + (b - partOfB) };
}

/// The exact product of two doubles.
inline DoubleDouble ExactProduct(double a, double b)
{
  const double product = a * b;
  return { product, std::fma(a, b, -product) };
}

inline DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b)
{
  const DoubleDouble high = ExactSum(a.High, b.High);
  const DoubleDouble low = ExactSum(a.Low, b.Low);
  const DoubleDouble sum = ExactSum(high.High, high.Low + low.High);
  return ExactSum(sum.High, sum.Low + low.Low);
}

inline DoubleDouble operator*(double a, const DoubleDouble& b)
{
  const DoubleDouble product = ExactProduct(a, b.High);
  return ExactSum(product.High, product.Low + a * b.Low);
}

inline DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b)
{
  const DoubleDouble product = ExactProduct(a.High, b.High);
  return ExactSum(product.High, product.Low + (a.High * b.Low + a.Low * b.High));
}

inline double TripleProduct(const Vector3& a, const Vector3& b, const Vector3& c)
{
  return Dot(a, Cross(b, c));
}

/// a . (b x c) with an error of at most about 1e-30 times the greatest of its products.
inline double AccurateTripleProduct(const Vector3& a, const Vector3& b, const Vector3& c)
{
  DoubleDouble sum{ 0.0, 0.0 };
  for (int i = 0; i < 3; ++i)
  {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    sum = sum + a[i] * (ExactProduct(b[j], c[k]) + ExactProduct(-b[k], c[j]));
  }
  return sum.High + sum.Low;
}

}

#endif
