// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Curves_LinePair_h
#define skd_Curves_LinePair_h

#include "../Geometry/Distance/ClosestSegments.h"
#include "../Geometry/Intersection/SegmentContact.h"
#include "CurveWithinCurve.h"

namespace skd
{

/// The nearest points of segments that may cross at a small angle: the feet on each other of what
/// ClosestPoints() finds. That may be off along both by rounding over the angle, which then counts
/// by the angle only.
inline SegmentPair ClosestPointsAtAnyAngle(const Segment<3>& first, const Segment<3>& second)
{
  SegmentPair nearest = ClosestPoints(first, second);
  const SegmentPoint<3> there = ClosestPointOnSegment(second.A, second.B, first.At(nearest.T));
  detail::KeepNearer(nearest, { nearest.T, there.R, there.Dist2 });
  const SegmentPoint<3> here = ClosestPointOnSegment(first.A, first.B, second.At(nearest.R));
  detail::KeepNearer(nearest, { here.R, nearest.R, here.Dist2 });
  return nearest;
}

/// What two straight pieces have in common. Where they meet by exact signs, they do; others meet
/// where they are within the tolerance of each other. Pieces that are so all along what both pass
/// by have a interval in common, however they cross there: rounding has made one line two.
class LinePair
{
public:
  explicit LinePair(const CurvePair& pair)
    : Pair(pair)
    , First{ pair.First.Start(), pair.First.End() }
    , Second{ pair.Second.Start(), pair.Second.End() }
  {
  }

  /// Appends a point, or both ends of a interval.
  void Find(std::vector<CurvePairHit>& hits) const
  {
    const SegmentContact contact = Meet(this->First, this->Second);
    if (contact.Kind == SegmentContact::Interval)
    {
      AppendInterval(this->Pair, ExactHit(contact.Begin), ExactHit(contact.End), hits);
    }
    else if (this->FindNearInterval(hits))
    {
      return;
    }
    else if (contact.Kind == SegmentContact::Point)
    {
      this->AppendPoint(ExactHit(contact.Begin), hits);
    }
    else
    {
      this->FindNearPoint(hits);
    }
  }

private:
  static CurvePairHit ExactHit(const SegmentContact::Position& at)
  {
    CurvePairHit hit;
    hit.T = at.T;
    hit.S = at.S;
    hit.IsExact = true;
    return hit;
  }

  static bool IsEnd(double t) { return t == 0.0 || t == 1.0; }

  void AppendPoint(CurvePairHit hit, std::vector<CurvePairHit>& hits) const
  {
    this->Pair.SetSlacks(hit);
    if (hit.IsExact)
    {
      this->Pair.Measure(hit);
    }
    else if (!this->Pair.LocateWithin(hit, 2.0 * this->Pair.Tolerance))
    {
      return;
    }
    const bool isInLine =
      !CurvePair::Inverse(this->First.B - this->First.A, this->Second.B - this->Second.A).IsRegular;
    if (isInLine && IsEnd(hit.T) && IsEnd(hit.S))
    {
      hit.Kind = IntersectionKind::Touching;
    }
    hits.push_back(hit);
  }

  void FindNearPoint(std::vector<CurvePairHit>& hits) const
  {
    const SegmentPair nearest = ClosestPointsAtAnyAngle(this->First, this->Second);
    if (nearest.Dist2 <= this->Pair.Tolerance * this->Pair.Tolerance)
    {
      CurvePairHit hit;
      hit.T = nearest.T;
      hit.S = nearest.R;
      this->AppendPoint(hit, hits);
    }
  }

  /// Where both pass by each other, if they stay together there. What is not much longer than the
  /// tolerance decides nothing.
  bool FindNearInterval(std::vector<CurvePairHit>& hits) const
  {
    const Vector3 along = this->First.B - this->First.A;
    const double length2 = Norm2(along);
    const double atA = Dot(this->Second.A - this->First.A, along) / length2;
    const double atB = Dot(this->Second.B - this->First.A, along) / length2;
    const Interval range{ std::max(0.0, std::min(atA, atB)), std::min(1.0, std::max(atA, atB)) };
    const double shortest = 1024.0 * this->Pair.Tolerance;
    const double length = range.Max - range.Min;
    if (!(length > 0.0) || length * length * length2 <= shortest * shortest)
    {
      return false;
    }
    CurvePairHit ends[2];
    for (int i = 0; i < 2; ++i)
    {
      const double t = i == 0 ? range.Min : range.Max;
      const Vector3 x = this->First.At(t);
      ends[i].T = t;
      ends[i].S = t == atA
        ? 0.0
        : (t == atB ? 1.0 : ClosestPointOnSegment(this->Second.A, this->Second.B, x).R);
      const double gap2 = Distance2(x, this->Second.At(ends[i].S));
      if (!(gap2 <= 4.0 * this->Pair.Tolerance * this->Pair.Tolerance))
      {
        return false;
      }
    }
    AppendInterval(this->Pair, ends[0], ends[1], hits);
    return true;
  }

  const CurvePair& Pair;
  Segment<3> First;
  Segment<3> Second;
};

}

#endif
