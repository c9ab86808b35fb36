// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Where a segment crosses the bilinear patch of four points (VTK's order): the face of a
/// hexahedron as it is, warped or not. Seen along the segment a patch is a quadratic in one of its
/// parameters.
#ifndef skd_Geometry_Intersection_SegmentPatch_h
#define skd_Geometry_Intersection_SegmentPatch_h

#include "../Tolerances.h"
#include "SegmentTriangle.h"

#include <algorithm>

namespace skd
{

/// The parameters along the segment, ascending.
struct PatchHits
{
  int Count = 0;
  double T[2];
};

namespace detail
{

/// A patch seen along a segment: P + r U + s V + r s W, each of (across, across, along).
struct ShearedPatch
{
  double P[3], U[3], V[3], W[3];

  ShearedPatch(const SegmentView& view, const Vector3* points)
  {
    const Sheared sheared[4] = { view.See(points[0]), view.See(points[1]), view.See(points[2]),
      view.See(points[3]) };
    for (int axis = 0; axis < 3; ++axis)
    {
      double x[4];
      for (int i = 0; i < 4; ++i)
      {
        x[i] = axis == 0 ? sheared[i].X : (axis == 1 ? sheared[i].Y : sheared[i].Z);
      }
      this->P[axis] = x[0];
      this->U[axis] = x[1] - x[0];
      this->V[axis] = x[3] - x[0];
      this->W[axis] = (x[2] - x[1]) - this->V[axis];
    }
  }

  double At(int axis, double r, double s) const
  {
    return this->P[axis] + r * this->U[axis] + s * (this->V[axis] + r * this->W[axis]);
  }

  /// r where the segment is on the ruling of s: NaN when that is seen end to end.
  double RulingParameter(double s) const
  {
    const double x = this->U[0] + s * this->W[0];
    const double y = this->U[1] + s * this->W[1];
    return std::abs(x) > std::abs(y) ? -(this->P[0] + s * this->V[0]) / x
                                     : -(this->P[1] + s * this->V[1]) / y;
  }

  /// One step of Newton's method, unless there is none.
  void Polish(double& r, double& s) const
  {
    const double x = this->At(0, r, s);
    const double y = this->At(1, r, s);
    const double xr = this->U[0] + s * this->W[0];
    const double yr = this->U[1] + s * this->W[1];
    const double xs = this->V[0] + r * this->W[0];
    const double ys = this->V[1] + r * this->W[1];
    const double determinant = xr * ys - xs * yr;
    const double stepR = (x * ys - y * xs) / determinant;
    const double stepS = (y * xr - x * yr) / determinant;
    if (std::abs(stepR) < tolerances::PolishStep && std::abs(stepS) < tolerances::PolishStep)
    {
      r -= stepR;
      s -= stepS;
    }
  }
};

/// The real roots of a x^2 + b x + c; a root at infinity is infinite or NaN.
struct QuadraticRoots
{
  double X[2];

  QuadraticRoots(double a, double b, double c)
  {
    const double discriminant = b * b - 4.0 * a * c;
    const bool isDouble = discriminant < 0.0 && discriminant >= -tolerances::DoubleRoot * b * b;
    const double root = isDouble ? 0.0 : std::sqrt(discriminant); // NaN when there are none
    const double q = -0.5 * (b + std::copysign(root, b));
    this->X[0] = q / a;
    this->X[1] = c / q;
  }
};

}

/// The crossings of a segment and a patch, edges included, to within 1e-9 of the patch's size
/// beyond them. A patch that the segment runs within is not hit.
inline PatchHits IntersectPatch(const SegmentView& view, const Vector3* points)
{
  constexpr double Slack = tolerances::BesidePatch;
  const detail::ShearedPatch patch(view, points);
  const double *p = patch.P, *u = patch.U, *v = patch.V, *w = patch.W;
  const detail::QuadraticRoots roots(v[0] * w[1] - v[1] * w[0],
    (p[0] * w[1] - p[1] * w[0]) + (v[0] * u[1] - v[1] * u[0]), p[0] * u[1] - p[1] * u[0]);
  PatchHits hits;
  for (double s : roots.X)
  {
    double r = patch.RulingParameter(s);
    patch.Polish(r, s);
    if (r >= -Slack && r <= 1.0 + Slack && s >= -Slack && s <= 1.0 + Slack)
    {
      const auto t = view.Accept(patch.At(2, std::clamp(r, 0.0, 1.0), std::clamp(s, 0.0, 1.0)));
      if (t)
      {
        hits.T[hits.Count++] = *t;
      }
    }
  }
  if (hits.Count == 2 && hits.T[1] < hits.T[0])
  {
    std::swap(hits.T[0], hits.T[1]);
  }
  return hits;
}

}

#endif
