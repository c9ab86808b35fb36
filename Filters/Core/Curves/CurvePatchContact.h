// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Curves_CurvePatchContact_h
#define skd_Curves_CurvePatchContact_h

#include "IntersectionKind.h"
#include "Preconditioner.h"
#include "Tolerances.h"

#include <array>
#include <optional>
#include <vector>

namespace skd
{

/// A point that a curve and a patch have in common.
struct CurvePatchHit
{
  double T = 0.0;
  double R = 0.0;
  double S = 0.0;
  Vector3 X{};
  double Gap = 0.0;   ///< what is left between both
  double Slack = 0.0; ///< what T may be off by
  double Error = 0.0; ///< and X
  IntersectionKind Kind = IntersectionKind::Crossing;
  int Passes = 0;      ///< 1 along dX/dr x dX/ds, -1 against it, 0 not
  bool Begins = false; ///< of an OverlapEnd: the common interval begins here
  int Before = 0; ///< the side of the patch on which the curve comes, 1 where its normal points to
  int After = 0;  ///< and on which it goes; 0 where that is not known
  bool IsResolved = false; ///< not simple: Resolve() has determined its kind
  bool OnBoundary =
    false; ///< of the patch or at an end of the curve: neighbours may report it, too
};

/// A interval of the curve within the tolerance of the patch near (R, S).
struct CurvePatchContact
{
  Interval T;
  double R;
  double S;
};

/// A curve and a patch, and queries of both at given parameters.
struct CurvePatchPair
{
  const BezierCurve& Curve;
  const BezierPatch& Patch;
  double Tolerance; ///< the distance that is 0 to within rounding

  /// Newton's method from where the hit is. Whether it came to a point of both, or of what
  /// continues them beyond their ends.
  bool Polish(CurvePatchHit& hit) const
  {
    double last = std::numeric_limits<double>::infinity();
    for (int iteration = 0; iteration < 20; ++iteration)
    {
      const CurvePoint c = this->Curve.At(hit.T);
      const SurfacePoint s = this->Patch.At(hit.R, hit.S);
      const Vector3 gap = c.X - s.X;
      const double size = Norm(gap);
      if (!(size < 0.5 * last) && last <= this->Tolerance)
      {
        return true;
      }
      const InverseRows inverse(c.D1, -1.0 * s.DR, -1.0 * s.DS);
      if (!inverse.IsRegular || !std::isfinite(size))
      {
        return false;
      }
      hit.T -= Dot(inverse.Rows[0], gap);
      hit.R -= Dot(inverse.Rows[1], gap);
      hit.S -= Dot(inverse.Rows[2], gap);
      last = size;
    }
    return last <= this->Tolerance;
  }

  /// What T, R and S of a root may be off by.
  std::array<double, 3> SlacksOf(const CurvePatchHit& hit) const
  {
    const SurfacePoint s = this->Patch.At(hit.R, hit.S);
    const InverseRows inverse(this->Curve.At(hit.T).D1, -1.0 * s.DR, -1.0 * s.DS);
    std::array<double, 3> slacks;
    for (int row = 0; row < 3; ++row)
    {
      slacks[row] =
        std::min(8.0 * this->Tolerance * Norm(inverse.Rows[row]) + tolerances::RootRounding,
          tolerances::MostSlack);
    }
    return slacks;
  }

  /// Whether a root lies on both, to within rounding: what it may be off by counts as inside. Fills
  /// in all that depends on (T, R, S).
  bool Accept(CurvePatchHit& hit, const std::array<double, 3>& slacks) const
  {
    const Vector3 along = this->Curve.At(hit.T).D1;
    hit.Slack = slacks[0];
    hit.Error = 8.0 * this->Tolerance + hit.Slack * Norm(along);
    hit.Passes = Dot(along, this->Patch.At(hit.R, hit.S).Normal()) > 0.0 ? 1 : -1;
    return this->LocateWithin(hit, slacks[1], slacks[2]);
  }

  /// Puts the hit onto the ends or the sides that it is near, and says whether it is beyond.
  bool LocateWithin(CurvePatchHit& hit, double slackR, double slackS) const
  {
    const bool isInside = this->SnapToEnd(hit) && Snap(hit.R, slackR, hit.OnBoundary) &&
      Snap(hit.S, slackS, hit.OnBoundary);
    if (this->Patch.IsTriangle)
    {
      double rest = 1.0 - hit.R - hit.S;
      if (!Snap(rest, slackR + slackS, hit.OnBoundary))
      {
        return false;
      }
    }
    hit.X = this->Curve.At(hit.T).X;
    hit.Gap = std::sqrt(Distance2(hit.X, this->Patch.At(hit.R, hit.S).X));
    return isInside;
  }

