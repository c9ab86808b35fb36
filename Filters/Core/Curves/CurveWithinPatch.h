// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Curves_CurveWithinPatch_h
#define skd_Curves_CurveWithinPatch_h

#include "CurvePatchContact.h"

namespace skd
{

/// Whether a curve runs within the surface that a patch is a part of, and which stretches of it are
/// on the patch itself. A curve and an algebraic surface that have more points in common than the
/// product of their degrees have all; so many places along the curve are tried.
class CurveWithinPatch
{
public:
  explicit CurveWithinPatch(const CurvePatchPair& pair)
    : Pair(pair)
  {
    const int surface = 2 * pair.Patch.DegreeR * pair.Patch.DegreeS;
    this->Size = std::clamp(pair.Curve.Degree * surface + 2, 16, MaximumSize - 1);
  }

  /// If it does, appends both ends of each stretch. A curve that does not is mostly told by its
  /// first place.
  bool Find(std::vector<CurvePatchHit>& hits)
  {
    const int middle = this->Size / 2;
    CurvePatchHit foot{ 0.0, 0.5, 0.5 };
    if (!this->Try(middle, foot))
    {
      return false;
    }
    for (int i = middle - 1; i >= 0; --i)
    {
      if (!this->Try(i, foot))
      {
        return false;
      }
    }
    foot = this->Feet[middle];
    for (int i = middle + 1; i <= this->Size; ++i)
    {
      if (!this->Try(i, foot))
      {
        return false;
      }
    }
    this->AppendStretches(hits);
    return true;
  }

private:
  static constexpr int MaximumSize = 128;

  bool Try(int i, CurvePatchHit& foot)
  {
    foot.T = static_cast<double>(i) / this->Size;
    double height;
    const bool isWithin =
      this->Pair.FindFoot(foot, height) && std::abs(height) <= 2.0 * this->Pair.Tolerance;
    this->Feet[i] = foot;
    return isWithin;
  }

  /// How far the foot is within the patch; negative beyond.
  double Depth(const CurvePatchHit& foot) const
  {
    const double inSquare = std::min({ foot.R, 1.0 - foot.R, foot.S, 1.0 - foot.S });
    return this->Pair.Patch.IsTriangle ? std::min(inSquare, 1.0 - foot.R - foot.S) : inSquare;
  }

  bool IsOn(const CurvePatchHit& foot) const { return this->Depth(foot) >= -1e-9; }

  /// Between a place on the patch and one beyond.
  CurvePatchHit Border(CurvePatchHit on, CurvePatchHit beyond) const
  {
    for (int iteration = 0; iteration < 60; ++iteration)
    {
      CurvePatchHit middle = on;
      middle.T = 0.5 * (on.T + beyond.T);
      double height;
      this->Pair.FindFoot(middle, height);
      (this->Depth(middle) >= 0.0 ? on : beyond) = middle;
    }
    return on;
  }

  void Append(CurvePatchHit begin, CurvePatchHit end, std::vector<CurvePatchHit>& hits) const
  {
    bool isPlaced = true;
    for (CurvePatchHit* hit : { &begin, &end })
    {
      hit->Kind = MeetingKind::OverlapEnd;
      hit->Begins = hit == &begin;
      hit->Slack = 1e-9;
      hit->Reach = 1e-9 * Norm(this->Pair.Curve.At(hit->T).D1) + 8.0 * this->Pair.Tolerance;
      isPlaced = this->Pair.Place(*hit, 1e-8, 1e-8) && isPlaced;
      hit->OnBoundary = true;
    }
    const bool isStretch = end.T - begin.T > 2.0 * begin.Slack;
    if (isPlaced && isStretch)
    {
      hits.push_back(begin);
      hits.push_back(end);
    }
    else if (isPlaced) // with an end on the side of the patch
    {
      begin.Kind = MeetingKind::Touching;
      begin.Begins = false;
      hits.push_back(begin);
    }
  }

  void AppendStretches(std::vector<CurvePatchHit>& hits) const
  {
    CurvePatchHit begin;
    bool isOn = false;
    for (int i = 0; i <= this->Size; ++i)
    {
      const bool isNext = this->IsOn(this->Feet[i]);
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

  const CurvePatchPair& Pair;
  int Size;
  CurvePatchHit Feet[MaximumSize];
};

}

#endif
