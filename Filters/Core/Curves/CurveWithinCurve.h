// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Curves_CurveWithinCurve_h
#define skd_Curves_CurveWithinCurve_h

#include "CommonIntervals.h"
#include "CurvePair.h"
#include "Tolerances.h"

namespace skd
{

/// Appends both ends of a interval that two curves have in common. One that is as short as its ends
/// may be off by is a touch, end to end, unless it is exact.
inline void AppendInterval(
  const CurvePair& pair, CurvePairHit begin, CurvePairHit end, std::vector<CurvePairHit>& hits)
{
  for (CurvePairHit* hit : { &begin, &end })
  {
    const double speed = Norm(pair.First.At(hit->T).D1);
    const double other = Norm(pair.Second.At(hit->S).D1);
    hit->Kind = IntersectionKind::OverlapEnd;
    hit->SlackT = 16.0 * pair.Tolerance / speed + tolerances::OverlapRounding;
    hit->SlackS = 16.0 * pair.Tolerance / other + tolerances::OverlapRounding;
    hit->Error = 16.0 * pair.Tolerance + hit->SlackT * speed;
    hit->Begins = hit == &begin;
    if (hit->IsExact)
    {
      pair.Measure(*hit);
    }
    else
    {
      pair.LocateWithin(*hit, 4.0 * pair.Tolerance);
    }
  }
  if (begin.IsExact || end.T - begin.T > begin.SlackT)
  {
    hits.push_back(begin);
    hits.push_back(end);
    return;
  }
  begin.Kind = IntersectionKind::Touching;
  begin.Begins = false;
  hits.push_back(begin);
}

/// Whether a curve runs along what another continues to, and which intervals of it are on the other
/// itself. Two curves that have more points in common than the product of their degrees have all
/// (of one piece); so many points along the curve are tried.
class CurveWithinCurve
{
public:
  explicit CurveWithinCurve(const CurvePair& pair)
    : Pair(pair)
  {
  }

  /// If it does, appends both ends of each interval, one after the other.
  bool Find(std::vector<CurvePairHit>& hits) const
  {
    using Intervals = CommonIntervals<CurveWithinCurve, CurvePairHit>;
    const int size = this->Pair.First.Degree * this->Pair.Second.Degree + 2;
    CurvePairHit start;
    start.S = 0.5;
    return Intervals(*this, std::clamp(size, 8, Intervals::MaximumSize)).Find(start, hits);
  }

private:
  friend class CommonIntervals<CurveWithinCurve, CurvePairHit>;

  bool Follow(CurvePairHit& foot) const
  {
    Vector3 gap;
    return this->Pair.FindFoot(foot, gap) && Norm(gap) <= 2.0 * this->Pair.Tolerance;
  }

  static double Depth(const CurvePairHit& foot) { return std::min(foot.S, 1.0 - foot.S); }

  void Append(
    const CurvePairHit& begin, const CurvePairHit& end, std::vector<CurvePairHit>& hits) const
  {
    AppendInterval(this->Pair, begin, end, hits);
  }

  const CurvePair& Pair;
};

}

#endif
