// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Curves_CurvePair_h
#define skd_Curves_CurvePair_h

#include "Meeting.h"
#include "Preconditioner.h"

#include <optional>
#include <vector>

namespace skd
{

/// A point that two curves have in common.
struct CurvePairHit
{
  double T = 0.0; ///< on the first
  double S = 0.0; ///< on the second
  Vector3 X{};
  double Gap = 0.0;    ///< what is left between both
  double SlackT = 0.0; ///< what T may be off by
  double SlackS = 0.0;
  double Reach = 0.0; ///< and X
  MeetingKind Kind = MeetingKind::Crossing;
  bool Begins = false; ///< of an OverlapEnd: the common stretch begins here
};

/// A stretch of the first curve within the tolerance of the second near S.
struct CurvePairContact
{
  Interval T;
  double S;
};

/// Two curves, and what is asked of both at a place.
struct CurvePair
{
  const BezierCurve& First;
  const BezierCurve& Second;
  double Tolerance; ///< the distance that is 0 to within rounding

  /// Newton's method (Gauss's: three equations, two unknowns), as long as it leads nearer.
  void Polish(CurvePairHit& hit) const
  {
    double last = std::sqrt(Distance2(this->First.At(hit.T).X, this->Second.At(hit.S).X));
    for (int iteration = 0; iteration < 8; ++iteration)
    {
      const CurvePoint a = this->First.At(hit.T);
      const CurvePoint b = this->Second.At(hit.S);
      const InverseRows inverse = Inverse(a.D1, b.D1);
      CurvePairHit next = hit;
      next.T -= Dot(inverse.Rows[0], a.X - b.X);
      next.S -= Dot(inverse.Rows[1], a.X - b.X);
      const double gap = std::sqrt(Distance2(this->First.At(next.T).X, this->Second.At(next.S).X));
      if (!(gap < last))
      {
        return;
      }
      last = gap;
      hit = next;
    }
  }

  /// Whether the place is a root of both, to within rounding. Fills in all that depends on it.
  bool Accept(CurvePairHit& hit) const
  {
    const CurvePoint a = this->First.At(hit.T);
    const CurvePoint b = this->Second.At(hit.S);
    const InverseRows inverse = Inverse(a.D1, b.D1);
    const auto slack = [&](int row)
    { return std::min(8.0 * this->Tolerance * Norm(inverse.Rows[row]) + 1e-14, 1e-5); };
    hit.SlackT = slack(0);
    hit.SlackS = slack(1);
    hit.Reach = 8.0 * this->Tolerance + hit.SlackT * Norm(a.D1);
    return this->Place(hit, 2.0 * this->Tolerance);
  }

  /// Puts the hit onto the ends that it is near, and says whether it is on both curves.
  bool Place(CurvePairHit& hit, double farthest) const
  {
    const bool isInside = SnapToEnds(hit.T, hit.SlackT) && SnapToEnds(hit.S, hit.SlackS);
    hit.X = this->First.At(hit.T).X;
    hit.Gap = std::sqrt(Distance2(hit.X, this->Second.At(hit.S).X));
    return isInside && hit.Gap <= farthest;
  }

  /// The place of the second curve nearest to the first's at T, found from where the hit is, also
  /// beyond its ends; the way from there. Whether it is one.
  bool FindFoot(CurvePairHit& hit, Vector3& way) const
  {
    const Vector3 x = this->First.At(hit.T).X;
    CurvePoint b = this->Second.At(hit.S);
    for (int iteration = 0; iteration < 16; ++iteration)
    {
      const double speed2 = Norm2(b.D1);
      const double step = speed2 > 0.0 ? Dot(x - b.X, b.D1) / speed2 : 0.0;
      hit.S += step;
      b = this->Second.At(hit.S);
      if (std::abs(step) < 1e-15)
      {
        break;
      }
    }
    way = x - b.X;
    const double across2 = Norm2(way) - Dot(way, b.D1) * Dot(way, b.D1) / Norm2(b.D1);
    const double far = this->Second.Degree == 1 ? 1e3 : 2.0;
    return Norm2(way) <= 4.0 * across2 + this->Tolerance * this->Tolerance &&
      std::abs(hit.S - 0.5) < far;
  }

  /// What a stretch within the tolerance of the other curve is: a touch, a crossing that is not
  /// simple, or nothing that comes near enough.
  std::optional<CurvePairHit> Resolve(const CurvePairContact& contact) const
  {
    const double length = contact.T.Max - contact.T.Min;
    const double margin = std::max(2.0 * length, 1e-6);
    CurvePairHit before;
    CurvePairHit after;
    before.T = contact.T.Min - margin;
    after.T = contact.T.Max + margin;
    before.S = after.S = contact.S;
    Vector3 ways[2];
    CurvePairHit hit;
    hit.T = 0.5 * (contact.T.Min + contact.T.Max);
    hit.S = contact.S;
    if (this->FindFoot(before, ways[0]) && this->FindFoot(after, ways[1]))
    {
      const bool crosses = Dot(ways[0], ways[1]) < 0.0;
      const Vector3 across = Norm2(ways[0]) > Norm2(ways[1]) ? ways[0] : ways[1];
      hit.T = this->Bisect(before, after, across, !crosses);
    }
    hit.Kind = MeetingKind::Touching;
    hit.SlackT = std::min(8.0 * length + 1e-12, 1e-5);
    Vector3 way;
    this->FindFoot(hit, way);
    const double speeds = Norm(this->First.At(hit.T).D1) / Norm(this->Second.At(hit.S).D1);
    hit.SlackS = std::min(hit.SlackT * speeds + 1e-12, 1e-5);
    hit.Reach = hit.SlackT * Norm(this->First.At(hit.T).D1) + 8.0 * this->Tolerance;
    return this->Place(hit, 4.0 * this->Tolerance) ? std::optional<CurvePairHit>(hit)
                                                   : std::nullopt;
  }

  /// Whether the curves stay within the tolerance of each other from one touch to the next.
  bool IsOneContact(const CurvePairHit& a, const CurvePairHit& b) const
  {
    CurvePairHit foot = a;
    for (const double t : { 0.5 * (a.T + b.T), b.T })
    {
      foot.T = t;
      Vector3 way;
      if (!this->FindFoot(foot, way) || Norm(way) > 4.0 * this->Tolerance)
      {
        return false;
      }
    }
    return std::abs(foot.S - b.S) <= 1e-6; // not where the second curve comes by again
  }

  /// Takes a gap to the changes of T and S (less) that close it: the third direction is across
  /// both.
  static InverseRows Inverse(const Vector3& first, const Vector3& second)
  {
    const Vector3 across = Cross(first, second);
    const double length = Norm(across);
    return InverseRows(first, -1.0 * second, length > 0.0 ? (1.0 / length) * across : Vector3{});
  }

private:
  /// Where what is between the curves, seen along `across`, changes its sign; or its slope does.
  double Bisect(const CurvePairHit& before, const CurvePairHit& after, const Vector3& across,
    bool ofSlope) const
  {
    const auto value = [&](double t)
    {
      CurvePairHit hit = before;
      hit.T = t;
      Vector3 way;
      this->FindFoot(hit, way);
      const Vector3 a = this->First.At(t).D1;
      const Vector3 b = this->Second.At(hit.S).D1;
      return ofSlope ? Dot(a - (Dot(a, b) / Norm2(b)) * b, across) : Dot(way, across);
    };
    return SignChange(before.T, after.T, value);
  }
};

}

#endif
