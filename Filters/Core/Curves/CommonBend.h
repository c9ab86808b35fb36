// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Curves_CommonBend_h
#define skd_Curves_CommonBend_h

#include "Preconditioner.h"

namespace skd
{

/// Tells curves apart that bend alike, side by side, which no plane between them does unless they
/// are cut into very short parts: by a cylinder in between.
///
/// g(x) = n.x - bend (|x|^2 - (b.x)^2) / 2, with x from a place of a curve, n its normal there and
/// b what is across both it and the curve, is 0 on the cylinder around its circle of curvature.
/// Where the ranges that g takes on two curves are apart, so are the curves. On a piece in
/// Bernstein form g is a quotient of such, of twice the degree: its range is within that of
///   sum of c_ij w_i w_j g(x_i, x_j) / sum of c_ij w_i w_j over i + j = k,
/// g(x, y) being symmetric, linear in both, and g(x, x) = g(x); c_ij = (d over i) (d over j).
class CommonBend
{
public:
  /// The bend of a curve at a place.
  explicit CommonBend(const CurvePoint& at)
    : Origin(at.X)
  {
    const double speed2 = Norm2(at.D1);
    const Vector3 bend = at.D2 - (Dot(at.D2, at.D1) / speed2) * at.D1;
    const double size = Norm(bend);
    this->Bend = size / speed2;
    this->IsKnown = this->Bend > 0.0 && std::isfinite(this->Bend);
    this->Along = (1.0 / std::sqrt(speed2)) * at.D1;
    this->Normal = (1.0 / size) * bend;
  }

  /// Whether both are certainly farther apart than the tolerance. Both in the hulls of their
  /// points.
  bool Separates(const BezierCurve& first, const BezierCurve& second, double tolerance) const
  {
    if (!this->IsKnown)
    {
      return false;
    }
    double reach = 0.0;
    const Extent a = this->RangeOn(first, reach);
    const Extent b = this->RangeOn(second, reach);
    constexpr double rounding = 4e-15;                // of sums of up to eleven terms
    const double steepest = 1.0 + this->Bend * reach; // of g, within reach
    return a.IsApart(b, (tolerance + rounding * reach) * steepest);
  }

private:
  Extent RangeOn(const BezierCurve& curve, double& reach) const
  {
    double along[MaximumDegree + 1];
    double across[MaximumDegree + 1];
    for (int i = 0; i <= curve.Degree; ++i)
    {
      const Vector3 x = curve.Control(i) - this->Origin;
      along[i] = Dot(this->Along, x);
      across[i] = Dot(this->Normal, x);
      reach = std::max(reach, Norm(x));
    }
    double choose[MaximumDegree + 1];
    choose[0] = 1.0;
    for (int i = 0; i < curve.Degree; ++i)
    {
      choose[i + 1] = choose[i] * (curve.Degree - i) / (i + 1);
    }
    double sums[2 * MaximumDegree + 1] = {};
    double weights[2 * MaximumDegree + 1] = {};
    for (int i = 0; i <= curve.Degree; ++i)
    {
      for (int j = 0; j <= curve.Degree; ++j)
      {
        const double weight = choose[i] * choose[j] * curve.Points[i][3] * curve.Points[j][3];
        weights[i + j] += weight;
        sums[i + j] += weight *
          (0.5 * (across[i] + across[j]) -
            0.5 * this->Bend * (along[i] * along[j] + across[i] * across[j]));
      }
    }
    Extent extent;
    for (int k = 0; k <= 2 * curve.Degree; ++k)
    {
      extent.Add(sums[k] / weights[k]);
    }
    return extent;
  }

  Vector3 Origin;
  Vector3 Along;
  Vector3 Normal;
  double Bend;
  bool IsKnown;
};

}

#endif
