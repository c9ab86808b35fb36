// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Curves_CurvePatchContraction_h
#define skd_Curves_CurvePatchContraction_h

#include "CurvePatchCell.h"

namespace skd
{

/// Curve less patch, without a division: F = w(patch) curve - w(curve) patch is a polynomial of
/// (t, r, s), and so are its derivatives, whose Bernstein coefficients are visited here.
class CurvePatchDerivatives
{
public:
  explicit CurvePatchDerivatives(const CurvePatchCell& cell)
    : Curve(cell.Curve)
    , Patch(cell.Patch)
    , IsRational(cell.Curve.IsRational() || cell.Patch.IsRational())
  {
  }

  /// visit(axis, coefficient) for each of dF/dt, dF/dr and dF/ds: O(degrees), rational ones
  /// O(product of all degrees).
  template <class Visit>
  void ForEach(Visit visit) const
  {
    const int p = this->Patch.DegreeR;
    const int q = this->Patch.DegreeS;
    const int others = this->IsRational ? this->Patch.Size() : 1;
    for (int k = 0; k < this->Curve.Degree; ++k)
    {
      const Homogeneous step = this->Curve.Points[k + 1] - this->Curve.Points[k];
      for (int other = 0; other < others; ++other)
      {
        visit(0, double(this->Curve.Degree) * Combined(step, this->Patch.Points[other]));
      }
    }
    for (int j = 0; j <= q; ++j)
    {
      for (int i = 0; i <= p; ++i)
      {
        if (i < p)
        {
          this->VisitStep(1, p, this->Patch.Point(i + 1, j) - this->Patch.Point(i, j), visit);
        }
        if (j < q)
        {
          this->VisitStep(2, q, this->Patch.Point(i, j + 1) - this->Patch.Point(i, j), visit);
        }
      }
    }
  }

private:
  static Vector3 Combined(const Homogeneous& curve, const Homogeneous& patch)
  {
    return patch[3] * Space(curve) - curve[3] * Space(patch);
  }

  template <class Visit>
  void VisitStep(int axis, int degree, const Homogeneous& step, Visit& visit) const
  {
    const int others = this->IsRational ? this->Curve.Degree + 1 : 1;
    for (int other = 0; other < others; ++other)
    {
      visit(axis, double(degree) * Combined(this->Curve.Points[other], step));
    }
  }

  const BezierCurve& Curve;
  const BezierPatch& Patch;
  bool IsRational;
};

/// The mean of the derivatives' coefficients: a Jacobian from about the middle.
inline InverseRows MeanInverse(const CurvePatchDerivatives& derivatives)
{
  Vector3 sums[3] = {};
  int counts[3] = {};
  derivatives.ForEach(
    [&](int axis, const Vector3& coefficient)
    {
      sums[axis] = sums[axis] + coefficient;
      ++counts[axis];
    });
  return InverseRows(
    (1.0 / counts[0]) * sums[0], (1.0 / counts[1]) * sums[1], (1.0 / counts[2]) * sums[2]);
}

/// Krawczyk's test of a cell, in its own parameters.
inline Contraction<3> ContractionOf(const CurvePatchCell& cell, double tolerance)
{
  const CurvePatchDerivatives derivatives(cell);
  const InverseRows inverse = MeanInverse(derivatives);
  Contraction<3> contraction{};
  if (!inverse.IsRegular)
  {
    std::fill(contraction.Spread, contraction.Spread + 3, std::numeric_limits<double>::infinity());
    return contraction;
  }
  double most[3][3] = {};
  derivatives.ForEach(
    [&](int axis, const Vector3& coefficient)
    {
      for (int i = 0; i < 3; ++i)
      {
        const double off = std::abs(Dot(inverse.Rows[i], coefficient) - (i == axis ? 1.0 : 0.0));
        most[i][axis] = std::max(most[i][axis], off);
      }
    });
  const Homogeneous curve = cell.Curve.WeightedAt(0.5);
  const Homogeneous patch = cell.Patch.WeightedAt(0.5, 0.5);
  const Vector3 value = patch[3] * Space(curve) - curve[3] * Space(patch);
  for (int i = 0; i < 3; ++i)
  {
    contraction.Step[i] = -Dot(inverse.Rows[i], value);
    contraction.Spread[i] = most[i][0] + most[i][1] + most[i][2];
    contraction.Slack[i] = tolerance * curve[3] * patch[3] * Norm(inverse.Rows[i]);
  }
  return contraction;
}

}

#endif
