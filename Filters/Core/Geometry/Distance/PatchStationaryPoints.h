// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_Distance_PatchStationaryPoints_h
#define skd_Geometry_Distance_PatchStationaryPoints_h

#include "BernsteinRoots.h"
#include "PatchView.h"

namespace skd
{

/// A quadratic polynomial by its Bernstein coefficients on [0, 1].
struct Quadratic
{
  double C[3];

  double operator()(double t) const
  {
    const double rest = 1.0 - t;
    return rest * rest * this->C[0] + 2.0 * t * rest * this->C[1] + t * t * this->C[2];
  }
};

/// A patch is swept by the lines L(s) along r. With A(s) the product of the vector to the line's
/// start with its direction, B(s) and E(s) the squares of the two, x is B - A A / E from the line,
/// squared. That is stationary where the quintic B' E E - 2 A A' E + A A E' is zero.
struct LinesOfPatch
{
  Quadratic A;
  Quadratic B;
  Quadratic E;

  explicit LinesOfPatch(const PatchView& view)
  {
    const Vector3 lastF = view.F + view.V;
    const Vector3 lastU = view.U + view.W;
    // Lengths relative to their sum: sixth powers neither over- nor underflow.
    const double scale = 1.0 / (Norm2(view.F) + Norm2(lastF) + Norm2(view.U) + Norm2(lastU));
    this->A = Product(view.F, lastF, view.U, lastU, scale);
    this->B = Product(view.F, lastF, view.F, lastF, scale);
    this->E = Product(view.U, lastU, view.U, lastU, scale);
  }

  BernsteinPolynomial<5> Stationary() const
  {
    BernsteinPolynomial<5> sum{ { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 } };
    Add(this->B, this->E, this->E, 1.0, sum);
    Add(this->A, this->A, this->E, -2.0, sum);
    Add(this->E, this->A, this->A, 1.0, sum);
    return sum;
  }

private:
  /// The product of two vectors that run linearly from p to q and from u to v.
  static Quadratic Product(
    const Vector3& p, const Vector3& q, const Vector3& u, const Vector3& v, double scale)
  {
    return { { scale * Dot(p, u), 0.5 * scale * (Dot(p, v) + Dot(q, u)), scale * Dot(q, v) } };
  }

  /// sum += factor x' y z.
  static void Add(const Quadratic& x, const Quadratic& y, const Quadratic& z, double factor,
    BernsteinPolynomial<5>& sum)
  {
    static constexpr double binomials2[3] = { 1.0, 2.0, 1.0 };
    static constexpr double binomials5[6] = { 1.0, 5.0, 10.0, 10.0, 5.0, 1.0 };
    const double slope[2] = { 2.0 * (x.C[1] - x.C[0]), 2.0 * (x.C[2] - x.C[1]) };
    for (int i = 0; i < 2; ++i)
    {
      for (int j = 0; j < 3; ++j)
      {
        for (int k = 0; k < 3; ++k)
        {
          sum.Coefficients[i + j + k] += factor * slope[i] * binomials2[j] * y.C[j] *
            binomials2[k] * z.C[k] / binomials5[i + j + k];
        }
      }
    }
  }
};

/// Calls visit(parameters) for every point inside the patch where the distance from x may be least.
template <class Visit>
void VisitStationaryPoints(const PatchView& view, Visit&& visit)
{
  const LinesOfPatch lines(view);
  const auto visitLine = [&](double s)
  {
    const double r = -lines.A(s) / lines.E(s);
    if (r > 0.0 && r < 1.0)
    {
      visit(PatchParameters{ r, s });
    }
  };
  VisitRisingRoots(lines.Stationary(), visitLine);
}

}

#endif
