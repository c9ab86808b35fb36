// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_Distance_ConvexPatchMinimum_h
#define skd_Geometry_Distance_ConvexPatchMinimum_h

#include "../Tolerances.h"
#include "PatchView.h"

namespace skd
{

/// The scalar products that half the squared distance g(r, s) of a patch is made of.
struct PatchProducts
{
  double FU, FV, FW, UU, VV, WW, UV, UW, VW;

  explicit PatchProducts(const PatchView& v)
    : FU(Dot(v.F, v.U))
    , FV(Dot(v.F, v.V))
    , FW(Dot(v.F, v.W))
    , UU(Dot(v.U, v.U))
    , VV(Dot(v.V, v.V))
    , WW(Dot(v.W, v.W))
    , UV(Dot(v.U, v.V))
    , UW(Dot(v.U, v.W))
    , VW(Dot(v.V, v.W))
  {
  }

  /// Second derivatives of g.
  double AlongR(double s) const { return this->UU + s * (2.0 * this->UW + s * this->WW); }
  double AlongS(double r) const { return this->VV + r * (2.0 * this->VW + r * this->WW); }
  double Mixed(double r, double s) const
  {
    return this->UV + this->FW + 2.0 * (r * this->UW + s * this->VW + r * s * this->WW);
  }

  /// First derivatives of g.
  double SlopeR(double r, double s) const
  {
    return this->FU + s * (this->FW + this->UV + s * this->VW) + r * this->AlongR(s);
  }
  double SlopeS(double r, double s) const
  {
    return this->FV + r * (this->FW + this->UV + r * this->UW) + s * this->AlongS(r);
  }

  /// Whether g is certainly, and not just barely, convex on the patch: the diagonal of the matrix
  /// of second derivatives is bounded from below, the other element, bilinear, by its corners.
  bool IsConvex() const
  {
    const double alongR = std::min(this->UU, this->AlongR(1.0)) - 0.25 * this->WW;
    const double alongS = std::min(this->VV, this->AlongS(1.0)) - 0.25 * this->WW;
    double mixed = 0.0;
    for (const double corner : { this->Mixed(0.0, 0.0), this->Mixed(1.0, 0.0),
           this->Mixed(0.0, 1.0), this->Mixed(1.0, 1.0) })
    {
      mixed = std::max(mixed, corner * corner);
    }
    return alongR > 0.0 && alongS > 0.0 && alongR * alongS * 0.99 > mixed;
  }

  /// Where g is least, if it is convex. For a given s the best r is known, so this is the search of
  /// the one root of a rising function of s: Newton's steps, kept within bounds that close in.
  PatchParameters ConvexMinimum() const
  {
    double below = 0.0;
    double above = 1.0;
    double s = this->FirstS();
    for (int iteration = 0; iteration < 60; ++iteration)
    {
      const double alongR = this->AlongR(s);
      const double free = -this->SlopeR(0.0, s) / alongR;
      const double r = PatchView::Clamped(free);
      const double slope = this->SlopeS(r, s);
      const double mixed = r == free ? this->Mixed(r, s) : 0.0;
      const double newton = s - slope / (this->AlongS(r) - mixed * mixed / alongR);
      if (!(std::abs(newton - s) > tolerances::ConvexStep))
      {
        s = PatchView::Clamped(newton);
        break;
      }
      (slope < 0.0 ? below : above) = s;
      const double next = newton > below && newton < above ? newton : Within(newton, below, above);
      if (next == s)
      {
        break;
      }
      s = next;
    }
    return { PatchView::Clamped(-this->SlopeR(0.0, s) / this->AlongR(s)), s };
  }

private:
  /// The minimum of the parallelogram through the middle.
  double FirstS() const
  {
    const double alongR = this->AlongR(0.5);
    const double alongS = this->AlongS(0.5);
    const double mixed = this->Mixed(0.5, 0.5);
    const double slopeR = this->SlopeR(0.5, 0.5);
    const double slopeS = this->SlopeS(0.5, 0.5);
    const double determinant = alongR * alongS - mixed * mixed;
    return PatchView::Clamped(0.5 + (mixed * slopeR - alongR * slopeS) / determinant);
  }

  /// A step that leads out of bounds: to 0 or 1 if these are still open, else to the middle.
  static double Within(double next, double below, double above)
  {
    if (next <= below)
    {
      return below == 0.0 ? 0.0 : 0.5 * (below + above);
    }
    return above == 1.0 ? 1.0 : 0.5 * (below + above);
  }
};

}

#endif