  /// The point of the surface nearest to the curve's point at T, found from where the hit is, also
  /// beyond the patch; the distance along the normal there. Whether it is one.
  bool FindFoot(CurvePatchHit& hit, double& height) const
  {
    const Vector3 x = this->Curve.At(hit.T).X;
    SurfacePoint s = this->Patch.At(hit.R, hit.S);
    for (int iteration = 0; iteration < 12; ++iteration)
    {
      const InverseRows inverse(s.DR, s.DS, s.Normal());
      if (!inverse.IsRegular)
      {
        return false;
      }
      const double stepR = Dot(inverse.Rows[0], x - s.X);
      const double stepS = Dot(inverse.Rows[1], x - s.X);
      hit.R += stepR;
      hit.S += stepS;
      s = this->Patch.At(hit.R, hit.S);
      if (std::abs(stepR) + std::abs(stepS) < tolerances::FootStep)
      {
        break;
      }
    }
    const Vector3 normal = s.Normal();
    height = Dot(normal, x - s.X) / Norm(normal);
    const bool isFoot =
      Distance2(x, s.X) <= 4.0 * height * height + this->Tolerance * this->Tolerance;
    const bool isBilinear = this->Patch.DegreeR == 1 && this->Patch.DegreeS == 1;
    const double far = isBilinear ? 1e3 : 2.0; // higher degrees bend away beyond their sides
    return isFoot && std::abs(hit.R - 0.5) < far && std::abs(hit.S - 0.5) < far;
  }

  /// The slope of the height along the curve.
  double HeightSlope(CurvePatchHit hit, double t) const
  {
    hit.T = t;
    double height;
    this->FindFoot(hit, height);
    const Vector3 normal = this->Patch.At(hit.R, hit.S).Normal();
    return Dot(this->Curve.At(t).D1, normal);
  }

  /// What a interval within the tolerance of the patch is: a crossing that is not simple, a touch,
  /// or nothing that comes near enough. The sides on which the curve is decide, where it comes out
  /// of the tolerance.
  std::optional<CurvePatchHit> Resolve(const CurvePatchContact& contact) const
  {
    const double length = contact.T.Max - contact.T.Min;
    const double step = std::max(2.0 * length, tolerances::ContactStep);
    const double maxStep = 8.0 * this->Tolerance;
    const auto gapAt = [&](CurvePatchHit& at)
    {
      double height;
      return this->FindFoot(at, height) ? std::abs(height)
                                        : std::numeric_limits<double>::quiet_NaN();
    };
    CurvePatchHit before{ contact.T.Min, contact.R, contact.S };
    CurvePatchHit after{ contact.T.Max, contact.R, contact.S };
    CurvePatchHit hit{ 0.5 * (contact.T.Min + contact.T.Max), contact.R, contact.S };
    hit.IsResolved = true;
    hit.Slack = 8.0 * length;
    if (!LeaveContact(before, -step, maxStep, gapAt) || !LeaveContact(after, step, maxStep, gapAt))
    {
      return this->ResolvePole(hit);
    }
    const bool isNear = this->Locate(hit, before, after);
    hit.Slack = ContactLength(hit, maxStep, gapAt);
    return isNear && this->LocateContact(hit) ? std::optional<CurvePatchHit>(hit) : std::nullopt;
  }

  /// Whether a point may be more than a simple root: the curve nearly runs along the patch there.
  static bool IsDoubtful(const CurvePatchHit& hit)
  {
    return hit.Slack > tolerances::Doubtful && !hit.IsResolved;
  }

  static bool IsBefore(const CurvePatchHit& a, const CurvePatchHit& b)
  {
    return a.T != b.T ? a.T < b.T : (a.R != b.R ? a.R < b.R : a.S < b.S);
  }

  static CurvePatchContact ContactAt(const Interval& range, const CurvePatchHit& hit)
  {
    return { range, hit.R, hit.S };
  }

  /// Two roots of one point: the error of X shows where patches have a pole.
  static bool IsSameIntersection(const CurvePatchHit& a, const CurvePatchHit& b)
  {
    return std::abs(b.T - a.T) <= tolerances::SameParameter &&
      Distance2(a.X, b.X) <= 4.0 * (a.Error + b.Error) * (a.Error + b.Error);
  }

  /// Whether the curve stays within the tolerance of the patch from one point to another.
  bool IsOneContact(const CurvePatchHit& a, const CurvePatchHit& b) const
  {
    CurvePatchHit foot = a;
    for (const double part : { 0.25, 0.5, 0.75, 1.0 })
    {
      foot.T = a.T + part * (b.T - a.T);
      double height;
      if (!this->FindFoot(foot, height) || std::abs(height) > 4.0 * this->Tolerance)
      {
        return false;
      }
    }
    return Norm(this->Patch.At(foot.R, foot.S).X - this->Patch.At(b.R, b.S).X) <=
      a.Error + b.Error + tolerances::SameContact * Norm(this->Curve.At(b.T).D1);
  }

private:
  int SideOf(CurvePatchHit hit) const
  {
    double height = 0.0;
    this->FindFoot(hit, height);
    return height > 0.0 ? 1 : -1;
  }

