// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Curves_CurveWithinCurve_h
#define skd_Curves_CurveWithinCurve_h

#include "CommonStretches.h"
#include "CurvePair.h"

namespace skd
{

/// Whether a curve runs along what another continues to, and which stretches of it are on the other
/// itself. Two curves that have more points in common than the product of their degrees have all
/// (of one piece); so many places along the curve are tried.
class CurveWithinCurve
{
public:
  explicit CurveWithinCurve(const CurvePair& pair)
    : Pair(pair)
  {
  }

  /// If it does, appends both ends of each stretch, one after the other.
  bool Find(std::vector<CurvePairHit>& hits) const
  {
    using Stretches = CommonStretches<CurveWithinCurve, CurvePairHit>;
    const int size = this->Pair.First.Degree * this->Pair.Second.Degree + 2;
    CurvePairHit start;
    start.S = 0.5;
    return Stretches(*this, std::clamp(size, 8, Stretches::MaximumSize)).Find(start, hits);
  }

private:
  friend class CommonStretches<CurveWithinCurve, CurvePairHit>;

  bool Follow(CurvePairHit& foot) const
  {
    Vector3 way;
    return this->Pair.FindFoot(foot, way) && Norm(way) <= 2.0 * this->Pair.Tolerance;
  }

  static double Depth(const CurvePairHit& foot) { return std::min(foot.S, 1.0 - foot.S); }

  void Append(CurvePairHit begin, CurvePairHit end, std::vector<CurvePairHit>& hits) const
  {
    for (CurvePairHit* hit : { &begin, &end })
    {
      const double speed = Norm(this->Pair.First.At(hit->T).D1);
      const double other = Norm(this->Pair.Second.At(hit->S).D1);
      hit->Kind = MeetingKind::OverlapEnd;
      hit->SlackT = 16.0 * this->Pair.Tolerance / speed + 1e-13;
      hit->SlackS = 16.0 * this->Pair.Tolerance / other + 1e-13;
      hit->Reach = 16.0 * this->Pair.Tolerance + hit->SlackT * speed;
      hit->Begins = hit == &begin;
      this->Pair.Place(*hit, 4.0 * this->Pair.Tolerance);
    }
    if (end.T - begin.T > begin.SlackT)
    {
      hits.push_back(begin);
      hits.push_back(end);
    }
    else // end to end
    {
      begin.Kind = MeetingKind::Touching;
      begin.Begins = false;
      hits.push_back(begin);
    }
  }

  const CurvePair& Pair;
};

}

#endif
