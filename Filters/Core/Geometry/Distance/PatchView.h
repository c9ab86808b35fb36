// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_Distance_PatchView_h
#define skd_Geometry_Distance_PatchView_h

#include "../Tolerances.h"
#include "ClosestPointOnTriangle.h"

#include <algorithm>
#include <limits>

namespace skd
{

/// The parameters of a point on a patch, in [0, 1] x [0, 1].
struct PatchParameters
{
  double R;
  double S;
};

/// A bilinear patch as seen from a point x: F + r U + s V + r s W, relative to x.
struct PatchView
{
  Vector3 F;
  Vector3 U;
  Vector3 V;
  Vector3 W;

  PatchView(const Vector3* points, const Vector3& x)
    : F(points[0] - x)
    , U(points[1] - points[0])
    , V(points[3] - points[0])
    , W((points[2] - points[1]) - V)
  {
  }

  Vector3 At(const PatchParameters& at) const
  {
    return this->F + at.R * (this->U + at.S * this->W) + at.S * this->V;
  }

  /// Whether all corners, so the whole patch, are certainly farther from x than sqrt(limit2): a
  /// plane across the line from x to the middle shows.
  bool IsFartherThan(double limit2) const
  {
    if (!(limit2 < std::numeric_limits<double>::infinity()))
    {
      return false;
    }
    const Vector3 toMiddle = this->F + 0.5 * (this->U + this->V) + 0.25 * this->W;
    const double first = Dot(toMiddle, this->F);
    const double r = Dot(toMiddle, this->U);
    const double s = Dot(toMiddle, this->V);
    const double both = r + s + Dot(toMiddle, this->W);
    const double gap = first + std::min(std::min(0.0, r), std::min(s, both));
    const double size2 = Norm2(this->F) + Norm2(this->U) + Norm2(this->V) + Norm2(this->W);
    return gap > 0.0 && gap * gap > (limit2 + tolerances::PlaneGap2 * size2) * Norm2(toMiddle);
  }

  /// Steps inside the patch, as long as they lead nearer. They repair what a solution from squared
  /// numbers lost, and land exactly when x is on the patch.
  PatchParameters Polished(PatchParameters at) const
  {
    double dist2 = Norm2(this->At(at));
    for (int iteration = 0; iteration < 16; ++iteration)
    {
      PatchParameters next = this->AcrossPlane(at);
      double nextDist2 = Norm2(this->At(next));
      if (!(nextDist2 < dist2))
      {
        next = this->AlongLines(at);
        nextDist2 = Norm2(this->At(next));
      }
      if (!(nextDist2 < dist2))
      {
        break;
      }
      at = next;
      dist2 = nextDist2;
    }
    return at;
  }

  /// Into [0, 1]; NaN gives 0.
  static double Clamped(double t) { return t > 0.0 ? std::min(t, 1.0) : 0.0; }

private:
  /// To the foot of the perpendicular on the plane that touches the patch: a step of Gauss's.
  PatchParameters AcrossPlane(const PatchParameters& at) const
  {
    const TriangleFoot step(
      this->U + at.S * this->W, this->V + at.R * this->W, -1.0 * this->At(at));
    return { Clamped(at.R + step.R), Clamped(at.S + step.S) };
  }

  /// To the nearest point of the line along r, then of that along s.
  PatchParameters AlongLines(PatchParameters at) const
  {
    const Vector3 alongR = this->U + at.S * this->W;
    at.R = Clamped(at.R - Dot(this->At(at), alongR) / Norm2(alongR));
    const Vector3 alongS = this->V + at.R * this->W;
    at.S = Clamped(at.S - Dot(this->At(at), alongS) / Norm2(alongS));
    return at;
  }
};

}

#endif
