// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Curves_CurveWithinCurve_h
#define skd_Curves_CurveWithinCurve_h

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
    , Size(std::clamp(pair.First.Degree * pair.Second.Degree + 2, 8, MaximumSize - 1))
  {
  }

  /// If it does, appends both ends of each stretch, one after the other.
  bool Find(std::vector<CurvePairHit>& hits)
  {
    const int middle = this->Size / 2;
    CurvePairHit foot;
    foot.S = 0.5;
    if (!this->TryAll(middle, -1, foot))
    {
      return false;
    }
    foot = this->Feet[middle];
    if (!this->TryAll(middle + 1, this->Size + 1, foot))
    {
      return false;
    }
    this->AppendStretches(hits);
    return true;
  }

private:
  static constexpr int MaximumSize = 128;

  /// From `first` on, to before `end`.
  bool TryAll(int first, int end, CurvePairHit& foot)
  {
    const int step = end < first ? -1 : 1;
    for (int i = first; i != end; i += step)
    {
      foot.T = static_cast<double>(i) / this->Size;
      Vector3 way;
      const bool isWithin =
        this->Pair.FindFoot(foot, way) && Norm(way) <= 2.0 * this->Pair.Tolerance;
      this->Feet[i] = foot;
      if (!isWithin)
      {
        return false;
      }
    }
    return true;
  }

  static double Depth(const CurvePairHit& foot) { return std::min(foot.S, 1.0 - foot.S); }

  /// Between a place on the other curve and one beyond its ends.
  CurvePairHit Border(CurvePairHit on, CurvePairHit beyond) const
  {
    for (int iteration = 0; iteration < 60; ++iteration)
    {
      CurvePairHit middle = on;
      middle.T = 0.5 * (on.T + beyond.T);
      Vector3 way;
      this->Pair.FindFoot(middle, way);
      (Depth(middle) >= 0.0 ? on : beyond) = middle;
    }
    return on;
  }

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

  void AppendStretches(std::vector<CurvePairHit>& hits) const
  {
    CurvePairHit begin;
    bool isOn = false;
    for (int i = 0; i <= this->Size; ++i)
    {
      const bool isNext = Depth(this->Feet[i]) >= -1e-9;
      if (isNext && !isOn)
      {
        begin = i == 0 ? this->Feet[0] : this->Border(this->Feet[i], this->Feet[i - 1]);
      }
      if (!isNext && isOn)
      {
        this->Append(begin, this->Border(this->Feet[i - 1], this->Feet[i]), hits);
      }
      isOn = isNext;
    }
    if (isOn)
    {
      this->Append(begin, this->Feet[this->Size], hits);
    }
  }

  const CurvePair& Pair;
  int Size;
  CurvePairHit Feet[MaximumSize];
};

}

#endif
