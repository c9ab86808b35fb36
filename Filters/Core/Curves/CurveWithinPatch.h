// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Curves_CurveWithinPatch_h
#define skd_Curves_CurveWithinPatch_h

#include "CommonIntervals.h"
#include "CurvePatchContact.h"
#include "Tolerances.h"

namespace skd
{

/// Whether a curve runs within the surface that a patch is a part of, and which intervals of it are
/// on the patch itself. A curve and an algebraic surface that have more points in common than the
/// product of their degrees have all; so many points along the curve are tried.
class CurveWithinPatch
{
public:
  explicit CurveWithinPatch(const CurvePatchPair& pair)
    : Pair(pair)
  {
  }

  /// If it does, appends both ends of each interval.
  bool Find(std::vector<CurvePatchHit>& hits) const
  {
    using Intervals = CommonIntervals<CurveWithinPatch, CurvePatchHit>;
    const int surface = 2 * this->Pair.Patch.DegreeR * this->Pair.Patch.DegreeS;
    const int size = this->Pair.Curve.Degree * surface + 2;
    const CurvePatchHit start{ 0.0, 0.5, 0.5 };
    return Intervals(*this, std::clamp(size, 16, Intervals::MaximumSize)).Find(start, hits);
  }

private:
  friend class CommonIntervals<CurveWithinPatch, CurvePatchHit>;

  bool Follow(CurvePatchHit& foot) const
  {
    double height;
    return this->Pair.FindFoot(foot, height) && std::abs(height) <= 2.0 * this->Pair.Tolerance;
  }

  /// How far the foot is within the patch; negative beyond.
  double Depth(const CurvePatchHit& foot) const
  {
    const double inSquare = std::min({ foot.R, 1.0 - foot.R, foot.S, 1.0 - foot.S });
    return this->Pair.Patch.IsTriangle ? std::min(inSquare, 1.0 - foot.R - foot.S) : inSquare;
  }

  void Append(CurvePatchHit begin, CurvePatchHit end, std::vector<CurvePatchHit>& hits) const
  {
    bool isOnPatch = true;
    for (CurvePatchHit* hit : { &begin, &end })
    {
      hit->Kind = IntersectionKind::OverlapEnd;
      hit->Begins = hit == &begin;
      hit->Slack = tolerances::PatchOverlap;
      hit->Error = hit->Slack * Norm(this->Pair.Curve.At(hit->T).D1) + 8.0 * this->Pair.Tolerance;
      isOnPatch =
        this->Pair.LocateWithin(*hit, tolerances::PatchOverlapSide, tolerances::PatchOverlapSide) &&
        isOnPatch;
      hit->OnBoundary = true;
    }
    const bool isInterval = end.T - begin.T > 2.0 * begin.Slack;
    if (isOnPatch && isInterval)
    {
      hits.push_back(begin);
      hits.push_back(end);
    }
    else if (isOnPatch) // with an end on the side of the patch
    {
      begin.Kind = IntersectionKind::Touching;
      begin.Begins = false;
      hits.push_back(begin);
    }
  }

  const CurvePatchPair& Pair;
};

}

#endif
