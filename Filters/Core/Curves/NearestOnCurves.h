// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Curves_NearestOnCurves_h
#define skd_Curves_NearestOnCurves_h

#include "../Geometry/Distance/ClosestSegments.h"
#include "CurveSpans.h"
#include "Tolerances.h"

#include <vector>

namespace skd
{

/// Where two curves come nearest to each other: at T on the first, at S on the second.
struct CurveApproach
{
  double T = 0.0;
  double S = 0.0;
  double Distance = std::numeric_limits<double>::infinity();
};

/// The nearest approach of two curves by halving: parts whose safety cylinders are farther apart
/// than what is known already are left out. One a thread.
class NearestOnCurves
{
public:
  /// `known`: what is nearer is looked for; its distance is the limit. It is returned when nothing
  /// is. The distance is exact to about 1e-10 of the curves' size.
  CurveApproach Find(
    const BezierCurve& first, const BezierCurve& second, const CurveApproach& known)
  {
    this->Best = known;
    this->Stack.clear();
    this->Stack.push_back({ first, second, { 0.0, 1.0 }, { 0.0, 1.0 } });
    const double enough =
      tolerances::Nearest * (first.Bounds().Diagonal() + second.Bounds().Diagonal());
    for (int budget = 20000; !this->Stack.empty() && budget > 0; --budget)
    {
      const Cell cell = this->Stack.back();
      this->Stack.pop_back();
      this->Examine(cell, first, second, enough);
    }
    this->Polish(first, second);
    return this->Best;
  }

private:
  struct Cell
  {
    BezierCurve First;
    BezierCurve Second;
    Interval T;
    Interval S;
  };

  void Examine(const Cell& cell, const BezierCurve& first, const BezierCurve& second, double enough)
  {
    const double deviations[2] = { ChordDeviation(cell.First), ChordDeviation(cell.Second) };
    const SegmentPair chords = ClosestPoints(Segment<3>{ cell.First.Start(), cell.First.End() },
      Segment<3>{ cell.Second.Start(), cell.Second.End() });
    const double deviation = deviations[0] + deviations[1];
    if (!(std::sqrt(chords.Dist2) - deviation < this->Best.Distance))
    {
      return;
    }
    this->Try(cell.T.Min + chords.T * (cell.T.Max - cell.T.Min),
      cell.S.Min + chords.R * (cell.S.Max - cell.S.Min), first, second);
    if (deviation > enough)
    {
      PushHalves(cell, deviations[0] >= deviations[1], this->Stack);
    }
  }

  void Try(double t, double s, const BezierCurve& first, const BezierCurve& second)
  {
    const double distance = std::sqrt(Distance2(first.At(t).X, second.At(s).X));
    if (distance < this->Best.Distance)
    {
      this->Best = { t, s, distance };
    }
  }

  /// Newton's method on the slopes of the squared distance, as long as it leads nearer.
  void Polish(const BezierCurve& first, const BezierCurve& second)
  {
    for (int iteration = 0; iteration < 8; ++iteration)
    {
      const CurvePoint a = first.At(this->Best.T);
      const CurvePoint b = second.At(this->Best.S);
      const Vector3 gap = a.X - b.X;
      const double tt = Norm2(a.D1) + Dot(gap, a.D2);
      const double ss = Norm2(b.D1) - Dot(gap, b.D2);
      const double ts = -Dot(a.D1, b.D1);
      const double determinant = tt * ss - ts * ts;
      const double slopeT = Dot(gap, a.D1);
      const double slopeS = -Dot(gap, b.D1);
      const double t = this->Best.T - (ss * slopeT - ts * slopeS) / determinant;
      const double s = this->Best.S - (tt * slopeS - ts * slopeT) / determinant;
      const double before = this->Best.Distance;
      if (t >= 0.0 && t <= 1.0 && s >= 0.0 && s <= 1.0)
      {
        this->Try(t, s, first, second);
      }
      if (!(this->Best.Distance < before))
      {
        return;
      }
    }
  }

  CurveApproach Best;
  std::vector<Cell> Stack;
};

}

#endif
