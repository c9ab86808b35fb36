// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Signs of determinants of coordinates, exact: on which side of a plane is a point, how do two
/// lines pass each other.
///
/// A floating-point value decides where it is larger than its error can be; else the products are
/// summed without rounding: J. R. Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast
/// Robust Geometric Predicates", Discrete & Computational Geometry 18 (1997) 305-363. Exact as long
/// as no product under- or overflows: coordinates of 1e-90 to 1e90 (and 0). NaN gives 0. Must be
/// compiled without contraction (-ffp-contract=off).
#ifndef skd_Geometry_ExactOrientation_h
#define skd_Geometry_ExactOrientation_h

#include "TripleProduct.h"

namespace skd
{

/// A sum of doubles and of products of them, without rounding.
class ExactAccumulator
{
public:
  void Add(double term)
  {
    int kept = 0;
    for (int i = 0; i < this->Size; ++i)
    {
      const DoubleDouble sum = ExactSum(term, this->Terms[i]);
      term = sum.High;
      if (sum.Low != 0.0)
      {
        this->Terms[kept++] = sum.Low;
      }
    }
    if (term != 0.0)
    {
      this->Terms[kept++] = term;
    }
    this->Size = kept;
  }

  void AddProduct(double a, double b)
  {
    const DoubleDouble product = ExactProduct(a, b);
    this->Add(product.Low);
    this->Add(product.High);
  }

  void AddProduct(double a, double b, double c)
  {
    const DoubleDouble product = ExactProduct(a, b);
    this->AddProduct(product.Low, c);
    this->AddProduct(product.High, c);
  }

  /// (b - a) (d - c)
  void AddProductOfDifferences(double a, double b, double c, double d)
  {
    this->AddProduct(b, d);
    this->AddProduct(-b, c);
    this->AddProduct(-a, d);
    this->AddProduct(a, c);
  }

  /// a . (b x c)
  void AddTripleProduct(const Vector3& a, const Vector3& b, const Vector3& c)
  {
    for (int i = 0; i < 3; ++i)
    {
      const int j = (i + 1) % 3;
      const int k = (i + 2) % 3;
      this->AddProduct(a[i], b[j], c[k]);
      this->AddProduct(-a[i], b[k], c[j]);
    }
  }

  /// The last term is larger than all others together.
  int Sign() const
  {
    const double last = this->Size > 0 ? this->Terms[this->Size - 1] : 0.0;
    return last > 0.0 ? 1 : (last < 0.0 ? -1 : 0);
  }

private:
  static constexpr int Capacity = 128; // 24 products of three make 96 terms at most
  double Terms[Capacity];
  int Size = 0;
};

/// The sign of (a - d) . ((b - d) x (c - d)): positive where a, b, c turn clockwise seen from d.
inline int Orientation(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d)
{
  const Vector3 u = a - d;
  const Vector3 v = b - d;
  const Vector3 w = c - d;
  double value = 0.0;
  double size = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    const double left = v[(i + 1) % 3] * w[(i + 2) % 3];
    const double right = v[(i + 2) % 3] * w[(i + 1) % 3];
    value += u[i] * (left - right);
    size += std::abs(u[i]) * (std::abs(left) + std::abs(right));
  }
  constexpr double enough = 1e-15; // 7.8e-16 and some: Shewchuk's bound
  if (std::abs(value) > enough * size)
  {
    return value > 0.0 ? 1 : -1;
  }
  if (!IsFinite(u) || !IsFinite(v) || !IsFinite(w))
  {
    return 0;
  }
  ExactAccumulator sum;
  sum.AddTripleProduct(a, b, c);
  sum.AddTripleProduct(-1.0 * d, b, c);
  sum.AddTripleProduct(a, -1.0 * d, c);
  sum.AddTripleProduct(a, b, -1.0 * d);
  return sum.Sign();
}

/// The sign of component `axis` of (b - a) x (d - c).
inline int SignOfCross(
  const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d, int axis)
{
  const int j = (axis + 1) % 3;
  const int k = (axis + 2) % 3;
  const double left = (b[j] - a[j]) * (d[k] - c[k]);
  const double right = (b[k] - a[k]) * (d[j] - c[j]);
  constexpr double enough = 1e-15;
  if (std::abs(left - right) > enough * (std::abs(left) + std::abs(right)))
  {
    return left > right ? 1 : -1;
  }
  ExactAccumulator sum;
  sum.AddProductOfDifferences(a[j], b[j], c[k], d[k]);
  sum.AddProductOfDifferences(b[k], a[k], c[j], d[j]);
  return sum.Sign();
}

/// The sign of ((b - a) x (d - c)) . (e, e^2, e^3) for any e > 0 that is small enough: 0 only when
/// the two directions are parallel.
inline int SignOfCrossAlongMove(
  const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (const int sign = SignOfCross(a, b, c, d, axis))
    {
      return sign;
    }
  }
  return 0;
}

}

#endif
