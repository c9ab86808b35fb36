// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Curves_SeparatingQuadric_h
#define skd_Curves_SeparatingQuadric_h

#include "Preconditioner.h"
#include "Tolerances.h"

namespace skd
{

/// Tells curves, and a curve and a surface, apart that are curved alike, side by side, which no
/// plane between them does unless they are cut into very short parts: by a quadric in between.
///
/// g(x) = z - (L u^2 + 2 M u v + N v^2 + K z^2) / 2, (u, v, z) being x as seen from a point of one
/// of them, z along the normal and L, M, N its curvature there, is 0 on it but for terms of third
/// order; with K, the greater curvature, on circles, cylinders and spheres altogether. Where the
/// ranges that g takes on two things are apart, so are these. On a piece in Bernstein form g is a
/// quotient of such, of twice the degrees: its range is within that of the means, over i + j = k,
/// of g(x_i, x_j) with weights c_ij w_i w_j, g(x, y) being symmetric, linear in both, and g(x, x) =
/// g(x). (c_ij: binomial coefficients of i and j.)
class SeparatingQuadric
{
public:
  /// Of a curve at a point.
  explicit SeparatingQuadric(const CurvePoint& at)
    : Origin(at.X)
  {
    const double speed2 = Norm2(at.D1);
    const Vector3 curvature = at.D2 - (Dot(at.D2, at.D1) / speed2) * at.D1;
    const double size = Norm(curvature);
    this->Rows[0] = (1.0 / std::sqrt(speed2)) * at.D1;
    this->Rows[1] = Vector3{};
    this->Rows[2] = (1.0 / size) * curvature;
    this->L = this->K = this->Steepness = size / speed2;
    this->IsKnown = this->K > 0.0 && std::isfinite(this->K);
  }

  /// Of a patch in its middle, estimated by differences across it.
  explicit SeparatingQuadric(const BezierPatch& patch)
    : Origin(patch.At(0.5, 0.5).X)
  {
    const SurfacePoint at = patch.At(0.5, 0.5);
    const Vector3 normal = at.Normal();
    const InverseRows inverse(at.DR, at.DS, (1.0 / Norm(normal)) * normal);
    std::copy(inverse.Rows, inverse.Rows + 3, this->Rows);
    const auto height = [&](double r, double s)
    { return Dot(this->Rows[2], patch.At(r, s).X - this->Origin); };
    this->L = 4.0 * (height(0.0, 0.5) + height(1.0, 0.5));
    this->N = 4.0 * (height(0.5, 0.0) + height(0.5, 1.0));
    this->M = height(1.0, 1.0) - height(1.0, 0.0) - height(0.0, 1.0) + height(0.0, 0.0);
    // In space the curvatures are those of the form L a a + M (a b + b a) + N b b, a and b being
    // rows.
    const double aa = Norm2(this->Rows[0]);
    const double bb = Norm2(this->Rows[1]);
    const double ab = Dot(this->Rows[0], this->Rows[1]);
    const double sum = this->L * aa + 2.0 * this->M * ab + this->N * bb;
    const double product = (this->L * this->N - this->M * this->M) * (aa * bb - ab * ab);
    const double half = std::sqrt(std::max(0.0, 0.25 * sum * sum - product));
    this->K = 0.5 * sum + (sum > 0.0 ? half : -half);
    this->Steepness = std::abs(this->K);
    this->IsKnown = inverse.IsRegular && this->Steepness > 0.0 && std::isfinite(this->K);
  }

  ///@{
  /// Whether both are certainly farther apart than the tolerance. Both in the hulls of their
  /// points.
  bool Separates(const BezierCurve& first, const BezierCurve& second, double tolerance) const
  {
    return this->IsKnown &&
      this->AreApart(this->RangeOn(first.Points, first.Degree, 0),
        this->RangeOn(second.Points, second.Degree, 0), tolerance);
  }
  bool Separates(const BezierCurve& curve, const BezierPatch& patch, double tolerance) const
  {
    return this->IsKnown &&
      this->AreApart(this->RangeOn(curve.Points, curve.Degree, 0),
        this->RangeOn(patch.Points, patch.DegreeR, patch.DegreeS), tolerance);
  }
  ///@}

private:
  struct Range
  {
    Extent Values;
    double Size; ///< how far the control points are from the point
  };

  bool AreApart(const Range& a, const Range& b, double tolerance) const
  {
    const double extent = std::max(a.Size, b.Size);
    const double steepest = 1.0 + 2.0 * this->Steepness * extent; // of g, within the extent
    return a.Values.IsApart(b.Values, (tolerance + tolerances::SumOfTen * extent) * steepest);
  }

  static void Choose(int degree, double* choose)
  {
    choose[0] = 1.0;
    for (int i = 0; i < degree; ++i)
    {
      choose[i + 1] = choose[i] * (degree - i) / (i + 1);
    }
  }

  double Value(const Vector3& x, const Vector3& y) const
  {
    return 0.5 *
      (x[2] + y[2] - this->L * x[0] * y[0] - this->M * (x[0] * y[1] + x[1] * y[0]) -
        this->N * x[1] * y[1] - this->K * x[2] * y[2]);
  }

  /// Of the points of a patch of degrees p and q, p running first; of a curve q is 0.
  Range RangeOn(const Homogeneous* points, int p, int q) const
  {
    constexpr int most = MaximumDegree + 1;
    Vector3 scaled[most * most];
    double weights[most * most];
    double chooseP[most];
    double chooseQ[most];
    Choose(p, chooseP);
    Choose(q, chooseQ);
    const int size = (p + 1) * (q + 1);
    Range range{ {}, 0.0 };
    for (int i = 0; i < size; ++i)
    {
      const Vector3 x = Projected(points[i]) - this->Origin;
      scaled[i] = { { Dot(this->Rows[0], x), Dot(this->Rows[1], x), Dot(this->Rows[2], x) } };
      weights[i] = chooseP[i % (p + 1)] * chooseQ[i / (p + 1)] * points[i][3];
      range.Size = std::max(range.Size, Norm(x));
    }
    constexpr int twice = 2 * MaximumDegree + 1;
    double sums[twice * twice] = {};
    double parts[twice * twice] = {};
    for (int i = 0; i < size; ++i)
    {
      for (int j = 0; j < size; ++j)
      {
        const int k = i % (p + 1) + j % (p + 1) + (i / (p + 1) + j / (p + 1)) * (2 * p + 1);
        parts[k] += weights[i] * weights[j];
        sums[k] += weights[i] * weights[j] * this->Value(scaled[i], scaled[j]);
      }
    }
    for (int k = 0; k < (2 * p + 1) * (2 * q + 1); ++k)
    {
      range.Values.Add(sums[k] / parts[k]);
    }
    return range;
  }

  Vector3 Origin;
  Vector3 Rows[3]; ///< what takes x to u, v and z
  double L = 0.0;
  double M = 0.0;
  double N = 0.0;
  double K = 0.0;
  double Steepness = 0.0; ///< the greatest curvature
  bool IsKnown = false;
};

}

#endif
