// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// All common points of a piece of a curve and a patch (section 6.2), in their native
/// representation.
///
/// Both are halved until each part of them is certainly apart (the hulls of control points are, or
/// a quadric is in between: SeparatingQuadric.h), has one certain root (Krawczyk's test, then
/// Newton's method), or touches: curve and patch are then within the tolerance of each other
/// without a simple root. Parts that touch are put together and examined for where exactly, and
/// whether the curve passes. A curve that runs within the patch is found first, by more points than
/// two different ones can share.
#ifndef skd_Curves_CurvePatchSolver_h
#define skd_Curves_CurvePatchSolver_h

#include "CurvePatchContraction.h"
#include "CurveWithinPatch.h"
#include "IntersectionSearch.h"

#include <vector>

namespace skd
{

/// One a thread: it keeps its memory. A solution costs some dozens of cells for a simple root, some
/// hundreds for a contact.
class CurvePatchSolver
  : private IntersectionSearch<CurvePatchCell, CurvePatchHit, CurvePatchContact>
{
public:
  /// `tolerance`: the distance that is 0 to within rounding. The result is by ascending T and good
  /// until the next call. Control points should be relative to an origin near by.
  const std::vector<CurvePatchHit>& Solve(
    const BezierCurve& curve, const BezierPatch& patch, double tolerance)
  {
    this->Clear();
    const CurvePatchPair pair{ curve, patch, tolerance };
    CurvePatchCell whole;
    whole.Curve = curve;
    whole.Patch = patch;
    return this->Search<CurvePatchHulls, CurveWithinPatch>(whole, pair,
      [&](const CurvePatchCell& cell, bool mayHalve) { this->Examine(cell, pair, mayHalve); });
  }

private:
  static constexpr int DepthLimit = 150; ///< 50 halvings of each parameter

  void Examine(const CurvePatchCell& cell, const CurvePatchPair& pair, bool mayHalve)
  {
    const CurvePatchHulls hulls(cell);
    if (cell.IsOutside() || hulls.AreApart(pair.Tolerance))
    {
      return;
    }
    const Contraction<3> contraction = ContractionOf(cell, pair.Tolerance);
    if (contraction.Excludes() || this->Finds(cell, contraction, pair) ||
      hulls.AreApartAround(cell, pair.Tolerance))
    {
      return;
    }
    if (!mayHalve || cell.Depth >= DepthLimit || hulls.AreTogether(2.0 * pair.Tolerance))
    {
      this->Contacts.push_back({ cell.T, cell.MiddleR(), cell.MiddleS() });
      return;
    }
    this->Halve(cell, hulls.Largest());
  }

  /// Whether the cell has been dealt with: its only root was found.
  bool Finds(
    const CurvePatchCell& cell, const Contraction<3>& contraction, const CurvePatchPair& pair)
  {
    if (!(contraction.Worst() < 0.5))
    {
      return false;
    }
    const auto start = [](const Interval& interval, double step)
    { return interval.Min + std::clamp(0.5 + step, 0.0, 1.0) * (interval.Max - interval.Min); };
    CurvePatchHit hit;
    hit.T = start(cell.T, contraction.Step[0]);
    hit.R = start(cell.R, contraction.Step[1]);
    hit.S = start(cell.S, contraction.Step[2]);
    if (!pair.Polish(hit))
    {
      return false;
    }
    // Newton's method may have gone to another root: then the cell is not dealt with.
    const std::array<double, 3> slacks = pair.SlacksOf(hit);
    if (!Holds(cell.T, hit.T, slacks[0]) || !Holds(cell.R, hit.R, slacks[1]) ||
      !Holds(cell.S, hit.S, slacks[2]))
    {
      return false;
    }
    if (pair.Accept(hit, slacks))
    {
      this->Hits.push_back(hit);
    }
    return true;
  }

  void Halve(const CurvePatchCell& cell, int axis)
  {
    this->Stack.push_back(cell);
    this->Stack.push_back(cell);
    CurvePatchCell& low = this->Stack[this->Stack.size() - 2];
    CurvePatchCell& high = this->Stack.back();
    low.Depth = high.Depth = cell.Depth + 1;
    if (axis == 0)
    {
      low.T.Max = high.T.Min = cell.MiddleT();
      low.Curve = cell.Curve.Restricted(0.0, 0.5);
      high.Curve = cell.Curve.Restricted(0.5, 1.0);
    }
    else if (axis == 1)
    {
      low.R.Max = high.R.Min = cell.MiddleR();
      high.Patch = low.Patch.SplitOffR();
    }
    else
    {
      low.S.Max = high.S.Min = cell.MiddleS();
      high.Patch = low.Patch.SplitOffS();
    }
  }
};

}

#endif
