// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Curves_CurvePatchContact_h
#define skd_Curves_CurvePatchContact_h

#include "Meeting.h"
#include "Preconditioner.h"

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
  double Reach = 0.0; ///< and X
  MeetingKind Kind = MeetingKind::Crossing;
  int Passes = 0;          ///< 1 along dX/dr x dX/ds, -1 against it, 0 not
  bool Begins = false;     ///< of an OverlapEnd: the common stretch begins here
  bool OnBoundary = false; ///< of the patch or at an end of the curve: neighbours may tell it, too
};

/// A stretch of the curve within the tolerance of the patch near (R, S).
struct CurvePatchContact
{
  Interval T;
  double R;
  double S;
};

/// A curve and a patch, and what is asked of both at a place.
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

  /// Whether a root lies on both, to within rounding: what it may be off by counts as inside. Fills
  /// in all that depends on (T, R, S).
  bool Accept(CurvePatchHit& hit) const
  {
    const CurvePoint c = this->Curve.At(hit.T);
    const SurfacePoint s = this->Patch.At(hit.R, hit.S);
    const InverseRows inverse(c.D1, -1.0 * s.DR, -1.0 * s.DS);
    const auto slack = [&](int row)
    { return std::min(8.0 * this->Tolerance * Norm(inverse.Rows[row]) + 1e-14, 1e-5); };
    hit.Slack = slack(0);
    hit.Reach = 8.0 * this->Tolerance + hit.Slack * Norm(c.D1);
    hit.Passes = Dot(c.D1, s.Normal()) > 0.0 ? 1 : -1;
    return this->Place(hit, slack(1), slack(2));
  }

  /// Puts the hit onto the ends or the sides that it is near, and says whether it is beyond.
  bool Place(CurvePatchHit& hit, double slackR, double slackS) const
  {
    const bool isInside = Snap(hit.T, hit.Slack, hit.OnBoundary) &&
      Snap(hit.R, slackR, hit.OnBoundary) && Snap(hit.S, slackS, hit.OnBoundary);
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

  /// The place of the surface nearest to the curve's point at T, found from where the hit is, also
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
      if (std::abs(stepR) + std::abs(stepS) < 1e-15)
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

  /// What a stretch within the tolerance of the patch is: a crossing that is not simple, a touch,
  /// or nothing that comes near enough.
  std::optional<CurvePatchHit> Resolve(const CurvePatchContact& contact) const
  {
    const double length = contact.T.Max - contact.T.Min;
    const double margin = std::max(2.0 * length, 1e-6);
    CurvePatchHit before{ contact.T.Min - margin, contact.R, contact.S };
    CurvePatchHit after{ contact.T.Max + margin, contact.R, contact.S };
    double heights[2];
    CurvePatchHit hit{ 0.5 * (contact.T.Min + contact.T.Max), contact.R, contact.S };
    hit.Slack = 8.0 * length + 1e-12;
    const bool hasFeet = this->FindFoot(before, heights[0]) && this->FindFoot(after, heights[1]);
    if (!hasFeet)
    {
      return this->ResolvePole(hit);
    }
    const bool crosses = heights[0] * heights[1] < 0.0;
    hit.T = crosses ? this->Bisect(before.T, after.T, hit, false)
                    : this->Bisect(before.T, after.T, hit, true);
    hit.Kind = crosses ? MeetingKind::Crossing : MeetingKind::Touching;
    hit.Passes = crosses ? (heights[1] > 0.0 ? 1 : -1) : 0;
    double height;
    const bool isNear = this->FindFoot(hit, height) && std::abs(height) <= 4.0 * this->Tolerance;
    return isNear && this->PlaceContact(hit) ? std::optional<CurvePatchHit>(hit) : std::nullopt;
  }

  /// Whether the curve stays within the tolerance of the patch from one touch to the next.
  bool IsOneContact(const CurvePatchHit& a, const CurvePatchHit& b) const
  {
    CurvePatchHit foot = a;
    for (const double t : { 0.5 * (a.T + b.T), b.T })
    {
      foot.T = t;
      double height;
      if (!this->FindFoot(foot, height) || std::abs(height) > 4.0 * this->Tolerance)
      {
        return false;
      }
    }
    return std::abs(foot.R - b.R) + std::abs(foot.S - b.S) <= 1e-6;
  }

private:
  static bool Snap(double& value, double slack, bool& isOnBoundary)
  {
    const bool isInside = SnapToEnds(value, slack);
    isOnBoundary |= value == 0.0 || value == 1.0;
    return isInside;
  }

  bool PlaceContact(CurvePatchHit& hit) const
  {
    const CurvePoint c = this->Curve.At(hit.T);
    const SurfacePoint s = this->Patch.At(hit.R, hit.S);
    const double length = std::max(hit.Slack * Norm(c.D1), 8.0 * this->Tolerance);
    hit.Reach = length;
    const auto slack = [&](const Vector3& along)
    { return std::min(length / std::max(Norm(along), 1e-300), 1e-5); };
    hit.Slack = std::min(hit.Slack, 1e-5);
    return this->Place(hit, slack(s.DR), slack(s.DS));
  }

  /// A place without a normal, where a side of the patch is drawn together in a point.
  std::optional<CurvePatchHit> ResolvePole(CurvePatchHit hit) const
  {
    const CurvePoint c = this->Curve.At(hit.T);
    const SurfacePoint s = this->Patch.At(0.5 + 0.999 * (hit.R - 0.5), 0.5 + 0.999 * (hit.S - 0.5));
    const Vector3 normal = s.Normal();
    const double slope = Dot(c.D1, normal) / (Norm(normal) * Norm(c.D1));
    const bool crosses = std::abs(slope) > 1e-3;
    hit.Kind = crosses ? MeetingKind::Crossing : MeetingKind::Touching;
    hit.Passes = crosses ? (slope > 0.0 ? 1 : -1) : 0;
    const double gap2 = Distance2(c.X, this->Patch.At(hit.R, hit.S).X);
    const bool isNear = gap2 <= 64.0 * this->Tolerance * this->Tolerance;
    hit.OnBoundary = true;
    return isNear && this->PlaceContact(hit) ? std::optional<CurvePatchHit>(hit) : std::nullopt;
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
