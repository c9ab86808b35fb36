// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Curves_CurvePair_h
#define skd_Curves_CurvePair_h

#include "IntersectionKind.h"
#include "Preconditioner.h"
#include "Tolerances.h"

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
  double Error = 0.0; ///< and X
  IntersectionKind Kind = IntersectionKind::Crossing;
  bool Begins = false;     ///< of an OverlapEnd: the common interval begins here
  Vector3 Before{};        ///< from the second to the first before a point that is not simple; or 0
  Vector3 After{};         ///< the same after it
  bool IsResolved = false; ///< not simple: Resolve() has determined its kind
  bool IsExact = false;    ///< T and S are right to a few units in the last place
};

/// A interval of the first curve within the tolerance of the second near S.
struct CurvePairContact
{
  Interval T;
  double S;
};

/// Two curves, and queries of both at given parameters.
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

  /// What a root may be off by.
  void SetSlacks(CurvePairHit& hit) const
  {
    const Vector3 along = this->First.At(hit.T).D1;
    const InverseRows inverse = Inverse(along, this->Second.At(hit.S).D1);
    const auto slack = [&](int row)
    {
      return std::min(8.0 * this->Tolerance * Norm(inverse.Rows[row]) + tolerances::RootRounding,
        tolerances::MostSlack);
    };
    hit.SlackT = slack(0);
    hit.SlackS = slack(1);
    hit.Error = 8.0 * this->Tolerance + hit.SlackT * Norm(along);
  }

  /// Fills in what depends on T and S.
  void Measure(CurvePairHit& hit) const
  {
    hit.X = this->First.At(hit.T).X;
    hit.Gap = std::sqrt(Distance2(hit.X, this->Second.At(hit.S).X));
  }

  /// Whether the parameters are a root of both, to within rounding. Fills in all that depends on
  /// it.
  bool Accept(CurvePairHit& hit) const
  {
    this->SetSlacks(hit);
    return this->LocateWithin(hit, 2.0 * this->Tolerance);
  }

  /// Puts the hit onto the ends that it is near, and says whether it is on both curves. An end is
  /// where the hit is when the other curve comes as near to it: at the foot there, for where curves
  /// cross at a small angle a root may be off by more than they are apart.
  bool LocateWithin(CurvePairHit& hit, double farthest) const
  {
    CurvePairHit moved = hit;
    const bool isNearT = SnapToEnds(moved.T, moved.SlackT);
    const bool isNearS = SnapToEnds(moved.S, moved.SlackS);
    const double endT = moved.T;
    const double endS = moved.S;
    const bool hasEndT = isNearT && (endT == 0.0 || endT == 1.0);
    const bool hasEndS = isNearS && (endS == 0.0 || endS == 1.0);
    const auto isOn = [&](double t, double s)
    {
      moved.T = t;
      moved.S = s;
      this->Measure(moved);
      return t >= 0.0 && t <= 1.0 && s >= 0.0 && s <= 1.0 && moved.Gap <= farthest;
    };
    const bool isOnBoth = (hasEndT && hasEndS && isOn(endT, endS)) ||
      (hasEndT && isOn(endT, Foot(this->Second, this->First.At(endT).X, hit.S))) ||
      (hasEndS && isOn(Foot(this->First, this->Second.At(endS).X, hit.T), endS)) ||
      isOn(hit.T, hit.S);
    if (!isOnBoth)
    {
      isOn(std::clamp(endT, 0.0, 1.0), std::clamp(endS, 0.0, 1.0));
    }
    hit = moved;
    return isOnBoth;
  }

  /// The point of the second curve nearest to the first's at T, found from where the hit is, also
  /// beyond its ends; the vector from there. Whether it is one.
  bool FindFoot(CurvePairHit& hit, Vector3& offset) const
  {
    const Vector3 x = this->First.At(hit.T).X;
    hit.S = Foot(this->Second, x, hit.S);
    const CurvePoint b = this->Second.At(hit.S);
    offset = x - b.X;
    const double across2 = Norm2(offset) - Dot(offset, b.D1) * Dot(offset, b.D1) / Norm2(b.D1);
    const double far = this->Second.Degree == 1 ? 1e3 : 2.0;
    return Norm2(offset) <= 4.0 * across2 + this->Tolerance * this->Tolerance &&
      std::abs(hit.S - 0.5) < far;
  }

  /// What a interval within the tolerance of the other curve is: a touch, a crossing that is not
  /// simple, or nothing that comes near enough. The sides on which the first curve is decide, where
  /// it comes out of the tolerance.
  std::optional<CurvePairHit> Resolve(const CurvePairContact& contact) const
  {
    const double length = contact.T.Max - contact.T.Min;
    const double step = std::max(2.0 * length, tolerances::ContactStep);
    const double maxStep = 8.0 * this->Tolerance;
    const auto gapAt = [&](CurvePairHit& trial)
    {
      Vector3 offset;
      return this->FindFoot(trial, offset) ? Norm(offset)
                                           : std::numeric_limits<double>::quiet_NaN();
    };
    CurvePairHit hit;
    hit.S = contact.S;
    CurvePairHit before = hit;
    CurvePairHit after = hit;
    hit.T = 0.5 * (contact.T.Min + contact.T.Max);
    before.T = contact.T.Min;
    after.T = contact.T.Max;
    hit.Kind = IntersectionKind::Touching;
    hit.IsResolved = true;
    hit.SlackT = 8.0 * length;
    if (LeaveContact(before, -step, maxStep, gapAt) && LeaveContact(after, step, maxStep, gapAt))
    {
      this->Locate(hit, before, after);
      hit.SlackT = ContactLength(hit, maxStep, gapAt);
    }
    return this->LocateContact(hit) ? std::optional<CurvePairHit>(hit) : std::nullopt;
  }

  /// Whether a point may be more than a simple root: the curves nearly run along each other there.
  static bool IsDoubtful(const CurvePairHit& hit)
  {
    return hit.SlackT > tolerances::Doubtful && !hit.IsResolved;
  }

  static bool IsBefore(const CurvePairHit& a, const CurvePairHit& b)
  {
    return a.T != b.T ? a.T < b.T : a.S < b.S;
  }

  static CurvePairContact ContactAt(const Interval& range, const CurvePairHit& hit)
  {
    return { range, hit.S };
  }

  static bool IsSameIntersection(const CurvePairHit& a, const CurvePairHit& b)
  {
    return std::abs(a.T - b.T) <= tolerances::SameParameter &&
      std::abs(a.S - b.S) <= tolerances::SameParameter;
  }

  /// Whether the curves stay within the tolerance of each other from one point to another.
  bool IsOneContact(const CurvePairHit& a, const CurvePairHit& b) const
  {
    CurvePairHit foot = a;
    for (const double part : { 0.25, 0.5, 0.75, 1.0 })
    {
      foot.T = a.T + part * (b.T - a.T);
      Vector3 offset;
      if (!this->FindFoot(foot, offset) || Norm(offset) > 4.0 * this->Tolerance)
      {
        return false;
      }
    }
    // not where the second curve comes by again
    return std::abs(foot.S - b.S) <= std::max({ a.SlackS, b.SlackS, tolerances::SameContact });
  }

  /// The point of a curve nearest to a point, found from `start`, also beyond its ends.
  static double Foot(const BezierCurve& curve, const Vector3& x, double start)
  {
    double foot = start;
    for (int iteration = 0; iteration < 16; ++iteration)
    {
      const CurvePoint at = curve.At(foot);
      const double speed2 = Norm2(at.D1);
      const double step = speed2 > 0.0 ? Dot(x - at.X, at.D1) / speed2 : 0.0;
      foot += step;
      if (std::abs(step) < tolerances::FootStep)
      {
        break;
      }
    }
    return foot;
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
  bool LocateContact(CurvePairHit& hit) const
  {
    Vector3 offset;
    this->FindFoot(hit, offset);
    const double speed = Norm(this->First.At(hit.T).D1);
    hit.SlackT = std::min(hit.SlackT + tolerances::SameParameter, 0.125);
    hit.SlackS =
      std::min(hit.SlackT * speed / Norm(this->Second.At(hit.S).D1) + tolerances::SameParameter,
        0.125); // not of NaN
    hit.Error = hit.SlackT * speed + 8.0 * this->Tolerance;
    return this->LocateWithin(hit, 4.0 * this->Tolerance);
  }

  /// Where a contact is, and what, between points before and after it.
  void Locate(CurvePairHit& hit, CurvePairHit before, CurvePairHit after) const
  {
    const double middle = hit.T;
    Vector3 offset;
    for (int i = 0; i < 2; ++i)
    {
      this->FindFoot(before, hit.Before);
      this->FindFoot(after, hit.After);
      const bool crosses = Dot(hit.Before, hit.After) < 0.0;
      const Vector3 across = Norm2(hit.Before) > Norm2(hit.After) ? hit.Before : hit.After;
      hit.Kind = crosses ? IntersectionKind::Crossing : IntersectionKind::Touching;
      hit.T = this->Bisect(before, after, across, !crosses);
      this->FindFoot(hit, offset);
      if (crosses || Norm(offset) <= 4.0 * this->Tolerance || Dot(offset, hit.Before) >= 0.0)
      {
        break;
      }
      (middle < hit.T ? after : before) = hit; // it crosses twice, once on the contact's side
    }
    if (!(Norm(offset) <= this->Tolerance)) // they pass by each other askew
    {
      hit.T = this->NearestWithin(before, after);
    }
  }

  /// Where both are nearest, by thirds.
  double NearestWithin(CurvePairHit low, CurvePairHit high) const
  {
    const auto gapAt = [&](double t)
    {
      CurvePairHit foot = low;
      foot.T = t;
      Vector3 offset;
      this->FindFoot(foot, offset);
      return Norm2(offset);
    };
    for (int iteration = 0; iteration < 80; ++iteration)
    {
      const double first = low.T + (high.T - low.T) / 3.0;
      const double second = high.T - (high.T - low.T) / 3.0;
      const bool isAfter = gapAt(first) > gapAt(second);
      (isAfter ? low.T : high.T) = isAfter ? first : second;
    }
    return 0.5 * (low.T + high.T);
  }

  /// Where what is between the curves, seen along `across`, changes its sign; or its slope does.
  double Bisect(const CurvePairHit& before, const CurvePairHit& after, const Vector3& across,
    bool ofSlope) const
  {
    const auto value = [&](double t)
    {
      CurvePairHit hit = before;
      hit.T = t;
      Vector3 offset;
      this->FindFoot(hit, offset);
      const Vector3 a = this->First.At(t).D1;
      const Vector3 b = this->Second.At(hit.S).D1;
      return ofSlope ? Dot(a - (Dot(a, b) / Norm2(b)) * b, across) : Dot(offset, across);
    };
    return SignChange(before.T, after.T, value);
  }
};

}

#endif
