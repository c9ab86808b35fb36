// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// All common points of two pieces of curves (section 6.1), in their native representation.
///
/// As for a curve and a patch (CurvePatchSolver.h): both are halved until each part is certainly
/// apart, by planes or, where both are curved alike, by a cylinder (SeparatingQuadric.h), has at
/// most one root, which is then found, or touches. Two straight pieces are decided by exact signs
/// (LinePair.h).
#ifndef skd_Curves_CurvePairSolver_h
#define skd_Curves_CurvePairSolver_h

#include "CurvePairCell.h"
#include "CurveWithinCurve.h"
#include "IntersectionSearch.h"
#include "LinePair.h"
#include "Tolerances.h"

namespace skd
{

/// One a thread: it keeps its memory.
class CurvePairSolver : private IntersectionSearch<CurvePairCell, CurvePairHit, CurvePairContact>
{
public:
  /// `tolerance`: the distance that is 0 to within rounding. The result is by ascending T and good
  /// until the next call. Control points should be relative to an origin near by, but of two lines
  /// they should be the very coordinates.
  const std::vector<CurvePairHit>& Solve(
    const BezierCurve& first, const BezierCurve& second, double tolerance)
  {
    this->Clear();
    const CurvePair pair{ first, second, tolerance };
    if (first.IsLine() && second.IsLine())
    {
      LinePair(pair).Find(this->Hits);
      return this->Hits;
    }
    return this->Search<CurvePairHulls, CurveWithinCurve>({ first, second }, pair,
      [&](const CurvePairCell& cell, bool mayHalve) { this->Examine(cell, pair, mayHalve); });
  }

private:
  static constexpr int DepthLimit = 100; ///< 50 halvings of each curve

  void Examine(const CurvePairCell& cell, const CurvePair& pair, bool mayHalve)
  {
    const CurvePairHulls hulls(cell);
    if (hulls.AreApart(pair.Tolerance))
    {
      return;
    }
    const PairInverse inverse(cell);
    const Contraction<2> contraction = inverse.ContractionOf(cell, pair.Tolerance);
    if (contraction.Excludes())
    {
      return;
    }
    if (contraction.Worst() < 0.5)
    {
      this->FindOnly(cell, inverse, pair);
      return;
    }
    if (hulls.AreApartAround(cell, pair.Tolerance))
    {
      return;
    }
    if (!mayHalve || cell.Depth >= DepthLimit || hulls.AreTogether(2.0 * pair.Tolerance))
    {
      this->Contacts.push_back({ cell.T, 0.5 * (cell.S.Min + cell.S.Max) });
      return;
    }
    PushHalves(cell, hulls.Largest(), this->Stack);
    this->Stack.end()[-2].Depth = this->Stack.back().Depth = cell.Depth + 1;
  }

  /// The one point of the cell where both curves are level, seen along what is across both; whether
  /// they also meet there.
  void FindOnly(const CurvePairCell& cell, const PairInverse& inverse, const CurvePair& pair)
  {
    double at[2] = { 0.5, 0.5 };
    for (int iteration = 0; iteration < 60; ++iteration)
    {
      double step[2];
      inverse.Step(cell, at, step);
      at[0] = std::clamp(at[0] + step[0], 0.0, 1.0); // a root of the cell is only come nearer to
      at[1] = std::clamp(at[1] + step[1], 0.0, 1.0);
      if (std::abs(step[0]) + std::abs(step[1]) < tolerances::FootStep)
      {
        break;
      }
    }
    CurvePairHit hit;
    hit.T = cell.T.Min + at[0] * (cell.T.Max - cell.T.Min);
    hit.S = cell.S.Min + at[1] * (cell.S.Max - cell.S.Min);
    pair.Polish(hit);
    pair.SetSlacks(hit);
    if (Holds(cell.T, hit.T, hit.SlackT) && Holds(cell.S, hit.S, hit.SlackS) && pair.Accept(hit))
    {
      this->Hits.push_back(hit);
    }
  }
};

}

#endif
