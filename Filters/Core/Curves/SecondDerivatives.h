// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Bounds of the second derivatives of curves and patches: what a chord of a length h in parameters
/// departs from the curve is at most such a bound times h^2 / 8.
#ifndef skd_Curves_SecondDerivatives_h
#define skd_Curves_SecondDerivatives_h

#include "BezierPatch.h"

#include <limits>

namespace skd
{

/// Of the control points of a curve or of all rows of a patch: how large the points, their first
/// and their second differences are, in space and as weights.
struct DerivativeBounds
{
  double Size = 0.0;
  double Slope = 0.0;
  double Second = 0.0;
  double WeightSlope = 0.0;
  double WeightSecond = 0.0;
  double LeastWeight = std::numeric_limits<double>::infinity();

  void AddRow(const Homogeneous* points, int degree, int stride)
  {
    for (int i = 0; i <= degree; ++i)
    {
      const Homogeneous& at = points[i * stride];
      this->LeastWeight = std::min(this->LeastWeight, at[3]);
      this->Size = std::max(this->Size, Norm(Projected(at)));
      if (i > 0)
      {
        const Homogeneous d = double(degree) * (at - points[(i - 1) * stride]);
        this->Slope = std::max(this->Slope, Norm(Space(d)));
        this->WeightSlope = std::max(this->WeightSlope, std::abs(d[3]));
      }
      if (i > 1)
      {
        const Homogeneous before = points[(i - 1) * stride] - points[(i - 2) * stride];
        const Homogeneous d =
          double(degree * (degree - 1)) * ((at - points[(i - 1) * stride]) - before);
        this->Second = std::max(this->Second, Norm(Space(d)));
        this->WeightSecond = std::max(this->WeightSecond, std::abs(d[3]));
      }
    }
  }

  /// Of x = P / w: x' = (P' - w' x) / w, and x'' = (P'' - 2 w' x' - w'' x) / w.
  double FirstOfX() const
  {
    return (this->Slope + this->WeightSlope * this->Size) / this->LeastWeight;
  }
  double SecondOfX() const
  {
    return (this->Second + 2.0 * this->WeightSlope * this->FirstOfX() +
             this->WeightSecond * this->Size) /
      this->LeastWeight;
  }
};

/// Whether halves have to be looked at: their control points are nearer to them. Of polynomials of
/// degree 2 nothing is gained.
inline bool AreBoundsLoose(int degree, bool isRational)
{
  return degree > 2 || isRational;
}

/// The largest second derivative of a curve whose weights are positive, by its parts: halved
/// `halvings` times.
inline double SecondDerivative(const BezierCurve& curve, int halvings = 3)
{
  if (halvings > 0 && AreBoundsLoose(curve.Degree, curve.IsRational()))
  {
    return 4.0 *
      std::max(SecondDerivative(curve.Restricted(0.0, 0.5), halvings - 1),
        SecondDerivative(curve.Restricted(0.5, 1.0), halvings - 1));
  }
  DerivativeBounds bounds;
  bounds.AddRow(curve.Points, curve.Degree, 1);
  return bounds.SecondOfX();
}

/// Those of a patch, along r, along s, and mixed.
struct PatchDerivatives
{
  double RR;
  double SS;
  double RS;
};

/// Of the patch as it is, by its control points.
inline PatchDerivatives SecondDerivativesOfWhole(const BezierPatch& patch)
{
  DerivativeBounds alongR;
  DerivativeBounds alongS;
  for (int j = 0; j <= patch.DegreeS; ++j)
  {
    alongR.AddRow(&patch.Point(0, j), patch.DegreeR, 1);
  }
  for (int i = 0; i <= patch.DegreeR; ++i)
  {
    alongS.AddRow(&patch.Point(i, 0), patch.DegreeS, patch.DegreeR + 1);
  }
  double twist = 0.0;
  double weightTwist = 0.0;
  for (int j = 0; j < patch.DegreeS; ++j)
  {
    for (int i = 0; i < patch.DegreeR; ++i)
    {
      const Homogeneous d = double(patch.DegreeR * patch.DegreeS) *
        ((patch.Point(i + 1, j + 1) - patch.Point(i, j + 1)) -
          (patch.Point(i + 1, j) - patch.Point(i, j)));
      twist = std::max(twist, Norm(Space(d)));
      weightTwist = std::max(weightTwist, std::abs(d[3]));
    }
  }
  const double mixed = (twist + alongR.WeightSlope * alongS.FirstOfX() +
                         alongS.WeightSlope * alongR.FirstOfX() + weightTwist * alongR.Size) /
    alongR.LeastWeight;
  return { alongR.SecondOfX(), alongS.SecondOfX(), mixed };
}

/// The largest over a patch whose weights are positive, of a triangle over the part that counts, by
/// its parts: quartered `halvings` times.
inline PatchDerivatives SecondDerivatives(
  const BezierPatch& patch, int halvings = 2, double r = 0.0, double s = 0.0, double size = 1.0)
{
  if (patch.IsTriangle && r + s >= 1.0)
  {
    return { 0.0, 0.0, 0.0 };
  }
  if (halvings == 0 || !AreBoundsLoose(std::max(patch.DegreeR, patch.DegreeS), patch.IsRational()))
  {
    return SecondDerivativesOfWhole(patch);
  }
  BezierPatch parts[4];
  parts[0] = patch;
  parts[1] = parts[0].SplitOffR();
  parts[2] = parts[0].SplitOffS();
  parts[3] = parts[1].SplitOffS();
  PatchDerivatives most{ 0.0, 0.0, 0.0 };
  for (int i = 0; i < 4; ++i)
  {
    const double half = 0.5 * size;
    const PatchDerivatives part =
      SecondDerivatives(parts[i], halvings - 1, r + half * (i & 1), s + half * (i >> 1), half);
    most = { std::max(most.RR, 4.0 * part.RR), std::max(most.SS, 4.0 * part.SS),
      std::max(most.RS, 4.0 * part.RS) };
  }
  return most;
}

}

#endif