  /// Where a contact is, and what, between points before and after it; whether it is near enough.
  bool Locate(CurvePatchHit& hit, CurvePatchHit before, CurvePatchHit after) const
  {
    const double middle = hit.T;
    for (int i = 0; i < 2; ++i)
    {
      hit.Before = this->SideOf(before);
      hit.After = this->SideOf(after);
      const bool crosses = hit.Before != hit.After;
      hit.T = this->Bisect(before.T, after.T, hit, !crosses);
      hit.Kind = crosses ? IntersectionKind::Crossing : IntersectionKind::Touching;
      hit.Passes = crosses ? hit.After : 0;
      double height;
      if (this->FindFoot(hit, height) && std::abs(height) <= 4.0 * this->Tolerance)
      {
        return true;
      }
      if (crosses || this->SideOf(hit) == hit.Before)
      {
        break;
      }
      (middle < hit.T ? after : before) = hit; // it crosses twice, once on the contact's side
    }
    double height;
    hit.T = middle;
    return this->FindFoot(hit, height) && std::abs(height) <= 4.0 * this->Tolerance;
  }

  static bool Snap(double& value, double slack, bool& isOnBoundary)
  {
    const bool isInside = SnapToEnds(value, slack);
    isOnBoundary |= value == 0.0 || value == 1.0;
    return isInside;
  }

  /// Puts a hit that is near an end of the curve there, and finds the foot again; but not one that
  /// is on the curve when its end is farther from the patch than rounding explains.
  bool SnapToEnd(CurvePatchHit& hit) const
  {
    CurvePatchHit end = hit;
    if (!Snap(end.T, end.Slack, end.OnBoundary))
    {
      return false;
    }
    double height = 0.0;
    const bool isMoved = end.T != hit.T && this->FindFoot(end, height);
    const bool isOn = hit.T >= 0.0 && hit.T <= 1.0;
    if (!isMoved)
    {
      end.R = hit.R;
      end.S = hit.S;
    }
    if (!isMoved || !isOn || std::abs(height) <= 4.0 * this->Tolerance)
    {
      hit = end;
    }
    return true;
  }

  bool LocateContact(CurvePatchHit& hit) const
  {
    const CurvePoint c = this->Curve.At(hit.T);
    const SurfacePoint s = this->Patch.At(hit.R, hit.S);
    hit.Slack = std::min(hit.Slack + tolerances::SameParameter, 0.125);
    const double length = std::max(hit.Slack * Norm(c.D1), 8.0 * this->Tolerance);
    hit.Error = length;
    const auto slack = [&](const Vector3& along)
    {
      return std::min(
        length / std::max(Norm(along), tolerances::LeastDivisor), tolerances::MostSlack);
    };
    return this->LocateWithin(hit, slack(s.DR), slack(s.DS));
  }

  /// A point without a normal, where a side of the patch is drawn together in a point.
  std::optional<CurvePatchHit> ResolvePole(CurvePatchHit hit) const
  {
    const CurvePoint c = this->Curve.At(hit.T);
    const SurfacePoint s = this->Patch.At(0.5 + 0.999 * (hit.R - 0.5), 0.5 + 0.999 * (hit.S - 0.5));
    const Vector3 normal = s.Normal();
    const double slope = Dot(c.D1, normal) / (Norm(normal) * Norm(c.D1));
    const bool crosses = std::abs(slope) > tolerances::PoleSlope;
    hit.Kind = crosses ? IntersectionKind::Crossing : IntersectionKind::Touching;
    hit.Passes = crosses ? (slope > 0.0 ? 1 : -1) : 0;
    const double gap2 = Distance2(c.X, this->Patch.At(hit.R, hit.S).X);
    const bool isNear = gap2 <= 64.0 * this->Tolerance * this->Tolerance;
    hit.OnBoundary = true;
    return isNear && this->LocateContact(hit) ? std::optional<CurvePatchHit>(hit) : std::nullopt;
  }

  /// Where the height, or its slope, changes its sign; the middle where it does not.
  double Bisect(double low, double high, const CurvePatchHit& near, bool ofSlope) const
  {
    const auto value = [&](double t)
    {
      CurvePatchHit hit = near;
      hit.T = t;
      double height = 0.0;
      return ofSlope ? this->HeightSlope(near, t) : (this->FindFoot(hit, height), height);
    };
    return SignChange(low, high, value);
  }
};

}

#endif
